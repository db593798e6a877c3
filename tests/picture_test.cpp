// SPDX-License-Identifier: GPL-3.0-or-later
// What a mark looks like: pictures of a real model before and after, under raking light.
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <doctest/doctest.h>
#include <wm3d/io.hpp>
#include <wm3d/picture.hpp>
#include <wm3d/watermark/mark.hpp>

#include "fixed_key.hpp"

using namespace wm3d;

namespace {

struct Differences {
    double whole, face; ///< RMS, of 255 grey levels
};

TriangleMesh marked(const TriangleMesh& original, const watermark::MarkOptions& options) {
    TriangleMesh copy = original;
    copy.positions = watermark::mark(original, fixed_key(), options).positions;
    return copy;
}

/// Of igea's head as it looks at the viewer, and of the face alone.
Differences seen(const TriangleMesh& original, const TriangleMesh& copy) {
    const picture::Camera head = picture::frame(original, Vec3::UnitZ(), Vec3::UnitY()),
                          face = picture::close_up(head, 0, 0, 3);
    picture::RenderOptions options;
    options.width = options.height = 300;
    const auto difference = [&](const picture::Camera& camera) {
        return picture::rms_difference(picture::render(original, camera, options),
                                       picture::render(copy, camera, options));
    };
    return {difference(head), difference(face)};
}

} // namespace

TEST_CASE("nobody tells igea from its copy with the default mark, unlike marks of version 0.1") {
    const char* folder = std::getenv("WM3D_MESHES");
    const auto file = std::filesystem::path(folder ? folder : "") / "igea.ply";
    if (!std::filesystem::exists(file)) {
        std::cout << "SKIPPED: no igea.ply in WM3D_MESHES\n";
        return;
    }
    const TriangleMesh igea = io::read(file).mesh();
    const Differences by_default = seen(igea, marked(igea, {}));
    CAPTURE(by_default.whole);
    CAPTURE(by_default.face);
    CHECK(by_default.whole < 6);
    CHECK(by_default.face < 5);

    watermark::MarkOptions hammered; // what marks of version 0.1 looked like
    hammered.profile = watermark::Profile::robust;
    hammered.strength = 0.05;
    const Differences by_strength = seen(igea, marked(igea, hammered));
    CAPTURE(by_strength.face);
    CHECK(by_strength.face > 2 * by_default.face);
}
