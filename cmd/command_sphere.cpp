// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_sphere.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/key.hpp>
#include <wm3d/sphere.hpp>

#include "support/key_files.hpp"
#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct SphereOptions {
    MeshFiles files;
    std::string key;
    std::uint64_t seed = 1;
    unsigned level = 5;
    double rmax = 0.1;
    double radius = 1;
};

key::Secret secret_of(const SphereOptions& options, Output& output) {
    return options.key.empty() ? key::null_secret(options.seed, 0) : load_key(options.key, output).secret();
}

int run(const SphereOptions& options, Output& output) {
    const io::Format format = check_output(options.files, output);
    if (!(options.rmax < options.radius))
        throw ParameterError(
            fmt::format("--rmax {} must be below the radius of the sphere, {}; otherwise a bump could "
                        "reach through the centre",
                        options.rmax, options.radius));
    const auto heights =
        key::watermark_sequence(secret_of(options, output), options.level, options.rmax / options.radius);
    TriangleMesh mesh = sphere::BumpedSphere(sphere::Icosphere(options.level), heights).mesh();
    for (Vec3& p : mesh.positions)
        p *= options.radius;
    write_output(options.files, io::encode(mesh, format), output);
    output.say(fmt::format("Wrote the watermarking sphere, {} vertices and {} faces, to {}.",
                           mesh.positions.size(), mesh.triangles.size(),
                           display_name(options.files.output, "standard output")));
    output.print_json({{"output", options.files.output},
                       {"level", options.level},
                       {"rmax", options.rmax},
                       {"radius", options.radius},
                       {"vertices", mesh.positions.size()},
                       {"faces", mesh.triangles.size()}});
    return exit_done;
}

} // namespace

Action declare_sphere(CLI::App& app) {
    const auto options = std::make_shared<SphereOptions>();
    app.description(
        "Writes the watermarking sphere as a mesh: an icosahedron subdivided --level times, every vertex\n"
        "moved along its radius by a number between -rmax and rmax (figures 5 and 6 of the paper).\n"
        "With --key these are the key's own bumps: as secret as the key. With --seed, an experiment.");
    add_output(app, options->files);
    auto* key = app.add_option("--key", options->key, "Key file whose bumps to show")->option_text("FILE");
    app.add_option("--seed", options->seed, "Number that draws bumps without a key [1]")
        ->option_text("N")
        ->check(whole_number_between(0, std::numeric_limits<std::uint64_t>::max()))
        ->excludes(key);
    app.add_option("--level", options->level, "Subdivisions of the icosahedron, 20 * 4^level faces [5]")
        ->option_text("L")
        ->check(whole_number_between(0, sphere::max_level));
    app.add_option("--rmax", options->rmax, "Height of the bumps [0.1]")
        ->option_text("R")
        ->check(positive_number());
    app.add_option("--radius", options->radius, "Radius of the sphere [1]")
        ->option_text("R")
        ->check(positive_number());
    app.footer("Example, one of figure 6:\n  wm3d sphere -o sphere.ply --level 5 --rmax 0.2 --seed 7");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
