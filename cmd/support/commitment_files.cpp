// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/commitment_files.hpp"

#include <filesystem>

#include <CLI/CLI.hpp>

#include <wm3d/commitment/deposit.hpp>

#include "support/mesh_files.hpp"

namespace wm3d::cmd {

void add_commitment_output(CLI::App& app, std::string& path) {
    app.add_option("--commitment", path,
                   "Also write what can be deposited and dated, with its digest and a time stamp request")
        ->option_text("FILE");
}

void check_commitment_target(const std::string& path, bool overwrite) {
    if (path.empty())
        return;
    for (const char* suffix : {"", ".sha256", ".tsq"})
        check_target(path + suffix, overwrite);
}

void add_commitment_files(io::FileSet& set, const std::string& path,
                          const commitment::Commitment& commitment) {
    if (path.empty())
        return;
    const std::string text = commitment::to_text(commitment);
    set.add(path, text);
    set.add(path + ".sha256", commitment::sha256_line(text, std::filesystem::path(path).filename().string()));
    if (commitment::has_timestamps())
        set.add(path + ".tsq", commitment::timestamp_request(text));
}

} // namespace wm3d::cmd
