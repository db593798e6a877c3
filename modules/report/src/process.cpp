// SPDX-License-Identifier: GPL-3.0-or-later
#include "process.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>

extern char** environ;

namespace wm3d::report {

namespace {

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

/// An unnamed temporary file. All three streams of the process are such files, so that neither side can wait
/// for the other.
File temporary_file() {
    File file(std::tmpfile());
    if (!file)
        throw Error(fmt::format("no temporary file can be made ({}); free some space in the temporary folder",
                                std::strerror(errno)));
    return file;
}

std::string read_all(std::FILE* file) {
    std::string text;
    std::rewind(file);
    char buffer[65536];
    for (std::size_t got; (got = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        text.append(buffer, got);
    return text;
}

} // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input) {
    const File in = temporary_file(), out = temporary_file(), err = temporary_file();
    if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0)
        throw Error("the temporary folder is full; free some space there");
    std::rewind(in.get());

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ::fileno(in.get()), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ::fileno(out.get()), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ::fileno(err.get()), STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_t child = 0;
    const int failure = ::posix_spawnp(&child, argv.front(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);

    ProcessResult result;
    if (failure != 0) {
        result.found = failure != ENOENT;
        result.errors = std::strerror(failure);
        return result;
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    result.success = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    result.output = read_all(out.get());
    result.errors = read_all(err.get());
    return result;
}

} // namespace wm3d::report
