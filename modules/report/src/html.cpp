// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/html.hpp>

#include <fmt/format.h>

namespace wm3d::report {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; line-height: 1.2; }
h2 { font-size: 1.2rem; margin-top: 2rem; }
figure { margin: 1.5rem 0; background: white; border-radius: 4px; }
figure svg { width: 100%; height: auto; display: block; }
figcaption { background: Canvas; font-size: 0.9rem; padding-top: 0.5rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.8rem; text-align: right; white-space: nowrap; border-bottom: 1px solid #8884; }
th { border-bottom: 2px solid #888; }
th:first-child, td:first-child { text-align: left; }
@media print {
  body { max-width: none; margin: 0; font-size: 10pt; }
  thead { display: table-header-group; }
  tr, figure { break-inside: avoid; }
  .wide { overflow: visible; }
}
)";

/// The element itself, without what may stand before it in a file of its own.
std::string svg_element(const std::string& svg) {
    const std::size_t at = svg.find("<svg");
    return at == std::string::npos ? std::string() : svg.substr(at);
}

/// JSON inside a script element must not be able to end it.
std::string json_for_script(const std::string& json) {
    std::string text;
    for (char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

std::string row_html(const std::vector<std::string>& row, const char* cell) {
    std::string text = "<tr>";
    for (const std::string& content : row)
        text += fmt::format("<{0}>{1}</{0}>", cell, html_escaped(content));
    return text + "</tr>\n";
}

std::string table_html(const Table& table) {
    std::string text =
        "<div class=\"wide\"><table>\n<thead>" + row_html(table.columns, "th") + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows)
        text += row_html(row, "td");
    return text + "</tbody></table></div>\n";
}

std::string section_html(const Section& section) {
    std::string text = fmt::format("<section>\n<h2>{}</h2>\n", html_escaped(section.heading));
    if (!section.text.empty())
        text += fmt::format("<p>{}</p>\n", html_escaped(section.text));
    return text + table_html(section.table) + "</section>\n";
}

} // namespace

std::string html_escaped(const std::string& text) {
    std::string result;
    for (char c : text)
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    return result;
}

std::string to_html(const Page& page) {
    const std::string title = html_escaped(page.title);
    std::string text =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
                    title, style, title);
    for (const std::string& paragraph : page.paragraphs)
        text += fmt::format("<p>{}</p>\n", html_escaped(paragraph));
    if (!page.svg.empty())
        text += fmt::format("<figure id=\"figure\">\n{}<figcaption>{}</figcaption>\n</figure>\n",
                            svg_element(page.svg), html_escaped(page.caption));
    for (const Section& section : page.sections)
        text += section_html(section);
    if (!page.json.empty())
        text += fmt::format("<script type=\"application/json\" id=\"data\">\n{}\n</script>\n",
                            json_for_script(page.json));
    return text + "</body>\n</html>\n";
}

} // namespace wm3d::report
