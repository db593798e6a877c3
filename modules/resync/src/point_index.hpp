// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Nearest points of a template (a kd-tree of nanoflann).
#pragma once

#include <memory>
#include <vector>

#include <wm3d/resync/pose_template.hpp>

namespace wm3d::resync {

class PointIndex {
public:
    /// The template has to outlive the index.
    explicit PointIndex(const PoseTemplate& pose_template);
    ~PointIndex();

    /// Number of the point nearest to p.
    std::size_t nearest(const Vec3& p) const;

    /// Normals blended over the `count` nearest points: what a coarse version of the surface would have.
    std::vector<Vec3> blended_normals(std::size_t count) const;

    const PoseTemplate& points() const { return template_; }

private:
    struct Tree;
    const PoseTemplate& template_;
    std::unique_ptr<Tree> tree_;
};

} // namespace wm3d::resync
