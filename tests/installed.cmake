# The installed suite as strangers meet it: into an empty prefix, then found by CMake and by pkg-config. And the suite as
# a folder of another project.

set(stage ${CMAKE_CURRENT_BINARY_DIR}/stage)
set(key ${PROJECT_SOURCE_DIR}/golden/mark/sample/test.key) # published, so that what fails once fails again
add_test(NAME "installed: a prefix of its own"
    COMMAND ${CMAKE_COMMAND} -D STAGE=${stage} -D BUILD=${PROJECT_BINARY_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/install.cmake)
set_tests_properties("installed: a prefix of its own" PROPERTIES FIXTURES_SETUP installed)
if(WM3D_COMMANDS AND TARGET wm3d_voxels)
    add_test(NAME "installed: the library of the voxels"
        COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/voxels.sh ${stage} ${CMAKE_CURRENT_BINARY_DIR}/voxels)
    set_tests_properties("installed: the library of the voxels" PROPERTIES FIXTURES_REQUIRED installed
        SKIP_REGULAR_EXPRESSION "SKIPPED:")
endif()

# wm3d_consumer_test(NAME SOURCE PROGRAM OPTION...): configures and builds a project, and runs a program of it. What is tried
# is whether it builds, so it is compiled in the least time.
function(wm3d_consumer_test name source program)
    add_test(NAME ${name}
        COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${source} ${CMAKE_CURRENT_BINARY_DIR}/${program}-consumer
            --build-generator ${CMAKE_GENERATOR} --build-noclean
            --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=Release
                "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" ${ARGN}
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
            ${CMAKE_CURRENT_BINARY_DIR} $<TARGET_FILE:wm3d> ${key})
    set_tests_properties("installed: pkg-config" PROPERTIES FIXTURES_REQUIRED installed)
    add_test(NAME "installed: import"
        COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/imported.sh ${PROJECT_SOURCE_DIR} ${stage} ${CMAKE_CURRENT_BINARY_DIR}/import)
    set_tests_properties("installed: import" PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 600
        SKIP_REGULAR_EXPRESSION "SKIPPED:")
    wm3d_consumer_test("embedded: add_subdirectory" ${CMAKE_CURRENT_SOURCE_DIR}/embedded parts
        -DWM3D_SOURCE=${PROJECT_SOURCE_DIR} -DWM3D_WITHOUT=${WM3D_WITHOUT} -DWM3D_RESYNC=${WM3D_RESYNC}
        -DCMAKE_UNITY_BUILD=${CMAKE_UNITY_BUILD} -DCMAKE_UNITY_BUILD_BATCH_SIZE=${CMAKE_UNITY_BUILD_BATCH_SIZE})
endif()

if(WM3D_COMMANDS AND NOT WM3D_SANITIZE)
    add_test(NAME "packaged: Debian"
        COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/packaged.sh ${CMAKE_CPACK_COMMAND} ${PROJECT_BINARY_DIR}
            ${CMAKE_CURRENT_BINARY_DIR}/packaged ${key})
    set_tests_properties("packaged: Debian" PROPERTIES TIMEOUT 300 SKIP_REGULAR_EXPRESSION "SKIPPED:")
endif()
add_test(NAME "interface units export what the headers declare"
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/scripts/interface-units --check)
add_test(NAME "docs: library.md shows the examples that are built"
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/library_doc.py ${PROJECT_SOURCE_DIR})
