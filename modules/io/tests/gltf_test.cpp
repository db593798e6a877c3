// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <wm3d/shapes.hpp>

#include "../src/json_text.hpp"
#include "gltf_support.hpp"
#include "support.hpp"
#include <wm3d/core/base64.hpp>

using namespace wm3d;
using namespace wm3d::io;
using namespace wm3d::io::test;
using Json = nlohmann::json;

namespace {

const std::string in_chunk = R"({"byteLength":60})";
const std::string one_node = R"([{"mesh":0}])";

Json json_of_glb(const std::string& bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, 4);
    return Json::parse(bytes.substr(20, length));
}

/// The GLB of a square with `from` in its JSON replaced by `to`.
std::string changed_square(const std::string& from, const std::string& to) {
    std::string json = square_asset(one_node, in_chunk);
    const std::size_t at = json.find(from);
    REQUIRE(at != std::string::npos);
    return glb(json.replace(at, from.size(), to), square_buffer());
}

} // namespace

TEST_CASE("base64 both ways") {
    for (const std::string bytes : {"", "f", "fo", "foo", "foob", "fooba", "foobar"})
        CHECK(from_base64(to_base64(bytes)) == bytes);
    CHECK(to_base64("foob") == "Zm9vYg==");
    CHECK_FALSE(from_base64("Zm9v!"));
    CHECK_FALSE(from_base64("Zm9vY"));
}

TEST_CASE("values are found in the text of a JSON document") {
    const std::string text = R"( {"a" : "x]\"}", "b":[1, {"c":[2]} ,-3e5],"e":[], "d":true} )";
    const JsonSpan root = json_root(text);
    const auto at = [&](JsonSpan span) { return text.substr(span.begin, span.end - span.begin); };
    CHECK(at(*json_member(text, root, "a")) == R"("x]\"}")");
    CHECK(at(*json_member(text, root, "d")) == "true");
    CHECK_FALSE(json_member(text, root, "c"));
    const auto elements = json_elements(text, *json_member(text, root, "b"));
    REQUIRE(elements.size() == 3);
    CHECK(at(elements[1]) == R"({"c":[2]})");
    CHECK(at(elements[2]) == "-3e5");
    CHECK(json_elements(text, *json_member(text, root, "e")).empty());
    CHECK(json_elements(text, *json_member(text, root, "a")).empty());
}

TEST_CASE("GLB: positions change in the chunk and bounds in the JSON, nothing else") {
    const std::string bytes = glb(square_asset(one_node, in_chunk), square_buffer());
    const Model model = parse_as(Format::glb, bytes);
    CHECK(model.mesh().positions[2] == Vec3(1, 1, 0));
    CHECK(model.mesh().triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    const std::string out = check_patch(bytes, Format::glb, 0.01);

    const std::vector<Vec3> stored = model.stored_positions(moved(model.mesh(), 0.01));
    Json before = json_of_glb(bytes), after = json_of_glb(out);
    for (int k = 0; k < 3; ++k) {
        double least = stored[0][k], most = stored[0][k];
        for (const Vec3& p : stored) {
            least = std::min(least, p[k]);
            most = std::max(most, p[k]);
        }
        CHECK(after["accessors"][0]["min"][k].get<float>() == static_cast<float>(least));
        CHECK(after["accessors"][0]["max"][k].get<float>() == static_cast<float>(most));
    }
    for (const char* bound : {"min", "max"})
        before["accessors"][0].erase(bound), after["accessors"][0].erase(bound);
    CHECK(before == after);
    CHECK(out.size() % 4 == 0);
    CHECK(out.substr(out.size() - 12) == bytes.substr(bytes.size() - 12)); // the vertex numbers
}

TEST_CASE("GLB: an extreme that stays keeps its spelling") {
    const std::string bytes = glb(square_asset(one_node, in_chunk), square_buffer());
    const Model model = parse_as(Format::glb, bytes);
    std::vector<Vec3> wanted = model.mesh().positions;
    wanted[3][2] = 0.5;
    const std::string out = model.patched(wanted);
    CHECK(out.find("\"min\":[0, 0,0.0],\"max\":[1.0,1,0.5]") != std::string::npos);
}

TEST_CASE("glTF: a buffer inline is patched inline") {
    const std::string bytes =
        square_asset(one_node, R"({"uri":")" + data_uri(square_buffer()) + R"(","byteLength":60})");
    const std::string out = check_patch(bytes, Format::gltf, 0.01);
    CHECK(out.find("data:application/octet-stream;base64,") != std::string::npos);
}

TEST_CASE("glTF: an external buffer becomes a side file of a new name, or goes inline") {
    const std::string bytes = square_asset(one_node, R"({"uri":"my%20data.bin","byteLength":60})");
    const Resolver resolver = [](std::string_view uri) {
        CHECK(uri == "my data.bin");
        return square_buffer() + "beyond";
    };
    const Model model = parse(bytes, Format::gltf, "model", resolver);
    CHECK(model.patched(model.mesh().positions) == bytes);
    const std::vector<Vec3> wanted = moved(model.mesh(), 0.01);
    const PatchedFiles files = model.patched_files(wanted, "folder/out file.gltf");
    REQUIRE(files.side_files.size() == 1);
    CHECK(files.side_files[0].name == "out file.bin");
    CHECK(files.side_files[0].bytes.substr(48) == square_buffer().substr(48) + "beyond");
    const Model again = parse(files.bytes, Format::gltf, "again", [&](std::string_view uri) {
        CHECK(uri == "out file.bin");
        return files.side_files[0].bytes;
    });
    check_reads_back(model, again, model.stored_positions(wanted));
    check_reads_back(model, parse_as(Format::gltf, model.patched(wanted)), model.stored_positions(wanted));
    CHECK(mentions(input_error(Format::gltf, bytes), "out of reach"));
}

TEST_CASE(
    "glTF: reading back takes side files as they will be, and everything else where the model came from") {
    // Positions in one file, triangles in another, which stays.
    std::string bytes = square_asset(
        one_node, R"({"uri":"positions.bin","byteLength":48},{"uri":"triangles.bin","byteLength":12})");
    const std::string before = R"("buffer":0,"byteOffset":48)";
    bytes.replace(bytes.find(before), before.size(), R"("buffer":1)");
    std::vector<std::string> asked;
    bool refuses = false;
    const Resolver guard = [&](std::string_view uri) {
        asked.emplace_back(uri);
        if (refuses)
            throw InputError("outside of the model's folder");
        return uri == "positions.bin" ? square_buffer().substr(0, 48) : square_buffer().substr(48);
    };
    const Model model = parse(bytes, Format::gltf, "model", guard);
    const PatchedFiles files = model.patched_files(moved(model.mesh(), 0.01), "out.gltf");
    REQUIRE(files.side_files.size() == 1);
    asked.clear();
    CHECK(model.read_back(files).mesh().triangles == model.mesh().triangles);
    CHECK(asked == std::vector<std::string>{"triangles.bin"});
    PatchedFiles same = files;
    CHECK(model.reread(same).positions == model.read_back(files).mesh().positions);
    CHECK(same.bytes == files.bytes);
    refuses = true;
    CHECK_THROWS_WITH_AS(model.read_back(files), doctest::Contains("outside"), InputError);
}

TEST_CASE("glTF: interleaved, quantized and unindexed positions") {
    // Normalized shorts at a stride of 8; a strip without indices.
    const std::string buffer = shorts({0, 0, 0, 7, 65535, 0, 0, 7, 0, 32768, 0, 7, 65535, 65535, 6, 7});
    const std::string json =
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5123,"normalized":true,"count":4,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":32,"byteStride":8}],"buffers":[{"byteLength":32}]})";
    const std::string bytes = glb(json, buffer);
    const Model model = parse_as(Format::glb, bytes);
    CHECK(model.mesh().triangles == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}});
    CHECK(model.mesh().positions[1] == Vec3(1, 0, 0));
    CHECK(model.coordinate_step() == doctest::Approx(1 / 65535.0));
    std::vector<Vec3> wanted = model.mesh().positions;
    for (Vec3& p : wanted)
        p = 0.9 * p + Vec3::Constant(0.01);
    const std::string out = model.patched(wanted);
    check_reads_back(model, parse_as(Format::glb, out), model.stored_positions(wanted));
    for (std::size_t offset : different_bytes(bytes, out))
        CHECK((offset - (bytes.size() - 32)) % 8 < 6);
}

TEST_CASE("glTF: what can't be read is refused with its reason") {
    const auto error = [](const std::string& from, const std::string& to) {
        return input_error(Format::glb, changed_square(from, to));
    };
    CHECK(mentions(error("\"indices\":1", "\"indices\":1,\"extensions\":{\"KHR_draco_mesh_compression\":{}}"),
                   "Draco"));
    CHECK(mentions(
        error("\"byteLength\":48", "\"byteLength\":48,\"extensions\":{\"EXT_meshopt_compression\":{}}"),
        "meshopt"));
    CHECK(mentions(error("\"count\":4", "\"sparse\":{},\"count\":4"), "sparse"));
    CHECK(mentions(error("\"count\":4", "\"count\":5"), "accessor 0 reaches out"));
    CHECK(mentions(error("\"count\":4", "\"count\":18446744073709551615"), "accessor 0 reaches out"));
    CHECK(mentions(error("\"count\":4", "\"count\":-4"), "whole number"));
    CHECK(mentions(error("\"count\":4", "\"count\":3"), "names vertex 3"));
    CHECK(mentions(error("\"byteLength\":48", "\"byteLength\":4800"), "reaches out of buffer"));
    CHECK(mentions(error("\"byteLength\":60", "\"byteLength\":100"), "cut short"));
    CHECK(mentions(error("\"POSITION\":0", "\"POSITION\":7"), "entry 7"));
    CHECK(mentions(error("\"version\":\"2.0\"", "\"version\":\"1.0\""), "version"));
    CHECK(mentions(error("[{\"mesh\":0}]", "[{\"mesh\":0,\"children\":[0]}]"), "ancestor"));
    CHECK(mentions(error("[{\"mesh\":0}]", "[{\"mesh\":0,\"scale\":[1,2]}]"), "scale"));
    CHECK(mentions(error("\"asset\"", "\"asset"), "JSON"));
    const std::string good = changed_square("1.0,1", "1.0,1");
    CHECK(mentions(input_error(Format::glb, good.substr(0, 100)), "cut short"));
    CHECK(mentions(
        input_error(Format::gltf, square_asset(one_node, R"({"uri":"data:x;base64,????","byteLength":60})")),
        "base64"));
}

TEST_CASE("brackets without end are refused wherever they are") {
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    const std::string whole =
        square_asset(R"([{"mesh":0}])", R"({"byteLength":60,"uri":")" + data_uri(square_buffer()) + "\"}");
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"\"2.0\"", deep}, {"\"scene\":0", "\"scene\":" + deep}, {"\"mesh\":0", "\"mesh\":" + deep}}) {
        std::string bytes = whole;
        bytes.replace(bytes.find(from), from.size(), to);
        CHECK(mentions(input_error(Format::gltf, bytes), "brackets nest"));
    }
}
