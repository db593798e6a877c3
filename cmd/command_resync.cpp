// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_resync.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/resync.hpp>
#include <wm3d/watermark/examination.hpp>

#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

constexpr std::size_t reference_points = 4000;

struct ResyncArguments {
    MeshFiles files;
    std::string reference, receipt;
    bool matrix = false;

    const std::string& against() const { return reference.empty() ? receipt : reference; }
};

resync::PoseTemplate template_of(const ResyncArguments& arguments, Output& output) {
    if (arguments.reference.empty())
        return resync::parse_receipt(io::read_file(arguments.receipt), arguments.receipt).in_file();
    const io::Model reference = read_mesh(arguments.reference);
    const watermark::Suspect simplified =
        watermark::simplify_suspect(reference.mesh(), watermark::default_vertices, output.progress());
    return resync::make_template(simplified.base, reference_points);
}

TriangleMesh transformed(TriangleMesh mesh, const resync::Similarity& t) {
    for (Vec3& p : mesh.positions)
        p = t(p);
    if (t.mirrors()) // keep the outside outside
        for (Triangle& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    return mesh;
}

std::string matrix_text(const resync::Similarity& t) {
    const Eigen::Matrix4d m = t.matrix();
    std::string text;
    for (int row = 0; row < 4; ++row)
        text += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", m(row, 0), m(row, 1), m(row, 2), m(row, 3));
    return text;
}

std::string figures(const resync::Similarity& t, const resync::Registration& found) {
    const Mat3 proper = t.mirrors() ? Mat3(-t.rotation) : t.rotation;
    const Eigen::AngleAxisd turn(Eigen::Quaterniond{proper});
    const Vec3& a = turn.axis();
    return fmt::format("rotation     {:.4f} degrees about ({:.6f}, {:.6f}, {:.6f}){}\n"
                       "scale        {:.8g}\n"
                       "translation  ({:.8g}, {:.8g}, {:.8g})\n"
                       "residual     {:.3g} mean radii of the reference (root mean square)\n"
                       "explained    {:.1f} % of the surface\n"
                       "confidence   {:.2f}\n",
                       turn.angle() * 180 / EIGEN_PI, a[0], a[1], a[2],
                       t.mirrors() ? ", then a reflection through the origin" : "", t.scale, t.translation[0],
                       t.translation[1], t.translation[2], found.residual, 100 * found.coverage,
                       found.confidence);
}

nlohmann::ordered_json to_json(const ResyncArguments& arguments, const resync::Similarity& t,
                               const resync::Registration& found) {
    const Eigen::Matrix4d m = t.matrix();
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back({m(row, 0), m(row, 1), m(row, 2), m(row, 3)});
    return {{"input", arguments.files.input},
            {"output", arguments.files.output},
            {"against", arguments.against()},
            {"matrix", rows},
            {"scale", t.scale},
            {"mirrored", t.mirrors()},
            {"residual", found.residual},
            {"coverage", found.coverage},
            {"confidence", found.confidence},
            {"searched", found.searched}};
}

void warn_of(const ResyncArguments& arguments, const resync::Registration& found, Output& output) {
    const std::string input = display_name(arguments.files.input);
    if (found.transform.mirrors())
        output.warn(fmt::format("{} is a mirror image of {}", input, arguments.against()));
    if (found.confidence < 0.1)
        output.warn(fmt::format("{} fits {} in clearly different poses almost equally well", input,
                                arguments.against()));
}

int run(const ResyncArguments& arguments, Output& output) {
    if (arguments.reference.empty() == arguments.receipt.empty())
        throw ParameterError("resync aligns a mesh with one thing: give either --reference or --receipt");
    const io::Format format = check_output(arguments.files, output);
    const resync::PoseTemplate against = template_of(arguments, output);
    const io::Model model = read_input(arguments.files);
    const watermark::Suspect suspect =
        watermark::simplify_suspect(model.mesh(), watermark::default_vertices, output.progress());
    const resync::Registration found =
        resync::register_template(against, suspect.base, {}, output.progress());
    if (!found.aligned)
        throw GeometryError(fmt::format("{}: it can't be aligned with {}, because the best pose explains "
                                        "{:.0f} % of its surface only; either "
                                        "it is another object, or too little of it is left",
                                        display_name(arguments.files.input), arguments.against(),
                                        100 * found.coverage));
    const resync::Similarity t = found.transform.inverse();
    write_output(arguments.files, io::encode(transformed(model.mesh(), t), format), output);
    warn_of(arguments, found, output);
    output.say(fmt::format("Aligned {} with {} and wrote {}.", display_name(arguments.files.input),
                           arguments.against(), display_name(arguments.files.output, "standard output")));
    if (arguments.files.output != "-")
        output.print(arguments.matrix ? matrix_text(t) : figures(t, found));
    output.print_json(to_json(arguments, t, found));
    return exit_done;
}

} // namespace

Action declare_resync(CLI::App& app) {
    const auto arguments = std::make_shared<ResyncArguments>();
    app.description(
        "Lays a mesh that was moved, scaled or cut back on the model it comes from, and tells the\n"
        "transform, how well it fits and how sure it is. The model is a mesh or a receipt of mark.\n"
        "Where no pose explains most of the mesh, nothing is written and the exit status is 2.");
    add_input(app, arguments->files);
    add_output(app, arguments->files);
    app.add_option("--reference", arguments->reference, "Mesh to align with: the original or the marked one")
        ->option_text("FILE");
    app.add_option("--receipt", arguments->receipt, "Receipt to align with")->option_text("FILE");
    app.add_flag("--matrix", arguments->matrix, "Print the transform as a 4x4 matrix, row by row, alone");
    app.footer("Examples:\n  wm3d resync head.ply -o aligned.ply --reference statue.ply\n"
               "  wm3d resync suspect.stl -o aligned.stl --receipt statue.receipt --matrix");
    return [arguments](Output& output) { return run(*arguments, output); };
}

} // namespace wm3d::cmd
