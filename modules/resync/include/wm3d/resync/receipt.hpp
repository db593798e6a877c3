// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What an owner keeps of a marking, so that a cut or ambiguous copy can be laid back into the mark's
/// frame without the original. docs/receipt.md describes the file field by field.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <wm3d/resync/pose_template.hpp>

namespace wm3d::resync {

/// A file as the receipt remembers it.
struct FileDigest {
    std::string sha256; ///< 64 hexadecimal digits
    std::uint64_t bytes = 0;

    bool operator==(const FileDigest&) const = default;
};

FileDigest digest_of(std::string_view bytes);

struct Receipt {
    /// Newest version of the format that this library reads and the one it writes.
    static constexpr int format_version = 2;

    std::string tool;           ///< name and version of the program that marked
    std::string key_name;       ///< public short name of the key
    std::string key_commitment; ///< 64 hexadecimal digits that bind the key and tell nothing about it
    FileDigest original;
    FileDigest marked;
    std::uint64_t base_vertices = 0;
    unsigned level = 0;
    double gamma = 0;
    double rmax = 0;
    double rms_percent = 0;     ///< move along the normals, as `--strength`
    Frame frame;                ///< of the mark, in the coordinates of the marked file
    PoseTemplate pose_template; ///< of the original's surface, in the frame's coordinates

    /// The template in the coordinates of the marked file.
    PoseTemplate in_file() const { return moved(pose_template, to_canonical(frame).inverse()); }
};

/// Number of points that a receipt keeps: 9 bytes each.
inline constexpr std::size_t receipt_points = 2000;

/// The receipt as a JSON text. Points are rounded to 1/65535 of the template's box, normals to 1/127.
std::string to_text(const Receipt& receipt);

/// Reads the text of a receipt; messages call it `file_name`.
/// \throw InputError  if it is no receipt, cut, altered, of a newer version or has a value out of range
Receipt parse_receipt(std::string_view text, std::string_view file_name);

} // namespace wm3d::resync
