// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_attack.hpp"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/attack.hpp>

#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct AttackOptions {
    MeshFiles files;
    std::string kind;
    std::vector<std::string> more; ///< where several attacks are named: the others and, last, IN
    std::uint64_t seed = 1;
};

/// "KIND IN MORE..." as it was meant: the last is the mesh, what stands before it is a chain.
AttackOptions in_order(AttackOptions options) {
    if (options.more.empty())
        return options;
    options.kind += "+" + options.files.input;
    for (std::size_t i = 0; i + 1 < options.more.size(); ++i)
        options.kind += "+" + options.more[i];
    options.files.input = options.more.back();
    return options;
}

int run(const AttackOptions& options, Output& output) {
    const auto chain = attack::parse_chain(options.kind);
    const io::Format format = check_output(options.files, output);
    const io::Model model = read_input(options.files);
    const TriangleMesh attacked = attack::apply(model.mesh(), chain, options.seed, output.progress());
    // An attack is the stated one and no rounding beside it: doubles where the format can.
    write_output(options.files, io::encode(attacked, format, {.double_precision = true}), output);
    output.say(fmt::format("Wrote {} vertices and {} triangles, of {} and {}, after {} to {}.",
                           attacked.positions.size(), attacked.triangles.size(),
                           model.mesh().positions.size(), model.mesh().triangles.size(),
                           attack::to_string(chain), display_name(options.files.output, "standard output")));
    output.print_json({{"output", options.files.output},
                       {"attack", attack::to_string(chain)},
                       {"seed", options.seed},
                       {"vertices", attacked.positions.size()},
                       {"faces", attacked.triangles.size()},
                       {"input_vertices", model.mesh().positions.size()},
                       {"input_faces", model.mesh().triangles.size()}});
    return exit_done;
}

} // namespace

Action declare_attack(CLI::App& app) {
    const auto options = std::make_shared<AttackOptions>();
    app.description(
        "Does to a mesh what may happen to it on its way to the suspect copy, to see what a mark bears.\n"
        "KIND is an attack with its values, 'noise:0.3' or 'smoothing:30,lambda=0.2'. Several, one after\n"
        "the other or joined by '+', are done in turn. Only the surface is kept, no texture and no colour.");
    app.add_option("KIND", options->kind, "Attack, or several joined by '+'")
        ->option_text("ATTACK")
        ->required();
    add_input(app, options->files);
    app.add_option("MORE", options->more)->group("");
    add_output(app, options->files);
    app.add_option("--seed", options->seed,
                   "Number that draws what is random; the same number, the same file [1]")
        ->option_text("N");
    app.footer("Attacks and their values, in order:\n\n" + attack::describe_known_attacks() +
               "\nExamples:\n  wm3d attack noise:0.3 bunny.obj -o noisy.obj --seed 7\n"
               "  wm3d attack noise:0.1 smooth:10 similarity bunny.obj -o worn.ply\n"
               "  wm3d attack similarity+simplification:90 bunny.obj -o small.ply");
    return [options](Output& output) { return run(in_order(*options), output); };
}

} // namespace wm3d::cmd
