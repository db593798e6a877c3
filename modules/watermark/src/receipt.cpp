// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/receipt.hpp>

#include <fmt/format.h>

#include <wm3d/core/version.hpp>
#include <wm3d/watermark/suspect.hpp>

namespace wm3d::watermark {

namespace {

/// Vertices of the surface that the template samples: enough that its points lie on the original's surface.
constexpr std::size_t template_vertices = 20000;

} // namespace

resync::Receipt make_receipt(const TriangleMesh& mesh, const Marked& marked, const key::Key& key,
                             std::string_view original, std::string_view marked_file,
                             const Progress& progress) {
    resync::Receipt receipt;
    receipt.tool = fmt::format("wm3d {}", version());
    receipt.key_name = key.fingerprint();
    receipt.key_commitment = key.commitment();
    receipt.original = resync::digest_of(original);
    receipt.marked = resync::digest_of(marked_file);
    receipt.base_vertices = marked.base_vertices;
    receipt.level = marked.level;
    receipt.gamma = marked.gamma;
    receipt.rmax = marked.rmax;
    receipt.rms_percent = percent(marked.distortion, marked.diagonal).normal_rms;
    receipt.frame = marked.frame;
    const TriangleMesh base = simplify_suspect(mesh, template_vertices, progress).base;
    receipt.pose_template = resync::make_template(to_frame(base, marked.frame), resync::receipt_points);
    return receipt;
}

} // namespace wm3d::watermark
