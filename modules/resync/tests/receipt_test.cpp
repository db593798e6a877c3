// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/receipt.hpp>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/shapes/shapes.hpp>

#include "receipt_0_1.hpp"

using namespace wm3d;
using resync::Receipt;

namespace {

Receipt sample() {
    const TriangleMesh mesh = shapes::blob(1500, 9);
    Receipt receipt;
    receipt.tool = "wm3d 0.1.0";
    receipt.key_name = "3e5279a6f16b20e8";
    receipt.key_commitment = std::string(64, 'c');
    receipt.original = resync::digest_of("original");
    receipt.marked = resync::digest_of("marked");
    receipt.base_vertices = 1500;
    receipt.level = 5;
    receipt.gamma = 0.07;
    receipt.rmax = 0.1;
    receipt.rms_percent = 0.05;
    receipt.frame = canonical_frame(mesh);
    receipt.pose_template = resync::make_template(to_frame(mesh, receipt.frame), 400);
    return receipt;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

} // namespace

TEST_CASE("a receipt reads back what was written, points to the rounding that is promised") {
    const Receipt written = sample();
    const Receipt read = resync::parse_receipt(resync::to_text(written), "r");
    CHECK(read.tool == written.tool);
    CHECK(read.key_name == written.key_name);
    CHECK(read.key_commitment == written.key_commitment);
    CHECK(read.original == written.original);
    CHECK(read.marked == written.marked);
    CHECK(read.base_vertices == written.base_vertices);
    CHECK(read.level == written.level);
    CHECK(read.gamma == written.gamma);
    CHECK(read.rmax == written.rmax);
    CHECK(read.rms_percent == written.rms_percent);
    CHECK(read.frame.axes == written.frame.axes);
    CHECK(read.frame.centroid == written.frame.centroid);
    CHECK(read.frame.scale == written.frame.scale);
    REQUIRE(read.pose_template.points.size() == 400);
    for (std::size_t i = 0; i < 400; ++i) {
        CHECK((read.pose_template.points[i] - written.pose_template.points[i]).norm() < 4.0 / 65535);
        CHECK(read.pose_template.normals[i].dot(written.pose_template.normals[i]) > 0.9999);
    }
}

TEST_CASE("a receipt of wm3d 0.1 still reads, and still tells that it was altered") {
    const Receipt read = resync::parse_receipt(receipt_of_0_1, "r");
    CHECK(read.tool == "wm3d 0.1.0");
    CHECK(read.marked == resync::digest_of("marked"));
    CHECK(read.frame.scale == 1.0095646680450518);
    CHECK(read.pose_template.points.size() == 12);
    CHECK_THROWS_WITH_AS(
        resync::parse_receipt(replaced(receipt_of_0_1, "\"gamma\": 0.07", "\"gamma\": 0.08"), "r"),
        doctest::Contains("altered"), InputError);
}

TEST_CASE("every byte of a receipt counts, also those that mean nothing to JSON") {
    const std::string text = resync::to_text(sample());
    CHECK_THROWS_WITH_AS(resync::parse_receipt(text + " ", "r"), doctest::Contains("altered"), InputError);
    CHECK_THROWS_WITH_AS(resync::parse_receipt(replaced(text, "\"level\": 5", "\"level\":  5"), "r"),
                         doctest::Contains("altered"), InputError);
    CHECK_THROWS_WITH_AS(resync::parse_receipt(replaced(text, "\"digest\": \"", "\"digest\": \"0"), "r"),
                         doctest::Contains("altered"), InputError);
}

TEST_CASE("the digests are SHA-256") { // "abc": the example of FIPS 180-4
    CHECK(resync::digest_of("abc").sha256 ==
          "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(resync::digest_of("abc").bytes == 3);
}

TEST_CASE("cut, altered, foreign and newer receipts are refused in one sentence") {
    const std::string text = resync::to_text(sample());
    for (std::size_t size : {std::size_t{0}, std::size_t{1}, text.size() / 2, text.size() - 3})
        CHECK_THROWS_WITH_AS(resync::parse_receipt(text.substr(0, size), "r"),
                             doctest::Contains("not a complete receipt"), InputError);
    CHECK_THROWS_WITH_AS(resync::parse_receipt(replaced(text, "\"level\": 5", "\"level\": 4"), "r"),
                         doctest::Contains("altered"), InputError);
    CHECK_THROWS_WITH_AS(resync::parse_receipt(replaced(text, "receipt/2", "receipt/3"), "r"),
                         doctest::Contains("newer wm3d"), InputError);
    for (const char* foreign : {"{}", "[]", "3", R"({"schema": "wm3d.verify/1"})", R"({"schema": 1})"})
        CHECK_THROWS_WITH_AS(resync::parse_receipt(foreign, "r"), doctest::Contains("no receipt"),
                             InputError);
}

TEST_CASE("a receipt with a right digest but impossible values is refused") {
    Receipt flat = sample();
    flat.frame.scale = 0;
    CHECK_THROWS_AS(resync::parse_receipt(resync::to_text(flat), "r"), InputError);
    Receipt skewed = sample();
    skewed.frame.axes(0, 0) += 0.1;
    CHECK_THROWS_AS(resync::parse_receipt(resync::to_text(skewed), "r"), InputError);
    Receipt empty = sample();
    empty.pose_template = {};
    CHECK_THROWS_AS(resync::parse_receipt(resync::to_text(empty), "r"), InputError);
}

TEST_CASE("brackets without end are refused") {
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    CHECK_THROWS_WITH_AS(resync::parse_receipt("{\"schema\":\"wm3d.receipt/1\",\"x\":" + deep + "}", "r"),
                         doctest::Contains("brackets nest"), InputError);
}
