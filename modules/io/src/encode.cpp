// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/encode.hpp>

#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

#include "binary.hpp"
#include "encode_gltf.hpp"

namespace wm3d::io {

namespace {

void put_number(std::string& out, double value) {
    char text[40];
    out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

void put_number(std::string& out, float value) {
    char text[40];
    out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// The three coordinates with a space between; as floats or as doubles.
void put_position(std::string& out, const Vec3& p, bool as_float) {
    for (int k = 0; k < 3; ++k) {
        if (k > 0)
            out += ' ';
        if (as_float)
            put_number(out, static_cast<float>(p[k]));
        else
            put_number(out, p[k]);
    }
}

void put_color(std::string& out, const Color& color) {
    out += fmt::format(" {} {} {}", color[0], color[1], color[2]);
}

std::string ply_header(const TriangleMesh& mesh, const EncodeOptions& options) {
    const auto colors = [](const std::vector<Color>& given) {
        return given.empty() ? "" : "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    };
    const std::string_view type = options.double_precision ? "double" : "float";
    return fmt::format(
        "ply\nformat {} 1.0\n{}element vertex {}\nproperty {} x\nproperty {} y\nproperty {} z\n{}"
        "element face {}\nproperty list uchar int vertex_indices\n{}end_header\n",
        options.ascii ? "ascii" : "binary_little_endian",
        options.comment.empty() ? "" : "comment " + options.comment + "\n", mesh.positions.size(), type, type,
        type, colors(options.vertex_colors), mesh.triangles.size(), colors(options.face_colors));
}

std::string encode_ply_text(const TriangleMesh& mesh, const EncodeOptions& options) {
    std::string out = ply_header(mesh, options);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        put_position(out, mesh.positions[v], !options.double_precision);
        if (!options.vertex_colors.empty())
            put_color(out, options.vertex_colors[v]);
        out += '\n';
    }
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        out += fmt::format("3 {} {} {}", t[0], t[1], t[2]);
        if (!options.face_colors.empty())
            put_color(out, options.face_colors[f]);
        out += '\n';
    }
    return out;
}

std::string encode_ply_binary(const TriangleMesh& mesh, const EncodeOptions& options) {
    std::string out = ply_header(mesh, options);
    const Scalar type = options.double_precision ? Scalar::f64 : Scalar::f32;
    const auto put_channels = [&](const std::vector<Color>& colors, std::size_t i) {
        if (!colors.empty())
            for (std::uint8_t channel : colors[i])
                out += static_cast<char>(channel);
    };
    out.reserve(out.size() + mesh.positions.size() * (3 * size_of(type) + 3) + mesh.triangles.size() * 16);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        for (int k = 0; k < 3; ++k)
            put(out, type, mesh.positions[v][k]);
        put_channels(options.vertex_colors, v);
    }
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        out += '\3';
        for (Index v : mesh.triangles[f])
            put(out, Scalar::u32, v);
        put_channels(options.face_colors, f);
    }
    return out;
}

std::string encode_obj(const TriangleMesh& mesh, const EncodeOptions& options) {
    std::string out = options.comment.empty() ? "" : "# " + options.comment + "\n";
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        out += "v ";
        put_position(out, mesh.positions[v], false);
        if (!options.vertex_colors.empty())
            for (std::uint8_t channel : options.vertex_colors[v])
                out += fmt::format(" {:.4f}", channel / 255.0);
        out += '\n';
    }
    for (const Triangle& t : mesh.triangles)
        out +=
            fmt::format("f {} {} {}\n", std::size_t{t[0]} + 1, std::size_t{t[1]} + 1, std::size_t{t[2]} + 1);
    return out;
}

std::string encode_off(const TriangleMesh& mesh, const EncodeOptions& options) {
    std::string out = options.vertex_colors.empty() ? "OFF\n" : "COFF\n";
    if (!options.comment.empty())
        out += "# " + options.comment + "\n";
    out += fmt::format("{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        put_position(out, mesh.positions[v], false);
        if (!options.vertex_colors.empty()) {
            put_color(out, options.vertex_colors[v]);
            out += " 255";
        }
        out += '\n';
    }
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        out += fmt::format("3 {} {} {}", t[0], t[1], t[2]);
        if (!options.face_colors.empty())
            put_color(out, options.face_colors[f]);
        out += '\n';
    }
    return out;
}

Vec3 unit_normal(const TriangleMesh& mesh, std::size_t f) {
    const Vec3 normal = area_vector(mesh, f);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3::Zero();
}

std::string encode_stl_text(const TriangleMesh& mesh) {
    std::string out = "solid wm3d\n";
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        out += "  facet normal ";
        put_position(out, unit_normal(mesh, f), true);
        out += "\n    outer loop\n";
        for (Index v : mesh.triangles[f]) {
            out += "      vertex ";
            put_position(out, mesh.positions[v], true);
            out += '\n';
        }
        out += "    endloop\n  endfacet\n";
    }
    return out + "endsolid wm3d\n";
}

std::string encode_stl_binary(const TriangleMesh& mesh) {
    std::string out = "wm3d binary STL";
    out.resize(80, ' ');
    out.reserve(84 + 50 * mesh.triangles.size());
    put(out, Scalar::u32, static_cast<double>(mesh.triangles.size()));
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Vec3 normal = unit_normal(mesh, f);
        for (int k = 0; k < 3; ++k)
            put(out, Scalar::f32, normal[k]);
        for (Index v : mesh.triangles[f])
            for (int k = 0; k < 3; ++k)
                put(out, Scalar::f32, mesh.positions[v][k]);
        put(out, Scalar::u16, 0);
    }
    return out;
}

void check_coordinates(const TriangleMesh& mesh, bool as_float) {
    const double largest = as_float ? static_cast<double>(std::numeric_limits<float>::max())
                                    : std::numeric_limits<double>::max();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (!mesh.positions[v].allFinite() || mesh.positions[v].cwiseAbs().maxCoeff() > largest)
            throw GeometryError(
                fmt::format("vertex {} has a coordinate that the file can't hold (not finite, or beyond "
                            "{:g}); scale the mesh down",
                            v, largest));
}

void check_colors(const TriangleMesh& mesh, Format format, const EncodeOptions& options) {
    const bool vertex = !options.vertex_colors.empty(), face = !options.face_colors.empty();
    if ((vertex && options.vertex_colors.size() != mesh.positions.size()) ||
        (face && options.face_colors.size() != mesh.triangles.size()))
        throw ParameterError("the number of colours is not that of the vertices or faces");
    if ((format == Format::stl && (vertex || face)) || (format == Format::obj && face))
        throw ParameterError(fmt::format("{} can't hold {} colours; write PLY, OFF or GLB instead",
                                         name_of(format), vertex ? "vertex" : "face"));
    if ((format == Format::glb || format == Format::gltf) && vertex && face)
        throw ParameterError("glTF holds vertex colours or face colours, not both");
    if (options.comment.find_first_of("\r\n") != std::string::npos)
        throw ParameterError("a comment in a mesh file must be one line");
}

} // namespace

std::string encode(const TriangleMesh& mesh, Format format, const EncodeOptions& options) {
    check_colors(mesh, format, options);
    const bool text_of_doubles = format == Format::obj || format == Format::off;
    check_coordinates(mesh, !text_of_doubles && !(format == Format::ply && options.double_precision));
    switch (format) {
    case Format::obj:
        return encode_obj(mesh, options);
    case Format::off:
        return encode_off(mesh, options);
    case Format::ply:
        return options.ascii ? encode_ply_text(mesh, options) : encode_ply_binary(mesh, options);
    case Format::stl:
        return options.ascii ? encode_stl_text(mesh) : encode_stl_binary(mesh);
    case Format::gltf:
        return encode_gltf(mesh, options, false);
    case Format::glb:
        return encode_gltf(mesh, options, true);
    }
    throw ParameterError("unknown file format");
}

} // namespace wm3d::io
