// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/core/version.hpp>

#include "commands.hpp"
#include "support/external.hpp"
#include "support/output.hpp"
#include "support/streams.hpp"
#include "support/suggest.hpp"
#include "support/usage.hpp"
#include "support/wrap.hpp"

namespace wm3d::cmd {

namespace {

/// Whoever is told of an error.
struct Caller {
    std::string who;   ///< the command, as it was called
    bool json = false; ///< --json is among its arguments, even where they can't be understood

    Caller(std::string name, std::span<char* const> arguments)
        : who(std::move(name)),
          json(std::ranges::find(arguments, std::string_view("--json")) != arguments.end()) {}

    int complain(std::string_view sentence, ErrorCode code) const {
        write_error(who, sentence, code, json);
        return exit_error;
    }
};

std::string overview() {
    std::string text =
        "wm3d hides an owner's mark in the geometry of a 3D mesh, and later tells from a copy\n"
        "and the owner's key alone whether the mark is there.\n\n"
        "Usage: wm3d COMMAND [OPTIONS]\n";
    std::string_view group;
    for (const Command& command : commands()) {
        if (command.group != group)
            text += fmt::format("\n{}:\n", group = command.group);
        text += fmt::format("  {:<10} {}\n", command.name, command.summary);
    }
    text += "\n'wm3d COMMAND --help' explains a command; 'wm3d --version' names the version.\n"
            "Any other NAME runs the executable 'wm3d-NAME' from PATH.\n";
    constexpr std::size_t summaries = 13; // column
    return wrapped(text, help_width(), summaries);
}

int run_command(const Command& command, std::span<char* const> arguments) {
    const std::string name = fmt::format("wm3d {}", command.name);
    CLI::App app{std::string(command.summary), name};
    OutputOptions options;
    const Action action = declare(command, app, options);
    try {
        // CLI11 takes the arguments last first.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        write_all(STDOUT_FILENO, help_text(app, help_width()));
        return exit_done;
    } catch (const CLI::ParseError& error) {
        return Caller(name, arguments).complain(usage_complaint(app, error), ErrorCode::usage);
    }
    const ThreadLimit limit(options.threads);
    Output output(std::string(command.name), options);
    return action(output);
}

int unknown_command(std::string_view name, std::span<char* const> arguments) {
    const Caller caller("wm3d", arguments);
    const auto complain = [&](std::string_view sentence) {
        return caller.complain(sentence, ErrorCode::usage);
    };
    if (name.starts_with('-'))
        return complain(fmt::format("'{}' is not an option; see 'wm3d --help'.", name));
    std::vector<std::string_view> names;
    for (const Command& command : commands())
        names.push_back(command.name);
    if (const auto near = nearest_name(name, names))
        return complain(fmt::format("'{}' is not a command; did you mean '{}'?", name, *near));
    return complain(fmt::format("'{}' is neither a command nor an executable 'wm3d-{}' on PATH; "
                                "see 'wm3d --help'.",
                                name, name));
}

int dispatch(std::span<char* const> arguments) {
    if (arguments.size() < 2) {
        write_message(overview());
        return exit_error;
    }
    std::string_view name = arguments[1];
    std::span<char* const> rest = arguments.subspan(2);
    char help_flag[] = "--help";
    char* const help_arguments[] = {help_flag};
    if (name == "help" && !rest.empty()) { // wm3d help NAME is wm3d NAME --help
        name = rest[0];
        rest = help_arguments;
    }
    if (name == "--help" || name == "-h" || name == "help") {
        write_all(STDOUT_FILENO, overview());
        return exit_done;
    }
    if (name == "--version" || name == "-V") {
        write_all(STDOUT_FILENO, fmt::format("wm3d {}\n", version()));
        return exit_done;
    }
    if (const Command* command = find_command(name))
        return run_command(*command, rest);
    const char* path = std::getenv("PATH");
    if (const auto executable = find_external(name, path != nullptr ? path : ""))
        run_external(*executable, rest);
    return unknown_command(name, rest);
}

} // namespace

int run_program(std::span<char* const> arguments) {
    prepare_standard_streams();
    const bool known = arguments.size() > 1 && find_command(arguments[1]) != nullptr;
    const Caller caller(known ? fmt::format("wm3d {}", arguments[1]) : std::string("wm3d"), arguments);
    try {
        return dispatch(arguments);
    } catch (const ClosedPipe&) {
        return exit_error;
    } catch (const Error& error) {
        return caller.complain(error.what(), error.code());
    } catch (const std::bad_alloc&) {
        return caller.complain("there is not enough memory for this input; try a smaller mesh.",
                               ErrorCode::system);
    } catch (const std::exception& error) {
        return caller.complain(fmt::format("internal error, please report it: {}", error.what()),
                               ErrorCode::internal);
    }
}

} // namespace wm3d::cmd
