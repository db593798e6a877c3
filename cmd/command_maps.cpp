// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_maps.hpp"

#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/maps.hpp>

#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct MapsOptions {
    MeshFiles files;
    std::string base, map;
    simplify::Options simplify;
};

/// Light colours; numbers that follow each other get hues far apart (steps of the golden ratio).
io::Color colour_of(Index base_triangle) {
    const double hue = 6 * std::fmod(0.6180339887498949 * base_triangle, 1.0);
    io::Color colour{};
    for (int channel = 0; channel < 3; ++channel) {
        const double distance = std::abs(std::fmod(hue + 6 - 2 * channel, 6.0) - 3);
        colour[static_cast<std::size_t>(channel)] =
            static_cast<std::uint8_t>(std::lround(90 + 150 * std::clamp(distance - 1, 0.0, 1.0)));
    }
    return colour;
}

/// The base triangle that two corners of a triangle lie in, or else that of its first corner.
Index base_triangle_of(const Triangle& triangle, const maps::BaseDomain& domain) {
    const auto& [a, b, c] = triangle;
    return domain.point[b].triangle == domain.point[c].triangle ? domain.point[b].triangle
                                                                : domain.point[a].triangle;
}

/// The regions of figure 4: every triangle of the original in the colour of its base triangle.
std::string coloured_original(const TriangleMesh& mesh, const maps::BaseDomain& domain, io::Format format) {
    io::EncodeOptions options;
    for (const Triangle& triangle : mesh.triangles)
        options.face_colors.push_back(colour_of(base_triangle_of(triangle, domain)));
    return io::encode(mesh, format, options);
}

std::string coloured_base(const maps::BaseDomain& domain, io::Format format) {
    io::EncodeOptions options;
    for (Index t = 0; t < domain.mesh.triangles.size(); ++t)
        options.face_colors.push_back(colour_of(t));
    return io::encode(domain.mesh, format, options);
}

/// One line for every stored vertex of the file, in its order.
std::string map_as_csv(const io::Model& model, const maps::BaseDomain& domain) {
    std::string text = "vertex,base_triangle,alpha,beta,gamma\n";
    for (std::size_t slot = 0; slot < model.vertex_of_slot().size(); ++slot)
        if (const SurfacePoint& at = domain.point[model.vertex_of_slot()[slot]]; at.triangle != no_index)
            text += fmt::format("{},{},{},{},{}\n", slot, at.triangle, at.barycentric[0], at.barycentric[1],
                                at.barycentric[2]);
    return text;
}

std::string map_as_json(const io::Model& model, const maps::BaseDomain& domain) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Index vertex : model.vertex_of_slot()) {
        const SurfacePoint& at = domain.point[vertex];
        points.push_back(at.triangle == no_index
                             ? nlohmann::ordered_json()
                             : nlohmann::ordered_json{at.triangle, at.barycentric[0], at.barycentric[1],
                                                      at.barycentric[2]});
    }
    const nlohmann::ordered_json object{{"schema", "wm3d.map/1"},
                                        {"base_vertices", domain.mesh.positions.size()},
                                        {"base_faces", domain.mesh.triangles.size()},
                                        {"points", std::move(points)}};
    return object.dump() + "\n";
}

/// Formats and targets of all outputs, found out before any work.
struct Targets {
    io::Format coloured, base = io::Format::ply;
    bool map_is_json = false;
};

Targets check_targets(const MapsOptions& options, const Output& output) {
    Targets targets{.coloured = check_output(options.files, output)};
    if (!options.base.empty()) {
        MeshFiles base = options.files;
        base.output = options.base;
        targets.base = check_output(base, output);
    }
    if (!options.map.empty()) {
        check_target(options.map, options.files.overwrite);
        targets.map_is_json = options.map.ends_with(".json");
        if (!targets.map_is_json && !options.map.ends_with(".csv"))
            throw ParameterError(
                fmt::format("{}: the map is written as .csv or .json; choose one", options.map));
    }
    for (const io::Format format : {targets.coloured, targets.base})
        if (format == io::Format::obj || format == io::Format::stl)
            throw ParameterError(fmt::format(
                "{} files hold no colours of triangles; write ply, off, gltf or glb", io::name_of(format)));
    return targets;
}

int run(const MapsOptions& options, Output& output) {
    const Targets targets = check_targets(options, output);
    const io::Model model = read_input(options.files);
    const maps::BaseDomain domain = maps::parameterize(model.mesh(), options.simplify, output.progress());
    write_output(options.files, coloured_original(model.mesh(), domain, targets.coloured), output);
    if (!options.base.empty())
        io::write_file(options.base, coloured_base(domain, targets.base),
                       {.overwrite = options.files.overwrite});
    if (!options.map.empty())
        io::write_file(options.map,
                       targets.map_is_json ? map_as_json(model, domain) : map_as_csv(model, domain),
                       {.overwrite = options.files.overwrite});

    output.say(fmt::format("Mapped {} vertices to a base domain of {} vertices and {} triangles; wrote {}.",
                           model.mesh().positions.size(), domain.mesh.positions.size(),
                           domain.mesh.triangles.size(),
                           display_name(options.files.output, "standard output")));
    if (domain.stop != simplify::Stop::reached)
        output.warn(simplify::describe(domain.stop));
    output.detail(fmt::format("{} of {} relocations met a fold of the flattened ring.", domain.clamped,
                              domain.relocations));
    output.print_json({{"output", options.files.output},
                       {"vertices", model.mesh().positions.size()},
                       {"base_vertices", domain.mesh.positions.size()},
                       {"base_faces", domain.mesh.triangles.size()},
                       {"relocations", domain.relocations},
                       {"clamped", domain.clamped},
                       {"error", domain.error}});
    return exit_done;
}

} // namespace

Action declare_maps(CLI::App& app) {
    const auto options = std::make_shared<MapsOptions>();
    app.description(
        "Builds the base domain of a mesh and the MAPS map onto it (figure 4 of the paper), and writes the\n"
        "original with every triangle in the colour of its base triangle.");
    add_input(app, options->files);
    add_output(app, options->files);
    app.add_option("--vertices", options->simplify.target_vertices, "Vertices of the base domain")
        ->option_text("N (required)")
        ->required()
        ->check(whole_number_between(1, 1'000'000'000));
    app.add_option("--base", options->base, "Also write the base domain, in the same colours")
        ->option_text("FILE");
    app.add_option("--map", options->map,
                   "Also write the map, as .csv or .json: for every vertex of the file its base triangle and "
                   "barycentric coordinates there")
        ->option_text("FILE");
    app.footer("Example, figure 4:\n"
               "  wm3d maps bunny.obj -o regions.ply --base base.ply --map map.csv --vertices 252");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
