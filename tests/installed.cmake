# The installed suite as strangers meet it: into an empty prefix, then found by CMake and by pkg-config. And the suite as
# a folder of another project.

set(stage ${CMAKE_CURRENT_BINARY_DIR}/stage)
add_test(NAME "installed: a prefix of its own"
    COMMAND ${CMAKE_COMMAND} -D STAGE=${stage} -D BUILD=${PROJECT_BINARY_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/install.cmake)
set_tests_properties("installed: a prefix of its own" PROPERTIES FIXTURES_SETUP installed)

# wm3d_consumer_test(NAME SOURCE PROGRAM OPTION...): configures and builds a project, and runs a program of it.
function(wm3d_consumer_test name source program)
    add_test(NAME ${name}
        COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${source} ${CMAKE_CURRENT_BINARY_DIR}/${program}-consumer
            --build-generator ${CMAKE_GENERATOR} --build-noclean
            --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=Release ${ARGN}
            --test-command ${program})
    set_tests_properties(${name} PROPERTIES TIMEOUT 600)
endfunction()

if(NOT WM3D_SANITIZE) # whose libraries need programs that are built alike
    wm3d_consumer_test("installed: find_package" ${PROJECT_SOURCE_DIR}/examples mark_and_verify
        -DCMAKE_PREFIX_PATH=${stage})
    set_tests_properties("installed: find_package" PROPERTIES FIXTURES_REQUIRED installed)
    add_test(NAME "installed: pkg-config"
        COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/pkg_config.sh ${CMAKE_CXX_COMPILER}
            ${stage}/${CMAKE_INSTALL_LIBDIR}/pkgconfig ${PROJECT_SOURCE_DIR}/examples/mark_file.cpp
            ${CMAKE_CURRENT_BINARY_DIR} $<TARGET_FILE:wm3d>)
    set_tests_properties("installed: pkg-config" PROPERTIES FIXTURES_REQUIRED installed)
    wm3d_consumer_test("embedded: add_subdirectory" ${CMAKE_CURRENT_SOURCE_DIR}/embedded parts
        -DWM3D_SOURCE=${PROJECT_SOURCE_DIR})
endif()

add_test(NAME "docs: library.md shows the examples that are built"
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/library_doc.py ${PROJECT_SOURCE_DIR})
