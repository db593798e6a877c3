// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_keygen.hpp"

#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/key.hpp>

#include "support/commitment_files.hpp"
#include "support/output.hpp"
#include "support/passphrase.hpp"
#include "support/usage.hpp"

namespace wm3d::cmd {

namespace {

struct KeygenOptions {
    std::string path;
    std::string name;
    std::string commitment;
    bool passphrase = false; ///< ask for one
    int passphrase_fd = -1;  ///< read one; below 0: don't
};

/// The passphrase that is to protect the key, if one is wanted.
std::optional<key::Passphrase> new_passphrase(const KeygenOptions& options) {
    if (options.passphrase_fd >= 0)
        return passphrase_from(options.passphrase_fd);
    if (!options.passphrase)
        return std::nullopt;
    const key::Passphrase first = ask_passphrase(fmt::format("New passphrase of {}: ", options.path));
    if (ask_passphrase("The same once more: ").text() != first.text())
        throw InputError("the two passphrases differ, so no key was made; try again");
    return first;
}

int run(const KeygenOptions& options, Output& output) {
    check_commitment_target(options.commitment, false);
    protect_memory();
    const std::optional<key::Passphrase> passphrase = new_passphrase(options);
    const key::Key key = key::Key::generate(options.name);
    io::FileSet deposit; // on the disk before the key is, so that a full disk leaves neither
    add_commitment_files(deposit, options.commitment, commitment::commit_to(key, {}));
    key.save(options.path, passphrase ? &*passphrase : nullptr);
    deposit.commit();
    output.say(fmt::format(
        "Wrote a new key to {}. Who has this file{} can prove and find your marks: keep it secret, "
        "and keep a copy.",
        options.path, passphrase ? " and its passphrase" : ""));
    output.print(fmt::format("fingerprint  {}\ncommitment   {}\n", key.fingerprint(), key.commitment()));
    nlohmann::ordered_json json{{"output", options.path},
                                {"name", key.name()},
                                {"fingerprint", key.fingerprint()},
                                {"commitment", key.commitment()}};
    if (!options.commitment.empty())
        json["commitment_file"] = options.commitment;
    output.print_json(json);
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
    app.add_flag("--passphrase", options->passphrase,
                 "Ask for a passphrase, without which the key can't be used");
    app.add_option(
           "--passphrase-fd", options->passphrase_fd,
           "Read the passphrase from this file descriptor; every command that reads the key has this too")
        ->option_text("N")
        ->check(whole_number_between(0, 1 << 20));
    add_commitment_output(app, options->commitment);
    app.footer("Example:\n  wm3d keygen museum.key --name 'City Museum, 2024'");
    return [options](Output& output) { return run(*options, output); };
}

} // namespace wm3d::cmd
