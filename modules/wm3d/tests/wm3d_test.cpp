// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/wm3d.hpp>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>

#include "fixed_key.hpp"

TEST_CASE("a mesh is marked and verified by the names of the front door") {
    const wm3d::Key key = wm3d::fixed_key(), other = wm3d::another_fixed_key();
    wm3d::TriangleMesh mesh = wm3d::shapes::blob(4000, 7);
    wm3d::MarkOptions options;
    options.strength = 0.3;
    const wm3d::Marked marked = wm3d::mark(mesh, key, options);
    CHECK(marked.positions.size() == mesh.positions.size());
    mesh.positions = marked.positions;
    CHECK(wm3d::verify(mesh, key).verdict == wm3d::Verdict::present);
    CHECK(wm3d::verify(mesh, other).verdict != wm3d::Verdict::present);
}
