// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/recipients.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/key/stream.hpp>
#include <wm3d/payload/carrier.hpp>

namespace wm3d::payload {

namespace {

constexpr std::size_t signs_per_word = 64;

std::size_t words_of(std::size_t signs) {
    return (signs + signs_per_word - 1) / signs_per_word;
}

/// For every eight coefficients and every byte, their sum with a minus where the byte has a 0.
class ByteSums {
public:
    explicit ByteSums(std::span<const double> coefficients) : sums_((coefficients.size() + 7) / 8) {
        parallel_blocks(sums_.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b)
                fill(sums_[b],
                     coefficients.subspan(8 * b, std::min<std::size_t>(8, coefficients.size() - 8 * b)));
        });
    }

    std::size_t bytes() const { return sums_.size(); }
    const std::array<double, 256>& operator[](std::size_t byte) const { return sums_[byte]; }

private:
    static void fill(std::array<double, 256>& sums, std::span<const double> c) {
        for (std::size_t value = 0; value < sums.size(); ++value) {
            sums[value] = 0;
            for (std::size_t k = 0; k < c.size(); ++k)
                sums[value] += value >> k & 1 ? c[k] : -c[k];
        }
    }

    std::vector<std::array<double, 256>> sums_;
};

/// T of a few copies: each table is used for all of them while it is in the nearest cache.
void score_block(const key::Secret& secret, const ByteSums& sums, std::span<const std::uint64_t> numbers,
                 std::span<double> scores) {
    const std::size_t words = (sums.bytes() + 7) / 8;
    std::vector<std::uint64_t> signs(words * numbers.size());
    for (std::size_t r = 0; r < numbers.size(); ++r)
        key::Stream(secret, key::Purpose::recipient, numbers[r])
            .fill(std::span(signs).subspan(r * words, words));
    std::ranges::fill(scores, 0.0);
    for (std::size_t b = 0; b < sums.bytes(); ++b)
        for (std::size_t r = 0; r < numbers.size(); ++r)
            scores[r] += sums[b][signs[r * words + b / 8] >> (8 * (b % 8)) & 255];
}

} // namespace

std::uint64_t copy_number(std::string_view work, std::string_view recipient, unsigned level) {
    return key::index_of(fmt::format("copy {} {} {}", level, work, recipient));
}

std::vector<double> copy_sequence(const key::Secret& secret, unsigned level, double rmax,
                                  std::uint64_t number) {
    if (level > key::max_level)
        throw ParameterError(
            fmt::format("level {} is too fine for a watermarking sphere; choose one from 0 to {}", level,
                        key::max_level));
    std::vector<double> sequence(key::sequence_length(level));
    std::vector<std::uint64_t> words(words_of(sequence.size()));
    key::Stream(secret, key::Purpose::recipient, number).fill(words);
    for (std::size_t j = 0; j < sequence.size(); ++j) {
        const bool positive = words[j / signs_per_word] >> (j % signs_per_word) & 1;
        sequence[j] = positive ? sign_height(rmax) : -sign_height(rmax);
    }
    return sequence;
}

std::vector<double> copy_scores(const key::Secret& secret, const detect::LinearStatistic& statistic,
                                std::span<const std::uint64_t> numbers, const Progress& progress) {
    constexpr std::size_t block = 64, stretch = 256 * block; // progress is told after each stretch
    std::vector<double> scores(numbers.size(), 0.0);
    double squares = 0;
    for (const double c : statistic.coefficients())
        squares += c * c;
    if (!(squares > 0))
        return scores;
    const ByteSums sums(statistic.coefficients());
    for (std::size_t first = 0; first < numbers.size(); first += stretch) {
        notify(progress, "comparing with the copies",
               static_cast<double>(first) / static_cast<double>(numbers.size()));
        parallel_blocks(std::min(stretch, numbers.size() - first), block,
                        [&](std::size_t begin, std::size_t end) {
                            score_block(secret, sums, numbers.subspan(first + begin, end - begin),
                                        std::span(scores).subspan(first + begin, end - begin));
                        });
    }
    for (double& score : scores)
        score /= std::sqrt(squares);
    notify(progress, "comparing with the copies", 1);
    return scores;
}

std::vector<Accusation> accuse(const detect::LinearStatistic& statistic, std::span<const double> scores,
                               double log10_pf, std::size_t family) {
    std::vector<Accusation> accused;
    const std::span<const double> c = statistic.coefficients();
    const detect::LinearStatistic signs({c.begin(), c.end()}, sign_height(statistic.rmax()),
                                        detect::Law::sign);
    if (!(signs.sigma() > 0))
        return accused;
    const double log10_family = std::log10(static_cast<double>(std::max(family, scores.size())));
    // The exact tail is worth its time only near the threshold and above.
    const double threshold = detect::tail_quantile(signs, std::clamp(log10_pf - log10_family, -299.0, -1e-3));
    for (std::size_t copy = 0; copy < scores.size(); ++copy) {
        const double t = scores[copy] * signs.sigma();
        if (t < 0.99 * threshold)
            continue;
        const double log10_p = std::min(0.0, detect::exact_tail(signs, t).log10_p + log10_family);
        if (log10_p <= log10_pf)
            accused.push_back({copy, scores[copy], log10_p});
    }
    std::ranges::stable_sort(accused, {}, &Accusation::log10_p);
    return accused;
}

} // namespace wm3d::payload
