// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include <wm3d/core/parallel.hpp>

namespace wm3d::io {

namespace {

constexpr std::size_t block = 8192;
constexpr int most_digits = 17; // more says nothing about a double
constexpr std::size_t text_size = 400;

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r'); // tab, LF, VT, FF, CR
}

/// Powers of ten that a double holds exactly.
constexpr std::array<double, 23> exact_powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A decimal without an exponent and of so few digits that it is the quotient of two whole numbers which double holds
/// exactly: one division rounds it correctly (Clinger).
/// \return its end, or nullptr if it is of another kind
const char* parse_plain_decimal(const char* begin, const char* end, double& value) {
    constexpr std::ptrdiff_t most = 19; // digits of any number below 2^64
    const bool negative = begin != end && *begin == '-';
    const char* const first = begin + (negative ? 1 : 0);
    std::uint64_t digits = 0;
    const auto after_digits = [&](const char* at) {
        for (; at != end && is_digit(*at); ++at)
            digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
        return at;
    };
    const char* const point = after_digits(first);
    const bool whole = point == end || *point != '.';
    const char* const stop = whole ? point : after_digits(point + 1);
    const std::ptrdiff_t before = point - first, after = whole ? 0 : stop - point - 1;
    const bool exponent = stop != end && (*stop == 'e' || *stop == 'E');
    if (before == 0 || (after == 0 && !whole) || before + after > most || digits > std::uint64_t{1} << 53 ||
        exponent)
        return nullptr;
    const double size = static_cast<double>(digits) / exact_powers[static_cast<std::size_t>(after)];
    value = negative ? -size : size;
    return stop;
}

/// Writes a value with so many decimals, as std::to_chars does.
/// \return  the end, or nullptr where it isn't plain to which side the value has to be rounded
char* write_plain_decimal(double value, int decimals, char* out) {
    constexpr double most = 1e15; // of the number that the digits make up
    if (decimals < 1 || decimals >= static_cast<int>(exact_powers.size()))
        return nullptr;
    const double scaled = std::abs(value) * exact_powers[static_cast<std::size_t>(decimals)];
    if (!(scaled < most))
        return nullptr;
    auto digits = static_cast<std::uint64_t>(scaled);
    const double rest = scaled - static_cast<double>(digits);
    // The product is rounded, so near a half it doesn't tell.
    if (std::abs(rest - 0.5) <= scaled * std::numeric_limits<double>::epsilon())
        return nullptr;
    digits += rest > 0.5 ? 1 : 0;
    const fmt::format_int text(digits);
    const auto places = static_cast<std::size_t>(decimals), size = text.size();
    const std::size_t before = size > places ? size - places : 0;
    if (std::signbit(value))
        *out++ = '-';
    out = before > 0 ? std::copy_n(text.data(), before, out) : std::fill_n(out, 1, '0');
    *out++ = '.';
    out = std::fill_n(out, before > 0 ? 0 : places - size, '0');
    return std::copy_n(text.data() + before, size - before, out);
}

/// The power of ten of the first digit that is not zero. Exponents beyond all reason count as 10^15.
std::int64_t power_of_ten(std::string_view number) {
    const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, mark);
    std::string_view exponent = number.substr(std::min(mark + 1, number.size()));
    if (exponent.starts_with('+'))
        exponent.remove_prefix(1);
    std::int64_t power = 0;
    const bool fits = std::from_chars(exponent.begin(), exponent.end(), power).ec == std::errc();
    constexpr std::int64_t beyond = 1'000'000'000'000'000;
    if (!exponent.empty() && !fits)
        power = exponent.starts_with('-') ? -beyond : beyond;
    const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
    const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
    return std::clamp(power, -beyond, beyond) + point - first - (first < point ? 1 : 0);
}

} // namespace

const char* parse_number(const char* begin, const char* end, double& value) {
    if (begin != end && *begin == '+' && begin + 1 != end && begin[1] != '-')
        ++begin;
    if (const char* const stop = parse_plain_decimal(begin, end, value))
        return stop;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::result_out_of_range) {
        // Too small for a double is zero; too large is an error.
        if (power_of_ten({begin, stop}) > 0)
            return nullptr;
        value = 0;
        return stop;
    }
    return error == std::errc() ? stop : nullptr;
}

void TextScanner::skip_blanks() {
    while (!at_end() && is_blank(source_.bytes[at_]))
        ++at_;
}

void TextScanner::skip_space() {
    while (!at_end() && is_space(source_.bytes[at_]))
        ++at_;
}

void TextScanner::skip_line() {
    const char* const base = source_.bytes.data();
    const std::size_t size = source_.bytes.size();
    std::size_t at = at_; // a local: this loop sees every byte of a file
    while (at < size && !is_line_end(base[at]))
        ++at;
    at_ = at;
    if (at_end())
        return;
    const bool pair = base[at_] == '\r' && at_ + 1 < size && base[at_ + 1] == '\n';
    at_ += pair ? 2 : 1;
}

bool TextScanner::at_line_end() const {
    return at_end() || is_line_end(source_.bytes[at_]);
}

std::string_view TextScanner::word() {
    skip_space();
    const std::size_t start = at_;
    while (!at_end() && !is_space(source_.bytes[at_]))
        ++at_;
    return source_.bytes.substr(start, at_ - start);
}

double TextScanner::number(std::string_view what, std::size_t& start) {
    const double value = any_number(what, start);
    if (!std::isfinite(value))
        source_.fail_in_line(start, fmt::format("{} is not finite; wm3d needs finite coordinates", what));
    return value;
}

double TextScanner::any_number(std::string_view what, std::size_t& start) {
    skip_space();
    start = at_;
    const char* const base = source_.bytes.data();
    const char* const end = base + source_.bytes.size();
    double value = 0;
    const char* const stop = parse_number(base + at_, end, value);
    if (stop == nullptr || (stop != end && !is_space(*stop) && *stop != '#')) {
        if (at_end())
            source_.fail(fmt::format("the file ends where {} should be; it seems to be cut short", what));
        source_.fail_in_line(start, fmt::format("\"{}\" is no number for {}", word().substr(0, 30), what));
    }
    at_ = static_cast<std::size_t>(stop - base);
    return value;
}

Vec3 TextScanner::any_vector(std::string_view what, std::array<std::size_t, 3>& starts) {
    const double x = any_number(what, starts[0]), y = any_number(what, starts[1]);
    return {x, y, any_number(what, starts[2])};
}

std::int64_t TextScanner::integer(std::string_view what, std::int64_t least) {
    skip_space();
    const std::size_t start = at_;
    const char* const base = source_.bytes.data();
    const char* const end = base + source_.bytes.size();
    const char* begin = base + at_;
    if (begin != end && *begin == '+')
        ++begin;
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (at_end())
        source_.fail(fmt::format("the file ends where {} should be; it seems to be cut short", what));
    if (error != std::errc() || (stop != end && !is_space(*stop) && *stop != '#'))
        source_.fail_in_line(start,
                             fmt::format("\"{}\" is no whole number for {}", word().substr(0, 30), what));
    if (value < least)
        source_.fail_in_line(start, fmt::format("{} is {}, but can't be below {}", what, value, least));
    at_ = static_cast<std::size_t>(stop - base);
    return value;
}

void TextStyle::learn(std::string_view number) {
    int decimals = 0, significant = 0;
    bool after_point = false, exponent = false;
    for (char c : number) {
        if (c == '.') {
            after_point = true;
        } else if (is_digit(c)) {
            decimals += after_point ? 1 : 0;
            significant += significant > 0 || c != '0' ? 1 : 0;
        } else if (c == 'e' || c == 'E') {
            exponent = true;
            break;
        }
    }
    ++count_;
    with_exponent_ += exponent ? 1 : 0;
    decimals_ = std::max(decimals_, std::min(decimals, most_digits));
    significant_ = std::max(significant_, std::min(significant, most_digits));
}

void TextStyle::learn(const TextStyle& other) {
    count_ += other.count_;
    with_exponent_ += other.with_exponent_;
    decimals_ = std::max(decimals_, other.decimals_);
    significant_ = std::max(significant_, other.significant_);
}

std::string_view TextStyle::format(double value, char* out) const {
    const auto written = [&] {
        if (!exponents()) {
            if (char* const end = write_plain_decimal(value, decimals_, out))
                return std::to_chars_result{end, std::errc()};
            return std::to_chars(out, out + text_size, value, std::chars_format::fixed, decimals_);
        }
        if (with_exponent_ == count_)
            return std::to_chars(out, out + text_size, value, std::chars_format::scientific, decimals_);
        return std::to_chars(out, out + text_size, value, std::chars_format::general, significant_);
    }();
    return {out, static_cast<std::size_t>(written.ptr - out)};
}

double TextStyle::round(double value) const {
    char text[text_size];
    const std::string_view written = format(value, text);
    double back = value;
    parse_number(written.data(), written.data() + written.size(), back);
    return back;
}

double TextStyle::step(double magnitude) const {
    const double of_double = std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
    if (!exponents())
        return std::max(of_double, std::pow(10.0, -decimals_));
    const int digits = with_exponent_ == count_ ? decimals_ + 1 : significant_;
    if (!(magnitude > 0))
        return of_double;
    return std::max(of_double, std::pow(10.0, std::floor(std::log10(magnitude)) - (digits - 1)));
}

TextStyle TextStore::learned() const {
    std::vector<TextStyle> parts((offsets_.size() + block - 1) / block);
    parallel_blocks(offsets_.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot)
            for (std::size_t offset : offsets_[slot])
                parts[begin / block].learn(bytes_.substr(offset, end_of(offset) - offset));
    });
    TextStyle style;
    for (const TextStyle& part : parts)
        style.learn(part);
    return style;
}

const TextStyle& TextStore::style() const {
    std::call_once(asked_, [this] {
        // As a task of its own, which takes no other meanwhile that may ask for the same.
        parallel_tasks(1, [this](std::size_t) { style_ = learned(); });
    });
    return style_;
}

std::size_t TextStore::end_of(std::size_t offset) const {
    const auto goes_on = [&](char c) { return c > ' ' ? c != '#' : !is_space(c); };
    while (offset < bytes_.size() && goes_on(bytes_[offset]))
        ++offset;
    return offset;
}

double TextStore::step(const Welding& welding) const {
    return style().step(largest_coordinates(welding.mesh).maxCoeff());
}

std::vector<Vec3> TextStore::settle(const Welding& welding, std::span<const Vec3> wanted) const {
    const std::vector<Vec3>& old = welding.mesh.positions;
    std::vector<Vec3> settled = old;
    const TextStyle& style = this->style();
    parallel_blocks(old.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            for (int k = 0; k < 3; ++k)
                if (wanted[v][k] != old[v][k])
                    settled[v][k] = style.round(wanted[v][k]);
    });
    return settled;
}

/// The file from the first coordinate of slot `begin` to that of slot `end`, or to the file's own ends.
std::string TextStore::patched(const Welding& welding, std::span<const Vec3> wanted, std::size_t begin,
                               std::size_t end) const {
    const auto start_of = [&](std::size_t slot) { return std::ranges::min(offsets_[slot]); };
    std::size_t copied = begin == 0 ? 0 : start_of(begin);
    const std::size_t last = end == offsets_.size() ? bytes_.size() : start_of(end);
    std::string out;
    out.reserve((last - copied) + (last - copied) / 4);
    char text[text_size];
    const TextStyle& style = this->style();
    for (std::size_t slot = begin; slot < end; ++slot) {
        const Index v = welding.vertex_of_slot[slot];
        const auto& offsets = offsets_[slot];
        std::array<int, 3> order{0, 1, 2}; // of appearance in the file
        if (offsets[0] > offsets[1] || offsets[1] > offsets[2])
            std::sort(order.begin(), order.end(), [&](int a, int b) {
                return offsets[static_cast<std::size_t>(a)] < offsets[static_cast<std::size_t>(b)];
            });
        for (int k : order) {
            if (wanted[v][k] == welding.mesh.positions[v][k])
                continue;
            const std::size_t offset = offsets[static_cast<std::size_t>(k)];
            out.append(bytes_, copied, offset - copied);
            out.append(style.format(wanted[v][k], text));
            copied = end_of(offset);
        }
    }
    out.append(bytes_, copied, last - copied);
    return out;
}

PatchedFiles TextStore::patch(const Welding& welding, std::span<const Vec3> wanted, std::string_view) const {
    std::vector<std::string> parts(std::max<std::size_t>(1, (offsets_.size() + block - 1) / block));
    parallel_blocks(parts.size(), 1, [&](std::size_t p, std::size_t) {
        parts[p] = patched(welding, wanted, p * block, std::min(offsets_.size(), (p + 1) * block));
    });
    std::string out;
    out.reserve(bytes_.size() + bytes_.size() / 4);
    for (const std::string& part : parts)
        out += part;
    return {std::move(out), {}};
}

} // namespace wm3d::io
