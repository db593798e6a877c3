// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/pieces.hpp>

#include <algorithm>
#include <map>
#include <numeric>

#include <wm3d/mesh/measure.hpp>

namespace wm3d::watermark {

namespace {

/// Disjoint sets of numbers, with path halving.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
    Index of(Index v) {
        while (parent_[v] != v)
            v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void join(Index a, Index b) {
        const Index first = of(a), second = of(b);
        parent_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<Index> parent_;
};

struct Part {
    std::vector<Index> triangles;
    double area = 0;
    Box box;
};

bool touch(const Box& a, const Box& b, double part) {
    const double gap = part * std::min(a.diagonal(), b.diagonal());
    return ((a.min.array() <= b.max.array() + gap) && (b.min.array() <= a.max.array() + gap)).all();
}

void add(Part& to, const Part& from) {
    to.triangles.insert(to.triangles.end(), from.triangles.begin(), from.triangles.end());
    to.area += from.area;
    to.box.min = to.box.min.cwiseMin(from.box.min);
    to.box.max = to.box.max.cwiseMax(from.box.max);
}

/// Sets of triangles that vertices join, the largest first.
std::vector<Part> connected_parts(const TriangleMesh& mesh) {
    Sets sets(mesh.positions.size());
    for (const Triangle& t : mesh.triangles) {
        sets.join(t[0], t[1]);
        sets.join(t[0], t[2]);
    }
    const std::vector<double> area = triangle_areas(mesh);
    std::map<Index, Part> parts;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Vec3& first = mesh.positions[mesh.triangles[f][0]];
        Part& part =
            parts.try_emplace(sets.of(mesh.triangles[f][0]), Part{{}, 0, {first, first}}).first->second;
        part.triangles.push_back(static_cast<Index>(f));
        part.area += area[f];
        for (const Index v : mesh.triangles[f]) {
            part.box.min = part.box.min.cwiseMin(mesh.positions[v]);
            part.box.max = part.box.max.cwiseMax(mesh.positions[v]);
        }
    }
    std::vector<Part> sorted;
    for (auto& [vertex, part] : parts)
        sorted.push_back(std::move(part));
    std::ranges::stable_sort(sorted, std::greater{}, &Part::area);
    return sorted;
}

/// Parts whose boxes touch, joined. Boxes of what was joined before count as one, so one round does not find
/// all; small parts join large ones first.
std::vector<Part> groups(const std::vector<Part>& parts, double touching) {
    std::vector<Part> groups;
    for (const Part& part : parts) {
        const auto near = [&](const Part& group) { return touch(group.box, part.box, touching); };
        if (const auto found = std::ranges::find_if(groups, near); found != groups.end())
            add(*found, part);
        else
            groups.push_back(part);
    }
    return groups;
}

TriangleMesh extracted(const TriangleMesh& mesh, const std::vector<Index>& triangles) {
    TriangleMesh piece;
    std::vector<Index> number(mesh.positions.size(), no_index);
    for (const Index f : triangles) {
        Triangle t = mesh.triangles[f];
        for (Index& v : t) {
            if (number[v] == no_index) {
                number[v] = static_cast<Index>(piece.positions.size());
                piece.positions.push_back(mesh.positions[v]);
            }
            v = number[v];
        }
        piece.triangles.push_back(t);
    }
    return piece;
}

/// More parts than this are a cloud of triangles, or a scan's dust: only the largest can be models.
constexpr std::size_t most_parts = 256;

} // namespace

std::vector<TriangleMesh> pieces(const TriangleMesh& mesh, const PieceOptions& options) {
    std::vector<Part> parts = connected_parts(mesh);
    if (parts.size() < 2)
        return {};
    const double whole = std::accumulate(parts.begin(), parts.end(), 0.0,
                                         [](double sum, const Part& part) { return sum + part.area; });
    if (parts.size() > most_parts)
        parts.resize(most_parts);
    std::vector<Part> all = groups(parts, options.touch);
    for (Part& group : all)
        std::ranges::sort(group.triangles);
    all.insert(all.end(), parts.begin(), parts.end());
    std::erase_if(all, [&](const Part& part) {
        return part.area < options.least_area * whole || part.triangles.size() == mesh.triangles.size();
    });
    std::ranges::stable_sort(all, std::greater{}, &Part::area);
    std::vector<TriangleMesh> result;
    for (std::size_t k = 0; k < all.size() && result.size() < options.most; ++k) {
        const auto same = [&](const Part& other) { return other.triangles == all[k].triangles; };
        if (std::find_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k), same) ==
            all.begin() + static_cast<std::ptrdiff_t>(k))
            result.push_back(extracted(mesh, all[k].triangles));
    }
    return result;
}

LargestParts largest_parts(TriangleMesh mesh, std::size_t most_vertices) {
    std::vector<Part> parts = connected_parts(mesh);
    const auto hangs_together = [](const Part& part) { return part.triangles.size() > 1; };
    const auto area_of = [&](auto first, auto last) {
        return std::accumulate(first, last, 0.0, [&](double sum, const Part& part) {
            return hangs_together(part) ? sum + part.area : sum;
        });
    };
    const double whole = surface_area(mesh);
    if (mesh.positions.size() <= most_vertices)
        return {std::move(mesh), whole > 0 ? area_of(parts.begin(), parts.end()) / whole : 0};
    std::stable_partition(parts.begin(), parts.end(), hangs_together);
    if (!parts.empty() && hangs_together(parts.front()))
        std::erase_if(parts, std::not_fn(hangs_together));
    std::vector<Index> triangles;
    std::vector<bool> used(mesh.positions.size(), false);
    std::size_t vertices = 0, count = 0;
    for (; count < parts.size() && vertices < most_vertices; ++count)
        for (const Index f : parts[count].triangles) {
            triangles.push_back(f);
            for (const Index v : mesh.triangles[f]) {
                vertices += used[v] ? 0 : 1;
                used[v] = true;
            }
        }
    std::ranges::sort(triangles);
    const auto end = parts.begin() + static_cast<std::ptrdiff_t>(count);
    return {extracted(mesh, triangles), whole > 0 ? area_of(parts.begin(), end) / whole : 0};
}

} // namespace wm3d::watermark
