# Installs BUILD into an empty STAGE and looks whether all parts are there.
file(REMOVE_RECURSE ${STAGE})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${STAGE} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(pattern bin/wm3d include/wm3d/wm3d.hpp include/wm3d/core/error.hpp lib*/libwm3d_core.a lib*/libwm3d_watermark.a
        lib*/cmake/wm3d/wm3dConfig.cmake lib*/cmake/wm3d/wm3dConfigVersion.cmake lib*/pkgconfig/wm3d.pc
        share/doc/wm3d/LICENSE)
    file(GLOB found ${STAGE}/${pattern})
    if(NOT found)
        message(FATAL_ERROR "the installation lacks ${pattern}")
    endif()
endforeach()
file(GLOB_RECURSE configurations ${STAGE}/*.cmake ${STAGE}/*.pc)
foreach(file IN LISTS configurations)
    file(READ ${file} text)
    string(FIND "${text}" "${STAGE}" place)
    if(NOT place EQUAL -1)
        message(FATAL_ERROR "${file} names the place where it was installed, and so can't be moved")
    endif()
endforeach()
