// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Everything a command tells: data to standard output, talk to standard error.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/core/progress.hpp>

#include "support/progress_line.hpp"

namespace wm3d::cmd {

/// The options that every command has.
struct OutputOptions {
    bool json = false;       ///< --json: one object on standard output instead of text
    bool quiet = false;      ///< -q: errors only, besides the data that was asked for
    bool verbose = false;    ///< -v: say what happens on the way
    std::size_t threads = 0; ///< --threads: 0 means as many as the machine has
    int passphrase_fd = -1;  ///< --passphrase-fd, of commands that read a key; below 0: ask
};

/// Colours of words on a terminal.
enum class Tone { plain, good, bad, warning };

class Output {
public:
    Output(std::string command, const OutputOptions& options);

    bool json() const { return options_.json; }
    bool quiet() const { return options_.quiet; }
    bool verbose() const { return options_.verbose; }
    int passphrase_descriptor() const { return options_.passphrase_fd; }

    /// A sentence for the person who watches, on standard error; silent with -q.
    void say(std::string_view sentence);

    /// As `say`, with -v only.
    void detail(std::string_view sentence);

    /// As `say`, but -q doesn't silence it: "warning: ...".
    void warn(std::string_view sentence);

    /// As `warn`, for what makes the command fail without being an error of its input: "failed: ...".
    void fail(std::string_view sentence);

    /// The same, and with --json the error object: for commands that have no other object to print then.
    void fail(std::string_view sentence, ErrorCode code);

    /// Text of the result, on standard output. With --json nothing: the object says it all.
    void print(std::string_view text);

    /// With --json, prints `result` on standard output after adding
    /// "schema": "wm3d.COMMAND/`version`" at its front; otherwise nothing.
    void print_json(const nlohmann::ordered_json& result, int version = 1);

    /// Bytes of a produced file, on standard output (`-o -`).
    void write_bytes(std::string_view bytes);

    /// `text` in colour where standard output is a terminal that wants it (NO_COLOR, TERM=dumb).
    std::string toned(std::string_view text, Tone tone) const;

    /// For the functions of the modules; empty unless standard error is a terminal. Lives as long as this.
    Progress progress();

private:
    void tell(std::string_view line);

    std::string command_;
    OutputOptions options_;
    ProgressLine line_;
};

/// "WHO: error: sentence" on standard error, and with `json` the error object on standard output.
void write_error(std::string_view who, std::string_view sentence, ErrorCode code, bool json);

} // namespace wm3d::cmd
