// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/file.hpp>

#include <cstdlib>
#include <filesystem>

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include <wm3d/core/error.hpp>

#include "../src/temporary_file.hpp"

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

TEST_CASE("files get the mode that the umask leaves, and replaced ones keep theirs") {
    const Folder folder;
    const auto mode = [&](const char* name) {
        return static_cast<unsigned>(fs::status(folder.path / name).permissions() & fs::perms::all);
    };
    const mode_t before = ::umask(027);
    write_file(folder.path / "new", "b");
    ::umask(before);
    CHECK(mode("new") == 0640u);
    fs::permissions(folder.path / "new", fs::perms(0604));
    write_file(folder.path / "new", "c", {.overwrite = true});
    CHECK(mode("new") == 0604u);
}

TEST_CASE("what is no regular file is not replaced") {
    const Folder folder;
    const fs::path pipe = folder.path / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK_THROWS_WITH_AS(write_file(pipe, "b", {.overwrite = true}), doctest::Contains("no regular file"),
                         OutputError);
    CHECK(fs::is_fifo(pipe));
}

TEST_CASE("several files are replaced together or not at all") {
    const Folder folder;
    fs::create_directory(folder.path / "locked");
    for (const char* name : {"a", "b"})
        write_file(folder.path / name, "old");
    {
        FileSet set({.overwrite = true});
        set.add(folder.path / "a", "new");
        set.add(folder.path / "c", "new");
        set.add(folder.path / "locked" / "d", "new");
        set.add(folder.path / "b", "new");
        CHECK(read_file(folder.path / "a") == "old");
        fs::remove_all(folder.path / "locked"); // so that d can't take its name any more
        CHECK_THROWS_AS(set.commit(), OutputError);
    }
    CHECK(read_file(folder.path / "a") == "old");
    CHECK(read_file(folder.path / "b") == "old");
    CHECK(folder.entries() == 2);

    FileSet set({.overwrite = true});
    for (const char* name : {"a", "b", "c"})
        set.add(folder.path / name, "new");
    set.commit();
    for (const char* name : {"a", "b", "c"})
        CHECK(read_file(folder.path / name) == "new");
    CHECK(folder.entries() == 3);
}

TEST_CASE("two files of a set need two names") {
    const Folder folder;
    FileSet set({.overwrite = true});
    set.add(folder.path / "a", "one");
    CHECK_THROWS_WITH_AS(set.add(folder.path / "." / "a", "two"), doctest::Contains("two outputs"),
                         OutputError);
}

TEST_CASE("a set that is given up, or meets a file that came meanwhile, leaves nothing") {
    const Folder folder;
    {
        FileSet set;
        set.add(folder.path / "a", "new");
        set.add(folder.path / "b", "new");
    }
    CHECK(folder.entries() == 0);
    FileSet set;
    set.add(folder.path / "a", "new");
    set.add(folder.path / "b", "new");
    write_file(folder.path / "b", "someone else's");
    CHECK_THROWS_WITH_AS(set.commit(), doctest::Contains("exists"), OutputError);
    CHECK(read_file(folder.path / "b") == "someone else's");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a full disk leaves every file as it was") {
    const Folder folder;
    write_file(folder.path / "side.bin", "old side");
    write_file(folder.path / "main", "old main");
    struct rlimit before {};
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit small = before;
    small.rlim_cur = 1000;
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
    CHECK_THROWS_AS(write_files(folder.path / "main", {std::string(2000, 'm'), {{"side.bin", "new side"}}},
                                {.overwrite = true}),
                    OutputError);
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, handler);
    CHECK(read_file(folder.path / "side.bin") == "old side");
    CHECK(read_file(folder.path / "main") == "old main");
    CHECK(folder.entries() == 2);
}

TEST_CASE("temporary files with and without a name behave alike") {
    using Existing = TemporaryFile::Existing;
    for (bool unnamed : {false, true}) {
        CAPTURE(unnamed);
        const Folder folder;
        const fs::path path = folder.path / std::string(250, 'x'); // no room for a longer name
        {
            TemporaryFile file(path, "one", {.unnamed = unnamed});
            CHECK_FALSE(fs::exists(path));
            file.commit(Existing::refuse);
        }
        CHECK(read_file(path) == "one");
        {
            TemporaryFile file(path, "two", {.unnamed = unnamed});
            CHECK_THROWS_AS(file.commit(Existing::refuse), OutputError);
        }
        CHECK(read_file(path) == "one");
        {
            TemporaryFile file(path, "two", {.unnamed = unnamed});
            file.commit(Existing::keep);
            CHECK(read_file(path) == "two");
            file.roll_back();
            CHECK(read_file(path) == "one");
        }
        TemporaryFile(path, "two", {.unnamed = unnamed}).commit(Existing::replace);
        CHECK(read_file(path) == "two");
        CHECK(folder.entries() == 1);
        CHECK_THROWS_AS(TemporaryFile(folder.path / "missing" / "x", "b", {.unnamed = unnamed}), OutputError);
    }
}

TEST_CASE("buffers are read below the model's folder only, whatever leads out of it") {
    const Folder folder;
    fs::create_directories(folder.path / "model" / "parts");
    write_file(folder.path / "secret", "s");
    write_file(folder.path / "model" / "parts" / "b.bin", "b");
    fs::create_symlink(folder.path / "secret", folder.path / "model" / "link.bin");
    fs::create_symlink("parts", folder.path / "model" / "same");
    REQUIRE(::mkfifo((folder.path / "model" / "pipe").c_str(), 0600) == 0);
    const Resolver resolver = resolver_beside(folder.path / "model" / "m.gltf");
    CHECK(resolver("parts/b.bin") == "b");
    CHECK(resolver("./same/b.bin") == "b");
    const std::string outside = (folder.path / "secret").string();
    for (const std::string& uri : {std::string("../secret"), std::string("parts/../../secret"), outside,
                                   "file://" + outside, std::string("link.bin")})
        CHECK_THROWS_WITH_AS(resolver(uri), doctest::Contains("outside"), InputError);
    CHECK_THROWS_WITH_AS(resolver("none\n.bin"), doctest::Contains("none?.bin is not there"), InputError);
    CHECK_THROWS_WITH_AS(resolver("pipe"), doctest::Contains("no regular file"), InputError);
    CHECK_THROWS_WITH_AS(resolver("parts"), doctest::Contains("no regular file"), InputError);
}
