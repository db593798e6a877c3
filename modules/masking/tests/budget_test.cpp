// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/budget.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::masking;
using masking::test::level;

namespace {

/// A blob and a mark for it.
struct Host {
    TriangleMesh mesh;
    Carriers carriers;
    sphere::SparseRows rows;
    std::vector<double> w;

    explicit Host(std::size_t vertices = 4000)
        : mesh([&] {
              const TriangleMesh blob = along_curve(shapes::blob(vertices, 11)).mesh;
              return to_frame(blob, canonical_frame(blob));
          }()),
          carriers(mesh), rows(sphere::barycentric_rows(sphere::Icosphere(level), mesh.positions)) {
        std::uint64_t state = 1;
        for (std::size_t j = 0; j < rows.columns; ++j) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            w.push_back(0.1 * (static_cast<double>(state >> 11) * 0x1p-52 - 1));
        }
    }

    MarkOfStrength mark() const {
        const std::vector<double> moves = carriers.moves(rows, w);
        return [this, moves](double strength) {
            std::vector<Vec3> positions = mesh.positions;
            for (std::size_t i = 0; i < positions.size(); ++i)
                positions[i] += strength * moves[i] * carriers.normals()[i];
            return positions;
        };
    }
};

} // namespace

TEST_CASE("the strength that is found is seen as much as the budget allows") {
    const Host host;
    const Budget budget(host.mesh);
    for (double visible : {0.02, 0.1, 0.3})
        for (double guess : {1e-4, 1.0}) {
            CAPTURE(visible);
            CAPTURE(guess);
            const Fit fit = budget.fit(host.mark(), visible, guess);
            CHECK(fit.reached);
            const double measured = budget.visible(host.mark()(fit.strength));
            CHECK(measured <= visible);
            CHECK(measured > 0.97 * visible);
            CHECK(fit.msdm2 == doctest::Approx(measured).epsilon(1e-3));
        }
}

TEST_CASE("a mark that moves nothing reaches no budget") {
    const Host host;
    const Fit fit = Budget(host.mesh).fit([&](double) { return host.mesh.positions; }, 0.1, 0.01);
    CHECK_FALSE(fit.reached);
    CHECK(fit.msdm2 < 1e-9);
}

TEST_CASE("an equalized mark moves the surface further for what is seen of it") {
    Host host;
    const Budget budget(host.mesh);
    const auto rms = [&] {
        const double strength = budget.fit(host.mark(), 0.1, 0.01).strength;
        return strength * host.carriers.rms(host.carriers.moves(host.rows, host.w));
    };
    const double before = rms();
    Host other;
    std::ranges::reverse(other.w);
    budget.equalize(host.carriers, other.mark(), 0.1, 0.01);
    CHECK(rms() > 1.05 * before);
}

TEST_CASE("what the trial mark tells is near the strength of another mark, and leads to the same") {
    Host host;
    const Budget budget(host.mesh);
    Host other;
    std::ranges::reverse(other.w);
    const double told = budget.equalize(host.carriers, other.mark(), 0.1, 0.01);
    const double found = budget.fit(host.mark(), 0.1, 0.01).strength;
    CHECK(told == doctest::Approx(found).epsilon(0.25));
    const Fit near = budget.fit_near(host.mark(), 0.1, told);
    CHECK(near.reached);
    CHECK(near.strength == doctest::Approx(found).epsilon(0.02));
    const double half = Budget::rescaled(told, 0.1, 0.05);
    CHECK(budget.fit_near(host.mark(), 0.05, half).reached);
    CHECK(half < told);
}

TEST_CASE("where the budget is near, the strength is foretold, and keeps to it when it is looked at") {
    const Host host;
    BudgetOptions options;
    options.few = 1; // what few windows decide is never foretold
    const Budget budget(host.mesh, options);
    const double found = budget.fit(host.mark(), 0.1, 0.01).strength;
    const Fit near = budget.fit_near(host.mark(), 0.1, 1.02 * found);
    REQUIRE(near.foretold);
    CHECK(near.evaluations == 1);
    const double measured = budget.visible(host.mark()(near.strength));
    CHECK(measured <= 0.1);
    CHECK(near.msdm2 == doctest::Approx(measured).epsilon(0.01));
    const Fit seen = budget.looked_at(host.mark(), near, 0.1);
    CHECK_FALSE(seen.foretold);
    CHECK(seen.strength == near.strength);
    CHECK(seen.msdm2 == doctest::Approx(measured).epsilon(1e-3));
    CHECK_FALSE(budget.fit_near(host.mark(), 0.1, 1.2 * found).foretold);
}

TEST_CASE("a foretold strength that is seen too much gives way to a weaker one") {
    const Host host;
    BudgetOptions options;
    options.few = 1;
    const Budget budget(host.mesh, options);
    const double found = budget.fit(host.mark(), 0.1, 0.01).strength;
    Fit near = budget.fit_near(host.mark(), 0.1, 1.02 * found);
    REQUIRE(near.foretold);
    near.strength *= 1.1; // as if MSDM2 had grown by more
    const Fit seen = budget.looked_at(host.mark(), near, 0.1);
    CHECK(seen.reached);
    CHECK(seen.strength < near.strength);
    CHECK(budget.visible(host.mark()(seen.strength)) <= 0.1);
}

namespace {

/// A blob with a second, crumpled sheet over a part of it that nearly touches its vertices: as unwelded parts do, it makes
/// MSDM2 jump when something moves there, however little.
TriangleMesh with_a_second_sheet(TriangleMesh mesh) {
    std::vector<Index> copy(mesh.positions.size(), 0);
    const std::vector<Triangle> triangles = mesh.triangles;
    const auto copied = [&](Index v) {
        if (copy[v] == 0) {
            copy[v] = static_cast<Index>(mesh.positions.size());
            mesh.positions.push_back((1 - 1e-8) * mesh.positions[v]);
        }
        return copy[v];
    };
    for (const Triangle& t : triangles) {
        const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        const Vec3 centre = (a + b + c) / 3;
        if (centre.normalized().x() < 0.9)
            continue;
        const auto top = static_cast<Index>(mesh.positions.size());
        mesh.positions.push_back(centre + 0.4 * (b - a).cross(c - a) / (b - a).norm());
        for (std::size_t k = 0; k < 3; ++k)
            mesh.triangles.push_back({copied(t[k]), copied(t[(k + 1) % 3]), top});
    }
    return mesh;
}

} // namespace

TEST_CASE("nothing moves where MSDM2 jumps at the slightest move") {
    Host host;
    host.mesh = with_a_second_sheet(host.mesh);
    host.carriers = Carriers(host.mesh);
    host.rows = sphere::barycentric_rows(sphere::Icosphere(level), host.mesh.positions);
    const Budget budget(host.mesh);
    constexpr double slightest = 1e-5;
    const double before = budget.visible(host.mark()(slightest));
    Host other;
    std::ranges::reverse(other.w);
    other.mesh = host.mesh;
    other.carriers = Carriers(host.mesh);
    other.rows = host.rows;
    budget.equalize(host.carriers, other.mark(), 0.1, 0.01);
    const std::span<const double> mask = host.carriers.mask();
    const auto still = std::ranges::count(mask, 0.0);
    CHECK(still > 0);
    CHECK(static_cast<std::size_t>(still) < mask.size() / 2);
    CHECK(before > 0.02);
    CHECK(budget.visible(host.mark()(slightest)) < before / 2);
    CHECK(budget.fit(host.mark(), 0.1, 0.01).reached);
}

TEST_CASE("few vertices that spend the budget stay where they are, and all others move further") {
    Host host;
    const MarkOfStrength even = host.mark();
    const auto spiky = [&](double strength) {
        std::vector<Vec3> positions = even(strength);
        for (std::size_t i = 0; i < positions.size(); i += 400)
            positions[i] += 50 * (positions[i] - host.mesh.positions[i]);
        return positions;
    };
    const Budget budget(host.mesh);
    const Fit all = budget.fit(spiky, 0.1, 0.01);
    REQUIRE(all.by_few);
    CHECK(all.still.empty());
    const Fit few = budget.fit_near(spiky, 0.1, all.strength);
    REQUIRE(few.still.size() == host.mesh.positions.size());
    CHECK(few.strength > 1.2 * all.strength);
    std::vector<Vec3> positions = spiky(few.strength);
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (few.still[i])
            positions[i] = host.mesh.positions[i];
    CHECK(budget.visible(positions) <= 0.1);
    CHECK(static_cast<std::size_t>(std::ranges::count(few.still, 1)) < few.still.size() / 4);
}

TEST_CASE("the budget of a dense mesh is kept to by glances and a look at few windows") {
    const Host host(20'000);
    // As if it were dense: a glance is through some vertices of each window.
    BudgetOptions options;
    options.most_windows = options.most_jumpy = options.most_whole = 10'000;
    options.dense_windows = 4'000;
    options.glance_vertices = options.dense_vertices = 10;
    const Budget dense(host.mesh, options);
    const Budget whole(host.mesh);
    const double guess = 0.03;
    const Fit fit = dense.fit_near(host.mark(), 0.1, guess);
    CHECK(fit.reached);
    const std::vector<Vec3> marked = host.mark()(fit.strength);
    CHECK(whole.visible(marked) == doctest::Approx(fit.msdm2).epsilon(0.02));
    CHECK(dense.visible(marked) == doctest::Approx(fit.msdm2).epsilon(0.02));
    CHECK(dense.fit_near([&](double) { return host.mesh.positions; }, 0.1, guess).strength == 0);
}
