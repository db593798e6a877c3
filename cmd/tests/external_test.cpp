// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/external.hpp"

#include <cstdlib>
#include <fstream>

#include <doctest/doctest.h>

namespace fs = std::filesystem;
using wm3d::cmd::find_external;

namespace {

/// A folder that goes away with the object.
struct TemporaryFolder {
    fs::path path;
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "wm3d-XXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    ~TemporaryFolder() { fs::remove_all(path); }
};

void make_file(const fs::path& path, fs::perms permissions) {
    std::ofstream(path) << "#!/bin/sh\n";
    fs::permissions(path, permissions);
}

} // namespace

TEST_CASE("an external command is an executable file wm3d-NAME on the search path") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path / "first" / "wm3d-folder");
    fs::create_directories(folder.path / "second");
    make_file(folder.path / "first" / "wm3d-plain", fs::perms::owner_read);
    make_file(folder.path / "second" / "wm3d-plain", fs::perms::owner_all);
    make_file(folder.path / "second" / "wm3d-tool", fs::perms::owner_all);
    const std::string search = (folder.path / "first").string() + "::" + (folder.path / "second").string();

    CHECK(find_external("tool", search) == folder.path / "second" / "wm3d-tool");
    CHECK_FALSE(find_external("folder", search).has_value());
    CHECK_FALSE(find_external("missing", search).has_value());
    CHECK_FALSE(find_external("", search).has_value());
    CHECK_FALSE(find_external("../second/wm3d-tool", search).has_value());
    CHECK_FALSE(find_external("-tool", search).has_value());
    CHECK_FALSE(find_external("tool", "").has_value());
    SUBCASE("a file that isn't executable is passed over") {
        CHECK(find_external("plain", search) == folder.path / "second" / "wm3d-plain");
    }
}
