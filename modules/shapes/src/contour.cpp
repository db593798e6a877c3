// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/contour.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <Eigen/Eigenvalues>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

namespace wm3d::shapes {

namespace {

/// Cubes per side of a block that is skipped as a whole when the surface can't reach it.
constexpr std::size_t block_cells = 8;

struct Grid {
    Vec3 origin;
    double cell;
    std::array<std::size_t, 3> points; ///< grid points along x, y, z

    Vec3 at(std::size_t i, std::size_t j, std::size_t k) const {
        return origin + cell * Vec3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
    }
    std::size_t layer_size() const { return points[0] * points[1]; }
};

Grid make_grid(const Box& box, double cell) {
    if (!(cell > 0))
        throw ParameterError("the cell of a contour must be above 0");
    Grid grid{box.min, cell, {}};
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double count = std::ceil((box.max[axis] - box.min[axis]) / cell) + 1;
        cells *= count;
        grid.points[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(count);
    }
    if (!(cells < 0x1p40))
        throw ParameterError("the cell of a contour is too small for the box; take a larger one");
    return grid;
}

/// Values of the solid on one layer of grid points. Blocks far from the surface get one value for all.
class LayerSampler {
public:
    LayerSampler(const Solid& solid, const Grid& grid) : solid_(solid), grid_(grid) {
        for (int axis = 0; axis < 2; ++axis)
            blocks_[axis] = (grid.points[axis] + block_cells - 1) / block_cells;
    }

    std::vector<double> layer(std::size_t k) {
        if (k % block_cells == 0 || block_values_.empty())
            sample_blocks(k / block_cells);
        // No point of a block is further from its centre than this; the slope of the solid may be as low as a
        // half.
        const double reach = 2 * 0.5 * std::sqrt(3.0) * static_cast<double>(block_cells) * grid_.cell;
        std::vector<double> values(grid_.layer_size());
        parallel_blocks(grid_.points[1], 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j)
                for (std::size_t i = 0; i < grid_.points[0]; ++i) {
                    const double far = block_values_[j / block_cells * blocks_[0] + i / block_cells];
                    values[j * grid_.points[0] + i] = std::abs(far) > reach ? far : solid_(grid_.at(i, j, k));
                }
        });
        return values;
    }

private:
    void sample_blocks(std::size_t slab) {
        block_values_.resize(blocks_[0] * blocks_[1]);
        const Vec3 half = Vec3::Constant(0.5 * static_cast<double>(block_cells) * grid_.cell);
        parallel_blocks(blocks_[1], 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j)
                for (std::size_t i = 0; i < blocks_[0]; ++i)
                    block_values_[j * blocks_[0] + i] =
                        solid_(grid_.at(i * block_cells, j * block_cells, slab * block_cells) + half);
        });
    }

    const Solid& solid_;
    const Grid& grid_;
    std::array<std::size_t, 2> blocks_{};
    std::vector<double> block_values_;
};

/// An edge of the grid that the surface crosses: its lower end and direction, and which end is inside.
struct Crossing {
    std::array<std::size_t, 3> point;
    std::size_t axis;
    bool starts_inside;
};

std::vector<Crossing> find_crossings(const Solid& solid, const Grid& grid) {
    LayerSampler sampler(solid, grid);
    std::vector<Crossing> crossings;
    std::vector<double> above = sampler.layer(0);
    for (std::size_t k = 0; k + 1 < grid.points[2]; ++k) {
        const std::vector<double> values = std::move(above);
        above = sampler.layer(k + 1);
        for (std::size_t j = 0; j + 1 < grid.points[1]; ++j)
            for (std::size_t i = 0; i + 1 < grid.points[0]; ++i) {
                const std::size_t at = j * grid.points[0] + i;
                const bool inside = values[at] < 0;
                const std::array<bool, 3> ends{values[at + 1] < 0, values[at + grid.points[0]] < 0,
                                               above[at] < 0};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (ends[axis] != inside)
                        crossings.push_back({{i, j, k}, axis, inside});
            }
    }
    return crossings;
}

Vec3 gradient(const Solid& solid, const Vec3& p, double step) {
    Vec3 g;
    for (int axis = 0; axis < 3; ++axis)
        g[axis] = (solid(p + step * Vec3::Unit(axis)) - solid(p - step * Vec3::Unit(axis))) / (2 * step);
    return g;
}

/// Where the solid's sign changes between a (value below 0 or not) and b, by bisection.
Vec3 crossing_point(const Solid& solid, Vec3 a, Vec3 b) {
    const bool inside = solid(a) < 0;
    for (int step = 0; step < 20; ++step) {
        const Vec3 middle = 0.5 * (a + b);
        ((solid(middle) < 0) == inside ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

/// Sums over the crossings of a cube: of points and of the quadrics of their tangent planes.
struct CellSums {
    Vec3 point = Vec3::Zero();
    Mat3 normals = Mat3::Zero(); ///< sum of n n^T
    Vec3 offsets = Vec3::Zero(); ///< sum of n (n . p)
    double count = 0;
    Vec3 corner = Vec3::Zero(); ///< lower corner of the cube
};

struct CellVertex {
    Vec3 position;
    bool crease;
};

/// The point nearest to all tangent planes; directions the planes say nothing about keep the mean of the
/// crossings.
CellVertex place_vertex(const CellSums& sums, const Grid& grid, double crease_threshold) {
    const Vec3 mean = sums.point / sums.count;
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(sums.normals);
    const Vec3& values = eigen.eigenvalues();
    const Vec3 residual = sums.offsets - sums.normals * mean;
    Vec3 shift = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
        if (values[i] > crease_threshold * values[2])
            shift += eigen.eigenvectors().col(i) * (eigen.eigenvectors().col(i).dot(residual) / values[i]);
    const Vec3 position =
        (mean + shift).cwiseMax(sums.corner).cwiseMin(sums.corner + Vec3::Constant(grid.cell));
    return {position, values[1] > crease_threshold * values[2]};
}

/// One of the four cubes around a crossing, and the crossing's edge as the cube sees it.
struct CubeEdge {
    std::size_t cube;                 ///< number of the cube in the grid
    std::size_t crossing;             ///< number of the crossing
    std::size_t turn;                 ///< quarter turns around the crossing's edge
    std::array<std::size_t, 2> faces; ///< of the six sides of the cube, those that meet in the edge
    std::size_t inside_corner;        ///< of the eight corners, the edge's end inside the solid
};

CubeEdge cube_edge(const Grid& grid, const Crossing& crossing, std::size_t number, std::size_t turn) {
    // Around the edge, counter-clockwise seen from its upper end, the cubes lie at (-,-), (+,-), (+,+),
    // (-,+).
    const std::size_t u = (crossing.axis + 1) % 3, v = (crossing.axis + 2) % 3;
    const std::size_t du = turn == 0 || turn == 3, dv = turn == 0 || turn == 1;
    std::array<std::size_t, 3> cube = crossing.point;
    cube[u] -= du;
    cube[v] -= dv;
    const std::size_t corner = du << u | dv << v | std::size_t{!crossing.starts_inside} << crossing.axis;
    return {(cube[2] * grid.points[1] + cube[1]) * grid.points[0] + cube[0],
            number,
            turn,
            {2 * u + du, 2 * v + dv},
            corner};
}

/// Whether two crossed edges of a cube belong to the same sheet on a side of it: its only two, or, of four,
/// two that end in the same inside corner. The neighbour behind the side decides the same way.
bool joined(const CubeEdge& a, const CubeEdge& b, std::span<const CubeEdge> edges) {
    for (const std::size_t face : a.faces) {
        if (face != b.faces[0] && face != b.faces[1])
            continue;
        const auto on_face = std::ranges::count_if(
            edges, [&](const CubeEdge& e) { return e.faces[0] == face || e.faces[1] == face; });
        if (on_face == 2 || a.inside_corner == b.inside_corner)
            return true;
    }
    return false;
}

/// The parts of the surface in one cube.
struct Sheets {
    std::size_t count = 0;
    std::vector<std::size_t> of_edge; ///< numbers from 0, in the order of the cube's crossed edges
};

Sheets find_sheets(std::span<const CubeEdge> edges) {
    std::size_t count = 0;
    std::vector<std::size_t> sheet(edges.size(), edges.size());
    for (std::size_t first = 0; first < edges.size(); ++first) {
        if (sheet[first] != edges.size())
            continue;
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t a = open.back();
            open.pop_back();
            sheet[a] = count;
            for (std::size_t b = 0; b < edges.size(); ++b)
                if (sheet[b] == edges.size() && joined(edges[a], edges[b], edges))
                    open.push_back(b);
        }
        ++count;
    }
    return {count, std::move(sheet)};
}

using Quad = std::array<Index, 4>;

struct Surface {
    std::vector<CellVertex> vertices;
    std::vector<Quad> quads;
};

using Hermite = std::array<Vec3, 2>; ///< point and unit normal of a crossing

/// One vertex for every sheet of a cube, entered into the quads of the sheet's crossings.
void add_vertices(std::span<const CubeEdge> edges, const std::vector<Hermite>& hermite, const Grid& grid,
                  const ContourOptions& options, Surface& surface) {
    const auto [count, sheet] = find_sheets(edges);
    const std::size_t cube = edges.front().cube;
    const auto first = static_cast<Index>(surface.vertices.size());
    std::vector<CellSums> sums(count);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto& [p, n] = hermite[edges[e].crossing];
        CellSums& sum = sums[sheet[e]];
        sum.point += p;
        sum.normals += n * n.transpose();
        sum.offsets += n * n.dot(p);
        sum.count += 1;
        surface.quads[edges[e].crossing][edges[e].turn] = first + static_cast<Index>(sheet[e]);
    }
    for (CellSums& sum : sums) {
        sum.corner =
            grid.at(cube % grid.points[0], cube / grid.points[0] % grid.points[1], cube / grid.layer_size());
        surface.vertices.push_back(place_vertex(sum, grid, options.crease_threshold));
    }
}

/// The four cubes of every crossing, ordered by cube.
std::vector<CubeEdge> edges_by_cube(const Grid& grid, const std::vector<Crossing>& crossings) {
    std::vector<CubeEdge> edges;
    edges.reserve(4 * crossings.size());
    for (std::size_t c = 0; c < crossings.size(); ++c)
        for (std::size_t turn = 0; turn < 4; ++turn)
            edges.push_back(cube_edge(grid, crossings[c], c, turn));
    std::ranges::stable_sort(edges, {}, &CubeEdge::cube);
    return edges;
}

Surface build_surface(const Solid& solid, const Grid& grid, const ContourOptions& options) {
    std::vector<Crossing> crossings = find_crossings(solid, grid);
    // A surface that leaves through the lower sides of the box has no cubes there.
    std::erase_if(crossings, [](const Crossing& c) {
        return c.point[(c.axis + 1) % 3] == 0 || c.point[(c.axis + 2) % 3] == 0;
    });
    std::vector<Hermite> hermite(crossings.size());
    parallel_blocks(crossings.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const auto [i, j, k] = crossings[c].point;
            const Vec3 a = grid.at(i, j, k);
            const Vec3 p =
                crossing_point(solid, a, a + grid.cell * Vec3::Unit(static_cast<int>(crossings[c].axis)));
            hermite[c] = {p, gradient(solid, p, 1e-3 * grid.cell).normalized()};
        }
    });

    Surface surface;
    const std::vector<CubeEdge> edges = edges_by_cube(grid, crossings);
    surface.quads.resize(crossings.size());
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end].cube == edges[begin].cube)
            ++end;
        add_vertices({&edges[begin], end - begin}, hermite, grid, options, surface);
    }
    for (std::size_t c = 0; c < crossings.size(); ++c)
        if (!crossings[c].starts_inside)
            std::swap(surface.quads[c][1], surface.quads[c][3]);
    return surface;
}

/// One Newton step to the surface, never further than a cell.
Vec3 project(const Solid& solid, const Vec3& p, double cell) {
    const double value = solid(p);
    const Vec3 g = gradient(solid, p, 1e-3 * cell);
    const double slope = g.squaredNorm();
    if (!(slope > 1e-6))
        return p;
    const Vec3 step = -value / slope * g;
    return p + step * std::min(1.0, cell / std::max(step.norm(), 1e-300));
}

/// Moves every vertex off the creases half the way to the mean of its neighbours, along the surface.
void relax(const Solid& solid, double cell, Surface& surface) {
    std::vector<Vec3> sum(surface.vertices.size(), Vec3::Zero());
    std::vector<double> count(surface.vertices.size(), 0);
    for (const Quad& quad : surface.quads)
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (const std::size_t next : {(corner + 1) % 4, (corner + 3) % 4}) {
                sum[quad[corner]] += surface.vertices[quad[next]].position;
                count[quad[corner]] += 1;
            }
    parallel_blocks(surface.vertices.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            if (CellVertex& vertex = surface.vertices[v]; !vertex.crease)
                vertex.position = project(solid, 0.5 * (vertex.position + sum[v] / count[v]), cell);
    });
}

/// Cuts every quad along the diagonal that lies on a crease, or else the shorter one.
TriangleMesh triangulate(const Surface& surface) {
    TriangleMesh mesh;
    for (const CellVertex& vertex : surface.vertices)
        mesh.positions.push_back(vertex.position);
    for (const Quad& q : surface.quads) {
        const auto crease = [&](std::size_t a, std::size_t b) {
            return surface.vertices[q[a]].crease && surface.vertices[q[b]].crease;
        };
        const auto length = [&](std::size_t a, std::size_t b) {
            return (mesh.positions[q[a]] - mesh.positions[q[b]]).squaredNorm();
        };
        const bool first = crease(0, 2) != crease(1, 3) ? crease(0, 2) : length(0, 2) <= length(1, 3);
        if (first) {
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
        } else {
            mesh.triangles.push_back({q[0], q[1], q[3]});
            mesh.triangles.push_back({q[1], q[2], q[3]});
        }
    }
    return mesh;
}

} // namespace

TriangleMesh contour(const Solid& solid, const Box& box, const ContourOptions& options) {
    const Grid grid = make_grid(box, options.cell);
    Surface surface = build_surface(solid, grid, options);
    for (int sweep = 0; sweep < options.relaxation_sweeps; ++sweep)
        relax(solid, grid.cell, surface);
    return triangulate(surface);
}

} // namespace wm3d::shapes
