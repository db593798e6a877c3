// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_compare.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/metrics.hpp>

#include "support/mesh_files.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

using nlohmann::ordered_json;

struct CompareOptions {
    std::string a, b;
    std::size_t samples = metrics::Options{}.samples;
    bool no_perceptual = false;
    MeshFiles heatmap; ///< only its output
    double heatmap_top = 0;
};

/// Vertices answer each other only where both files have the same triangles between them.
const metrics::VertexFigures* corresponding(const metrics::Report& report) {
    return report.vertices && report.same_triangles ? &*report.vertices : nullptr;
}

/// What `mark --strength` means; between meshes of other triangles the surfaces' own distance stands for it.
double strength(const metrics::Report& report) {
    const metrics::VertexFigures* vertices = corresponding(report);
    return report.percent(vertices ? vertices->normal_rms : report.forward.rms);
}

std::string as_text(const CompareOptions& options, const metrics::Report& r) {
    std::string text = fmt::format("{} lies {:.4f} % of the box diagonal from {} (MRMS).\n\n",
                                   display_name(options.b), r.percent(r.mrms), display_name(options.a));
    const auto line = [&](std::string_view label, const std::string& value) {
        text += fmt::format("{:<18}{}\n", label, value);
    };
    const auto length = [&](double value) {
        return fmt::format("{:.5f} %  {:.6g}", r.percent(value), value);
    };
    line("diagonal", fmt::format("{:.6g}", r.diagonal));
    if (const metrics::VertexFigures* vertices = corresponding(r)) {
        line("vertex RMS", length(vertices->rms));
        line("vertex maximum", length(vertices->max));
        line("RMS along normal", length(vertices->normal_rms));
        line("SNR", std::isinf(vertices->snr) ? "infinite: no vertex moved"
                                              : fmt::format("{:.2f} dB", vertices->snr));
    } else
        line("vertices", "not compared: the triangles differ");
    line("MRMS", length(r.mrms));
    line("Hausdorff", length(r.hausdorff));
    line("mean distance", length(std::max(r.forward.mean, r.backward.mean)));
    line("normals", fmt::format("{:.4f} degrees apart in the mean", r.normal_deviation));
    line("area", fmt::format("{:+.5f} %", r.area_change));
    line("volume", r.volume_change ? fmt::format("{:+.5f} %", *r.volume_change) : "not closed");
    if (r.msdm2)
        line("MSDM2", fmt::format("{:.4f}; the mean of both sides {:.4f}", *r.msdm2, *r.msdm2_both));
    line("samples", fmt::format("{} and {}, {:.3f} % of the diagonal apart", r.forward.samples,
                                r.backward.samples, r.percent(r.forward.spacing)));
    return text;
}

/// JSON has no infinity.
ordered_json finite(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

ordered_json as_json(const CompareOptions& options, const metrics::Report& r) {
    const metrics::VertexFigures* vertices = corresponding(r);
    const auto of_vertices = [&](double metrics::VertexFigures::*figure) {
        return vertices ? ordered_json(r.percent(vertices->*figure)) : ordered_json();
    };
    const auto figure = [](const std::optional<double>& value) {
        return value ? ordered_json(*value) : ordered_json();
    };
    const auto side = [&](const metrics::OneSidedDistance& d) {
        return ordered_json{{"mean_percent", r.percent(d.mean)},
                            {"rms_percent", r.percent(d.rms)},
                            {"max_percent", r.percent(d.max)},
                            {"samples", d.samples},
                            {"spacing_percent", r.percent(d.spacing)}};
    };
    return {{"a", options.a},
            {"b", options.b},
            {"diagonal", r.diagonal},
            {"same_triangles", r.same_triangles},
            {"rms_percent", strength(r)},
            {"vertex_rms_percent", of_vertices(&metrics::VertexFigures::rms)},
            {"vertex_max_percent", of_vertices(&metrics::VertexFigures::max)},
            {"snr_db", vertices ? finite(vertices->snr) : ordered_json()},
            {"mrms_percent", r.percent(r.mrms)},
            {"hausdorff_percent", r.percent(r.hausdorff)},
            {"mrms", r.mrms},
            {"hausdorff", r.hausdorff},
            {"a_to_b", side(r.forward)},
            {"b_to_a", side(r.backward)},
            {"normal_deviation_degrees", r.normal_deviation},
            {"area_change_percent", r.area_change},
            {"volume_change_percent", figure(r.volume_change)},
            {"msdm2", figure(r.msdm2)},
            {"msdm2_both", figure(r.msdm2_both)}};
}

io::Format check_heatmap(const CompareOptions& options, const Output& output) {
    if (options.heatmap.output == "-")
        throw ParameterError("--heatmap '-' would mix the mesh with the figures; name a file");
    const io::Format format = check_output(options.heatmap, output);
    if (format == io::Format::stl)
        throw ParameterError("--heatmap: STL holds no colours; write a ply, obj, off, glb or gltf file");
    return format;
}

void write_heatmap(const CompareOptions& options, const TriangleMesh& a, const TriangleMesh& b,
                   io::Format format, double diagonal, Output& output) {
    const std::vector<double> distances = metrics::vertex_distances(b, metrics::SurfaceTree(a));
    const auto colours = metrics::heat_colours(distances, options.heatmap_top / 100 * diagonal);
    write_output(options.heatmap, io::encode(b, format, {.vertex_colors = colours}), output);
    output.say(fmt::format("Wrote the distances as colours to {}.", options.heatmap.output));
}

int run(const CompareOptions& options, Output& output) {
    const bool wants_heatmap = !options.heatmap.output.empty();
    const io::Format format = wants_heatmap ? check_heatmap(options, output) : io::Format::ply;
    const io::Model a = read_mesh(options.a), b = read_mesh(options.b);
    metrics::Options figures;
    figures.samples = options.samples;
    figures.perceptual = !options.no_perceptual;
    const metrics::Report report = metrics::compare(a.mesh(), b.mesh(), figures, output.progress());
    if (wants_heatmap)
        write_heatmap(options, a.mesh(), b.mesh(), format, report.diagonal, output);
    output.print(as_text(options, report));
    output.print_json(as_json(options, report));
    return exit_done;
}

} // namespace

Action declare_compare(CLI::App& app) {
    const auto options = std::make_shared<CompareOptions>();
    app.description(
        "Tells how far mesh B is from mesh A, which lies in the same place: from vertex to vertex where "
        "both\n"
        "have the same triangles, from surface to surface always (MRMS is the larger of the two one-sided\n"
        "RMS distances), and as the eye sees it (MSDM2 of B against A,\n"
        "0 to 1). Lengths are in % of A's box diagonal and "
        "in\n"
        "units of the file.");
    app.add_option("A", options->a, "Mesh to compare with, the reference")->option_text("FILE")->required();
    app.add_option("B", options->b, "Mesh to compare")->option_text("FILE")->required();
    app.add_option("--samples", options->samples,
                   "Samples on each surface, at least one per triangle [200000]")
        ->option_text("N")
        ->check(number_between(1, 1e9));
    app.add_flag("--no-perceptual", options->no_perceptual, "Leave MSDM2 out");
    auto* heatmap = app.add_option("--heatmap", options->heatmap.output,
                                   "Also write B with each vertex coloured by its distance from A")
                        ->option_text("FILE");
    app.add_option("--heatmap-top", options->heatmap_top,
                   "Distance of the last colour, % of the diagonal [the largest]")
        ->option_text("P")
        ->check(positive_number())
        ->needs(heatmap);
    app.add_flag("--overwrite", options->heatmap.overwrite, "Replace a heat map that exists")->needs(heatmap);
    app.footer("Examples:\n  wm3d compare bunny.obj marked.obj\n  wm3d compare bunny.obj marked.obj "
               "--heatmap moved.ply");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
