// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/spec.hpp>

#include <set>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

using namespace wm3d;
using namespace wm3d::attack;

TEST_CASE("values are read by position, by name, and from the defaults") {
    CHECK(parse("noise:0.3") == AttackSpec{"noise", {0.3}});
    CHECK(parse("noise") == AttackSpec{"noise", {0.1}});
    CHECK(parse("smoothing:30") == AttackSpec{"smoothing", {30, 0.1}});
    CHECK(parse("smoothing:lambda=0.5") == AttackSpec{"smoothing", {10, 0.5}});
    CHECK(parse("subdivision:loop,2") == AttackSpec{"subdivision", {2, 2}});
    CHECK(parse("crop:25,cap=yes,nz=-1") == AttackSpec{"cropping", {25, 1, 0, 0, -1}});
}

TEST_CASE("chains are read from left to right") {
    const auto chain = parse_chain("similarity+noise:0.3+simplify:95");
    REQUIRE(chain.size() == 3);
    CHECK(chain[0].name == "similarity");
    CHECK(chain[2] == AttackSpec{"simplification", {95}});
    CHECK(to_string(chain) == "similarity+noise:0.3+simplification:95");
}

TEST_CASE("text that is no attack is refused with what is known") {
    const auto message = [](const char* text) -> std::string {
        try {
            parse_chain(text);
        } catch (const ParameterError& error) {
            return error.what();
        }
        return {};
    };
    CHECK(message("blur").find("\"blur\"; the known attacks are file, similarity, noise") !=
          std::string::npos);
    CHECK(message("").find("known attacks") != std::string::npos);
    CHECK(message("noise+").find("known attacks") != std::string::npos);
    CHECK(message("noise:much=1").find("has no parameter \"much\"; it has amplitude") != std::string::npos);
    CHECK(message("noise:1,2").find("one too many") != std::string::npos);
    CHECK(message("noise:").find("amplitude=\"\" is not a number from 0 to 100") != std::string::npos);
    CHECK(message("noise:-1").find("from 0 to 100") != std::string::npos);
    CHECK(message("noise:nan").find("from 0 to 100") != std::string::npos);
    CHECK(message("noise:0.3x").find("0.3x") != std::string::npos);
    CHECK(message("quantization:9.5").find("whole number from 1 to 32") != std::string::npos);
    CHECK(message("subdivision:butterfly").find("one of midpoint, sqrt3, loop") != std::string::npos);
}

TEST_CASE("every attack is described once and reads its own text") {
    std::set<std::string_view> names;
    const std::string description = describe_known_attacks();
    for (const AttackInfo& info : known_attacks()) {
        CHECK(names.insert(info.name).second);
        CHECK(!info.summary.empty());
        CHECK(description.find(std::string(info.name) + ": ") != std::string::npos);
        const AttackSpec spec = parse(info.name);
        CHECK(spec.values.size() == info.parameters.size());
        CHECK(parse(to_string(spec)) == spec);
    }
    for (const char* text : {"cropping:12.5,ny=1", "subdivision:sqrt3", "taubin:5,mu=-0.5", "scale:1,1.1"})
        CHECK(parse(to_string(parse(text))) == parse(text));
}

TEST_CASE("the published benchmark has all its intensities") {
    const auto specs = published_benchmark();
    CHECK(specs.size() == 28);
    CHECK(to_string(specs[2]) == "noise:0.05");
    CHECK(to_string(specs.back()) == "cropping:50");
}
