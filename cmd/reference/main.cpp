// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Writes the manual pages and the completion scripts: wm3d_reference FOLDER
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "commands.hpp"
#include "reference/completion.hpp"
#include "reference/man_page.hpp"

namespace {

namespace fs = std::filesystem;
using namespace wm3d::cmd;

bool write(const fs::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        fmt::print(stderr, "wm3d_reference: {}: the file can't be written\n", path.string());
    return static_cast<bool>(file);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: wm3d_reference FOLDER\n");
        return 2;
    }
    const fs::path folder = argv[1];
    std::vector<reference::Page> pages;
    for (const Command& command : commands())
        pages.push_back(reference::describe(command));
    fs::create_directories(folder);
    bool written = write(folder / "wm3d.1", reference::man_overview(commands()));
    for (const reference::Page& page : pages)
        written &= write(folder / fmt::format("wm3d-{}.1", page.name), reference::man_page(page));
    written &= write(folder / "wm3d.bash", reference::bash_completion(pages));
    written &= write(folder / "_wm3d", reference::zsh_completion(pages));
    written &= write(folder / "wm3d.fish", reference::fish_completion(pages));
    return written ? 0 : 1;
}
