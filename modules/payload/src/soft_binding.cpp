// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/soft_binding.hpp>

#include <fmt/format.h>

#include <wm3d/core/base64.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/hex.hpp>

namespace wm3d::payload {

namespace {

std::string bytes_of(const Message& message) {
    if (message.kind == Message::Kind::text)
        return message.value;
    const std::optional<std::string> bytes = from_hex((message.value.size() % 2 ? "0" : "") + message.value);
    if (!bytes)
        throw ParameterError(fmt::format("the payload '{}' is no hexadecimal digits", message.value));
    return *bytes;
}

} // namespace

std::string soft_binding_value(const Message& message) {
    return to_base64(bytes_of(message));
}

} // namespace wm3d::payload
