// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/error.hpp>

#include <set>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("every kind of error has the code of its kind unless it is given another") {
    CHECK(Error("x").code() == ErrorCode::system);
    CHECK(InputError("x").code() == ErrorCode::malformed_input);
    CHECK(OutputError("x").code() == ErrorCode::unwritable_output);
    CHECK(GeometryError("x").code() == ErrorCode::unusable_geometry);
    CHECK(ParameterError("x").code() == ErrorCode::bad_parameter);
    const InputError newer("a file of version 2", ErrorCode::newer_version);
    CHECK(newer.code() == ErrorCode::newer_version);
    CHECK(std::string_view(newer.what()) == "a file of version 2");
}

TEST_CASE("codes have names of their own") {
    std::set<std::string_view> names;
    for (int code = 0; code <= static_cast<int>(ErrorCode::internal); ++code)
        names.insert(name(static_cast<ErrorCode>(code)));
    CHECK(names.size() == static_cast<std::size_t>(ErrorCode::internal) + 1);
    CHECK(names.contains("usage"));
    CHECK(names.contains("internal"));
}
