// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>

#include "commands.hpp"
#include "reference/completion.hpp"
#include "reference/man_page.hpp"

using namespace wm3d::cmd;
using namespace wm3d::cmd::reference;

namespace {

Page page_with(const Option& option) {
    Page page;
    page.name = "try";
    page.summary = "try something";
    page.options.push_back(option);
    return page;
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("The description of a command is that of its parser") {
    const Page page = describe(*find_command("mark"));
    CHECK(page.arguments.front().names == std::vector<std::string>{"IN"});
    const auto named = [&](const std::string& name) {
        return *std::ranges::find_if(page.options, [&](const Option& option) {
            return std::ranges::find(option.names, name) != option.names.end();
        });
    };
    CHECK(named("--output").names == std::vector<std::string>{"-o", "--output"});
    CHECK(named("--output").required);
    CHECK(named("--output").values == Values::file);
    CHECK(named("--auto").value.empty());
    CHECK(named("--normals").choices == std::vector<std::string>{"keep", "recompute"});
    CHECK(named("--threads").group == "Output");
    REQUIRE_FALSE(page.examples.empty());
    CHECK(page.examples.front().starts_with("wm3d mark "));
}

TEST_CASE("What a page says literally means nothing to troff") {
    Option option;
    option.names = {"--odd"};
    option.help = "'quoted' at the start, a\\b, and\n.TH at the start of a line";
    const std::string text = man_page(page_with(option));
    CHECK(contains(text, "\n\\&'quoted' at the start, a\\eb, and\n\\&.TH at the start of a line\n"));
    CHECK(contains(text, "\\fB\\-\\-odd\\fR"));
}

TEST_CASE("What a completion says literally means nothing to the shell") {
    Option option;
    option.names = {"-o", "--odd"};
    option.value = std::string("A:B"); // g++ 12 warns of assigned short literals
    option.help = "the user's [1:2]";
    const std::vector<Page> pages{page_with(option)};
    CHECK(contains(zsh_completion(pages), "'[the user'\\''s \\[1\\:2\\]]:A\\:B:'"));
    CHECK(contains(fish_completion(pages), "-d 'the user\\'s [1:2]'"));
    CHECK(contains(bash_completion(pages), "try:-o | try:--odd) : ;;"));
}

TEST_CASE("Choices are offered by every shell") {
    Option option;
    option.names = {"--mode"};
    option.value = std::string("M");
    option.values = Values::one_of;
    option.choices = {"one", "two"};
    const std::vector<Page> pages{page_with(option)};
    CHECK(contains(bash_completion(pages), "compgen -W 'one two'"));
    CHECK(contains(zsh_completion(pages), ":M:(one two)"));
    CHECK(contains(fish_completion(pages), "-x -a 'one two'"));
    CHECK(contains(man_page(pages.front()), ":\none, two\n"));
}
