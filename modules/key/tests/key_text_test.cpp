// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/key_file.hpp>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

#include "message_of.hpp"

using namespace wm3d;
using namespace wm3d::key;
using key::test::message_of;

namespace {

/// A text of version 1 whose checksum Python's hashlib made: what this version writes must stay readable.
constexpr std::string_view frozen_open =
    "wm3d key, version 1\n"
    "# A comment.\n"
    "name: Museum of Casts\n"
    "secret: 000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f\n"
    "levels: 4 6\n"
    "rmax: 0.2\n"
    "reference-strength: 0.03\n"
    "created-by: wm3d 0.1.0\n"
    "checksum: f461349b03ee963bb6cbb80bab47c526\n";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

bool says(std::string_view text, std::string_view what) {
    const std::string message = message_of<InputError>([&] { Key::parse(text, "my.key"); });
    CAPTURE(message);
    return message.starts_with("my.key: ") && message.find(what) != std::string::npos;
}

} // namespace

TEST_CASE("a frozen key file is read") {
    const Key key = Key::parse(frozen_open, "frozen.key");
    CHECK(key.name() == "Museum of Casts");
    CHECK(key.created_by() == "wm3d 0.1.0");
    CHECK(key.parameters() == PublicParameters{{4, 6}, 0.2, 0.03});
    CHECK(key.secret().bytes()[31] == 31);
}

TEST_CASE("a key survives its text, names of every kind included") {
    for (const char* name : {"", "a", "Galerie dell'Accademia: David", "# not a comment", "名前", "x: y"}) {
        const Key key = Key::generate(name, {{0, 9}, 1.0 / 3, 0.1});
        const Key again = Key::parse(key.to_text(), "text");
        CHECK(again.name() == name);
        CHECK(again.secret() == key.secret());
        CHECK(again.parameters() == key.parameters());
        CHECK(again.created_by() == key.created_by());
        CHECK(again.to_text() == key.to_text());
        CHECK(again.fingerprint() == key.fingerprint());
    }
}

TEST_CASE("the text has its version, its defaults and no second secret") {
    const std::string text = Key::generate("Studio").to_text();
    CHECK(text.starts_with("wm3d key, version 1\n"));
    CHECK(text.find("\nname: Studio\n") != std::string::npos);
    CHECK(text.find("\nlevels: 3 4 5 6\n") != std::string::npos);
    CHECK(text.find("\nrmax: 0.1\n") != std::string::npos);
    CHECK(text.find("\nreference-strength: 0.05\n") != std::string::npos);
    CHECK(text != Key::generate("Studio").to_text());
}

TEST_CASE("changed line ends do no harm") {
    std::string text(frozen_open);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.replace(at, 1, "\r\n");
    CHECK(Key::parse(text, "dos.key").name() == "Museum of Casts");
    CHECK(Key::parse(frozen_open.substr(0, frozen_open.size() - 1), "no end.key").name() ==
          "Museum of Casts");
}

TEST_CASE("a text cut anywhere is refused") {
    for (std::size_t length = 0; length + 1 < frozen_open.size(); ++length)
        CHECK_THROWS_AS(Key::parse(frozen_open.substr(0, length), "cut.key"), InputError);
    CHECK(says(frozen_open.substr(0, frozen_open.size() - 9), "was cut"));
    CHECK(says(frozen_open.substr(0, 70), "was cut"));
}

TEST_CASE("a text with any byte altered is refused") {
    for (std::size_t at = 0; at < frozen_open.size() - 1; ++at) {
        std::string text(frozen_open);
        text[at] = static_cast<char>(text[at] ^ 1);
        CHECK_THROWS_AS(Key::parse(text, "altered.key"), InputError);
    }
    CHECK(says(replaced(std::string(frozen_open), "rmax: 0.2", "rmax: 0.3"), "was altered"));
}

TEST_CASE("what is no key file is told from a key file of a newer version") {
    CHECK(says("", "is not a key file"));
    CHECK(says("ply\nformat ascii 1.0\n", "is not a key file"));
    CHECK(says("wm3d key, version zero\n", "is not a key file"));
    CHECK(says("wm3d key, version 0\n", "is not a key file"));
    CHECK(says(replaced(std::string(frozen_open), "version 1", "version 3"), "understands version 2"));
}

TEST_CASE("names that are not UTF-8 are refused") {
    for (const char* name :
         {"\x80", "a\xc3", "\xc3(", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xff", "\xe2\x82"})
        CHECK_THROWS_AS(Key::generate(name), ParameterError);
    for (const char* name : {"\x7e", "\xc2\xa0", "\xdf\xbf", "\xed\x9f\xbf", "\xee\x80\x80",
                             "\xf0\x9f\x97\xbf", "\xf4\x8f\xbf\xbf"})
        CHECK(Key::generate(name).name() == name);
}

TEST_CASE("names and parameters out of range are refused") {
    CHECK_THROWS_AS(Key::generate("two\nlines"), ParameterError);
    CHECK_THROWS_AS(Key::generate(" space"), ParameterError);
    CHECK_THROWS_AS(Key::generate(std::string(201, 'x')), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{}, 0.1, 0.05}), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{4, 3}, 0.1, 0.05}), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{3, 3}, 0.1, 0.05}), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{10}, 0.1, 0.05}), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{3}, 0.0, 0.05}), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{3}, 1.0, 0.05}), ParameterError);
    CHECK_THROWS_AS(Key::generate("", {{3}, 0.1, 0.0}), ParameterError);
}
