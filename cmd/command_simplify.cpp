// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_simplify.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/simplify.hpp>

#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct SimplifyOptions {
    MeshFiles files;
    simplify::Options simplify;
};

std::string_view name_of(simplify::Stop stop) {
    switch (stop) {
    case simplify::Stop::reached:
        return "reached";
    case simplify::Stop::already_small:
        return "already_small";
    case simplify::Stop::blocked:
        return "blocked";
    }
    return "";
}

int run(const SimplifyOptions& options, Output& output) {
    const io::Format format = check_output(options.files, output);
    const TriangleMesh mesh = read_input(options.files).take_mesh();
    const simplify::Result result = simplify::simplify(mesh, options.simplify, output.progress());
    write_output(options.files, io::encode(result.mesh, format), output);
    output.say(fmt::format("Wrote {} vertices and {} triangles, of {} and {}, to {}.",
                           result.mesh.positions.size(), result.mesh.triangles.size(), mesh.positions.size(),
                           mesh.triangles.size(), display_name(options.files.output, "standard output")));
    if (result.stop != simplify::Stop::reached)
        output.warn(simplify::describe(result.stop));
    output.print_json({{"output", options.files.output},
                       {"vertices", result.mesh.positions.size()},
                       {"faces", result.mesh.triangles.size()},
                       {"input_vertices", mesh.positions.size()},
                       {"input_faces", mesh.triangles.size()},
                       {"stop", name_of(result.stop)},
                       {"error", result.error}});
    return exit_done;
}

} // namespace

Action declare_simplify(CLI::App& app) {
    const auto options = std::make_shared<SimplifyOptions>();
    app.description(
        "Simplifies a mesh to a number of vertices, each a vertex of the input at its own place: half-edge\n"
        "collapses in the order of the quadric error, as marks and verdicts use them. The topology stays:\n"
        "components, holes and handles. Only the surface is kept, no texture and no colour.");
    add_input(app, options->files);
    add_output(app, options->files);
    app.add_option("--vertices", options->simplify.target_vertices, "Vertices to keep")
        ->option_text("N (required)")
        ->required()
        ->check(whole_number_between(1, 1'000'000'000));
    app.footer("Example:\n  wm3d simplify bunny.obj -o base.ply --vertices 10000");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
