// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/picture/render.hpp>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::picture;

namespace {

constexpr Rgb white{255, 255, 255};

std::size_t covered(const Image& image) {
    return static_cast<std::size_t>(
        std::ranges::count_if(image.pixels, [](const Rgb& c) { return c != white; }));
}

} // namespace

TEST_CASE("a sphere is a disc, lit from its side") {
    const TriangleMesh ball = shapes::sphere(2, 60);
    const Camera camera = frame(ball, {0, 0, 1}, {0, 1, 0});
    CHECK(camera.height == doctest::Approx(4 * 1.06).epsilon(1e-3));
    RenderOptions options;
    options.width = options.height = 100;
    options.light = Vec3(-1, 0, 0.2);
    const Image image = render(ball, camera, options);
    const double disc = 3.14159 / 4 / (1.06 * 1.06) * 100 * 100;
    CHECK(static_cast<double>(covered(image)) == doctest::Approx(disc).epsilon(0.04));
    CHECK(image.at(0, 0) == white);
    CHECK(image.at(15, 50)[0] > image.at(50, 50)[0]);
    CHECK(image.at(50, 50)[0] > image.at(85, 50)[0]);
    for (std::size_t y : {20UL, 70UL}) // light from the left treats above and below alike
        CHECK(std::abs(int{image.at(40, y)[0]} - int{image.at(40, 99 - y)[0]}) <= 2);
}

TEST_CASE("what is nearer hides what is behind, and up is up") {
    // A red square in front of a green one that is higher.
    TriangleMesh mesh{
        {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {0, 1, 0}, {2, 1, 0}, {2, 3, 0}, {0, 3, 0}},
        {{4, 5, 6}, {4, 6, 7}, {0, 1, 2}, {0, 2, 3}}};
    const std::vector<Rgb> colours{{255, 0, 0}, {255, 0, 0}, {255, 0, 0}, {255, 0, 0},
                                   {0, 255, 0}, {0, 255, 0}, {0, 255, 0}, {0, 255, 0}};
    RenderOptions options;
    options.width = options.height = 60;
    options.vertex_colours = colours;
    const auto is_red = [](const Rgb& c) { return c[0] > 0 && c[1] == 0; };
    const auto is_green = [](const Rgb& c) { return c[0] == 0 && c[1] > 0; };
    const Image front = render(mesh, frame(mesh, {0, 0, 1}, {0, 1, 0}), options);
    CHECK(is_green(front.at(30, 5)));
    CHECK(is_red(front.at(30, 30)));
    CHECK(is_red(front.at(30, 55)));
    const Image back = render(mesh, frame(mesh, {0, 0, -1}, {0, 1, 0}), options);
    CHECK(is_green(back.at(30, 30)));
    options.vertex_colours = std::span(colours).first(3);
    CHECK_THROWS_AS(render(mesh, frame(mesh, {0, 0, 1}, {0, 1, 0}), options), ParameterError);
}

TEST_CASE("a close-up shows a part, larger") {
    const TriangleMesh ball = shapes::sphere(1, 30);
    const Camera whole = frame(ball, {0, 0, 1}, {0, 1, 0}), part = close_up(whole, 0.5, 0, 4);
    CHECK(part.height == doctest::Approx(whole.height / 4));
    CHECK(part.centre[0] == doctest::Approx(whole.centre[0] + whole.height / 4));
    RenderOptions options;
    options.width = options.height = 40;
    CHECK(covered(render(ball, close_up(whole, 0, 0, 4), options)) == 40 * 40);
}

TEST_CASE("flat shading shows facets that smooth shading blends, and a bump shows under raking light") {
    const TriangleMesh coarse = shapes::sphere(1, 8);
    const Camera camera = frame(coarse, {0, 0, 1}, {0, 1, 0});
    RenderOptions flat;
    flat.width = flat.height = 80;
    flat.smooth = false;
    RenderOptions smooth = flat;
    smooth.smooth = true;
    CHECK(rms_difference(render(coarse, camera, flat), render(coarse, camera, smooth)) > 3);

    const TriangleMesh plate = shapes::square(1, 40);
    TriangleMesh bumped = plate;
    for (Vec3& p : bumped.positions)
        p[2] += 0.002 * std::sin(60 * p[0]);
    const auto seen = [&](const Vec3& light) {
        RenderOptions options = smooth;
        options.light = light;
        const Camera above = frame(plate, {0, 0, 1}, {0, 1, 0});
        return rms_difference(render(plate, above, options), render(bumped, above, options));
    };
    CHECK(seen({-1, 0, 0.25}) > 5 * seen({0, 0, 1}));
}
