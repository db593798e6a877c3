// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/identify.hpp>

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/receipt.hpp>

#include "fixed_key.hpp"

using namespace wm3d;
using namespace wm3d::watermark;

namespace {

constexpr const char* work = "the digest of the blob";

std::string buyer(std::size_t number) {
    return "buyer " + std::to_string(number);
}

Marked marked(const TriangleMesh& mesh, const payload::Content& content) {
    MarkOptions options;
    options.strength = 0.1;
    options.content = content;
    return mark(mesh, fixed_key(), options);
}

/// Copies of a work for `count` buyers, as a ledger would list them.
std::vector<IssuedCopy> issued(std::size_t count, unsigned level) {
    std::vector<IssuedCopy> copies;
    for (std::size_t r = 0; r < count; ++r)
        copies.push_back({payload::copy_number(work, buyer(r), level), level});
    return copies;
}

IdentifyReport identified(const TriangleMesh& mesh, const std::vector<Vec3>& positions,
                          const std::vector<IssuedCopy>& copies) {
    TriangleMesh suspect = mesh;
    suspect.positions = positions;
    IdentifyOptions options;
    options.verify.search = SearchUse::never;
    return identify(suspect, fixed_key(), copies, options);
}

/// What lies on one side of a plane.
TriangleMesh half(const TriangleMesh& mesh) {
    TriangleMesh part{mesh.positions, {}};
    for (const Triangle& t : mesh.triangles)
        if (std::ranges::all_of(t, [&](Index v) { return mesh.positions[v].x() < 0.2; }))
            part.triangles.push_back(t);
    return part;
}

} // namespace

TEST_CASE("copies are read on more vertices than the mark was found on") {
    const TriangleMesh mesh = shapes::blob(12000, 4);
    const Marked one = marked(mesh, {{}, payload::CopyLabel{work, buyer(3)}});
    const std::vector<IssuedCopy> copies = issued(20, one.level);
    IdentifyOptions options;
    options.verify.search = SearchUse::never;
    options.verify.vertices = 6500;
    const IdentifyReport report = identify({one.positions, mesh.triangles}, fixed_key(), copies, options);
    REQUIRE(report.mark.verdict == detect::Verdict::present);
    CHECK(report.mark.base_vertices == 6500);
    const std::vector<std::uint64_t> numbers{copies[3].number};
    const double on_fewer =
        payload::copy_scores(fixed_key().secret(), report.mark.statistic, numbers).front();
    CHECK(report.best_sigmas > 1.1 * on_fewer);
    REQUIRE(report.accused.size() == 1);
    CHECK(report.accused[0].copy == 3);
}

TEST_CASE(
    "a copy is told among many, two that were averaged both are, and the owner's own mark is nobody's") {
    const TriangleMesh mesh = shapes::blob(12000, 4);
    const Marked one = marked(mesh, {{}, payload::CopyLabel{work, buyer(3)}});
    const Marked other = marked(mesh, {{}, payload::CopyLabel{work, buyer(150)}});
    std::vector<IssuedCopy> copies = issued(200, one.level);
    copies.push_back(
        {payload::copy_number(work, buyer(3), one.level + 1), one.level + 1}); // of another level

    const IdentifyReport report = identified(mesh, one.positions, copies);
    REQUIRE(report.accused.size() == 1);
    CHECK(report.accused[0].copy == 3);
    CHECK(report.accused[0].log10_p < -20);
    CHECK(report.compared == 200);
    CHECK(report.is_owners());

    std::vector<Vec3> mean = one.positions;
    for (std::size_t i = 0; i < mean.size(); ++i)
        mean[i] = (mean[i] + other.positions[i]) / 2;
    const IdentifyReport mixed = identified(mesh, mean, copies);
    REQUIRE(mixed.accused.size() == 2);
    CHECK(std::ranges::all_of(mixed.accused, [](const auto& a) { return a.copy == 3 || a.copy == 150; }));

    const IdentifyReport own = identified(mesh, marked(mesh, {}).positions, copies);
    CHECK(own.accused.empty());
    CHECK(own.is_owners());
    CHECK_FALSE(identified(mesh, mesh.positions, copies).is_owners());
}

TEST_CASE("a part of a copy is told by the receipt of its work, in whatever order the receipts come") {
    const TriangleMesh mesh = shapes::blob(12000, 4), other = shapes::blob(12000, 5);
    const Marked one = marked(mesh, {{}, payload::CopyLabel{work, buyer(3)}});
    const std::vector<IssuedCopy> copies = issued(20, one.level);
    std::vector<resync::Receipt> receipts{make_receipt(other, one, fixed_key(), "other", "copy"),
                                          make_receipt(mesh, one, fixed_key(), "work", "copy")};
    receipts[0].frame = canonical_frame(other);
    const TriangleMesh part = half({one.positions, mesh.triangles});
    IdentifyOptions options;
    options.verify.search = SearchUse::never;
    CHECK(identify(part, fixed_key(), copies, options).accused.empty());

    options.receipts = receipts;
    const IdentifyReport report = identify(part, fixed_key(), copies, options);
    CHECK(report.receipts_tried == 2);
    CHECK(report.receipt == 1);
    CHECK(report.is_owners());
    REQUIRE(report.accused.size() == 1);
    CHECK(report.accused[0].copy == 3);

    // Where the quick look finds the mark, no receipt is needed.
    const IdentifyReport whole = identify({one.positions, mesh.triangles}, fixed_key(), copies, options);
    CHECK(whole.receipts_tried == 0);
    CHECK_FALSE(whole.receipt);
    CHECK(whole.accused.size() == 1);
    // A part of what was never marked is no more the owner's for all the receipts.
    const IdentifyReport innocent = identify(half(mesh), fixed_key(), copies, options);
    CHECK(innocent.receipts_tried == 2);
    CHECK_FALSE(innocent.is_owners());
}

TEST_CASE("a part of a copy is told in the pose that a search finds, without any receipt") {
    const TriangleMesh mesh = shapes::blob(12000, 4);
    const Marked one = marked(mesh, {{}, payload::CopyLabel{work, buyer(3)}});
    IdentifyOptions options;
    options.verify.effort = 0.3;
    const IdentifyReport report =
        identify(half({one.positions, mesh.triangles}), fixed_key(), issued(20, one.level), options);
    CHECK(report.mark.pose_origin == "search");
    REQUIRE(report.accused.size() == 1);
    CHECK(report.accused[0].copy == 3);
    CHECK(report.accused[0].log10_p < -6);
}

TEST_CASE("a payload and a copy in one mark are both read") {
    const TriangleMesh mesh = shapes::blob(12000, 4);
    const payload::Content content{payload::parse_message("0xC0FFEE"), payload::CopyLabel{work, buyer(7)}};
    const Marked both = marked(mesh, content);
    const IdentifyReport report = identified(mesh, both.positions, issued(20, both.level));
    REQUIRE(report.accused.size() == 1);
    CHECK(report.accused[0].copy == 7);
    REQUIRE(report.mark.payload);
    CHECK(report.mark.payload->message == *content.message);
    CHECK(report.mark.payload->log10_p < -20);
}
