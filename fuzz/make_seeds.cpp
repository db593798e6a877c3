// SPDX-License-Identifier: GPL-3.0-or-later
// make_seeds FOLDER writes the first inputs of every target to FOLDER/TARGET/ and its words to
// FOLDER/TARGET.dict, as libFuzzer takes them. They are made by code, so none is kept.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "target.hpp"

namespace {

namespace fs = std::filesystem;

std::string escaped(std::string_view word) {
    std::string text;
    for (const char c : word)
        text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return fmt::format("\"{}\"\n", text);
}

void write(const fs::path& folder, std::string_view target) {
    fs::create_directories(folder / target);
    int number = 0;
    for (const std::string& bytes : wm3d::fuzz::seeds(target))
        std::ofstream(folder / target / fmt::format("seed-{}", number++), std::ios::binary) << bytes;
    std::ofstream dictionary(folder / fmt::format("{}.dict", target));
    for (const std::string& word : wm3d::fuzz::words(target))
        dictionary << escaped(word);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_seeds FOLDER\n", stderr);
        return 2;
    }
    for (const std::string_view target : wm3d::fuzz::targets)
        write(argv[1], target);
    return 0;
}
