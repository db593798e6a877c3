// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_overlap.hpp"

#include <algorithm>
#include <map>
#include <queue>

namespace wm3d::io {

namespace {

/// The accessors that reach over the place of a sweep through a buffer. They have one stride and keep to
/// arcs of the circle of places modulo that stride, so a new one has to be compared with two neighbours only.
class Sweep {
public:
    /// Drops the accessors that end at or before `offset`.
    void advance(std::size_t offset) {
        while (!ends_.empty() && ends_.top().first <= offset) {
            arcs_.erase(ends_.top().second);
            ends_.pop();
        }
    }

    /// Adds an accessor.
    /// \return  the one that stands in its way, if any
    const GltfAccessor* add(const GltfAccessor& a) {
        if (!arcs_.empty() && arcs_.begin()->second->stride != a.stride)
            return arcs_.begin()->second;
        const std::size_t place = a.offset % a.stride;
        if (!arcs_.empty()) {
            auto next = arcs_.lower_bound(place);
            const auto before = std::prev(next == arcs_.begin() ? arcs_.end() : next);
            if (next == arcs_.end())
                next = arcs_.begin();
            if (ahead(place, next->first, a.stride) < element_size(a))
                return next->second;
            if (ahead(before->first, place, a.stride) < element_size(*before->second))
                return before->second;
        }
        arcs_.emplace(place, &a);
        ends_.emplace(a.end(), place);
        return nullptr;
    }

private:
    static std::size_t element_size(const GltfAccessor& a) { return 3 * size_of(a.type); }

    /// Way from one place on the circle forward to another.
    static std::size_t ahead(std::size_t from, std::size_t to, std::size_t stride) {
        return (to + stride - from) % stride;
    }

    using End = std::pair<std::size_t, std::size_t>;                  ///< offset, place
    std::map<std::size_t, const GltfAccessor*> arcs_;                 ///< by place
    std::priority_queue<End, std::vector<End>, std::greater<>> ends_; ///< the nearest first
};

} // namespace

std::optional<std::pair<std::size_t, std::size_t>> gltf_overlap(std::vector<GltfAccessor> accessors) {
    std::erase_if(accessors, [](const GltfAccessor& a) { return a.count == 0; });
    std::sort(accessors.begin(), accessors.end(), [](const GltfAccessor& a, const GltfAccessor& b) {
        return std::pair(a.buffer, a.offset) < std::pair(b.buffer, b.offset);
    });
    Sweep sweep;
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        if (i > 0 && accessors[i].buffer != accessors[i - 1].buffer)
            sweep = {};
        sweep.advance(accessors[i].offset);
        if (const GltfAccessor* other = sweep.add(accessors[i]))
            return std::pair(other->number, accessors[i].number);
    }
    return std::nullopt;
}

} // namespace wm3d::io
