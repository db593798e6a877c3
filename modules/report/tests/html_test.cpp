// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/html.hpp>

#include <doctest/doctest.h>

#include "contains.hpp"

using namespace wm3d::report;
using test::contains;

TEST_CASE("text of the user can't become markup") {
    Page page;
    page.title = "<b>&\"";
    page.sections.push_back({"h", "", {{"<i>"}, {{"</table>"}}}});
    page.json = R"({"name": "</script><script>"})";
    const std::string html = to_html(page);
    CHECK(contains(html, "<title>&lt;b&gt;&amp;&quot;</title>"));
    CHECK(contains(html, "<th>&lt;i&gt;</th>"));
    CHECK(contains(html, "<td>&lt;/table&gt;</td>"));
    CHECK(contains(html, R"({"name": "\u003c/script>\u003cscript>"})"));
}

TEST_CASE("the figure stands in the page without the head of its own file") {
    Page page;
    page.svg = "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n<svg id=\"s\"></svg>\n";
    page.caption = "caption";
    const std::string html = to_html(page);
    CHECK(contains(html, "<figure id=\"figure\">\n<svg id=\"s\"></svg>\n<figcaption>caption</figcaption>"));
    CHECK_FALSE(contains(html, "<?xml"));
    CHECK_FALSE(contains(html, "http"));
}
