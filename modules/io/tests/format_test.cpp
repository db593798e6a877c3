// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/format.hpp>

#include <doctest/doctest.h>

using namespace wm3d::io;

TEST_CASE("formats are recognised by extension in any case, or by bare name") {
    CHECK(format_of_name("a/b.OBJ") == Format::obj);
    CHECK(format_of_name("x.tar.Ply") == Format::ply);
    CHECK(format_of_name("stl") == Format::stl);
    CHECK(format_of_name("m.glb") == Format::glb);
    CHECK(format_of_name("m.gltf") == Format::gltf);
    CHECK_FALSE(format_of_name("m.txt"));
    CHECK_FALSE(format_of_name("objects"));
}

TEST_CASE("content proves some formats") {
    CHECK(format_of_content("ply\nformat ascii 1.0\n") == Format::ply);
    CHECK(format_of_content("glTF\2") == Format::glb);
    CHECK(format_of_content("COFF\n3 1 0\n") == Format::off);
    CHECK(format_of_content(" {\"asset\":{}}") == Format::gltf);
    CHECK(format_of_content("solid x\n facet normal") == Format::stl);
    CHECK_FALSE(format_of_content("v 0 0 0\n"));
    CHECK_FALSE(format_of_content("plywood"));
}
