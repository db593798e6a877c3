// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/sequence.hpp>

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/key/stream.hpp>
#include <wm3d/payload/carrier.hpp>
#include <wm3d/payload/recipients.hpp>

using namespace wm3d;
using namespace wm3d::payload;

namespace {

const key::Secret owner = key::null_secret(2, 2);

/// How much of a sequence's energy is along another.
double share(const std::vector<double>& mark, const std::vector<double>& part) {
    const auto dot = [](const auto& a, const auto& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    };
    return std::pow(dot(mark, part), 2) / (dot(mark, mark) * dot(part, part));
}

} // namespace

TEST_CASE("a mark that says nothing more is the key's own sequence") {
    CHECK(mark_sequence(owner, 4, 0.1, {}) == key::watermark_sequence(owner, 4, 0.1));
}

TEST_CASE("the parts have their shares of the energy, which stays the same") {
    const Message message = parse_message("wm3d");
    const CopyLabel copy{"work", "Ann"};
    const std::vector<double> own = key::watermark_sequence(owner, 5, 0.1);
    for (const Content& content : {Content{message, {}}, Content{{}, copy}, Content{message, copy}}) {
        const std::vector<double> mark = mark_sequence(owner, 5, 0.1, content, {0.3});
        CHECK(share(mark, own) == doctest::Approx(0.3).epsilon(0.1));
        const double part = content.message && content.copy ? 0.35 : 0.7;
        if (content.message)
            CHECK(share(mark, payload_sequence(owner, 5, 0.1, message)) ==
                  doctest::Approx(part).epsilon(0.1));
        if (content.copy)
            CHECK(share(mark, copy_sequence(owner, 5, 0.1, copy_number("work", "Ann", 5))) ==
                  doctest::Approx(part).epsilon(0.1));
        const double energy = std::inner_product(mark.begin(), mark.end(), mark.begin(), 0.0);
        CHECK(energy == doctest::Approx(static_cast<double>(mark.size()) * 0.01 / 3).epsilon(0.05));
    }
}
