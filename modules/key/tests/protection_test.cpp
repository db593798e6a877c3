// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/protection.hpp"

#include <fstream>
#include <sstream>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/key/key_file.hpp>

#include "fixed_secret.hpp"
#include "message_of.hpp"

using namespace wm3d;
using namespace wm3d::key;
using key::test::message_of;

namespace {

/// Written by generate/protected_key.py; the passphrase is "correct horse ë".
constexpr std::string_view frozen_protected =
    "wm3d key, version 2\n"
    "# A comment.\n"
    "name: Museum of Casts\n"
    "protected-secret: argon2id 1 8 6465666768696a6b6c6d6e6f70717273 "
    "c8c9cacbcccdcecfd0d1d2d3d4d5d6d7d8d9dadbdcdddedf "
    "6b35e74f7130ec2860d55e551fe8b5a96e81a44e7d21853abad97da776228a6f8663142dd97b585203136ca43f203bd5\n"
    "levels: 4 6\n"
    "rmax: 0.2\n"
    "reference-strength: 0.03\n"
    "created-by: wm3d 0.1.0\n"
    "checksum: 672d465c993e21e1f3a60a8a0720ee1f\n";

constexpr ProtectionCost cheap{1, 8};

AskPassphrase answer(const std::string& text) {
    return [text] { return Passphrase(std::string(text)); };
}

/// The line of /proc/self/smaps that tells how the kernel treats the memory at `address`.
std::string flags_of(const void* address) {
    std::ifstream maps("/proc/self/smaps");
    const auto wanted = reinterpret_cast<std::uintptr_t>(address);
    bool inside = false;
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t begin = 0, end = 0;
        char dash = 0;
        std::istringstream range(line);
        if (range >> std::hex >> begin >> dash >> end && dash == '-')
            inside = begin <= wanted && wanted < end;
        else if (inside && line.starts_with("VmFlags:"))
            return line + " ";
    }
    return "";
}

} // namespace

TEST_CASE("a frozen protected key opens with its passphrase, and with no other") {
    const Key key = Key::parse(frozen_protected, "frozen.key", answer("correct horse \xc3\xab"));
    CHECK(key.name() == "Museum of Casts");
    CHECK(key.parameters() == PublicParameters{{4, 6}, 0.2, 0.03});
    CHECK(key.secret() == fixed_secret());
    CHECK(message_of<Error>([] {
              Key::parse(frozen_protected, "frozen.key", answer("correct horse e"));
          }).starts_with("frozen.key: the passphrase doesn't open this key"));
    CHECK(message_of<Error>([] { Key::parse(frozen_protected, "frozen.key"); }).find("--passphrase-fd") !=
          std::string::npos);
}

TEST_CASE("a protected key survives its text, which tells nothing of the secret") {
    const Key key = Key::generate("Studio");
    const Passphrase passphrase(std::string("open sesame"));
    const std::string text = key.to_text(&passphrase, cheap), again = key.to_text(&passphrase, cheap);
    CHECK(text.starts_with("wm3d key, version 2\n"));
    CHECK(text != again); // salt and nonce are new
    CHECK(text.find(hex(key.secret().bytes())) == std::string::npos);
    CHECK(text.find("open sesame") == std::string::npos);
    CHECK(Key::parse(text, "k", answer("open sesame")).secret() == key.secret());
    CHECK(key.to_text().starts_with("wm3d key, version 1\n"));
}

TEST_CASE("nobody is asked before all else is right") {
    int asked = 0;
    const AskPassphrase ask = [&] {
        ++asked;
        return Passphrase(std::string("x"));
    };
    for (std::size_t at = 0; at < frozen_protected.size() - 1; at += 3) {
        std::string text(frozen_protected);
        text[at] = static_cast<char>(text[at] ^ 1);
        CHECK_THROWS_AS(Key::parse(text, "altered", ask), InputError);
    }
    CHECK(asked == 0);
    CHECK_THROWS_AS(Key::parse(frozen_protected, "frozen", ask), InputError);
    CHECK(asked == 1);
}

TEST_CASE("an altered box does not open, and costs without measure are refused") {
    const Passphrase passphrase(std::string("p"));
    const ProtectedSecret whole = protect(fixed_secret(), passphrase, cheap);
    CHECK(opened(whole, passphrase) == std::optional(fixed_secret()));
    for (std::string ProtectedSecret::*part :
         {&ProtectedSecret::salt, &ProtectedSecret::nonce, &ProtectedSecret::box}) {
        ProtectedSecret altered = whole;
        (altered.*part)[3] = static_cast<char>((altered.*part)[3] ^ 4);
        CHECK_FALSE(opened(altered, passphrase));
    }
    const std::string text = to_text(whole);
    CHECK(parse_protected(text));
    for (const char* cost : {"argon2id 0 8", "argon2id 1 0", "argon2id 21 8", "argon2id 1 4097",
                             "argon2id -1 8", "argon2i 1 8", "argon2id 1 8 00", "argon2id 4294967297 8"})
        CHECK_FALSE(parse_protected(cost + text.substr(std::string("argon2id 1 8").size())));
    CHECK_FALSE(parse_protected(text.substr(0, text.size() - 1)));
    CHECK_FALSE(parse_protected(""));
}

TEST_CASE("passphrases have a length, and their source is wiped") {
    std::string text = "a passphrase that is long enough to live on the heap";
    const Passphrase passphrase(std::move(text));
    CHECK(text.empty()); // NOLINT: it says that it wipes
    CHECK(passphrase.text().starts_with("a passphrase"));
    CHECK_THROWS_AS(Passphrase{std::string()}, ParameterError);
    CHECK_THROWS_AS(Passphrase(std::string(Passphrase::size_limit + 1, 'x')), ParameterError);
}

TEST_CASE("secrets lie where they are neither swapped out nor dumped") {
    const Secret secret = Secret::random();
    const Secret copy = secret; // NOLINT(performance-unnecessary-copy-initialization): where does it lie?
    CHECK(copy.bytes().data() == secret.bytes().data());
    const std::string flags = flags_of(secret.bytes().data());
    if (flags.empty()) {
        MESSAGE("SKIPPED: the system doesn't tell how it treats memory (/proc/self/smaps)");
        return;
    }
    CAPTURE(flags);
    CHECK(flags.find(" dd ") != std::string::npos);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // with them mlock does nothing
    CHECK(flags.find(" lo ") != std::string::npos);
#endif
}
