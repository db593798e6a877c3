// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/harmonics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "fftw.hpp"
#include "legendre.hpp"

namespace wm3d::search {

namespace {

using std::numbers::pi;

/// Weights of cubic interpolation between the second and the third of four places, at the part t of the way.
std::array<double, 4> cubic_weights(double t) {
    return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
            (t + 1) * t * (t - 1) / 6};
}

} // namespace

/// Rings theta_r = pi (r + 1/2) / rings, columns phi_c = 2 pi c / columns, and P_lm on each ring.
struct HarmonicTransform::Tables {
    unsigned bandwidth, rings, columns;
    std::vector<double> quadrature; ///< #rings: Fejer's weights, exact for degrees below `rings`
    std::vector<double> p;          ///< for each (l, m), as Harmonics numbers them, the northern rings
    FftwPlan<double> ring_to_orders;

    Tables(unsigned b, unsigned r);
    Harmonics transform(const FftwArray<double>& grid) const;
    void spread(const Vec3& direction, double q, double* grid) const;
    std::size_t half() const { return columns / 2 + 1; }

private:
    static fftw_plan plan(unsigned columns);
};

fftw_plan HarmonicTransform::Tables::plan(unsigned columns) {
    const std::lock_guard lock(planner());
    const FftwArray<double> in(columns);
    const FftwArray<fftw_complex> out(columns / 2 + 1);
    return Fftw<double>::real_to_complex(static_cast<int>(columns), in.get(), out.get());
}

HarmonicTransform::Tables::Tables(unsigned b, unsigned r)
    : bandwidth(b), rings(r), columns(2 * r), quadrature(r), p(std::size_t{b} * (b + 1) / 2 * (r / 2)),
      ring_to_orders(plan(2 * r)) {
    for (unsigned ring = 0; ring < rings; ++ring) {
        const double theta = pi * (ring + 0.5) / rings;
        double sum = 1;
        for (unsigned k = 1; k <= rings / 2; ++k)
            sum -= 2 * std::cos(2 * k * theta) / (4.0 * k * k - 1);
        quadrature[ring] = 2.0 / rings * sum * 2 * pi / columns;
        if (ring < rings / 2)
            legendre(bandwidth, std::cos(theta), std::sin(theta), [&](unsigned l, unsigned m, double value) {
                p[(std::size_t{l} * (l + 1) / 2 + m) * (rings / 2) + ring] = value;
            });
    }
}

Harmonics HarmonicTransform::Tables::transform(const FftwArray<double>& grid) const {
    const FftwArray<std::complex<double>> order(half());
    // A ring and its mirror image in the equator share P_lm up to the sign (-1)^(l + m).
    const std::size_t north = rings / 2;
    std::vector<std::complex<double>> even(std::size_t{bandwidth} * north), odd(even.size());
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const FftwArray<double>& whole = grid;
        ring_to_orders(whole.get() + ring * columns, reinterpret_cast<fftw_complex*>(order.get()));
        const bool mirrored = ring >= north;
        const std::size_t place = mirrored ? rings - 1 - ring : ring;
        for (std::size_t m = 0; m < bandwidth; ++m) {
            even[m * north + place] += order[m];
            odd[m * north + place] += mirrored ? -order[m] : order[m];
        }
    }
    Harmonics f(bandwidth);
    for (unsigned l = 0; l < bandwidth; ++l)
        for (unsigned m = 0; m <= l; ++m) {
            const std::complex<double>* sum = ((l + m) % 2 == 0 ? even : odd).data() + m * north;
            const double* legendre_of = p.data() + (std::size_t{l} * (l + 1) / 2 + m) * north;
            std::complex<double> c = 0;
            for (std::size_t ring = 0; ring < north; ++ring)
                c += legendre_of[ring] * sum[ring];
            f(l, m) = c;
        }
    return f;
}

void HarmonicTransform::Tables::spread(const Vec3& direction, double q, double* grid) const {
    const double horizontal = direction.head<2>().norm(); // no need of hypot's care for huge numbers
    if (!(horizontal + std::abs(direction.z()) > 0))
        return;
    const double ring = std::atan2(horizontal, direction.z()) / pi * rings - 0.5;
    const double column = (std::atan2(direction.y(), direction.x()) / (2 * pi) + 1) * columns;
    const double first_ring = std::floor(ring), first_column = std::floor(column);
    const std::array<double, 4> u = cubic_weights(ring - first_ring),
                                v = cubic_weights(column - first_column);
    for (int i = 0; i < 4; ++i) {
        int r = static_cast<int>(first_ring) + i - 1;
        std::size_t turn = 0; // beyond a pole the rings come back on the other side
        if (r < 0 || r >= static_cast<int>(rings)) {
            r = r < 0 ? -1 - r : 2 * static_cast<int>(rings) - 1 - r;
            turn = columns / 2;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t c = (static_cast<std::size_t>(first_column) + columns + k - 1 + turn) % columns;
            grid[static_cast<std::size_t>(r) * columns + c] += q * u[static_cast<std::size_t>(i)] * v[k];
        }
    }
}

HarmonicTransform::HarmonicTransform(unsigned bandwidth, unsigned rings) {
    if (bandwidth == 0 || rings % 2 != 0 || rings < 2 * bandwidth)
        throw ParameterError(
            "a harmonic transform needs an even number of rings, at least twice its bandwidth");
    tables_ = std::make_unique<Tables>(bandwidth, rings);
}
HarmonicTransform::~HarmonicTransform() = default;
HarmonicTransform::HarmonicTransform(HarmonicTransform&&) noexcept = default;
HarmonicTransform& HarmonicTransform::operator=(HarmonicTransform&&) noexcept = default;

unsigned HarmonicTransform::bandwidth() const {
    return tables_->bandwidth;
}

Harmonics HarmonicTransform::of_points(std::span<const Vec3> directions, std::span<const double> q) const {
    const std::size_t size = std::size_t{tables_->rings} * tables_->columns;
    const FftwArray<double> grid(size);
    std::fill_n(grid.get(), size, 0.0);
    for (std::size_t i = 0; i < directions.size(); ++i)
        tables_->spread(directions[i], q[i], grid.get());
    return tables_->transform(grid);
}

Harmonics HarmonicTransform::of_function(const std::function<double(const Vec3&)>& f) const {
    const std::size_t columns = tables_->columns;
    const FftwArray<double> grid(std::size_t{tables_->rings} * columns);
    parallel_blocks(tables_->rings, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t ring = begin; ring < end; ++ring) {
            const double theta = pi * (static_cast<double>(ring) + 0.5) / tables_->rings;
            for (std::size_t c = 0; c < columns; ++c) {
                const double phi = 2 * pi * static_cast<double>(c) / static_cast<double>(columns);
                const Vec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
                grid[ring * columns + c] = tables_->quadrature[ring] * f(d);
            }
        }
    });
    return tables_->transform(grid);
}

} // namespace wm3d::search
