// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Lists and ranges of numbers on the command line: "0.1,0.2" and "1e-12:0.5:50".
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace wm3d::cmd {

/// What the numbers of an option have to be.
struct NumberRule {
    std::function<bool(double)> accepts;
    std::string expected; ///< as in "is not EXPECTED": "a number above 0, such as 0.1"
};

NumberRule positive_numbers(const std::string& example);
NumberRule probabilities();
NumberRule shares(const std::string& example);

/// The numbers of "A,B,...", at least one. `option` is named in complaints.
/// \throw ParameterError  if the list is empty or a part of it isn't what the rule wants
std::vector<double> parse_numbers(const std::string& text, const std::string& option, const NumberRule& rule);

/// The same for whole numbers from `low` up.
std::vector<std::size_t> parse_counts(const std::string& text, const std::string& option, std::size_t low);

/// The numbers of "LOW:HIGH:COUNT", from LOW to HIGH at equal ratios, both ends included exactly.
/// \throw ParameterError  unless LOW < HIGH, COUNT is 2 to 100 000 and both ends are what the rule wants
std::vector<double> parse_log_range(const std::string& text, const std::string& option,
                                    const NumberRule& rule);

} // namespace wm3d::cmd
