// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/number_list.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>

namespace wm3d::cmd {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// The number that all of `text` spells, or NaN.
double number(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end ? value : std::nan("");
}

double number(const std::string& text, const std::string& option, const NumberRule& rule) {
    const double value = number(text);
    if (!std::isfinite(value) || !rule.accepts(value))
        throw ParameterError(fmt::format("{}: '{}' is not {}", option, text, rule.expected));
    return value;
}

} // namespace

NumberRule positive_numbers(const std::string& example) {
    return {[](double x) { return x > 0; }, "a number above 0, such as " + example};
}

NumberRule probabilities() {
    return {[](double x) { return x > 0 && x < 1; }, "a probability between 0 and 1, such as 1e-6"};
}

NumberRule shares(const std::string& example) {
    return {[](double x) { return x > 0 && x <= 1; }, "a number above 0 and up to 1, such as " + example};
}

std::vector<double> parse_numbers(const std::string& text, const std::string& option,
                                  const NumberRule& rule) {
    if (text.empty())
        throw ParameterError(fmt::format("{}: the list is empty; give numbers joined by commas", option));
    std::vector<double> numbers;
    for (const std::string& part : split(text, ','))
        numbers.push_back(number(part, option, rule));
    return numbers;
}

std::vector<std::size_t> parse_counts(const std::string& text, const std::string& option, std::size_t low) {
    const NumberRule rule{
        [low](double x) { return x >= static_cast<double>(low) && x <= 1e9 && x == std::floor(x); },
        fmt::format("a whole number from {} to 1000000000", low)};
    std::vector<std::size_t> counts;
    for (double x : parse_numbers(text, option, rule))
        counts.push_back(static_cast<std::size_t>(x));
    return counts;
}

std::vector<double> parse_log_range(const std::string& text, const std::string& option,
                                    const NumberRule& rule) {
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 3)
        throw ParameterError(
            fmt::format("{}: '{}' is not LOW:HIGH:COUNT, such as 1e-12:0.5:50", option, text));
    const double low = number(parts[0], option, rule), high = number(parts[1], option, rule);
    if (!(low < high))
        throw ParameterError(fmt::format(
            "{}: the range '{}' is empty or descends; write the smaller number first", option, text));
    const NumberRule many{[](double x) { return x >= 2 && x <= 1e5 && x == std::floor(x); },
                          "a whole number of points from 2 to 100000"};
    const auto count = static_cast<std::size_t>(number(parts[2], option, many));
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        numbers[i] = std::exp(std::log(low) + part * (std::log(high) - std::log(low)));
    }
    numbers.front() = low;
    numbers.back() = high;
    return numbers;
}

} // namespace wm3d::cmd
