// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/file.hpp>

#include <cstdlib>
#include <filesystem>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>

using namespace wm3d;
using namespace wm3d::io;
namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "wm3d-io-XXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path), fs::directory_iterator{}));
    }
};

} // namespace

TEST_CASE("a written file holds the bytes and no temporary file stays") {
    const Folder folder;
    const std::string bytes("a\0b\n", 4);
    write_file(folder.path / "x.bin", bytes);
    CHECK(read_file(folder.path / "x.bin") == bytes);
    CHECK(folder.entries() == 1);
}

TEST_CASE("an existing file is replaced only on request") {
    const Folder folder;
    const fs::path path = folder.path / "x";
    write_file(path, "old");
    CHECK_THROWS_WITH_AS(write_file(path, "new"), doctest::Contains("--overwrite"), OutputError);
    CHECK(read_file(path) == "old");
    write_file(path, "new", {.overwrite = true});
    CHECK(read_file(path) == "new");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a secret file is for its owner alone") {
    const Folder folder;
    write_file(folder.path / "key", "s", {.private_to_owner = true});
    CHECK((fs::status(folder.path / "key").permissions() & fs::perms::all) ==
          (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("targets that can't be written are an error") {
    const Folder folder;
    CHECK_THROWS_AS(write_file(folder.path / "missing" / "x", "b"), OutputError);
    CHECK_THROWS_AS(write_file(folder.path, "b", {.overwrite = true}), OutputError);
}

TEST_CASE("what can't be read is an error that names it") {
    const Folder folder;
    CHECK_THROWS_WITH_AS(read_file(folder.path / "no.obj"), doctest::Contains("no.obj"), InputError);
    CHECK_THROWS_WITH_AS(read_file(folder.path), doctest::Contains("folder"), InputError);
    write_file(folder.path / "empty.obj", "");
    CHECK_THROWS_WITH_AS(read(folder.path / "empty.obj"), doctest::Contains("empty"), InputError);
    write_file(folder.path / "x.txt", "ply\n");
    CHECK_THROWS_WITH_AS(read(folder.path / "x.txt"), doctest::Contains("--format ply"), InputError);
    write_file(folder.path / "x.obj", "ply\nformat ascii 1.0\n");
    CHECK_THROWS_WITH_AS(read(folder.path / "x.obj"), doctest::Contains("of format ply"), InputError);
}

TEST_CASE("nothing is written if one of several files exists") {
    const Folder folder;
    write_file(folder.path / "side.bin", "old");
    CHECK_THROWS_AS(write_files(folder.path / "main", {"m", {{"side.bin", "new"}}}), OutputError);
    CHECK_FALSE(fs::exists(folder.path / "main"));
    write_files(folder.path / "main", {"m", {{"side.bin", "new"}}}, {.overwrite = true});
    CHECK(read_file(folder.path / "side.bin") == "new");
}
