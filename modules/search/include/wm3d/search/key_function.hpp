// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A key's bumps as a function of the direction.
#pragma once

#include <span>
#include <vector>

#include <wm3d/search/harmonics.hpp>
#include <wm3d/sphere/icosphere.hpp>

namespace wm3d::search {

/// The function B w: linear in the flat faces of the sphere, constant along rays.
class KeyFunction {
public:
    /// \param sphere  has to outlive the function
    /// \pre  as many heights as the sphere has vertices
    /// \param limit  R_max: the heights are below it
    KeyFunction(const sphere::Icosphere& sphere, std::vector<double> w, double limit);

    struct Value {
        double value = 0;
        Vec3 gradient = Vec3::Zero(); ///< by the direction's coordinates, within the face
    };
    Value operator()(const Vec3& direction) const;

    /// The same, looking at `face` of the sphere first and leaving there which one it is.
    Value operator()(const Vec3& direction, Index& face) const;

    const sphere::Icosphere& sphere() const { return *sphere_; }
    const std::vector<double>& heights() const { return w_; }
    double limit() const { return limit_; }

    /// Heights that were averaged with their neighbours' some times: a wider way to its peaks.
    KeyFunction smoothed(unsigned steps) const;

    /// Harmonics by quadrature over a grid that resolves the faces.
    Harmonics harmonics(unsigned bandwidth) const;

private:
    const sphere::Icosphere* sphere_;
    std::vector<double> w_;
    double limit_;
};

} // namespace wm3d::search
