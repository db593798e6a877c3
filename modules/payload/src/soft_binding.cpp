// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/soft_binding.hpp>

#include <wm3d/core/base64.hpp>

namespace wm3d::payload {

namespace {

std::string bytes_of(const Message& message) {
    if (message.kind == Message::Kind::text)
        return message.value;
    const std::string digits = (message.value.size() % 2 ? "0" : "") + message.value;
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
}

} // namespace

std::string soft_binding_value(const Message& message) {
    return to_base64(bytes_of(message));
}

} // namespace wm3d::payload
