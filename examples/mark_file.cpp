// SPDX-License-Identifier: GPL-3.0-or-later
// mark_file IN OUT KEYFILE: marks a mesh file, as `wm3d mark` does.
#include <cstdio>

#include <wm3d/wm3d.hpp>

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: mark_file IN OUT KEYFILE\n");
        return 2;
    }
    try {
        const wm3d::MarkedFile result = wm3d::mark_file(argv[1], argv[2], wm3d::Key::load(argv[3]));
        if (!result.written) {
            std::fprintf(stderr, "%s\n", result.reason.c_str());
            return 1;
        }
        std::printf("%s holds the mark: log10 p = %.1f\n", argv[2], result.check.score.log10_p);
        return 0;
    } catch (const wm3d::Error& error) {
        // error.code() is for programs, the sentence for people.
        const bool in_the_way = error.code() == wm3d::ErrorCode::output_exists;
        std::fprintf(stderr, "%s%s\n", error.what(), in_the_way ? " (set MarkFileOptions::overwrite)" : "");
        return 2;
    }
}
