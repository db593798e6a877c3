// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/uncoded.hpp>

#include <algorithm>
#include <vector>

#include <wm3d/payload/carrier.hpp>

namespace wm3d::payload {

UncodedErrors uncoded_errors(const key::Secret& secret, unsigned level, const Message& message,
                             std::span<const double> coefficients) {
    const Format format = format_of(message);
    const std::vector<std::uint8_t> coded = code_of(format).encode(to_frame(message, format));
    const std::vector<double> soft = Carrier(secret, level, format).demodulated(coefficients);
    std::vector<double> sums(capacity(format), 0.0);
    for (std::size_t k = 0; k < soft.size(); ++k)
        sums[k % sums.size()] += coded[k] ? -soft[k] : soft[k];
    return {sums.size(),
            static_cast<std::size_t>(std::ranges::count_if(sums, [](double sum) { return !(sum > 0); }))};
}

} // namespace wm3d::payload
