// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/file_bytes.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <doctest/doctest.h>
#include <sys/mman.h>
#include <unistd.h>
#include <wm3d/core/error.hpp>
#include <wm3d/io.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::io;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t fewest = 1'000'000;

/// A file that goes away.
struct Passing {
    fs::path path;
    explicit Passing(std::string_view bytes) {
        std::string name = (fs::temp_directory_path() / "wm3d-bytes-XXXXXX").string();
        ::close(::mkstemp(name.data()));
        path = name;
        rewrite(bytes);
    }
    ~Passing() { fs::remove(path); }
    Passing(const Passing&) = delete;
    Passing& operator=(const Passing&) = delete;
    void rewrite(std::string_view bytes) const { std::ofstream(path, std::ios::binary) << bytes; }
};

std::string text_of(std::size_t size) {
    std::string text(size, ' ');
    for (std::size_t i = 0; i < size; ++i)
        text[i] = static_cast<char>('a' + i * i % 23);
    return text;
}

/// Pages of the bytes that are in memory.
std::size_t resident(std::string_view bytes) {
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto first = reinterpret_cast<std::uintptr_t>(bytes.data()) / page * page;
    std::vector<unsigned char> pages((bytes.size() + page - 1) / page);
    REQUIRE(::mincore(reinterpret_cast<void*>(first), bytes.size(), pages.data()) == 0);
    return static_cast<std::size_t>(std::ranges::count_if(pages, [](unsigned char p) { return p & 1; }));
}

} // namespace

TEST_CASE("bytes go and come back to the same place") {
    const std::string text = text_of(3'000'001);
    const Passing file(text);
    FileBytes bytes(text);
    bytes.came_from(file.path);
    const std::string_view before = bytes.here();
    const std::size_t all = resident(before);
    bytes.let_go(fewest);
    CHECK(resident(before) < all / 10);
    bytes.let_go(fewest);
    CHECK(bytes.here().data() == before.data());
    CHECK(before == text);
    bytes.let_go(fewest);
    CHECK(std::move(bytes).take() == text);
}

TEST_CASE("bytes of a file that was changed, cut, lengthened or removed don't come back") {
    const std::string text = text_of(2'000'000);
    const Passing file(text);
    FileBytes bytes(text);
    bytes.came_from(file.path);
    bytes.let_go(fewest);
    std::string changed = text;
    changed[1'234'567] = '!';
    for (const std::string& other : {changed, text.substr(1), text + "a", std::string()}) {
        file.rewrite(other);
        CHECK_THROWS_WITH_AS(bytes.here(), doctest::Contains("isn't what it was"), InputError);
    }
    fs::remove(file.path);
    CHECK_THROWS_AS(bytes.here(), InputError);
    file.rewrite(text);
    CHECK(bytes.here() == text);
}

TEST_CASE("bytes stay where they can't be read again") {
    const std::string text = text_of(2'000'000);
    FileBytes from_nowhere(text), from_a_device(text);
    from_a_device.came_from("/dev/null");
    for (FileBytes* bytes : {&from_nowhere, &from_a_device}) {
        const std::size_t all = resident(bytes->here());
        bytes->let_go(fewest);
        CHECK(resident(bytes->here()) == all);
        CHECK(bytes->here() == text);
    }
}

TEST_CASE("fewer bytes than are worth it stay") {
    const std::string text = text_of(2'000'000);
    const Passing file(text);
    FileBytes bytes(text);
    bytes.came_from(file.path);
    bytes.let_go(text.size() + 1);
    fs::remove(file.path);
    CHECK(bytes.here() == text);
    const TriangleMesh mesh = shapes::blob(40'000, 1);
    const Passing small(encode(mesh, Format::ply));
    const Model model = read(small.path, {.format = Format::ply});
    model.let_bytes_go();
    fs::remove(small.path);
    CHECK(model.bytes() == encode(mesh, Format::ply));
}

TEST_CASE("a model is patched as ever after its bytes went, and not at all if the file changed") {
    const TriangleMesh mesh = shapes::blob(40'000, 1);
    const Passing file(encode(mesh, Format::ply));
    const Model model = read(file.path, {.format = Format::ply});
    std::vector<Vec3> moved = model.mesh().positions;
    moved[7] += Vec3(0.01, 0, 0);
    const std::string expected = model.patched(moved);
    model.let_bytes_go(fewest);
    CHECK(model.patched(moved) == expected);
    model.let_bytes_go(fewest);
    CHECK(model.bytes() == encode(mesh, Format::ply));
    model.let_bytes_go(fewest);
    file.rewrite(expected);
    CHECK_THROWS_AS(model.patched(moved), InputError);
}
