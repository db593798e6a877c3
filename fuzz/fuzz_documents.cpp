// SPDX-License-Identifier: GPL-3.0-or-later
// Any text is a key, a receipt, a commitment or a message, or is refused with wm3d::Error; what was read
// survives being written and read again. The first byte chooses. Checksums are made to fit: anybody can do
// that, and what lies behind them would hardly be reached by chance.
#include <array>

#include <sodium.h>

#include <wm3d/commitment.hpp>
#include <wm3d/core/hex.hpp>
#include <wm3d/key.hpp>
#include <wm3d/payload/message.hpp>
#include <wm3d/resync/receipt.hpp>

#include "target.hpp"

using namespace wm3d;

namespace {

std::string blake2b(std::string_view text, std::size_t size) {
    std::string sum(size, '\0');
    auto* bytes = reinterpret_cast<unsigned char*>(sum.data());
    crypto_generichash(bytes, size, reinterpret_cast<const unsigned char*>(text.data()), text.size(), nullptr,
                       0);
    return to_hex({bytes, size});
}

/// With the checksum that a key's last line should hold; another text as it is.
std::string with_checksum(std::string_view text) {
    std::string fitting(text);
    constexpr std::string_view field = "checksum: ";
    const std::size_t at = fitting.rfind(field);
    if (at != std::string::npos && at > 0)
        fitting.replace(at + field.size(), 32, blake2b(std::string_view(fitting).substr(0, at), 16));
    return fitting;
}

/// With the digest that a receipt should hold.
std::string with_digest(std::string_view text) {
    std::string fitting(text);
    constexpr std::string_view field = "\"digest\": \"";
    const std::size_t at = fitting.rfind(field);
    if (at == std::string::npos || at + field.size() + 64 > fitting.size())
        return fitting;
    const std::string rest = fitting.substr(0, at + field.size()) + fitting.substr(at + field.size() + 64);
    return fitting.replace(at + field.size(), 64, blake2b(rest, 32));
}

/// A protected key costs seconds to open, so it is refused when it asks.
key::Passphrase no_passphrase() {
    throw InputError("nobody is there");
}

void read_key(std::string_view text) {
    const key::Key key = key::Key::parse(text, "fuzz", no_passphrase);
    fuzz::require(key::Key::parse(key.to_text(), "again").to_text() == key.to_text());
}

void read_receipt(std::string_view text) {
    const resync::Receipt receipt = resync::parse_receipt(text, "fuzz");
    static_cast<void>(receipt.in_file());
    static_cast<void>(resync::parse_receipt(resync::to_text(receipt), "again"));
}

void read_commitment(std::string_view text) {
    const commitment::Commitment commitment = commitment::parse_commitment(text, "fuzz");
    const std::string written = commitment::to_text(commitment);
    fuzz::require(commitment::to_text(commitment::parse_commitment(written, "again")) == written);
}

void read_message(std::string_view text) {
    const payload::Message message = payload::parse_message(text);
    fuzz::require(payload::parse_message(payload::to_argument(message)) == message);
    const payload::Format format = payload::format_of(message);
    fuzz::require(payload::from_frame(payload::to_frame(message, format), format) == message);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0] % 4) {
        case 0:
            read_key(with_checksum(text));
            break;
        case 1:
            read_receipt(with_digest(text));
            break;
        case 2:
            read_commitment(text);
            break;
        default:
            read_message(text);
        }
    } catch (const Error&) {
    }
    return 0;
}
