// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/weighty_windows.hpp>

#include <cmath>

namespace wm3d::masking {

WeightyWindows::WeightyWindows(const metrics::Msdm2Sample& all, std::size_t shares) : mean_(all.mean) {
    const auto cube = [](double x) { return x * x * x; };
    double total = 0, passed = 0, next = 0.5;
    for (double x : all.local)
        total += cube(x);
    for (std::size_t i = 0; i < all.local.size(); ++i) {
        passed += cube(all.local[i]);
        double shares_here = 0;
        for (; next * total < passed * static_cast<double>(shares); ++next)
            ++shares_here;
        if (!(shares_here > 0))
            continue;
        vertices_.push_back(all.vertices[i]);
        before_.push_back(all.local[i]);
        shares_.push_back(shares_here);
    }
}

double WeightyWindows::mean(std::span<const double> now) const {
    double sum = 0, all = 0;
    for (std::size_t k = 0; k < before_.size(); ++k) {
        sum += shares_[k] * std::pow(now[k] / before_[k], 3);
        all += shares_[k];
    }
    return mean_ * std::cbrt(sum / all);
}

WeightyWindows WeightyWindows::followed_on(std::span<const double> now, std::size_t part) const {
    WeightyWindows some(mean(now));
    for (std::size_t k = part / 2; k < vertices_.size(); k += part) {
        some.vertices_.push_back(vertices_[k]);
        some.before_.push_back(now[k]);
        some.shares_.push_back(shares_[k] * std::pow(now[k] / before_[k], 3));
    }
    return some;
}

} // namespace wm3d::masking
