// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/number_list.hpp"

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>

using namespace wm3d::cmd;
using wm3d::ParameterError;

TEST_CASE("lists are read in their order") {
    CHECK(parse_numbers("0.2,1e-3", "--x", positive_numbers("1")) == std::vector{0.2, 1e-3});
    CHECK(parse_counts("2500,4", "--n", 4) == std::vector<std::size_t>{2500, 4});
}

TEST_CASE("what is no list of such numbers is refused with the option's name") {
    for (const char* text : {"", ",", "1,", "0", "1", "-0.5", "nan", "inf", "1e-6x", "0.1 0.2"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_numbers(text, "--pf", probabilities()), ParameterError);
    }
    CHECK_THROWS_WITH(parse_numbers("2", "--pf", probabilities()),
                      "--pf: '2' is not a probability between 0 and 1, such as 1e-6");
    for (const char* text : {"3", "4.5", "-4", "1e10"})
        CHECK_THROWS_AS(parse_counts(text, "--n", 4), ParameterError);
}

TEST_CASE("a range has equal ratios and both its ends") {
    const std::vector<double> range = parse_log_range("1e-12:0.5:3", "--r", probabilities());
    REQUIRE(range.size() == 3);
    CHECK(range[0] == 1e-12);
    CHECK(range[1] / range[0] == doctest::Approx(range[2] / range[1]).epsilon(1e-12));
    CHECK(range[2] == 0.5);
}

TEST_CASE("ranges that are empty, descend or have no count are refused") {
    for (const char* text : {"", "1e-3", "1e-3:0.5", "0.5:1e-3:5", "0.1:0.1:5", "1e-3:0.5:1", "1e-3:0.5:2.5",
                             "0:0.5:5", "1e-3:1:5", "a:b:c"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_log_range(text, "--r", probabilities()), ParameterError);
    }
}
