// SPDX-License-Identifier: GPL-3.0-or-later
#include "registry.hpp"

#include <fmt/format.h>

#include <wm3d/attack/cropping.hpp>
#include <wm3d/attack/deformation.hpp>
#include <wm3d/attack/flips.hpp>
#include <wm3d/attack/order.hpp>
#include <wm3d/attack/perturbation.hpp>
#include <wm3d/attack/resampling.hpp>
#include <wm3d/attack/smoothing.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::attack {

namespace {

using Mesh = const TriangleMesh&;
using Values = std::span<const double>;
using Seed = std::uint64_t;

int whole(double value) {
    return static_cast<int>(value);
}

Parameter real(std::string_view name, std::string_view meaning, double fallback, double min, double max) {
    return {name, meaning, Parameter::Type::real, fallback, min, max};
}

Parameter count(std::string_view name, std::string_view meaning, double fallback, double min, double max) {
    return {name, meaning, Parameter::Type::whole, fallback, min, max};
}

Parameter choice(std::string_view name, std::string_view meaning, std::vector<std::string_view> choices) {
    const auto last = static_cast<double>(choices.size() - 1);
    return {name, meaning, Parameter::Type::choice, 0, 0, last, std::move(choices)};
}

TriangleMesh run_crop(Mesh mesh, Values v, Seed seed) {
    CropOptions options{v[0], {}, v[1] != 0};
    if (const Vec3 normal{v[2], v[3], v[4]}; normal != Vec3::Zero())
        options.normal = normal;
    return crop(mesh, options, seed);
}

TriangleMesh run_shear(Mesh mesh, Values v, Seed) {
    Mat3 matrix;
    matrix << 1, v[0], v[1], 0, 1, v[2], 0, 0, 1;
    return transform(mesh, matrix);
}

TriangleMesh run_rounding(Mesh mesh, Values v, Seed) {
    const Box box = surface_box(mesh);
    const double side = (box.max - box.min).maxCoeff();
    const bool scales = v[1] > 0 && side > 0;
    return round_decimals(scales ? transform(mesh, Mat3(v[1] / side * Mat3::Identity())) : mesh, whole(v[0]));
}

/// The attacks of the published benchmark, as it defines them.
std::vector<RegistryEntry> published() {
    return {
        {{"file", "reorder", "vertices and triangles in another order, as another file format may bring", {}},
         [](Mesh m, Values, Seed s) { return reorder(m, s); }},
        {{"similarity",
          "",
          "random translation within 5 d per axis, rotation, and uniform scale from 0.1 to 10",
          {}},
         [](Mesh m, Values, Seed s) { return transform(m, random_similarity(mean_vertex_distance(m), s)); }},
        {{"noise",
          "",
          "uniform noise on each coordinate; borders kept",
          {real("amplitude", "% of d, the mean distance of a vertex to the mean vertex", 0.1, 0, 100)}},
         [](Mesh m, Values v, Seed s) { return add_noise(m, v[0], s); }},
        {{"smoothing",
          "smooth",
          "Laplacian smoothing, all vertices at once; borders kept",
          {count("steps", "number of steps", 10, 0, 100000), real("lambda", "step length", 0.1, 0, 1)}},
         [](Mesh m, Values v, Seed) { return smooth_laplacian(m, whole(v[0]), v[1]); }},
        {{"quantization",
          "quantize",
          "coordinates rounded to 2^bits steps of each axis' range",
          {count("bits", "bits per coordinate", 10, 1, 32)}},
         [](Mesh m, Values v, Seed) { return quantize(m, whole(v[0])); }},
        {{"subdivision",
          "subdivide",
          "each triangle cut in four (midpoint, loop) or three (sqrt3)",
          {choice("scheme", "scheme", {"midpoint", "sqrt3", "loop"}), count("steps", "iterations", 1, 1, 8)}},
         [](Mesh m, Values v, Seed) {
             return subdivide(m, static_cast<SubdivisionScheme>(whole(v[0])), whole(v[1]));
         }},
        {{"simplification",
          "simplify",
          "edge collapses by Lindstrom and Turk",
          {real("percent", "% of the edges removed", 50, 0.001, 99.999)}},
         [](Mesh m, Values v, Seed) { return simplify_edges(m, v[0]); }},
        {{"cropping",
          "crop",
          "what lies beyond a plane is cut off",
          {real("percent", "% of the vertices removed", 30, 0.001, 99.999),
           choice("cap", "whether the cut is closed", {"no", "yes"}),
           real("nx", "direction of the removed part; random where nx, ny, nz are all 0", 0, -1e6, 1e6),
           real("ny", "", 0, -1e6, 1e6), real("nz", "", 0, -1e6, 1e6)}},
         run_crop},
    };
}

/// What happens to models today beyond the published benchmark.
std::vector<RegistryEntry> further() {
    return {
        {{"taubin",
          "",
          "Taubin smoothing, which keeps the volume; borders kept",
          {count("steps", "pairs of steps", 10, 0, 100000), real("lambda", "shrinking factor", 0.33, 0, 1),
           real("mu", "inflating factor", -0.34, -1, 0)}},
         [](Mesh m, Values v, Seed) {
             return smooth_taubin(m, {whole(v[0]), v[1], v[2]});
         }},
        {{"flips",
          "flip",
          "random edge flips on flat parts: the same vertices, triangulated anew",
          {real("percent", "% of the edges flipped", 30, 0, 100),
           real("angle", "degrees that a flip may fold the surface", 20, 0, 90)}},
         [](Mesh m, Values v, Seed s) { return flip_random(m, v[0], s, {v[1]}).mesh; }},
        {{"delaunay",
          "",
          "edge flips towards the Delaunay triangulation",
          {real("angle", "degrees that a flip may fold the surface", 20, 0, 90)}},
         [](Mesh m, Values v, Seed) { return flip_delaunay(m, {v[0]}).mesh; }},
        {{"remeshing",
          "remesh",
          "isotropic remeshing: new vertices on the same surface",
          {real("factor", "target edge length in mean edge lengths", 1, 0.1, 100),
           count("iterations", "iterations", 3, 1, 100)}},
         [](Mesh m, Values v, Seed) {
             return remesh_isotropic(m, {v[0], whole(v[1])});
         }},
        {{"voxels",
          "",
          "re-extraction from a signed distance field on a grid",
          {count("resolution", "voxels across the longest side of the box", 256, 8, 4096)},
          has_voxels()},
         [](Mesh m, Values v, Seed) { return extract_voxels(m, whole(v[0])); }},
        {{"scale",
          "",
          "non-uniform scale along the axes of the file",
          {real("x", "factor", 1, 0.001, 1000), real("y", "factor", 1, 0.001, 1000),
           real("z", "factor", 1, 0.001, 1000)}},
         [](Mesh m, Values v, Seed) { return transform(m, Mat3(Vec3(v[0], v[1], v[2]).asDiagonal())); }},
        {{"shear",
          "",
          "x += xy y + xz z, y += yz z",
          {real("xy", "share of y that x gains", 0.05, -10, 10),
           real("xz", "share of z that x gains", 0, -10, 10),
           real("yz", "share of z that y gains", 0, -10, 10)}},
         run_shear},
        {{"bend",
          "",
          "the longest side of the box bent into an arc",
          {real("degrees", "angle of the arc", 5, -90, 90)}},
         [](Mesh m, Values v, Seed) { return bend(m, v[0]); }},
        {{"rounding",
          "round",
          "coordinates rounded to decimals, as text formats do",
          {count("decimals", "digits after the point", 3, -6, 15),
           real("size", "longest side of the box that the model is scaled to before; 0: as it is", 0, 0,
                1e9)}},
         run_rounding},
    };
}

} // namespace

const std::vector<RegistryEntry>& registry() {
    static const std::vector<RegistryEntry> entries = [] {
        std::vector<RegistryEntry> all = published();
        std::vector<RegistryEntry> beyond = further();
        for (RegistryEntry& entry : beyond)
            all.push_back(std::move(entry));
        return all;
    }();
    return entries;
}

const RegistryEntry& find_entry(std::string_view name) {
    for (const RegistryEntry& entry : registry())
        if (!name.empty() && (entry.info.name == name || entry.info.alias == name))
            return entry;
    std::string known;
    for (const RegistryEntry& entry : registry())
        known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.info.name);
    throw ParameterError(fmt::format("unknown attack \"{}\"; the known attacks are {}", name, known));
}

} // namespace wm3d::attack
