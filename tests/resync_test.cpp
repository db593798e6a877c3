// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Moved, cut and damaged copies through the whole of mark and verify: short versions of
/// bench/resync_bench.cpp.

#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/attack.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/receipt.hpp>
#include <wm3d/watermark/verify.hpp>

#include "fixed_key.hpp"

using namespace wm3d;
using detect::Verdict;

namespace {

struct Specimen {
    TriangleMesh original = shapes::blob(12000, 4), marked = original;
    key::Key key = fixed_key();
    resync::Receipt receipt;

    Specimen() {
        watermark::MarkOptions options;
        options.strength = 0.1;
        const watermark::Marked report = watermark::mark(original, key, options);
        marked.positions = report.positions;
        receipt = watermark::make_receipt(original, report, key, "a", "b");
    }
};

const Specimen& specimen() {
    static const Specimen made;
    return made;
}

TriangleMesh moved(TriangleMesh mesh, double angle, double scale) {
    const resync::Similarity t{Eigen::AngleAxisd(angle, Vec3(1, -2, 0.4).normalized()).toRotationMatrix(),
                               scale, scale * Vec3(3, 4, -1)};
    for (Vec3& p : mesh.positions)
        p = t(p);
    return mesh;
}

TriangleMesh cut(const TriangleMesh& mesh, double percent, std::uint64_t seed) {
    attack::CropOptions options;
    options.percent = percent;
    return attack::crop(mesh, options, seed);
}

watermark::VerifyOptions with_receipt() {
    watermark::VerifyOptions options;
    options.receipt = &specimen().receipt;
    options.align_receipt = resync::has_registration();
    return options;
}

watermark::VerifyOptions with_reference() {
    watermark::VerifyOptions options;
    options.reference = &specimen().original;
    return options;
}

} // namespace

TEST_CASE("a moved copy is found blind, as well as one in place but for the price of the poses") {
    const Specimen& s = specimen();
    watermark::VerifyOptions none;
    none.resync = watermark::Resync::none;
    const double in_place = watermark::verify(s.marked, s.key, none).score.log10_p;
    REQUIRE(in_place < -6);
    for (double scale : {0.1, 10.0}) {
        const watermark::VerifyReport report =
            watermark::verify(moved(s.marked, 2.5 * scale, scale), s.key, {});
        CHECK(report.verdict == Verdict::present);
        const double price = std::log10(static_cast<double>(report.score.hypotheses) / 12);
        CHECK(report.score.log10_p < in_place + price + 2);
    }
}

TEST_CASE("a copy that was cut in place is found in the receipt's frame as it stands") {
    const Specimen& s = specimen();
    watermark::VerifyOptions options = with_receipt();
    options.align_receipt = false;
    const watermark::VerifyReport report = watermark::verify(cut(s.marked, 40, 1), s.key, options);
    CHECK(report.verdict == Verdict::present);
    CHECK(report.pose_origin == "receipt, as it stands");
}

TEST_CASE("a copy that was cut and moved is found with the receipt and with the original") {
    if (!resync::has_registration()) {
        MESSAGE("SKIPPED: this build has no Ceres");
        return;
    }
    const Specimen& s = specimen();
    const TriangleMesh suspect = moved(cut(s.marked, 40, 2), 1.9, 4);
    CHECK(watermark::verify(suspect, s.key, with_receipt()).verdict == Verdict::present);
    CHECK(watermark::verify(suspect, s.key, with_reference()).verdict == Verdict::present);
}

TEST_CASE("of a cut copy nothing is called absent but in a pose that can be trusted") {
    const Specimen& s = specimen();
    const TriangleMesh suspect = moved(cut(s.marked, 20, 3), 1.2, 2),
                       clean = moved(cut(s.original, 20, 3), 1.2, 2);
    watermark::VerifyOptions by_axes; // which a cut turns: the search of all poses has a test of its own
    by_axes.search = watermark::SearchUse::never;
    const watermark::VerifyReport blind = watermark::verify(suspect, s.key, by_axes);
    CHECK(blind.verdict == Verdict::inconclusive);
    CHECK(blind.doubt == watermark::Doubt::opening);
    CHECK(blind.may_be_part);
    CHECK(watermark::verify(clean, s.key, by_axes).doubt == watermark::Doubt::opening);
    if (!resync::has_registration())
        return;
    CHECK(watermark::verify(suspect, s.key, with_receipt()).verdict == Verdict::present);
    const watermark::VerifyReport assisted = watermark::verify(clean, s.key, with_receipt());
    CHECK(assisted.verdict == Verdict::absent);
    CHECK(assisted.doubt == watermark::Doubt::none);
}

TEST_CASE("holes as scans have them leave the verdict as it is") {
    const Specimen& s = specimen();
    TriangleMesh clean = s.original;
    clean.triangles.resize(clean.triangles.size() - 40); // a hole of 0.2 % of the surface
    const watermark::VerifyReport report = watermark::verify(clean, s.key, {});
    CHECK(report.largest_opening > 0);
    CHECK(report.verdict == Verdict::absent);
    CHECK(watermark::verify(s.original, s.key, {}).largest_opening == 0);
}

TEST_CASE("the original finds what simplification leaves of a mark") {
    if (!resync::has_registration())
        return;
    const Specimen& s = specimen();
    const TriangleMesh suspect = moved(attack::simplify_edges(s.marked, 95), 1, 2);
    const double blind = watermark::verify(suspect, s.key, {}).score.log10_p;
    const double assisted = watermark::verify(suspect, s.key, with_reference()).score.log10_p;
    CHECK(assisted <= -12);
    CHECK(assisted < blind);
}

TEST_CASE("a mirror image is found with the receipt, and told") {
    if (!resync::has_registration())
        return;
    const Specimen& s = specimen();
    TriangleMesh mirrored = moved(s.marked, 2, 1);
    for (Vec3& p : mirrored.positions)
        p.y() = -p.y();
    const watermark::VerifyReport report = watermark::verify(mirrored, s.key, with_receipt());
    CHECK(report.verdict == Verdict::present);
    REQUIRE(report.registration);
    CHECK(report.registration->transform.mirrors());
}

TEST_CASE("with a reference of another object the alignment fails, and nothing is absent for sure") {
    if (!resync::has_registration())
        return;
    const Specimen& s = specimen();
    const watermark::VerifyReport report =
        watermark::verify(shapes::torus(2, 0.6, 120, 60), s.key, with_reference());
    REQUIRE(report.registration);
    CHECK_FALSE(report.registration->aligned);
    CHECK(report.verdict == Verdict::inconclusive);
    CHECK(report.doubt == watermark::Doubt::alignment);
}

TEST_CASE("random keys stay below P_f on every path") {
    const Specimen& s = specimen();
    const TriangleMesh suspect = moved(s.marked, 0.7, 3);
    std::vector<watermark::VerifyOptions> paths{{}, with_receipt()};
    if (resync::has_registration())
        paths.push_back(with_reference());
    for (watermark::VerifyOptions& options : paths) {
        options.pf = 0.05;
        options.null_keys = 2000;
        const watermark::VerifyReport report = watermark::verify(suspect, s.key, options);
        REQUIRE(report.null);
        // Bonferroni keeps the mean at 100 or below; 140 would be four standard deviations above.
        CHECK(report.null->false_positives <= 140);
    }
}

TEST_CASE("another key's receipt is refused, and so is registration without Ceres") {
    const Specimen& s = specimen();
    const key::Key other = another_fixed_key();
    CHECK_THROWS_AS(watermark::verify(s.marked, other, with_receipt()), ParameterError);
    if (!resync::has_registration())
        CHECK_THROWS_WITH_AS(watermark::verify(s.marked, s.key, with_reference()),
                             doctest::Contains("WM3D_RESYNC"), ParameterError);
}

TEST_CASE("shapes that moments can't turn are told") {
    const auto ambiguity_of = [](const TriangleMesh& mesh) {
        return resync::ambiguity_of(shape_moments(mesh).own());
    };
    CHECK(ambiguity_of(shapes::sphere(1, 20)) == resync::Ambiguity::all);
    CHECK(ambiguity_of(shapes::torus(1, 0.2, 30, 20)) == resync::Ambiguity::plane);
    CHECK(ambiguity_of(specimen().original) == resync::Ambiguity::none);
}
