// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_info.hpp"

#include <cmath>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/mesh.hpp>

#include "support/mesh_files.hpp"

namespace wm3d::cmd {

namespace {

using nlohmann::ordered_json;

/// The canonical frame, and how far its axes are from being exchangeable.
struct FrameFacts {
    Frame frame;
    Vec3 deviations; ///< standard deviations of the surface along the axes, descending, in units of the mesh

    /// Part by which each axis is longer than the next, 0 where they can't be told apart.
    double gap(int axis) const { return 1 - deviations[axis + 1] / deviations[axis]; }
};

struct Facts {
    io::Format format;
    std::size_t vertices, triangles, stored_vertices;
    Topology topology;
    Box box;
    double area, coordinate_step;
    std::optional<double> volume;
    std::optional<FrameFacts> frame;
};

Facts inspect(const io::Model& model) {
    const TriangleMesh& mesh = model.mesh();
    Facts facts{.format = model.format(),
                .vertices = mesh.positions.size(),
                .triangles = mesh.triangles.size(),
                .stored_vertices = model.vertex_of_slot().size(),
                .topology = inspect_topology(mesh),
                .box = surface_box(mesh),
                .area = surface_area(mesh),
                .coordinate_step = model.coordinate_step(),
                .volume = {},
                .frame = {}};
    if (facts.topology.closed() && facts.triangles > 0)
        facts.volume = enclosed_volume(mesh);
    if (facts.area > 0) {
        const ShapeMoments moments = shape_moments(mesh);
        const CentralMoments central = moments.of(moments.substance());
        const Eigen::SelfAdjointEigenSolver<Mat3> eigen(central.covariance);
        const Vec3 ascending = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
        facts.frame = {principal_frame(mesh, central), ascending.reverse()};
    }
    return facts;
}

/// What somebody who wants to mark this mesh should know.
std::vector<std::string> notes(const Facts& facts) {
    std::vector<std::string> notes;
    const Topology& t = facts.topology;
    if (!facts.frame)
        notes.emplace_back("The surface has no area, so it can't be marked.");
    else if (facts.frame->gap(0) < 0.02 || facts.frame->gap(1) < 0.02)
        notes.emplace_back("Two principal axes are nearly equal: verify searches all turns of a copy, which "
                           "takes it a few seconds.");
    if (facts.frame && facts.coordinate_step > 1e-4 * facts.box.diagonal())
        notes.emplace_back("The file's coordinates are coarse: a weak mark would be lost in their rounding.");
    if (t.non_manifold_edges + t.misoriented_edges > 0)
        notes.emplace_back("Some edges are no manifold; their vertices stay in the coarse mesh.");
    if (t.components > 1)
        notes.emplace_back(
            fmt::format("The surface has {} parts; all of them carry the mark.", t.components));
    return notes;
}

std::string sentence(const std::string& name, const Facts& facts) {
    const Topology& t = facts.topology;
    if (facts.triangles == 0)
        return fmt::format("{} holds no surface: all its faces are single points or lines.\n", name);
    const std::string_view kind = t.closed()             ? "a closed surface"
                                  : t.boundary_edges > 0 ? "an open surface"
                                                         : "a surface without boundary that is no manifold";
    return fmt::format("{} holds {} of {} triangles in {} part{}.\n", name, kind, facts.triangles,
                       t.components, t.components == 1 ? "" : "s");
}

std::string triple(const Vec3& v) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", v.x(), v.y(), v.z());
}

std::string as_text(const std::string& name, const Facts& facts) {
    std::string text = sentence(name, facts) + "\n";
    const auto line = [&](std::string_view label, const std::string& value) {
        text += fmt::format("{:<20}{}\n", label, value);
    };
    const Topology& t = facts.topology;
    line("format", std::string(io::name_of(facts.format)));
    line("vertices", fmt::format("{} ({} stored, {} isolated)", facts.vertices, facts.stored_vertices,
                                 t.isolated_vertices));
    line("triangles", fmt::format("{} ({} degenerate)", facts.triangles, t.degenerate_triangles));
    line("boundary loops", fmt::format("{} ({} edges)", t.boundary_loops, t.boundary_edges));
    line("non-manifold edges", fmt::format("{} ({} misoriented)", t.non_manifold_edges, t.misoriented_edges));
    line("box", fmt::format("{} to {}, diagonal {:.6g}", triple(facts.box.min), triple(facts.box.max),
                            facts.box.diagonal()));
    line("area", fmt::format("{:.6g}", facts.area));
    line("volume", facts.volume ? fmt::format("{:.6g}", *facts.volume) : "not closed");
    line("coordinate step", fmt::format("{:.3g}", facts.coordinate_step));
    if (facts.frame) {
        line("centroid", triple(facts.frame->frame.centroid));
        line("mean radius", fmt::format("{:.6g}", facts.frame->frame.scale));
        line("spread along axes",
             fmt::format("{}, gaps {:.0f} % and {:.0f} %", triple(facts.frame->deviations),
                         100 * facts.frame->gap(0), 100 * facts.frame->gap(1)));
    }
    for (const std::string& note : notes(facts))
        text += fmt::format("\n{}\n", note);
    return text;
}

ordered_json list(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

ordered_json as_json(const std::string& input, const Facts& facts) {
    const Topology& t = facts.topology;
    ordered_json object{{"input", input},
                        {"format", io::name_of(facts.format)},
                        {"vertices", facts.vertices},
                        {"stored_vertices", facts.stored_vertices},
                        {"faces", facts.triangles},
                        {"components", t.components},
                        {"boundary_loops", t.boundary_loops},
                        {"boundary_edges", t.boundary_edges},
                        {"non_manifold_edges", t.non_manifold_edges},
                        {"misoriented_edges", t.misoriented_edges},
                        {"isolated_vertices", t.isolated_vertices},
                        {"degenerate_faces", t.degenerate_triangles},
                        {"euler_characteristic", t.euler_characteristic},
                        {"closed", t.closed()},
                        {"box", {{"min", list(facts.box.min)}, {"max", list(facts.box.max)}}},
                        {"diagonal", facts.box.diagonal()},
                        {"area", facts.area},
                        {"volume", facts.volume ? ordered_json(*facts.volume) : ordered_json()},
                        {"coordinate_step", facts.coordinate_step}};
    if (facts.frame) {
        ordered_json axes = ordered_json::array();
        for (int row = 0; row < 3; ++row)
            axes.push_back(list(facts.frame->frame.axes.row(row)));
        object["frame"] = {{"centroid", list(facts.frame->frame.centroid)},
                           {"scale", facts.frame->frame.scale},
                           {"axes", std::move(axes)},
                           {"deviations", list(facts.frame->deviations)},
                           {"gaps", {facts.frame->gap(0), facts.frame->gap(1)}}};
    } else
        object["frame"] = nullptr;
    object["notes"] = notes(facts);
    return object;
}

int run(const MeshFiles& files, Output& output) {
    const Facts facts = inspect(read_input(files));
    output.print(as_text(display_name(files.input), facts));
    output.print_json(as_json(files.input, facts));
    return exit_done;
}

} // namespace

Action declare_info(CLI::App& app) {
    const auto files = std::make_shared<MeshFiles>();
    app.description("Tells what a mesh file holds: counts, holes, places where it is no manifold, size, the "
                    "precision of\n"
                    "its coordinates and its canonical frame. Positions that coincide count as one vertex.");
    add_input(app, *files);
    app.footer("Examples:\n  wm3d info bunny.obj\n  wm3d info scan.ply --json");
    return [files](Output& output) { return run(*files, output); };
}

} // namespace wm3d::cmd
