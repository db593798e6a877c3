// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/polar_code.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

#include <wm3d/core/error.hpp>

namespace wm3d::payload {

namespace {

/// Sum of 2^(k/4) over the binary digits k of a position. Different positions differ by far more than
/// rounding.
double polarization_weight(std::size_t position) {
    double weight = 0;
    for (int k = 0; position >> k != 0; ++k)
        if (position >> k & 1)
            weight += std::exp2(k / 4.0);
    return weight;
}

/// log of how much likelier the sum of two bits is 0 than 1.
double sum_llr(double a, double b) {
    const double least = std::copysign(std::min(std::abs(a), std::abs(b)), a * b);
    return least + std::log((1 + std::exp(-std::abs(a + b))) / (1 + std::exp(-std::abs(a - b))));
}

/// Cost of deciding for a bit: log(1 + exp(-llr)) for 0, log(1 + exp(llr)) for 1.
double decision_cost(double llr, bool bit) {
    const double against = bit ? llr : -llr;
    return std::max(against, 0.0) + std::log1p(std::exp(-std::abs(against)));
}

/// One decision path: what successive cancellation knows at each depth of the code's tree. A node of size 2^s
/// keeps its LLRs at [2^s, 2^(s+1)) of `llr`; `left` keeps there the bits of a left child until its sibling
/// is decided.
struct Path {
    std::vector<double> llr;
    std::vector<std::uint8_t> left;
    std::vector<std::uint8_t> bits; ///< information so far
    double cost = 0;

    explicit Path(std::span<const double> channel) : llr(2 * channel.size()), left(2 * channel.size()) {
        std::ranges::copy(channel, llr.begin() + static_cast<std::ptrdiff_t>(channel.size()));
    }

    /// LLR of bit i, after all before it were decided.
    double leaf(std::size_t i) {
        const std::size_t n = llr.size() / 2;
        std::size_t size = n; // of the node whose children are next
        if (i > 0) {
            size = std::size_t{1} << std::countr_zero(i); // of the right child that begins here
            for (std::size_t k = 0; k < size; ++k) {
                const double a = llr[2 * size + k], b = llr[3 * size + k];
                llr[size + k] = left[size + k] ? b - a : b + a;
            }
        }
        for (; size > 1; size /= 2)
            for (std::size_t k = 0; k < size / 2; ++k)
                llr[size / 2 + k] = sum_llr(llr[size + k], llr[size + size / 2 + k]);
        return llr[1];
    }

    /// Takes bit i for decided and combines the children that it completes.
    void decide(std::size_t i, std::uint8_t bit) {
        const std::size_t whole = std::size_t{1} << std::countr_one(i); // size of the node that it completes
        const std::span<std::uint8_t> done = std::span(left).subspan(whole, whole);
        done[0] = bit;
        for (std::size_t size = 1; size < whole; size *= 2)
            for (std::size_t k = 0; k < size; ++k) {
                done[size + k] = done[k];
                done[k] ^= left[size + k];
            }
    }
};

/// Both decisions of every path, and the `list` cheapest of them kept.
void branch(std::vector<Path>& paths, std::size_t i, std::size_t list) {
    struct Choice {
        std::size_t path;
        std::uint8_t bit;
        double cost;
    };
    std::vector<Choice> choices;
    for (std::size_t p = 0; p < paths.size(); ++p) {
        const double llr = paths[p].leaf(i);
        for (const std::uint8_t bit : {std::uint8_t{0}, std::uint8_t{1}})
            choices.push_back({p, bit, paths[p].cost + decision_cost(llr, bit != 0)});
    }
    std::ranges::stable_sort(choices, {}, &Choice::cost);
    choices.resize(std::min(list, choices.size()));
    std::vector<std::size_t> uses(paths.size(), 0);
    for (const Choice& choice : choices)
        ++uses[choice.path];
    std::vector<Path> kept;
    kept.reserve(choices.size());
    for (const Choice& choice : choices) {
        Path& path = paths[choice.path];
        kept.push_back(--uses[choice.path] == 0 ? std::move(path) : path);
        kept.back().cost = choice.cost;
        kept.back().bits.push_back(choice.bit);
        kept.back().decide(i, choice.bit);
    }
    paths = std::move(kept);
}

} // namespace

PolarCode::PolarCode(std::size_t length, std::size_t information)
    : information_(information), frozen_(length, 1) {
    if (!std::has_single_bit(length) || information > length)
        throw ParameterError(
            "a polar code needs a length that is a power of two and no more information than that");
    std::vector<std::pair<double, std::size_t>> positions(length);
    for (std::size_t i = 0; i < length; ++i)
        positions[i] = {polarization_weight(i), i};
    std::ranges::sort(positions, std::greater{});
    for (std::size_t k = 0; k < information; ++k)
        frozen_[positions[k].second] = 0;
}

std::vector<std::uint8_t> PolarCode::encode(std::span<const std::uint8_t> bits) const {
    std::vector<std::uint8_t> word(length());
    auto next = bits.begin();
    for (std::size_t i = 0; i < word.size(); ++i)
        if (!frozen_[i])
            word[i] = *next++;
    for (std::size_t size = 1; size < word.size(); size *= 2)
        for (std::size_t i = 0; i < word.size(); ++i)
            if (!(i & size))
                word[i] ^= word[i + size];
    return word;
}

std::vector<PolarCode::Candidate> PolarCode::decode(std::span<const double> llr, std::size_t list) const {
    std::vector<Path> paths{Path(llr)};
    for (std::size_t i = 0; i < length(); ++i) {
        if (!frozen_[i]) {
            branch(paths, i, list);
            continue;
        }
        for (Path& path : paths) {
            path.cost += decision_cost(path.leaf(i), false);
            path.decide(i, 0);
        }
    }
    std::ranges::stable_sort(paths, {}, &Path::cost);
    std::vector<Candidate> candidates;
    for (Path& path : paths)
        candidates.push_back({std::move(path.bits), path.cost});
    return candidates;
}

} // namespace wm3d::payload
