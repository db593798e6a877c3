# wm3d_module(NAME sphere HDRS a.hpp ... SRCS b.cpp ... DEPS mesh key LINK wm3d::third::fmt TESTS c_test.cpp ...)
#
# Makes the library wm3d::<NAME> of modules/<NAME>. Headers live in include/wm3d/<NAME>/, the facade is
# include/wm3d/<NAME>.hpp, sources in src/, tests in tests/. DEPS are modules whose headers the module's own
# headers may include (they must be listed before it in WM3D_MODULES); LINK is linked PRIVATE. Every header
# compiles alone (target wm3d_headers).

if(WM3D_TESTS)
    include(Wm3dHeaders)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/doctest_main.cpp CONTENT
        "#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN\n#include <doctest/doctest.h>\n")
    add_library(wm3d_doctest_main STATIC ${CMAKE_BINARY_DIR}/doctest_main.cpp)
    wm3d_not_hot(wm3d_doctest_main)
    target_link_libraries(wm3d_doctest_main PUBLIC wm3d::third::doctest)
    target_compile_features(wm3d_doctest_main PUBLIC cxx_std_20)
    target_include_directories(wm3d_doctest_main PUBLIC ${PROJECT_SOURCE_DIR}/tests/support) # what tests share
endif()

# wm3d_test(NAME SRCS ... LINK ...): a doctest executable whose cases are separate CTest tests.
function(wm3d_test name)
    cmake_parse_arguments(ARG "" "TIMEOUT" "SRCS;LINK;ENVIRONMENT" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    if(WM3D_SANITIZE OR WM3D_SANITIZE_THREADS) # which take many times as long
        math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
    endif()
    add_executable(${name} ${ARG_SRCS})
    wm3d_not_hot(${name})
    target_link_libraries(${name} PRIVATE wm3d_settings wm3d_doctest_main ${ARG_LINK})
    set(meshes $ENV{WM3D_MESHES})
    if(NOT meshes)
        set(meshes ${PROJECT_SOURCE_DIR}/../shared/meshes)
    endif()
    doctest_discover_tests(${name} TEST_PREFIX "${name}: "
        PROPERTIES TIMEOUT ${ARG_TIMEOUT} SKIP_REGULAR_EXPRESSION "SKIPPED:"
        ENVIRONMENT "WM3D_MESHES=${meshes};${ARG_ENVIRONMENT}")
endfunction()

function(wm3d_module)
    cmake_parse_arguments(ARG "" "NAME" "HDRS;SRCS;DEPS;LINK;TESTS;TEST_LINK" ${ARGN})
    if(ARG_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "wm3d_module(${ARG_NAME}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
    endif()
    set(target wm3d_${ARG_NAME})
    set(headers include/wm3d/${ARG_NAME}.hpp)
    foreach(header IN LISTS ARG_HDRS)
        list(APPEND headers include/wm3d/${ARG_NAME}/${header})
    endforeach()
    list(TRANSFORM ARG_SRCS PREPEND src/)
    set(arrows ${ARG_DEPS} ${ARG_LINK})
    list(FILTER arrows EXCLUDE REGEX "wm3d::third::")
    list(TRANSFORM arrows REPLACE "^wm3d::" "")
    list(JOIN arrows " " arrows)
    set_property(GLOBAL APPEND_STRING PROPERTY WM3D_ARROWS "${ARG_NAME}: ${arrows}\n")
    list(TRANSFORM ARG_DEPS PREPEND wm3d::)

    # What only sources include is no concern of a program that links the installed module.
    foreach(third IN LISTS ARG_LINK)
        if(third MATCHES "^wm3d::third::")
            get_target_property(find ${third} WM3D_FIND)
            if(NOT find)
                list(REMOVE_ITEM ARG_LINK ${third})
                list(APPEND ARG_LINK $<BUILD_INTERFACE:${third}>)
            endif()
        endif()
    endforeach()

    if(ARG_SRCS)
        set(scope PUBLIC)
        add_library(${target} STATIC ${ARG_SRCS})
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
        target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:wm3d_settings> ${ARG_LINK})
    else() # headers alone
        set(scope INTERFACE)
        add_library(${target} INTERFACE)
    endif()
    add_library(wm3d::${ARG_NAME} ALIAS ${target})
    target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS include FILES ${headers})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${ARG_NAME})
    target_compile_features(${target} ${scope} cxx_std_20)
    target_link_libraries(${target} ${scope} ${ARG_DEPS} wm3d::third::eigen)

    if(WM3D_TESTS)
        wm3d_check_headers(${ARG_NAME} ${headers})
    endif()
    if(WM3D_TESTS AND ARG_TESTS)
        list(TRANSFORM ARG_TESTS PREPEND tests/)
        wm3d_test(${target}_tests SRCS ${ARG_TESTS} LINK wm3d::${ARG_NAME} ${ARG_TEST_LINK})
    endif()
endfunction()
