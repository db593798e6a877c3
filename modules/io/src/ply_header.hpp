// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Header of a PLY file: encoding, elements and their properties.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "binary.hpp"
#include "source.hpp"

namespace wm3d::io {

struct PlyProperty {
    std::string name;
    Scalar type = Scalar::f32;
    std::optional<Scalar> count_type; ///< of a list
    bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    /// Number of the property of that name, if there is one.
    std::optional<std::size_t> find(std::string_view property) const;
    bool has_lists() const;
    /// Bytes of one record in a binary file, lists counted as empty.
    std::size_t least_size() const;
};

enum class PlyEncoding { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t body = 0; ///< offset of the first byte after the header
};

/// \throw InputError
PlyHeader read_ply_header(const Source& source);

} // namespace wm3d::io
