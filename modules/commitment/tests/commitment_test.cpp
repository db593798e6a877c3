// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/commitment/commitment.hpp>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>

using namespace wm3d;
using namespace wm3d::commitment;

namespace {

/// What this version writes must stay readable, and mean the same.
constexpr std::string_view frozen_key =
    "wm3d key, version 1\n"
    "# A comment.\n"
    "name: Museum of Casts\n"
    "secret: 000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f\n"
    "levels: 4 6\n"
    "rmax: 0.2\n"
    "reference-strength: 0.03\n"
    "created-by: wm3d 0.1.0\n"
    "checksum: f461349b03ee963bb6cbb80bab47c526\n";

key::Key frozen() {
    return key::Key::parse(frozen_key, "frozen.key");
}

bool says(std::string_view text, std::string_view what) {
    try {
        parse_commitment(text, "c");
    } catch (const InputError& error) {
        const std::string message = error.what();
        CAPTURE(message);
        return message.starts_with("c: ") && message.find(what) != std::string::npos;
    }
    return false;
}

} // namespace

TEST_CASE("a commitment survives its text and tells no secret") {
    const key::Key key = frozen();
    for (const bool with_receipt : {false, true}) {
        const auto receipt = with_receipt ? std::optional<std::string>("the receipt") : std::nullopt;
        const std::string text = to_text(commit_to(key, {12345}, receipt));
        const Commitment again = parse_commitment(text, "c");
        CHECK(to_text(again) == text);
        CHECK(again.settings.base_vertices == 12345);
        CHECK(again.parameters == key.parameters());
        CHECK(again.receipt.has_value() == with_receipt);
        CHECK(text.find("000102030405") == std::string::npos);
        CHECK(text.find("Museum") == std::string::npos);
    }
}

TEST_CASE("a commitment covers what it was made for") {
    const key::Key key = frozen();
    const Commitment with = commit_to(key, {}, "receipt"), without = commit_to(key, {});
    CHECK(check(with, key, {}, "receipt", "c").settings);
    CHECK(check(with, key, {}, "receipt", "c").receipt == std::optional(true));
    CHECK(check(without, key, {}, "receipt", "c").receipt == std::optional(false));
    CHECK(check(with, key, {}, std::nullopt, "c").receipt == std::nullopt);
    CHECK_FALSE(check(with, key, {9999}, std::nullopt, "c").settings);
}

TEST_CASE("another key, other parameters and another receipt are refused") {
    const key::Key key = frozen(), other = key::Key::generate("other", key.parameters());
    const Commitment commitment = commit_to(key, {}, "receipt");
    CHECK_THROWS_WITH_AS(check(commitment, other, {}, std::nullopt, "c"), doctest::Contains("not to key"),
                         InputError);
    CHECK_THROWS_WITH_AS(check(commitment, key, {}, "another receipt", "c"),
                         doctest::Contains("not the one that was committed to"), InputError);
    Commitment changed = commitment;
    changed.parameters.rmax = 0.3;
    CHECK_THROWS_WITH_AS(check(changed, key, {}, "receipt", "c"), doctest::Contains("public parameters"),
                         InputError);
}

TEST_CASE("what is no commitment is refused in one sentence") {
    const std::string whole = to_text(commit_to(frozen(), {}, "receipt"));
    for (std::size_t length = 0; length + 2 < whole.size(); length += 7)
        CHECK(says(whole.substr(0, length), "no commitment"));
    CHECK(says("[1, 2]", "no commitment"));
    CHECK(says("{\"schema\":\"wm3d.receipt/1\"}", "no commitment"));
    CHECK(says("{\"schema\":\"wm3d.commitment/2\"}", "use a newer wm3d"));
    CHECK(says("{\"schema\":\"wm3d.commitment/1\"}", "missing or out of range"));
    std::string altered = whole;
    altered[altered.find("\"fingerprint\": \"") + 16] = 'x';
    CHECK(says(altered, "missing or out of range"));
    for (const char* number :
         {"2.01e302", "-1", "20000.0", "null", "18446744073709551616"}) { // found by fuzzing
        std::string odd = whole;
        odd.replace(odd.find("20000"), 5, number);
        CHECK(says(odd, "missing or out of range"));
    }
    CHECK(says(std::string(300, '[') + std::string(300, ']'), "brackets nest"));
}

TEST_CASE("the frozen text of a commitment") {
    CHECK(commit_to(frozen(), {}).key_fingerprint == frozen().fingerprint());
    const Commitment c = parse_commitment(R"({"schema": "wm3d.commitment/1", "tool": "wm3d 0.1.0", "key":
        {"fingerprint": "0123456789abcdef", "commitment": "00000000000000000000000000000000000000000000000000000000000000ff",
        "levels": [4, 6], "rmax": 0.2, "reference_strength": 0.03}, "settings": {"base_vertices": 20000}, "receipt":
        {"sha256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", "bytes": 3}})",
                                          "c");
    CHECK(c.parameters.levels == std::vector<unsigned>{4, 6});
    CHECK(c.receipt == resync::digest_of("abc"));
}
