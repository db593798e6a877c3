// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Implicit diffusion on a triangulated surface: the filters of the whitened detector.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::detect {

/// The low pass (M + t L)^-1 M with the lumped mass M and the cotangent Laplacian L of a surface. Works on
/// any triangles: cotangents of obtuse and degenerate ones are clamped so that L stays symmetric and
/// positive. Solves by conjugate gradients that never form M + tL: three vectors at a time in one thread, or one in
/// each, and on dense surfaces over a hierarchy of levels in all threads: the bytes don't depend on their number.
class SurfaceFilter {
public:
    explicit SurfaceFilter(const TriangleMesh& mesh);
    /// \param areas  the mesh's `vertex_areas`
    SurfaceFilter(const TriangleMesh& mesh, std::vector<double> areas);
    ~SurfaceFilter();
    SurfaceFilter(SurfaceFilter&&) noexcept;
    SurfaceFilter& operator=(SurfaceFilter&&) noexcept;

    /// Lumped areas, the diagonal of M: #V.
    std::span<const double> mass() const;

    /// Residual of the solver, relative to the right-hand side; on dense surfaces the error, relative to x. A mark moves a vertex by a thousandth of the
    /// mean radius; an error of the filter can cost a little power but never a wrong probability, which is
    /// exact for any coefficients.
    static constexpr double usual_tolerance = 3e-6;

    /// (M + tL)^-1 M x for each of the vectors, #V each; t in units of length squared.
    std::vector<std::vector<double>> low_pass(double t, std::vector<std::vector<double>> vectors,
                                              double tolerance = usual_tolerance) const;

    /// M (M + tL)^-1 y: the transpose of `low_pass`.
    std::vector<double> low_pass_transposed(double t, std::span<const double> y,
                                            double tolerance = usual_tolerance) const;

private:
    struct Operators;
    std::unique_ptr<Operators> operators_;
};

} // namespace wm3d::detect
