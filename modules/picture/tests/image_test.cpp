// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/picture/image.hpp>

#include <fstream>
#include <iterator>
#include <string>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>

using namespace wm3d;
using namespace wm3d::picture;

TEST_CASE("differences of pictures") {
    const Image a(4, 3, {10, 20, 30});
    Image b = a;
    CHECK(rms_difference(a, b) == 0);
    b.at(1, 2) = {10, 20, 36};
    CHECK(largest_difference(a, b) == 6);
    CHECK(rms_difference(a, b) == doctest::Approx(1)); // sqrt(36 / 36)
    CHECK_THROWS_AS(rms_difference(a, Image(3, 4)), ParameterError);
}

TEST_CASE("pictures side by side") {
    const Image row = beside({Image(2, 2, {1, 1, 1}), Image(3, 2, {2, 2, 2})}, 1);
    CHECK(row.width == 6);
    CHECK(row.at(1, 1) == Rgb{1, 1, 1});
    CHECK(row.at(2, 1) == Rgb{255, 255, 255});
    CHECK(row.at(3, 0) == Rgb{2, 2, 2});
    CHECK_THROWS_AS(beside({Image(2, 2), Image(2, 3)}), ParameterError);
}

TEST_CASE("a PNG begins as one, and a folder that isn't there is an error") {
    const auto file = std::filesystem::temp_directory_path() / "wm3d-picture-test.png";
    write_png(file, Image(5, 4));
    std::ifstream in(file, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    CHECK(bytes.substr(1, 3) == "PNG");
    CHECK(bytes[19] == 5); // width, big-endian
    CHECK(bytes[23] == 4);
    std::filesystem::remove(file);
    CHECK_THROWS_AS(write_png("/nowhere/at/all.png", Image(1, 1)), OutputError);
}
