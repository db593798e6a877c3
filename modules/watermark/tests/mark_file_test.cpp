// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/mark_file.hpp>

#include <filesystem>
#include <sstream>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>
#include <wm3d/embed/turned_faces.hpp>
#include <wm3d/io/encode.hpp>
#include <wm3d/shapes.hpp>

#include "fixed_key.hpp"

using namespace wm3d;
using namespace wm3d::watermark;
namespace fs = std::filesystem;

namespace {

/// A folder that goes away, with a model in it.
struct Workshop {
    fs::path folder = fs::temp_directory_path() / fmt::format("wm3d-mark-file-{}", ::getpid());
    fs::path in = folder / "in.obj", out = folder / "out.obj", receipt = folder / "receipt.json";

    explicit Workshop(const TriangleMesh& mesh) {
        fs::create_directory(folder);
        io::write_file(in, "# scan 17\n" + io::encode(mesh, io::Format::obj) + "# the end\n");
    }
    ~Workshop() { fs::remove_all(folder); }

    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
    }
};

/// A small model needs a stronger mark than a scan.
MarkFileOptions strong() {
    MarkFileOptions options;
    options.mark.strength = 0.3;
    return options;
}

TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

} // namespace

TEST_CASE("a marked file differs in coordinates alone, and verify finds the mark in it") {
    const Workshop shop(shapes::blob(4000, 4));
    MarkFileOptions options = strong();
    options.receipt = shop.receipt;
    const MarkedFile report = mark_file(shop.in, shop.out, fixed_key(), options);
    REQUIRE(report.written);
    CHECK(report.reason.empty());

    const io::Model written = io::read(shop.out);
    const VerifyReport found = verify(written.mesh(), fixed_key());
    CHECK(found.verdict == detect::Verdict::present);
    CHECK(found.score.log10_p == report.check.score.log10_p); // the check read the very bytes
    CHECK(verify(io::read(shop.in).mesh(), fixed_key()).verdict != detect::Verdict::present);

    std::istringstream before(io::read_file(shop.in)), after(io::read_file(shop.out));
    std::size_t moved = 0;
    for (std::string a, b; std::getline(before, a);) {
        REQUIRE(std::getline(after, b));
        const bool vertex = a.starts_with("v ");
        CHECK((vertex ? b.starts_with("v ") : a == b));
        moved += a != b;
    }
    CHECK(moved > 3000);

    const resync::Receipt receipt = resync::parse_receipt(io::read_file(shop.receipt), "receipt.json");
    CHECK(receipt.key_commitment == fixed_key().commitment());
    CHECK(receipt.original.sha256 == resync::digest_of(io::read_file(shop.in)).sha256);
    CHECK(receipt.marked.sha256 == resync::digest_of(io::read_file(shop.out)).sha256);
}

TEST_CASE("nothing is written where the mark would not be found again") {
    const Workshop shop(tetrahedron());
    MarkFileOptions options;
    options.receipt = shop.receipt;
    const MarkedFile report = mark_file(shop.in, shop.out, fixed_key(), options);
    CHECK_FALSE(report.written);
    CHECK(report.reason.find("too small, too plain") != std::string::npos);
    CHECK(shop.files() == 1);
}

TEST_CASE("a weak mark on an open model is given up without a search for minutes, one on a gear is found") {
    TriangleMesh open = shapes::blob(2000, 4);
    std::erase_if(open.triangles, [&](const Triangle& t) { return open.positions[t[0]].z() > 0.3; });
    MarkModelOptions options;
    options.mark.strength = 1e-4;
    const io::Model weak = io::parse(io::encode(open, io::Format::obj), io::Format::obj, "open.obj");
    const MarkedModel lost = mark_model(weak, fixed_key(), options);
    CHECK(lost.loss == Loss::power);
    CHECK((!lost.check.search || lost.check.search->centres == 0));

    options.mark.strength = 0.2;
    const io::Model gear =
        io::parse(io::encode(shapes::gear(24, 8000), io::Format::obj), io::Format::obj, "gear.obj");
    const MarkedModel found = mark_model(gear, fixed_key(), options);
    CHECK(found.marked.ambiguity != resync::Ambiguity::none);
    CHECK(found.loss == Loss::none);
}

TEST_CASE(
    "maps: double precision bears 6,000 km, and single precision is told that its numbers are too coarse") {
    TriangleMesh far = shapes::blob(3000, 3); // details of millimetres at a size of some metres
    for (Vec3& p : far.positions)
        p += Vec3(4.2e6, 6e5, 4.7e6);
    const auto marked = [&](io::Format format) {
        return mark_model(io::parse(io::encode(far, format), format, "far"), fixed_key(), {});
    };
    CHECK(marked(io::Format::obj).loss == Loss::none);
    const MarkedModel coarse = marked(io::Format::stl); // always in single precision
    CHECK(coarse.loss == Loss::distance);
    const std::string sentence = describe_loss(coarse, default_pf);
    CHECK(sentence.find("numbers are 0.5 apart") != std::string::npos);
    CHECK(sentence.find("double precision") != std::string::npos);
}

TEST_CASE("a part too small for any digit of the whole's own frame keeps its faces upright") {
    TriangleMesh mesh = shapes::blob(2000, 4);
    for (Vec3& p : mesh.positions)
        p *= 1e17;
    const TriangleMesh part = shapes::blob(200, 7);
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const Triangle& t : part.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    MarkOptions options;
    options.strength = 0.3;
    const Marked marked = mark(mesh, fixed_key(), options);
    CHECK(marked.positions != mesh.positions);
    CHECK(embed::turned_faces(mesh, marked.positions).empty());
}

TEST_CASE("a file in the way is found out before any work, and left alone") {
    const Workshop shop(tetrahedron());
    io::write_file(shop.out, "mine");
    CHECK_THROWS_WITH_AS(mark_file(shop.in, shop.out, fixed_key()), doctest::Contains("the file exists"),
                         OutputError);
    CHECK(io::read_file(shop.out) == "mine");
    MarkFileOptions options;
    options.receipt = shop.out;
    CHECK_THROWS_AS(mark_file(shop.in, shop.folder / "new.obj", fixed_key(), options), OutputError);
    CHECK_THROWS_WITH_AS(mark_file(shop.in, shop.folder / "none/out.obj", fixed_key()),
                         doctest::Contains("there is no folder"), OutputError);
    CHECK_THROWS_WITH_AS(mark_file(shop.in, shop.folder / "out.ply", fixed_key()),
                         doctest::Contains("has to be a .obj"), ParameterError);
    CHECK_THROWS_WITH_AS(mark_file(shop.in, shop.folder / "out.xyz", fixed_key()),
                         doctest::Contains("names no known format"), ParameterError);
    CHECK(shop.files() == 2);
}

TEST_CASE("a refusal doesn't search for the marks of all sizes that it tries") {
    // The cube's axes are unclear, so that a check may be a search; 98 vertices hold no mark that would pay for one.
    const Workshop shop(shapes::box({1, 1, 1}, 4));
    int looks = 0, searches = 0;
    const auto count = [&](std::string_view stage, double done) {
        looks += stage == "examining the surface" && done == 0 ? 1 : 0;
        searches += stage == "searching all poses" ? 1 : 0;
    };
    const MarkedFile report = mark_file(shop.in, shop.out, fixed_key(), {}, count);
    CHECK_FALSE(report.written);
    CHECK(report.reason.find("no larger mark that was tried would do") != std::string::npos);
    CHECK(looks > 1);
    CHECK(searches == 0);
}
