// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A page of HTML that needs nothing beside it.
#pragma once

#include <string>
#include <vector>

#include <wm3d/report/table.hpp>

namespace wm3d::report {

struct Section {
    std::string heading;
    std::string text; ///< a paragraph before the table; may be empty
    Table table;
};

struct Page {
    std::string title;
    std::vector<std::string> paragraphs; ///< before the figure
    std::string svg;                     ///< the figure, as `render` gives it; may be empty
    std::string caption;
    std::vector<Section> sections;
    std::string json; ///< the same data for programs, in a script element with the id "data"; may be empty
};

/// The page, to be read on screens of any width, in the dark and on paper.
std::string to_html(const Page& page);

/// Text with &, <, > and quotes escaped.
std::string html_escaped(const std::string& text);

} // namespace wm3d::report
