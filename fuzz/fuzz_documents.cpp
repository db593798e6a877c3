// SPDX-License-Identifier: GPL-3.0-or-later
// Any text is a key, a receipt or a commitment, or is refused with wm3d::Error; what was read survives being
// written and read again. The first byte chooses.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <wm3d/commitment.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/key.hpp>
#include <wm3d/resync/receipt.hpp>

namespace {

void require(bool holds) {
    if (!holds)
        std::abort();
}

/// A protected key costs seconds to open, so it is refused when it asks.
wm3d::key::Passphrase no_passphrase() {
    throw wm3d::InputError("nobody is there");
}

void read_key(std::string_view text) {
    const auto key = wm3d::key::Key::parse(text, "fuzz", no_passphrase);
    require(wm3d::key::Key::parse(key.to_text(), "again").to_text() == key.to_text());
}

void read_receipt(std::string_view text) {
    const auto receipt = wm3d::resync::parse_receipt(text, "fuzz");
    static_cast<void>(receipt.in_file());
    static_cast<void>(wm3d::resync::to_text(receipt));
}

void read_commitment(std::string_view text) {
    const auto commitment = wm3d::commitment::parse_commitment(text, "fuzz");
    const std::string written = wm3d::commitment::to_text(commitment);
    require(wm3d::commitment::to_text(wm3d::commitment::parse_commitment(written, "again")) == written);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0] % 3) {
        case 0:
            read_key(text);
            break;
        case 1:
            read_receipt(text);
            break;
        default:
            read_commitment(text);
        }
    } catch (const wm3d::Error&) {
    }
    return 0;
}
