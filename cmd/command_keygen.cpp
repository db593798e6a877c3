// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_keygen.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/key.hpp>

#include "support/output.hpp"

namespace wm3d::cmd {

namespace {

struct KeygenOptions {
    std::string path;
    std::string name;
};

int run(const KeygenOptions& options, Output& output) {
    const key::Key key = key::Key::generate(options.name);
    key.save(options.path);
    output.say(
        fmt::format("Wrote a new key to {}. Who has this file can prove and find your marks: keep it secret, "
                    "and keep a copy.",
                    options.path));
    output.print(fmt::format("fingerprint  {}\ncommitment   {}\n", key.fingerprint(), key.commitment()));
    output.print_json({{"output", options.path},
                       {"name", key.name()},
                       {"fingerprint", key.fingerprint()},
                       {"commitment", key.commitment()}});
    return exit_done;
}

} // namespace

Action declare_keygen(CLI::App& app) {
    const auto options = std::make_shared<KeygenOptions>();
    app.description(
        "Makes an owner's key: 256 random secret bits and public parameters in a short text file that only\n"
        "its owner may read (mode 0600). A file that exists is never replaced.\n"
        "Prints the key's fingerprint and commitment, which may be published.");
    app.add_option("KEYFILE", options->path, "File to write")->option_text("FILE")->required();
    app.add_option("--name", options->name, "Name of the key, for people; it is not secret")
        ->option_text("S");
    app.footer("Example:\n  wm3d keygen museum.key --name 'City Museum, 2024'");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
