// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/alignment.hpp>

#include <algorithm>

#include <wm3d/detect/reference_evidence.hpp>
#include <wm3d/resync/pose_template.hpp>

namespace wm3d::watermark {

namespace {

constexpr std::size_t reference_points = 4000;    // of the template that is made of a reference
constexpr std::size_t reference_vertices = 40000; // that carry the difference
constexpr double reach = 0.03;                    // farthest counterpart, in mean radii

/// Whether the suspect lies around the frame at all. Seen from afar it would meet a few bumps of the sphere
/// only.
bool surrounds(const Frame& frame, const Frame& suspect) {
    const double ratio = suspect.scale / frame.scale;
    return (suspect.centroid - frame.centroid).norm() < 1.5 * frame.scale && ratio > 0.2 && ratio < 2;
}

} // namespace

KnownPose pose_by_receipt(const resync::Receipt& receipt, const Suspect& suspect, bool align,
                          const Progress& progress) {
    KnownPose known;
    if (surrounds(receipt.frame, canonical_frame(suspect.mesh)))
        known.poses.push_back({receipt.frame, "receipt, as it stands"});
    if (!align)
        return known;
    known.registration = resync::register_template(receipt.in_file(), suspect.base, {}, progress);
    if (known.registration->aligned)
        known.poses.push_back(
            {resync::moved(receipt.frame, known.registration->transform), "receipt, aligned"});
    return known;
}

ReferenceView compare_with_reference(const TriangleMesh& reference, const Suspect& suspect,
                                     const Progress& progress) {
    const Frame frame = canonical_frame(reference);
    const TriangleMesh base = simplify_suspect(reference, reference_vertices, progress).base;
    const resync::PoseTemplate points = resync::make_template(base, reference_points);
    ReferenceView view;
    view.known.registration = resync::register_template(points, suspect.base, {}, progress);
    if (!view.known.registration->aligned)
        return view;
    const Frame on_suspect = resync::moved(frame, view.known.registration->transform);
    view.known.poses.push_back({on_suspect, "reference, aligned"});
    view.mesh = to_frame(base, frame);
    view.difference = resync::surface_difference(view.mesh, to_frame(suspect.mesh, on_suspect), reach);
    return view;
}

std::vector<detect::Hypothesis> reference_family(const ReferenceView& view, const Examination& examination) {
    if (view.mesh.positions.empty())
        return {};
    const ExaminationOptions& options = examination.options();
    const std::size_t pose = examination.poses() - 1;
    const detect::ReferenceEvidence evidence(view.mesh, view.difference.along_normal, view.difference.trust);
    const sphere::Icosphere finest(std::ranges::max(options.levels));
    const std::vector<sphere::SparseRows> rows =
        sphere::barycentric_rows(finest, view.mesh.positions, options.levels);
    std::vector<detect::Hypothesis> family;
    for (std::size_t l = 0; l < options.levels.size(); ++l)
        family.push_back({evidence.statistic(rows[l], options.rmax), options.levels[l], pose, 0,
                          detect::Source::reference});
    return family;
}

} // namespace wm3d::watermark
