// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_sample.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/shapes/sample.hpp>

#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct SampleOptions {
    MeshFiles files;
    std::size_t faces = 100'000;
    std::uint64_t seed = 1;
};

int run(const SampleOptions& options, Output& output) {
    const io::Format format = check_output(options.files, output);
    output.detail(fmt::format("Shaping a ewer of about {} triangles.", options.faces));
    const TriangleMesh mesh = shapes::sample(options.faces, options.seed);
    write_output(options.files, io::encode(mesh, format), output);
    output.say(fmt::format("Wrote the sample, {} vertices and {} triangles, to {}.", mesh.positions.size(),
                           mesh.triangles.size(), display_name(options.files.output, "standard output")));
    output.print_json({{"output", options.files.output},
                       {"vertices", mesh.positions.size()},
                       {"faces", mesh.triangles.size()},
                       {"seed", options.seed}});
    return exit_done;
}

} // namespace

Action declare_sample(CLI::App& app) {
    const auto options = std::make_shared<SampleOptions>();
    app.description(
        "Writes the built-in demonstration model: a ewer on a plinth, 300 mm tall, with creases, a thin\n"
        "handle, a hollow neck and the fine relief of a scan. Made by formula; free to use anywhere.");
    add_output(app, options->files);
    app.add_option("--faces", options->faces, "Triangles, met within a few percent [100000]")
        ->option_text("N")
        ->check(whole_number_between(shapes::sample_min_faces, shapes::sample_max_faces));
    app.add_option("--seed", options->seed, "Number that draws the relief [1]")
        ->option_text("S")
        ->check(whole_number_between(0, std::numeric_limits<std::uint64_t>::max()));
    app.footer("Example:\n  wm3d sample -o ewer.ply");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
