// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/key_files.hpp"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "support/passphrase.hpp"

namespace wm3d::cmd {

namespace {

/// Whether the group's or others' permissions let them read a file; a pipe is nobody else's.
bool others_may_read(const std::string& path) {
    using std::filesystem::perms;
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(path, failure);
    return !failure && std::filesystem::is_regular_file(status) &&
           (status.permissions() & (perms::group_read | perms::others_read)) != perms::none;
}

} // namespace

key::Key load_key(const std::string& path, Output& output) {
    protect_memory();
    key::AskPassphrase ask;
    if (const int descriptor = output.passphrase_descriptor(); descriptor >= 0)
        ask = [descriptor] { return passphrase_from(descriptor); };
    else if (can_ask())
        ask = [&path] { return ask_passphrase(fmt::format("Passphrase of {}: ", path)); };
    key::Key key = key::Key::load(path, ask);
    if (others_may_read(path))
        output.warn(fmt::format(
            "{0}: other users of this machine can read this key, and with it make, find and remove "
            "its marks; keep it to yourself with: chmod 600 {0}",
            path));
    return key;
}

} // namespace wm3d::cmd
