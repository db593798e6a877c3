// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/wrap.hpp"

#include <doctest/doctest.h>

using wm3d::cmd::help_column;
using wm3d::cmd::wrapped;

TEST_CASE("what fits stays as it is, with all its lines and blanks") {
    const std::string text = "Marks.\nVerifies.\n\nOptions:\n  --key FILE    The key\n";
    CHECK(wrapped(text, 40, 16) == text);
}

TEST_CASE("a paragraph with a line too long is filled anew") {
    CHECK(wrapped("one two three four\nfive six\n\nseven\n", 12, 4) ==
          "one two\nthree four\nfive six\n\nseven\n");
}

TEST_CASE("a description goes on below itself") {
    CHECK(wrapped("  --key FILE    The key of the owner\n", 26, 16) == "  --key FILE    The key of\n"
                                                                       "                the owner\n");
    // The name was too long, so its description is alone on its line.
    CHECK(wrapped("  --commitment FILE\n                What an owner deposited\n", 30, 16) ==
          "  --commitment FILE\n                What an owner\n                deposited\n");
}

TEST_CASE("commands stay commands: lines go on after a backslash, quoted words stay whole") {
    CHECK(wrapped("Example:\n  wm3d keygen museum.key --name 'City Museum, 2024'\n", 40, 16) ==
          "Example:\n  wm3d keygen museum.key --name \\\n      'City Museum, 2024'\n");
    CHECK(wrapped("Lists:\n  a b c d e f\n", 8, 99) == "Lists:\n  a b c\n    d e\n    f\n");
}

TEST_CASE("a word that no line holds stands alone") {
    CHECK(wrapped("a verylongwordindeed b\n", 8, 4) == "a\nverylongwordindeed\nb\n");
}

TEST_CASE("the description's column follows the width") {
    CHECK(help_column(100) == 32);
    CHECK(help_column(80) == 32);
    CHECK(help_column(40) == 16);
}
