// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_index.hpp"

#include <nanoflann.hpp>

namespace wm3d::resync {

namespace {

struct Points {
    const std::vector<Vec3>& points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return points[i][static_cast<Eigen::Index>(axis)];
    }
    template<typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3, Index>;

} // namespace

struct PointIndex::Tree {
    Points points;
    KdTree tree;
    explicit Tree(const std::vector<Vec3>& p) : points{p}, tree(3, points) { tree.buildIndex(); }
};

PointIndex::PointIndex(const PoseTemplate& pose_template)
    : template_(pose_template), tree_(std::make_unique<Tree>(pose_template.points)) {}

PointIndex::~PointIndex() = default;

std::size_t PointIndex::nearest(const Vec3& p) const {
    Index found = 0;
    double squared_distance = 0;
    tree_->tree.knnSearch(p.data(), 1, &found, &squared_distance);
    return found;
}

std::vector<Vec3> PointIndex::blended_normals(std::size_t count) const {
    std::vector<Index> found(count);
    std::vector<double> squared_distances(count);
    std::vector<Vec3> blended;
    for (std::size_t i = 0; i < template_.points.size(); ++i) {
        const std::size_t n =
            tree_->tree.knnSearch(template_.points[i].data(), count, found.data(), squared_distances.data());
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < n; ++k)
            sum += template_.normals[found[k]];
        blended.push_back(sum.norm() > 0 ? Vec3(sum.normalized()) : template_.normals[i]);
    }
    return blended;
}

} // namespace wm3d::resync
