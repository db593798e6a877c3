// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Golden vectors of spec/vectors: loading, and comparison within the tolerance that each quantity
/// states.
#pragma once

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace wm3d::spec {

using Json = nlohmann::json;

/// One vector: inputs (exact doubles) and what an independent generator expects of them.
class Vector {
public:
    Vector(const Json& vector, const Json& tolerances) : vector_(vector), tolerances_(tolerances) {}

    std::string id() const { return vector_.at("id"); }
    bool has_input(const std::string& name) const { return vector_.at("inputs").contains(name); }
    bool expects(const std::string& quantity) const { return vector_.at("expected").contains(quantity); }

    template<typename T = double>
    T input(const std::string& name) const {
        return vector_.at("inputs").at(name).get<T>();
    }

    /// Fails the test unless |value - expected| <= relative |expected| + absolute, with the tolerances that
    /// the file states for the quantity, or this vector itself.
    void check(const std::string& quantity, double value) const {
        compare(quantity, vector_.at("expected").at(quantity), value);
    }

    /// The same for a list.
    void check(const std::string& quantity, const std::vector<double>& values) const {
        compare_list(quantity, vector_.at("expected").at(quantity), values);
    }

    /// The same for one list of a list of them.
    void check_row(const std::string& quantity, std::size_t row, const std::vector<double>& values) const {
        compare_list(quantity, vector_.at("expected").at(quantity).at(row), values);
    }

private:
    void compare_list(const std::string& quantity, const Json& expected,
                      const std::vector<double>& values) const {
        REQUIRE(values.size() == expected.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            compare(quantity, expected[i], values[i]);
    }

    void compare(const std::string& quantity, const std::string& digits, double value) const {
        const Json& stated = tolerances_.at(quantity);
        const Json& absolute =
            stated.at("absolute").is_null() ? vector_.at("absolute").at(quantity) : stated.at("absolute");
        const long double expected = std::stold(digits);
        const long double bound =
            stated.at("relative").get<long double>() * std::abs(expected) + absolute.get<long double>();
        INFO(id(), ", ", quantity, ": expected ", digits, ", got ", Json(value).dump(), ", allowed error ",
             static_cast<double>(bound));
        CHECK(std::abs(static_cast<long double>(value) - expected) <= bound);
    }

    const Json& vector_;
    const Json& tolerances_;
};

/// All vectors of an equation.
class Vectors {
public:
    explicit Vectors(const std::string& file_name) {
        std::ifstream file(WM3D_SPEC_VECTORS "/" + file_name);
        REQUIRE_MESSAGE(file, "missing: ", file_name);
        content_ = Json::parse(file);
        REQUIRE(!content_.at("vectors").empty());
    }

    /// Calls test(vector) for each.
    template<typename Test>
    void each(Test&& test) const {
        for (const Json& vector : content_.at("vectors"))
            test(Vector(vector, content_.at("tolerances")));
    }

private:
    Json content_;
};

} // namespace wm3d::spec
