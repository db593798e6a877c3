// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a mesh, or of an original beside its marked copy: for docs/visibility.md and for whoever wants
// to see.
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <wm3d/core.hpp>
#include <wm3d/io.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/metrics.hpp>
#include <wm3d/picture.hpp>

using namespace wm3d;

namespace {

struct Arguments {
    std::string mesh, marked, output;
    std::vector<double> view{0, -1, 0.15}, up{0, 0, 1}, spot{0, 0}, light{-0.77, 0.58, 0.26};
    double zoom = 6;
    double top = 0;
    std::size_t size = 300;
    bool flat = false;
};

Vec3 vector(const std::vector<double>& v) {
    return {v[0], v[1], v[2]};
}

/// Signed moves along the normals: blue inwards, white none, red outwards, full at `top` % of the diagonal.
std::vector<picture::Rgb> move_colours(const TriangleMesh& original, const TriangleMesh& marked,
                                       double& top) {
    if (original.positions.size() != marked.positions.size())
        throw ParameterError("the difference can only be drawn between meshes of the same vertices");
    const std::vector<Vec3> normals = vertex_normals(original);
    const double percent = surface_box(original).diagonal() / 100;
    std::vector<double> moves;
    double largest = 0;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        moves.push_back(normals[v].dot(marked.positions[v] - original.positions[v]) / percent);
        largest = std::max(largest, std::abs(moves.back()));
    }
    if (!(top > 0))
        top = largest;
    std::vector<picture::Rgb> colours;
    for (double move : moves) {
        const double share = top > 0 ? std::clamp(move / top, -1.0, 1.0) : 0;
        const auto rest = static_cast<std::uint8_t>(255 * (1 - std::abs(share)));
        colours.push_back(share > 0 ? picture::Rgb{255, rest, rest} : picture::Rgb{rest, rest, 255});
    }
    return colours;
}

int run(Arguments& a) {
    const TriangleMesh original = io::read(a.mesh).mesh();
    const picture::Camera whole = picture::frame(original, vector(a.view), vector(a.up));
    const picture::Camera detail = picture::close_up(whole, a.spot[0], a.spot[1], a.zoom);
    picture::RenderOptions options;
    options.width = options.height = a.size;
    options.smooth = !a.flat;
    options.light = vector(a.light);
    if (a.marked.empty()) {
        picture::write_png(a.output, picture::beside({picture::render(original, whole, options),
                                                      picture::render(original, detail, options)}));
        return 0;
    }
    const TriangleMesh marked = io::read(a.marked).mesh();
    std::vector<picture::Image> row;
    for (const picture::Camera& camera : {whole, detail})
        for (const TriangleMesh* mesh : {&original, &marked})
            row.push_back(picture::render(*mesh, camera, options));
    std::cout << "whole:  RMS difference " << picture::rms_difference(row[0], row[1]) << " of 255, largest "
              << picture::largest_difference(row[0], row[1]) << "\ndetail: RMS difference "
              << picture::rms_difference(row[2], row[3]) << " of 255, largest "
              << picture::largest_difference(row[2], row[3]) << "\n";
    const std::vector<picture::Rgb> colours = move_colours(original, marked, a.top);
    options.vertex_colours = colours;
    options.ambient = 0.5;
    options.headlight = 0.5;
    row.push_back(picture::render(original, whole, options));
    std::cout << "full colour at " << a.top << " % of the diagonal\n";
    picture::write_png(a.output, picture::beside(row));
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    Arguments a;
    CLI::App app("Draws MESH whole and a detail of it, under raking light. With a marked copy: both whole, "
                 "both details, and the "
                 "moves along the normals (red outwards, blue inwards).");
    app.add_option("MESH", a.mesh)->required();
    app.add_option("MARKED", a.marked);
    app.add_option("-o", a.output, "PNG to write")->required();
    app.add_option("--view", a.view, "Direction to the viewer, x,y,z")->delimiter(',')->expected(3);
    app.add_option("--up", a.up, "Upwards, x,y,z")->delimiter(',')->expected(3);
    app.add_option("--spot", a.spot, "Middle of the detail, -1 to 1 to the right and upwards")
        ->delimiter(',')
        ->expected(2);
    app.add_option("--zoom", a.zoom, "Of the detail [6]");
    app.add_option("--light", a.light, "Direction to the light as the viewer sees it: right, up, nearer")
        ->delimiter(',')
        ->expected(3);
    app.add_option("--top", a.top, "Move of the fullest colour, % of the diagonal [the largest]");
    app.add_option("--size", a.size, "Pixels of each side of a part [300]");
    app.add_flag("--flat", a.flat, "Show the facets");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(a);
    } catch (const std::exception& e) {
        std::cerr << "render: " << e.what() << "\n";
        return 2;
    }
}
