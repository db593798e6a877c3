// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Writing a mesh as a new file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <wm3d/io/format.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::io {

/// Red, green, blue.
using Color = std::array<std::uint8_t, 3>;

struct EncodeOptions {
    bool ascii = false;                 ///< PLY and STL: text instead of little-endian binary
    bool double_precision = false;      ///< PLY: coordinates as double instead of float
    std::vector<Color> vertex_colors{}; ///< #V or empty; PLY, OFF, OBJ, GLB and glTF
    std::vector<Color> face_colors{};   ///< #F or empty; PLY, OFF, GLB and glTF (corners are then unshared)
    std::string comment{};              ///< one line; PLY, OBJ, OFF, and glTF's generator
};

/// Bytes of a file that holds `mesh`. Text formats write the shortest decimals that read back to the same
/// double (PLY: to the same float unless `double_precision`); STL and glTF hold floats.
/// \throw ParameterError  if a colour list has the wrong length or the format can't hold it
/// \throw GeometryError  if a coordinate is not finite or too large for the format's floats
std::string encode(const TriangleMesh& mesh, Format format, const EncodeOptions& options = {});

} // namespace wm3d::io
