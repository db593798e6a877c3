// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/output.hpp"

#include <cstdio>
#include <functional>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <wm3d/core/error.hpp>

#include "support/streams.hpp"

using namespace wm3d::cmd;

namespace {

/// What `work` writes to a file descriptor.
std::string captured(int descriptor, const std::function<void()>& work) {
    std::FILE* file = std::tmpfile();
    const int saved = ::dup(descriptor);
    ::dup2(::fileno(file), descriptor);
    work();
    ::dup2(saved, descriptor);
    ::close(saved);
    std::string text;
    std::rewind(file);
    for (int c; (c = std::fgetc(file)) != EOF;)
        text += static_cast<char>(c);
    std::fclose(file);
    return text;
}

} // namespace

TEST_CASE("text and JSON exclude each other") {
    for (const bool json : {false, true}) {
        Output output("thing", {.json = json});
        const std::string text = captured(STDOUT_FILENO, [&] {
            output.print("plain\n");
            output.print_json({{"value", 0.1}, {"name", "x"}});
        });
        if (json) {
            const auto object = nlohmann::ordered_json::parse(text);
            CHECK(object.begin().key() == "schema");
            CHECK(object["schema"] == "wm3d.thing/1");
            CHECK(object["value"] == 0.1);
        } else
            CHECK(text == "plain\n");
    }
}

TEST_CASE("talk goes to standard error, and -q silences it") {
    for (const bool quiet : {false, true}) {
        Output output("thing", {.quiet = quiet});
        const std::string text = captured(STDERR_FILENO, [&] {
            output.say("one");
            output.detail("two");
            output.warn("three");
        });
        CHECK(text == (quiet ? "warning: three\n" : "one\nwarning: three\n"));
    }
    Output output("thing", {.verbose = true});
    CHECK(captured(STDERR_FILENO, [&] { output.detail("two"); }) == "two\n");
}

TEST_CASE("without a terminal there is neither progress nor colour") {
    Output output("thing", {});
    captured(STDERR_FILENO, [&] { CHECK_FALSE(static_cast<bool>(output.progress())); });
    captured(STDOUT_FILENO, [&] { CHECK(output.toned("present", Tone::good) == "present"); });
}

TEST_CASE("a reader that went away and a full disk are different things") {
    prepare_standard_streams();
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    ::close(ends[0]);
    CHECK_THROWS_AS(write_all(ends[1], "data"), ClosedPipe);
    ::close(ends[1]);
    CHECK_THROWS_AS(write_all(ends[1], "data"), wm3d::OutputError);
}
