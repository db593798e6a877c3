// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The file formats and how they are recognised.
#pragma once

#include <optional>
#include <string_view>

namespace wm3d::io {

enum class Format { obj, ply, stl, off, gltf, glb };

/// Lower-case name, which is also the usual extension: "obj", "ply", ...
std::string_view name_of(Format format);

/// Format by the extension of a path or by a bare name such as "ply"; upper or lower case.
std::optional<Format> format_of_name(std::string_view name);

/// Format that the first bytes prove (PLY, GLB, OFF, glTF, text STL); nothing where they prove none.
std::optional<Format> format_of_content(std::string_view bytes);

} // namespace wm3d::io
