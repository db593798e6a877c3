// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a Marker is made of, for the sources that make it.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include <wm3d/embed/embed.hpp>
#include <wm3d/maps/base_domain.hpp>
#include <wm3d/masking/budget.hpp>
#include <wm3d/masking/carriers.hpp>
#include <wm3d/masking/creases.hpp>
#include <wm3d/sphere/sparse_rows.hpp>
#include <wm3d/watermark/marker.hpp>

namespace wm3d::watermark {

/// RMS move of the first trial, % of the diagonal: about what a visibility of 0.1 comes to on a scan.
inline constexpr double first_strength = 0.02;

/// \throw GeometryError  if a mark moves nothing
void require_move(double rms);

/// The base domain and the details over it.
struct Marker::Base {
    maps::BaseDomain domain;
    embed::DetailedMesh detailed; ///< refers to `domain`

    Base(const TriangleMesh& canonical, std::size_t vertices, const Progress& progress);
};

/// The carriers of a level.
struct Marker::Carried {
    std::optional<sphere::SparseRows> rows; ///< B for all vertices, unless they are many
    masking::Carriers carriers;
    std::optional<masking::Creases> creases; ///< unless the mesh is large
    double usual_factor =
        0; ///< of moves that are seen about as much as `default_visibility`; 0 where unknown
};

/// What was needed so far.
struct Marker::Made {
    std::mutex guard;
    std::optional<TriangleMesh> canonical;
    std::unique_ptr<Base> base;
    std::unique_ptr<masking::Budget> budget;
    std::map<unsigned, Carried> carried;
};

/// A mark whose size is still open.
struct Marker::Layout {
    masking::MarkOfStrength positions; ///< in the coordinates of the mesh, of a strength in % of the diagonal
    double unit = 0;                   ///< strength of the bumps of gamma 1
    double usual = 0; ///< strength that is seen about as much as `default_visibility`; 0 where unknown
};

} // namespace wm3d::watermark
