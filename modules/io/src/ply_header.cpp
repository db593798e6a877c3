// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "text.hpp"

namespace wm3d::io {

namespace {

Scalar scalar_of_name(const TextScanner& scan, std::size_t line, std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, Scalar>, 16> names{{
        {"char", Scalar::i8},
        {"int8", Scalar::i8},
        {"uchar", Scalar::u8},
        {"uint8", Scalar::u8},
        {"short", Scalar::i16},
        {"int16", Scalar::i16},
        {"ushort", Scalar::u16},
        {"uint16", Scalar::u16},
        {"int", Scalar::i32},
        {"int32", Scalar::i32},
        {"uint", Scalar::u32},
        {"uint32", Scalar::u32},
        {"float", Scalar::f32},
        {"float32", Scalar::f32},
        {"double", Scalar::f64},
        {"float64", Scalar::f64},
    }};
    for (const auto& [known, type] : names)
        if (known == name)
            return type;
    scan.source().fail_in_line(line, fmt::format("\"{}\" is no property type of PLY", name.substr(0, 30)));
}

void read_format(TextScanner& scan, std::size_t line, PlyHeader& header) {
    const std::string_view encoding = scan.word();
    if (encoding == "ascii")
        header.encoding = PlyEncoding::ascii;
    else if (encoding == "binary_little_endian")
        header.encoding = PlyEncoding::binary_little_endian;
    else if (encoding == "binary_big_endian")
        header.encoding = PlyEncoding::binary_big_endian;
    else
        scan.source().fail_in_line(line, fmt::format("\"{}\" is no encoding of PLY", encoding.substr(0, 30)));
}

void read_property(TextScanner& scan, std::size_t line, PlyHeader& header) {
    if (header.elements.empty())
        scan.source().fail_in_line(line, "a property comes before the first element");
    PlyProperty property;
    std::string_view type = scan.word();
    if (type == "list") {
        property.count_type = scalar_of_name(scan, line, scan.word());
        if (!is_integer(*property.count_type))
            scan.source().fail_in_line(line, "the length of a list can't be a floating-point number");
        type = scan.word();
    }
    property.type = scalar_of_name(scan, line, type);
    property.name = scan.word();
    header.elements.back().properties.push_back(std::move(property));
}

/// Skips exactly one line end, of the kind that ends the first line: what follows may be binary.
void skip_header_line_end(TextScanner& scan) {
    const std::string_view bytes = scan.source().bytes;
    const std::size_t first = bytes.find_first_of("\r\n");
    const bool pair = bytes.substr(first, 2) == "\r\n";
    scan.skip_blanks();
    if (scan.at_end() || !scan.at_line_end())
        scan.source().fail_at_byte(scan.offset(),
                                   "no line end after end_header; the file is cut short or damaged");
    const bool pair_here = bytes.substr(scan.offset(), 2) == "\r\n";
    scan.jump(scan.offset() + (pair && pair_here ? 2 : 1));
}

} // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == property)
            return i;
    return std::nullopt;
}

bool PlyElement::has_lists() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& p) { return p.is_list(); });
}

std::size_t PlyElement::least_size() const {
    std::size_t size = 0;
    for (const PlyProperty& p : properties)
        size += size_of(p.is_list() ? *p.count_type : p.type);
    return size;
}

PlyHeader read_ply_header(const Source& source) {
    PlyHeader header;
    TextScanner scan(source, 0);
    if (scan.word() != "ply")
        source.fail("the file does not begin with \"ply\", so it is no PLY file");
    bool has_format = false;
    for (;;) {
        scan.skip_line();
        scan.skip_blanks();
        const std::size_t line = scan.offset();
        if (scan.at_end())
            source.fail("the header has no end_header; the file is cut short or no PLY file");
        const std::string_view keyword = scan.at_line_end() ? std::string_view{} : scan.word();
        if (keyword == "end_header")
            break;
        if (keyword == "format") {
            read_format(scan, line, header);
            has_format = true;
        } else if (keyword == "element") {
            PlyElement element;
            element.name = scan.word();
            element.count = static_cast<std::size_t>(scan.integer("the number of an element", 0));
            header.elements.push_back(std::move(element));
        } else if (keyword == "property") {
            read_property(scan, line, header);
        } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
            source.fail_in_line(
                line, fmt::format("\"{}\" begins no line of a PLY header, where format, element, property, "
                                  "comment and end_header do; correct the line, or put \"comment\" "
                                  "before a remark",
                                  keyword.substr(0, 30)));
        }
    }
    if (!has_format)
        source.fail("the header has no format line, so the encoding is unknown");
    skip_header_line_end(scan);
    header.body = scan.offset();
    return header;
}

} // namespace wm3d::io
