# C++20 interface units: wm3d_interface_units(MODULE...) makes wm3d::unit::MODULE of modules/MODULE/wm3d.MODULE.cppm, so
# that `import wm3d.MODULE;` works where a target links it. Units only name what the headers declare (scripts/interface-units
# writes them); they stand on the libraries wm3d::MODULE, whichever compiler built those.

if(CMAKE_VERSION VERSION_LESS 3.28)
    message(FATAL_ERROR "C++20 modules need CMake 3.28 or newer, and this is ${CMAKE_VERSION}; "
        "'scripts/install-packages modules' gets one from npm, or configure with -DWM3D_CXX_MODULES=OFF")
endif()
if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
        OR (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 17))
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} can't build these C++20 modules; take clang "
        "17 or newer (CXX=clang++-19, in 'scripts/install-packages modules'), or configure with -DWM3D_CXX_MODULES=OFF")
endif()

function(wm3d_interface_units)
    foreach(module IN LISTS ARGN)
        if(module STREQUAL "wm3d")
            set(file ${WM3D_UNITS_ROOT}/modules/wm3d/wm3d.cppm)
        else()
            set(file ${WM3D_UNITS_ROOT}/modules/${module}/wm3d.${module}.cppm)
        endif()
        add_library(wm3d_unit_${module} STATIC)
        add_library(wm3d::unit::${module} ALIAS wm3d_unit_${module})
        target_sources(wm3d_unit_${module} PUBLIC
            FILE_SET CXX_MODULES BASE_DIRS ${WM3D_UNITS_ROOT}/modules FILES ${file})
        target_compile_features(wm3d_unit_${module} PUBLIC cxx_std_20)
        set_target_properties(wm3d_unit_${module} PROPERTIES EXPORT_NAME unit::${module} POSITION_INDEPENDENT_CODE ON
            CXX_SCAN_FOR_MODULES ON)
        target_link_libraries(wm3d_unit_${module} PUBLIC wm3d::${module})
        if(DEFINED WM3D_INSTALL AND NOT WM3D_INSTALL)
            continue()
        endif()
        install(TARGETS wm3d_unit_${module} EXPORT wm3d-unit-${module} COMPONENT development
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            FILE_SET CXX_MODULES DESTINATION ${CMAKE_INSTALL_LIBDIR}/wm3d/units)
        install(EXPORT wm3d-unit-${module} NAMESPACE wm3d:: COMPONENT development
            DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/wm3d CXX_MODULES_DIRECTORY units)
    endforeach()
endfunction()
