// SPDX-License-Identifier: GPL-3.0-or-later
// A few bytes of glTF may stand for any number of vertices; how many are taken depends on the file's size.
#include <chrono>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "gltf_support.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;

namespace {

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i)
        all += (i == 0 ? "" : ",") + text;
    return all;
}

/// An asset that shows one mesh of square_buffer() `instances` times, with its primitive `primitives` times.
std::string crowd(std::size_t instances, std::size_t primitives, const std::string& how = R"("indices":1)") {
    std::string roots;
    for (std::size_t i = 0; i < instances; ++i)
        roots += fmt::format("{}{}", i == 0 ? "" : ",", i);
    return glb(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" +
                   repeated(R"({"mesh":0})", instances) + R"(],"meshes":[{"primitives":[)" +
                   repeated(R"({"attributes":{"POSITION":0},)" + how + "}", primitives) +
                   R"(]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                   R"({"type":"SCALAR","bufferView":1,"componentType":5123,"count":6}],)"
                   R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,)"
                   R"("byteLength":12}],"buffers":[{"byteLength":60}]})",
               square_buffer());
}

std::string refusal(const std::string& bytes, const Limits& limits) {
    try {
        parse(bytes, Format::glb, "model", {}, limits);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("what instances show is bounded, and the bound can be lifted") {
    const Limits few{.per_byte = 0, .always = 20};
    CHECK(refusal(crowd(5, 1), few) == "");
    CHECK(mentions(refusal(crowd(6, 1), few), "more than 20 vertices"));
    CHECK(mentions(refusal(crowd(6, 1), few), "--any-size"));
    CHECK(mentions(refusal(crowd(2, 11, R"("mode":0)"), few), "more than 20 primitives"));
    CHECK(mentions(refusal(crowd(2, 6), few), "more than 20 triangles"));
    CHECK(refusal(crowd(100, 50), Limits::none()) == "");
}

TEST_CASE("the bound grows with the file") {
    const std::string bytes = crowd(100, 1);
    const double vertices = 400;
    CHECK(refusal(bytes, {.per_byte = 1.001 * vertices / static_cast<double>(bytes.size()), .always = 0}) ==
          "");
    CHECK(refusal(bytes, {.per_byte = 0.999 * vertices / static_cast<double>(bytes.size()), .always = 0}) !=
          "");
}

TEST_CASE("2^26 vertices out of a megabyte are refused before they are made") {
    const std::size_t vertices = 32768, instances = 2048;
    std::string roots;
    for (std::size_t i = 0; i < instances; ++i)
        roots += fmt::format("{}{}", i == 0 ? "" : ",", i);
    const std::string bytes = glb(
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" +
            repeated(R"({"mesh":0})", instances) +
            R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)" +
            fmt::format(R"("componentType":5126,"count":{},"type":"VEC3"}}],"bufferViews":[{{"buffer":0,)"
                        R"("byteLength":{}}}],"buffers":[{{"byteLength":{}}}]}})",
                        vertices, 12 * vertices, 12 * vertices),
        std::string(12 * vertices, '\0'));
    CHECK(bytes.size() < 1'000'000);
    CHECK(mentions(refusal(bytes, {}), "vertices, out of files of"));
}

TEST_CASE("buffers that name one file share it") {
    std::string json = square_asset(R"([{"mesh":0}])", R"({"byteLength":60,"uri":"a.bin"},)"
                                                       R"({"byteLength":60,"uri":"./%61.bin"})");
    const std::string view = R"("bufferViews":[{"buffer":0,)";
    json.replace(json.find(view), view.size(), R"("bufferViews":[{"buffer":1,)");
    int read = 0;
    const Resolver resolver = [&](std::string_view) {
        ++read;
        return square_buffer();
    };
    const Model model = parse(json, Format::gltf, "model", resolver);
    CHECK(model.mesh().triangles.size() == 2);
    CHECK(read == 1);
    const PatchedFiles files = model.patched_files(moved(model.mesh(), 0.1), "out.gltf");
    REQUIRE(files.side_files.size() == 1);
    CHECK(files.side_files[0].bytes.substr(48) == square_buffer().substr(48));
}

TEST_CASE("the bounds of many accessors of the same bytes are found once") {
    const std::size_t vertices = 20000, accessors = 5000;
    std::vector<float> numbers(3 * vertices);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<float>(i % 977);
    std::string primitives;
    for (std::size_t i = 0; i < accessors; ++i)
        primitives += fmt::format(R"({}{{"attributes":{{"POSITION":{}}},"indices":{}}})", i == 0 ? "" : ",",
                                  i, accessors);
    const std::string bytes =
        glb(R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[)" + primitives + R"(]}],"accessors":[)" +
                repeated(fmt::format(R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3",)"
                                     R"("min":[0,0,0],"max":[976,976,976]}})",
                                     vertices),
                         accessors) +
                fmt::format(
                    R"(,{{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}}],"bufferViews":)"
                    R"([{{"buffer":0,"byteLength":{0}}},{{"buffer":0,"byteOffset":{0},"byteLength":6}}],)"
                    R"("buffers":[{{"byteLength":{1}}}]}})",
                    12 * vertices, 12 * vertices + 6),
            floats(numbers) + shorts({0, 1, 2}));
    const auto start = std::chrono::steady_clock::now();
    const Model model = parse_as(Format::glb, bytes);
    std::vector<Vec3> wanted = model.mesh().positions;
    for (Vec3& p : wanted)
        p *= 1.25;
    const std::string out = model.patched(wanted);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
    std::size_t bounds = 0;
    for (std::size_t at = 0; (at = out.find("\"max\":[1220,1220,1220]", at)) != std::string::npos; ++at)
        ++bounds;
    CHECK(bounds == accessors);
}
