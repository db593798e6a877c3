// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of all formats check of a patched file.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/io.hpp>

namespace wm3d::io::test {

inline Model parse_as(Format format, std::string bytes) {
    return parse(std::move(bytes), format, "model");
}

/// Small moves, different for every vertex, in part of the largest coordinate.
inline std::vector<Vec3> moved(const TriangleMesh& mesh, double amount) {
    std::vector<Vec3> positions = mesh.positions;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const auto i = static_cast<double>(v);
        positions[v] += amount * Vec3(std::sin(i + 1), std::cos(2 * i + 1), std::sin(3 * i + 2));
    }
    return positions;
}

/// Every slot of the patched file reads back as the vertex that `stored_positions` promised for it.
inline void check_reads_back(const Model& model, const Model& again, std::span<const Vec3> stored) {
    REQUIRE(again.vertex_of_slot().size() == model.vertex_of_slot().size());
    CHECK(again.mesh().triangles.size() == model.mesh().triangles.size());
    std::size_t wrong = 0;
    for (std::size_t slot = 0; slot < model.vertex_of_slot().size(); ++slot)
        if (again.mesh().positions[again.vertex_of_slot()[slot]] != stored[model.vertex_of_slot()[slot]])
            ++wrong;
    CHECK(wrong == 0);
}

/// Patches with small moves and checks what every format promises.
/// \return the patched bytes
inline std::string check_patch(const std::string& bytes, Format format, double amount) {
    const Model model = parse_as(format, bytes);
    CHECK(model.patched(model.mesh().positions) == bytes);
    const std::vector<Vec3> wanted = moved(model.mesh(), amount);
    const std::vector<Vec3> stored = model.stored_positions(wanted);
    std::string out = model.patched(wanted);
    CHECK(out != bytes);
    check_reads_back(model, parse_as(format, out), stored);
    for (std::size_t v = 0; v < stored.size(); ++v)
        CHECK((stored[v] - wanted[v]).cwiseAbs().maxCoeff() <= 0.5000001 * model.coordinate_step());
    return out;
}

/// Pairs of words that differ between two texts; the spaces and line ends between words must be the same.
inline std::vector<std::pair<std::string, std::string>> different_words(std::string_view a,
                                                                        std::string_view b) {
    std::vector<std::pair<std::string, std::string>> different;
    std::size_t i = 0, j = 0;
    const auto space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (i < a.size() && j < b.size()) {
        if (space(a[i]) || space(b[j])) {
            REQUIRE(a[i] == b[j]);
            ++i, ++j;
            continue;
        }
        std::size_t end_a = i, end_b = j;
        while (end_a < a.size() && !space(a[end_a]))
            ++end_a;
        while (end_b < b.size() && !space(b[end_b]))
            ++end_b;
        if (a.substr(i, end_a - i) != b.substr(j, end_b - j))
            different.emplace_back(a.substr(i, end_a - i), b.substr(j, end_b - j));
        i = end_a, j = end_b;
    }
    CHECK(i == a.size());
    CHECK(j == b.size());
    return different;
}

/// Offsets of bytes that differ between two strings of one length.
inline std::vector<std::size_t> different_bytes(const std::string& a, const std::string& b) {
    REQUIRE(a.size() == b.size());
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i])
            offsets.push_back(i);
    return offsets;
}

/// Message of the InputError that parsing throws; empty if it throws none.
inline std::string input_error(Format format, std::string bytes) {
    try {
        parse_as(format, std::move(bytes));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

inline bool mentions(const std::string& message, std::string_view part) {
    INFO(message);
    return message.find(part) != std::string::npos;
}

} // namespace wm3d::io::test
