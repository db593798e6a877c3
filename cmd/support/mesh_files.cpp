// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/mesh_files.hpp"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <wm3d/core/error.hpp>

#include "support/streams.hpp"

namespace wm3d::cmd {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view known_formats = "obj, ply, stl, off, gltf, glb";

void add_format(CLI::App& app, MeshFiles& files) {
    if (app.get_option_no_throw("--format") != nullptr)
        return;
    app.add_option("--format", files.format, "Format of '-' and of names without a known extension")
        ->option_text("F")
        ->check(CLI::Validator(
            [](std::string& name) {
                return io::format_of_name(name) ? std::string()
                                                : fmt::format("'{}' is none of {}", name, known_formats);
            },
            "{obj,ply,stl,off,gltf,glb}"));
}

bool is_stream(const std::string& path) {
    return path == "-";
}

/// Format by the extension, or else by --format.
io::Format format_of(const std::string& path, const std::string& fallback) {
    if (!is_stream(path))
        if (const auto format = io::format_of_name(path))
            return *format;
    if (const auto format = io::format_of_name(fallback))
        return *format;
    if (is_stream(path))
        throw ParameterError(fmt::format("'-' needs a format; add --format with one of {}", known_formats));
    throw ParameterError(fmt::format(
        "{}: the extension names no known format; use one of {}, or add --format", path, known_formats));
}

} // namespace

void add_input(CLI::App& app, MeshFiles& files) {
    app.add_option("IN", files.input, "Mesh to read; '-' is standard input")->option_text("FILE")->required();
    app.add_flag("--any-size", files.any_size)->group("");
    add_format(app, files);
}

void add_output(CLI::App& app, MeshFiles& files) {
    app.add_option("-o,--output", files.output, "File to write; '-' is standard output")
        ->option_text("FILE (required)")
        ->required();
    app.add_flag("--overwrite", files.overwrite, "Replace an output that exists");
    add_format(app, files);
}

void check_target(const std::string& path, bool overwrite) {
    if (!is_stream(path))
        io::require_writable(path, {.overwrite = overwrite});
}

io::Format check_output(const MeshFiles& files, const Output& output) {
    if (is_stream(files.output) && output.json())
        throw ParameterError("--json and '-o -' both want standard output; write the mesh to a file");
    check_target(files.output, files.overwrite);
    return format_of(files.output, files.format);
}

io::Model read_mesh(const std::string& path) {
    MeshFiles files;
    files.input = path;
    return read_input(files);
}

io::Model read_input(const MeshFiles& files) {
    if (!is_stream(files.input)) {
        // A file that is missing is the better complaint than one about its extension.
        std::error_code ignored;
        if (!fs::exists(files.input, ignored) || fs::is_directory(files.input, ignored))
            io::read_file(files.input);
        return io::read(files.input,
                        {.format = format_of(files.input, files.format), .limits = files.limits()});
    }
    std::string bytes = read_standard_input();
    const auto proven = files.format.empty() ? io::format_of_content(bytes) : std::nullopt;
    const io::Format format = proven ? *proven : format_of(files.input, files.format);
    return io::parse(std::move(bytes), format, display_name(files.input), {}, files.limits());
}

void write_output(const MeshFiles& files, std::string_view bytes, Output& output) {
    if (is_stream(files.output))
        output.write_bytes(bytes);
    else
        io::write_file(files.output, bytes, {.overwrite = files.overwrite});
}

std::string display_name(const std::string& path, std::string_view stream) {
    return is_stream(path) ? std::string(stream) : path;
}

} // namespace wm3d::cmd
