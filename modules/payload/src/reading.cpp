// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/reading.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/payload/carrier.hpp>

namespace wm3d::payload {

namespace {

/// Bits of one carrier have nearly equal deviations over random keys, so the common one is divided by.
std::vector<double> normalized(std::vector<double> soft, std::span<const double> coefficients) {
    double squares = 0;
    for (const double c : coefficients)
        squares += c * c;
    const double scale = squares > 0 ? std::sqrt(static_cast<double>(soft.size()) / squares) : 0;
    for (double& value : soft)
        value *= scale;
    return soft;
}

/// What values of deviation 1 around -a or a say about their bits; a from their own mean square.
std::vector<double> log_likelihoods(std::span<const double> soft) {
    double squares = 0;
    for (const double value : soft)
        squares += value * value;
    constexpr double least = 0.1; // of a: below it nothing can be read anyway
    const double a = std::sqrt(std::max(squares / static_cast<double>(soft.size()) - 1, least * least));
    std::vector<double> llr(soft.begin(), soft.end());
    for (double& value : llr)
        value *= 2 * a;
    return llr;
}

/// Score of a code word on the soft values.
double sigmas_of(std::span<const std::uint8_t> coded, std::span<const double> soft) {
    double sum = 0;
    for (std::size_t k = 0; k < soft.size(); ++k)
        sum += coded[k] ? -soft[k] : soft[k];
    return sum / std::sqrt(static_cast<double>(soft.size()));
}

std::size_t errors(std::span<const std::uint8_t> coded, std::span<const double> soft) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < soft.size(); ++k)
        count += (soft[k] < 0) != (coded[k] != 0);
    return count;
}

/// The likeliest whole frame of one format.
std::optional<Reading> read_format(const Carrier& carrier, std::span<const double> coefficients,
                                   const ReadOptions& options) {
    const Format format = carrier.format();
    const PolarCode code = code_of(format);
    const std::vector<double> soft = normalized(carrier.demodulated(coefficients), coefficients);
    for (const PolarCode::Candidate& candidate : code.decode(log_likelihoods(soft), options.list)) {
        const std::optional<Message> message = from_frame(candidate.bits, format);
        if (!message)
            continue;
        const std::vector<std::uint8_t> coded = code.encode(candidate.bits);
        return Reading{*message, format, sigmas_of(coded, soft), 0, soft.size(), errors(coded, soft)};
    }
    return {};
}

} // namespace

std::optional<Reading> read_payload(const key::Secret& secret, unsigned level,
                                    const detect::LinearStatistic& statistic, const ReadOptions& options) {
    const std::span<const double> c = statistic.coefficients();
    if (!(statistic.sigma() > 0))
        return {};
    // The coded bits turn the signs of a sum that is fixed but for them: each message's T has this
    // distribution.
    const detect::LinearStatistic signs({c.begin(), c.end()}, sign_height(statistic.rmax()),
                                        detect::Law::sign);
    std::vector<std::optional<Reading>> readings(formats.size());
    parallel_blocks(formats.size(), 1, [&](std::size_t f, std::size_t) {
        std::optional<Reading>& reading = readings[f];
        reading = read_format(Carrier(secret, level, formats[f]), c, options);
        if (reading)
            reading->log10_p = std::min(
                0.0, detect::exact_tail(signs, reading->sigmas * signs.sigma()).log10_p +
                         log10_messages(formats[f]) + std::log10(static_cast<double>(formats.size())));
    });
    const auto log10_p = [](const std::optional<Reading>& reading) {
        return reading ? reading->log10_p : 1.0;
    };
    return *std::ranges::min_element(readings, {}, log10_p);
}

std::vector<double> soft_values(const key::Secret& secret, unsigned level, Format format,
                                std::span<const double> coefficients) {
    return normalized(Carrier(secret, level, format).demodulated(coefficients), coefficients);
}

} // namespace wm3d::payload
