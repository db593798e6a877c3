// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

#include <wm3d/core/error.hpp>

#include "voxel_surface.hpp"

namespace wm3d::attack {

namespace {

/// Where the program's own search path leads, or where the library would be installed.
void* load_voxels() {
    const std::string installed = WM3D_VOXELS_FOLDER "/" WM3D_VOXELS_NAME;
    for (const char* path : {WM3D_VOXELS_NAME, installed.c_str()})
        if (void* library = dlopen(path, RTLD_LAZY | RTLD_LOCAL))
            return library;
    throw ParameterError(
        fmt::format("the attack voxels needs the library {}, which could not be loaded ({}); "
                    "install it again, or name its folder in LD_LIBRARY_PATH",
                    WM3D_VOXELS_NAME, dlerror()),
        ErrorCode::missing_feature);
}

} // namespace

ExtractSurface& extract_surface() {
    static void* const function = dlsym(load_voxels(), "wm3d_extract_surface");
    if (!function)
        throw ParameterError(
            fmt::format("the library {} is not that of this version of wm3d; install it again",
                        WM3D_VOXELS_NAME),
            ErrorCode::missing_feature);
    return *reinterpret_cast<ExtractSurface*>(function);
}

} // namespace wm3d::attack
