// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/filed.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

using namespace wm3d;

namespace {

Filed<char> some(const std::vector<std::pair<std::size_t, char>>& list, std::size_t length) {
    return filed<char>(3, length, [&](auto&& file) {
        for (const auto& [key, value] : list)
            file(key, [&] { return value; });
    });
}

} // namespace

TEST_CASE("values lie under their keys in the order in which they came, whoever files them") {
    const std::vector<std::pair<std::size_t, char>> list{{2, 'a'}, {0, 'b'}, {SIZE_MAX, 'c'},
                                                         {2, 'd'}, {3, 'e'}, {0, 'f'}};
    for (const std::size_t length : {std::size_t{6}, std::size_t{1} << 22}) {
        const Filed<char> result = some(list, length);
        CHECK(result.start == std::vector<std::uint32_t>{0, 2, 2, 4});
        CHECK(result.values == std::vector<char>{'b', 'f', 'a', 'd'});
        CHECK(result.under(1).empty());
        CHECK(result.under(2).back() == 'd');
    }
    CHECK(some({}, 0).values.empty());
}
