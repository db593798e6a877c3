// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/external.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>

namespace wm3d::cmd {

namespace fs = std::filesystem;

std::optional<fs::path> find_external(std::string_view name, std::string_view search_path) {
    if (name.empty() || name.front() == '-' || name.find('/') != std::string_view::npos)
        return std::nullopt;
    const std::string file = fmt::format("wm3d-{}", name);
    while (!search_path.empty()) {
        const std::size_t end = search_path.find(':');
        const std::string_view folder = search_path.substr(0, end);
        search_path.remove_prefix(end == std::string_view::npos ? search_path.size() : end + 1);
        // An empty folder would mean the current one: whatever lies there must not become a command.
        if (folder.empty())
            continue;
        const fs::path candidate = fs::path(folder) / file;
        std::error_code ignored;
        if (fs::is_regular_file(candidate, ignored) && ::access(candidate.c_str(), X_OK) == 0)
            return candidate;
    }
    return std::nullopt;
}

void run_external(const fs::path& executable, std::span<char* const> arguments) {
    std::string path = executable.string();
    std::vector<char*> argv{path.data()};
    argv.insert(argv.end(), arguments.begin(), arguments.end());
    argv.push_back(nullptr);
    std::signal(SIGPIPE, SIG_DFL); // an ignored signal would stay ignored in the new program
    ::execv(path.c_str(), argv.data());
    throw Error(fmt::format("'{}' can't be run: {}", path, std::strerror(errno)));
}

} // namespace wm3d::cmd
