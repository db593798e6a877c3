// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A payload as a soft binding of C2PA: what a lost manifest is looked up by.
#pragma once

#include <string>
#include <string_view>

#include <wm3d/payload/message.hpp>

namespace wm3d::payload {

/// Name of the algorithm and its version: frames, code and carriers as in this library.
inline constexpr std::string_view soft_binding_alg = "io.github.wm3d.payload.1";

/// The message's bytes in Base64 (RFC 4648, padded): those of a text, or two digits a byte, an odd number of
/// digits with a zero before them.
/// \throw ParameterError  if a message of digits holds anything else, as none does that was parsed or read
std::string soft_binding_value(const Message& message);

} // namespace wm3d::payload
