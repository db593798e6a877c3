// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Whole numbers out of JSON that anybody may have written.
#pragma once

#include <concepts>
#include <limits>

namespace wm3d {

/// The whole number that a value of the JSON library is. The library's own conversion takes 2e302 and -1 too,
/// and what that becomes is undefined or a number that nobody wrote.
/// \throw  the library's type error, if it is no whole number from 0 to the largest of its type
template<std::unsigned_integral Whole, typename Json>
Whole whole_number(const Json& value) {
    using Widest = typename Json::number_unsigned_t;
    const auto& number = value.template get_ref<const Widest&>();
    if (number > std::numeric_limits<Whole>::max())
        return static_cast<Whole>(Json().template get_ref<const Widest&>()); // throws: null is no number
    return static_cast<Whole>(number);
}

} // namespace wm3d
