# Settings as interface targets, linked PRIVATE: nothing here leaks into what uses a module.

add_library(wm3d_settings INTERFACE)
target_compile_features(wm3d_settings INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)

# The same bytes on every run and machine of one architecture: no fused multiply-add behind our back.
target_compile_options(wm3d_settings INTERFACE -ffp-contract=off)

# Where sources are compiled together, a local name may well be one of another file's own: no -Wshadow there.
target_compile_options(wm3d_settings INTERFACE
    -Wall -Wextra -Wpedantic $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow> -Wnon-virtual-dtor -Wcast-align -Woverloaded-virtual
    $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wlogical-op>)
if(CMAKE_UNITY_BUILD)
    # Sources that are compiled as one are headers to g++, which then warns of anonymous namespaces in classes.
    target_compile_options(wm3d_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
# g++ tidies up its memory less often: a twelfth of its time, for 200 MB more.
target_compile_options(wm3d_settings INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288> $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=100>)
if(WM3D_WERROR)
    target_compile_options(wm3d_settings INTERFACE -Werror)
endif()

if(WM3D_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()
if(WM3D_SANITIZE_THREADS)
    add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
    add_link_options(-fsanitize=thread)
endif()

# wm3d_not_hot(TARGET): what no command waits for is compiled in less time, not for speed.
function(wm3d_not_hot target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_target_properties(${target} PROPERTIES WM3D_NOT_HOT ON) # see wm3d_together
endfunction()

find_program(WM3D_CCACHE ccache)
if(WM3D_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${WM3D_CCACHE})
endif()
