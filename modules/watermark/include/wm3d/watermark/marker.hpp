// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A mesh made ready for marks of any key.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/maps/base_domain.hpp>
#include <wm3d/masking/budget.hpp>
#include <wm3d/masking/carriers.hpp>
#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/sphere/sparse_rows.hpp>
#include <wm3d/watermark/mark.hpp>

namespace wm3d::watermark {

/// A mesh made ready for marks: whatever depends on no key is made once, when it is first needed. The mesh
/// has to outlive it.
class Marker {
public:
    /// \throw GeometryError  if the mesh has no area
    Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress = {});
    ~Marker();
    Marker(const Marker&) = delete;
    Marker& operator=(const Marker&) = delete;

    /// The base domain of the profiles robust and paper, in the canonical frame.
    const maps::BaseDomain& domain() const;

    /// The carriers of the profile masked, whose moves are linear in any sequence of the level.
    const masking::Carriers& carriers(unsigned level) const;

    /// May be called from several threads.
    /// \throw GeometryError  if no radial move shows on the mesh
    /// \throw TooVisible     if no mark keeps to the visibility
    Marked mark(const key::Secret& secret, const MarkSetting& setting) const;

    /// The mark of a sequence of the level's length, whatever it was made of; heights above rmax are as good
    /// as others, since strength and visibility set the scale.
    /// \throw ParameterError  if w has another length
    /// \throw GeometryError   if no radial move shows on the mesh
    Marked mark(std::span<const double> w, const MarkSetting& setting) const;

    /// One-sided MSDM2 of moved vertices, #V in the coordinates of the mesh.
    double visible(const std::vector<Vec3>& positions) const;

private:
    struct Base;
    struct Carried;
    struct Layout;
    struct Made;
    using Meanwhile = std::function<void(const Carried& with)>; ///< work that doesn't depend on the mask

    const TriangleMesh& canonical() const; ///< made at first need; `made_` has to be locked
    const Base& base() const;
    const masking::Budget& budget() const;
    const masking::Budget& made_budget() const; ///< `made_` has to be locked
    Carried fresh_carriers(unsigned level) const;
    const Carried& carried(unsigned level, const Meanwhile& meanwhile = {}) const;
    void weigh(Carried& carried, unsigned level) const; ///< `made_` has to be locked
    sphere::SparseRows rows(unsigned level, std::size_t begin, std::size_t end) const;
    std::vector<double> bumps(const Carried& with, unsigned level, std::span<const double> w) const;
    Layout masked(std::span<const double> w, unsigned level) const;
    Layout shaped(std::span<const double> w, unsigned level) const;
    Layout bumpy(std::span<const double> w, unsigned level) const;
    Layout layout(std::span<const double> w, Profile profile, unsigned level) const;
    double normal_rms(std::span<const Vec3> moved) const; ///< of the full canonical mesh, % of the diagonal
    double percent_of_diagonal(double radii) const;
    /// What was moved of the canonical mesh, which is there, in the coordinates of the mesh.
    std::vector<Vec3> in_file(std::span<const Vec3> moved) const;
    std::vector<Vec3> moved(const masking::Carriers& carriers, std::span<const double> moves,
                            double factor) const; ///< in the coordinates of the mesh

    std::vector<Vec3> laid(const Layout& layout, double strength, const std::vector<char>& still) const;
    void keep_to(double visibility, const Layout& layout, Marked& marked) const;
    bool uncrease(Marked& marked, double visibility,
                  const std::optional<masking::WeightyWindows>& weighty) const;
    std::vector<Vec3> in_given_order(const std::vector<Vec3>& positions) const;

    Reordered sorted_;         ///< a mesh that is worth it; else empty
    const TriangleMesh& mesh_; ///< that is worked on: the one given or, if it is sorted, `sorted_`
    std::size_t vertices_;
    Progress progress_;
    ShapeMoments moments_;
    Frame frame_;
    double diagonal_;
    std::unique_ptr<Made> made_; ///< what was needed so far
};

} // namespace wm3d::watermark
