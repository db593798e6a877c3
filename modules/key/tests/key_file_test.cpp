// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/key_file.hpp>

#include <fstream>
#include <sstream>

#include <doctest/doctest.h>
#include <unistd.h>
#include <wm3d/core/error.hpp>

#include "message_of.hpp"

using namespace wm3d;
using namespace wm3d::key;
using key::test::message_of;
namespace fs = std::filesystem;

namespace {

/// A new folder that is removed with its content.
struct Folder {
    fs::path path;
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "wm3d-key-XXXXXX").string();
        REQUIRE(mkdtemp(pattern.data()) != nullptr);
        path = pattern;
    }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace

TEST_CASE("a saved key is read again, and only its owner may read the file") {
    const Folder folder;
    const fs::path path = folder.path / "owner.key";
    const Key key = Key::generate("Museum");
    key.save(path);
    CHECK(Key::load(path).secret() == key.secret());
    CHECK(content(path) == key.to_text());
    CHECK((fs::status(path).permissions() & fs::perms::all) ==
          (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("a key never overwrites, not even through a dangling link") {
    const Folder folder;
    const fs::path path = folder.path / "owner.key";
    const Key first = Key::generate("first");
    first.save(path);
    const std::string message = message_of<OutputError>([&] { Key::generate("second").save(path); });
    CHECK(message.find("never overwritten") != std::string::npos);
    CHECK(content(path) == first.to_text());
    fs::create_symlink(folder.path / "elsewhere", folder.path / "link.key");
    CHECK_THROWS_AS(first.save(folder.path / "link.key"), OutputError);
    CHECK_FALSE(fs::exists(folder.path / "elsewhere"));
}

TEST_CASE("a key that can't be written leaves nothing behind") {
    const Folder folder;
    const Key key = Key::generate("Museum");
    CHECK(message_of<OutputError>([&] {
              key.save(folder.path / "none" / "owner.key");
          }).find("can't be created") != std::string::npos);
    CHECK_THROWS_AS(key.save(folder.path), OutputError);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a missing file, a folder and a large file that is no key are told apart") {
    const Folder folder;
    CHECK(message_of<InputError>([&] { Key::load(folder.path / "none.key"); }).find("No such file") !=
          std::string::npos);
    CHECK(message_of<InputError>([&] { Key::load(folder.path); }).find("is a folder") != std::string::npos);
    std::ofstream(folder.path / "large") << std::string(200000, 'v');
    CHECK(message_of<InputError>([&] { Key::load(folder.path / "large"); }).find("is not a key file") !=
          std::string::npos);
}

TEST_CASE("a key is read from a pipe") {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const Key key = Key::generate("piped");
    const std::string text = key.to_text();
    REQUIRE(write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    close(ends[1]);
    CHECK(Key::load("/dev/fd/" + std::to_string(ends[0])).secret() == key.secret());
    close(ends[0]);
}
