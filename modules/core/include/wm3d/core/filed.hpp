// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Values filed under what is numbered, vertices say: a counting sort.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include <wm3d/core/parallel.hpp>

namespace wm3d {

/// Values by their keys, those of one key together; fewer than 2^32.
template<typename Value>
struct Filed {
    std::vector<std::uint32_t> start; ///< #keys + 1
    std::vector<Value> values;

    std::span<Value> under(std::size_t key) {
        return {values.data() + start[key], values.data() + start[key + 1]};
    }
    std::span<const Value> under(std::size_t key) const {
        return {values.data() + start[key], values.data() + start[key + 1]};
    }
};

/// Files values in the order in which they come, in the memory of others. Threads share a long list: each goes through all of it and keeps what
/// belongs under its own keys.
/// \param keys  how many there are; values under others are left out
/// \param length  of the list, about
/// \param for_each  calls file(key, make) for all of the list; `make` returns the value, and is called once for those
///                  that are kept
template<typename Value, typename ForEach>
void file_into(Filed<Value>& result, std::size_t keys, std::size_t length, ForEach&& for_each) {
    std::vector<std::uint32_t>& start = result.start;
    start.assign(keys + 1, 0);
    const auto shared = [&](auto&& keep) {
        parallel_shares(keys, length, [&](std::size_t begin, std::size_t end) {
            for_each([&](std::size_t key, auto&& make) {
                if (key >= begin && key < end)
                    keep(key, make);
            });
        });
    };
    shared([&](std::size_t key, auto&&) { ++start[key + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    result.values.resize(start.back());
    shared([&](std::size_t key, auto&& make) { result.values[start[key]++] = make(); });
    // By now `start` tells where the values of each key end.
    std::copy_backward(start.begin(), start.end() - 1, start.end());
    start.front() = 0;
}

/// The same in memory of their own.
template<typename Value, typename ForEach>
Filed<Value> filed(std::size_t keys, std::size_t length, ForEach&& for_each) {
    Filed<Value> result;
    file_into(result, keys, length, for_each);
    return result;
}

} // namespace wm3d
