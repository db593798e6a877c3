// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/key_function.hpp>

#include <algorithm>
#include <utility>

namespace wm3d::search {

KeyFunction::KeyFunction(const sphere::Icosphere& sphere, std::vector<double> w, double limit)
    : sphere_(&sphere), w_(std::move(w)), limit_(limit) {}

KeyFunction::Value KeyFunction::operator()(const Vec3& direction) const {
    Index face = no_index;
    return (*this)(direction, face);
}

KeyFunction::Value KeyFunction::operator()(const Vec3& direction, Index& face) const {
    const sphere::SphereLocation at = sphere_->locate(direction, face);
    face = at.face;
    const std::vector<Vec3>& u = sphere_->vertices();
    const auto& [i, j, k] = at.vertices;
    const Vec3 w(w_[i], w_[j], w_[k]);
    const double value = at.barycentric.dot(w);
    // direction = sum lambda_j u_j, value = sum lambda_j w_j / sum lambda_j
    Mat3 dual; // columns: derivative of lambda_j by the direction
    dual << u[j].cross(u[k]), u[k].cross(u[i]), u[i].cross(u[j]);
    const double determinant = u[i].dot(dual.col(0));
    const double sum = direction.norm() / at.flat_radius; // of the lambda_j
    if (!(sum > 0))
        return {value, Vec3::Zero()};
    return {value, dual * (w.array() - value).matrix() / (determinant * sum)};
}

KeyFunction KeyFunction::smoothed(unsigned steps) const {
    std::vector<double> w = w_;
    for (unsigned step = 0; step < steps; ++step) {
        std::vector<double> sum(w.size(), 0.0), weight(w.size(), 0.0);
        for (const Triangle& t : sphere_->faces()) // every edge comes twice
            for (std::size_t k = 0; k < 3; ++k) {
                sum[t[k]] += w[t[(k + 1) % 3]];
                weight[t[k]] += 1;
            }
        for (std::size_t j = 0; j < w.size(); ++j)
            w[j] = (w[j] + sum[j] / weight[j]) / 2;
    }
    return {*sphere_, std::move(w), limit_};
}

Harmonics KeyFunction::harmonics(unsigned bandwidth) const {
    const unsigned resolved = 8u << sphere_->level(); // two rings or more per edge of a face
    const unsigned rings = std::clamp(resolved, 2 * bandwidth, 1024u + 2 * bandwidth);
    return HarmonicTransform(bandwidth, rings / 2 * 2).of_function([&](const Vec3& d) {
        const sphere::SphereLocation at = sphere_->locate(d);
        double value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            value += at.barycentric[static_cast<Eigen::Index>(k)] * w_[at.vertices[k]];
        return value;
    });
}

} // namespace wm3d::search
