// SPDX-License-Identifier: GPL-3.0-or-later
// This work is based on Argon2 (RFC 9106) and on XSalsa20-Poly1305, both of libsodium.
#include "protection.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include <fmt/format.h>
#include <sodium.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/hex.hpp>

#include "sodium.hpp"

namespace wm3d::key {

namespace {

constexpr std::string_view method = "argon2id";
constexpr unsigned most_passes = 20, most_memory_mib = 4096;

std::uint8_t* bytes_of(std::string& text) {
    return reinterpret_cast<std::uint8_t*>(text.data());
}

std::string random_bytes(std::size_t size) {
    std::string bytes(size, '\0');
    randombytes_buf(bytes.data(), bytes.size());
    return bytes;
}

/// The key of the box.
std::shared_ptr<std::uint8_t> derived(const ProtectedSecret& secret, const Passphrase& passphrase) {
    std::shared_ptr<std::uint8_t> key = guarded_memory(crypto_secretbox_KEYBYTES);
    const std::string_view text = passphrase.text();
    if (crypto_pwhash(key.get(), crypto_secretbox_KEYBYTES, text.data(), text.size(),
                      key::bytes_of(secret.salt).data(), secret.cost.passes,
                      std::size_t{secret.cost.memory_mib} << 20, crypto_pwhash_ALG_ARGON2ID13) != 0)
        throw Error(fmt::format("the passphrase needs {} MiB of memory, which the system doesn't give; close "
                                "other programs",
                                secret.cost.memory_mib));
    return key;
}

std::optional<std::string> from_hex(std::string_view digits, std::size_t size) {
    std::string bytes(size, '\0');
    std::size_t length = 0;
    if (digits.size() != 2 * size ||
        sodium_hex2bin(bytes_of(bytes), size, digits.data(), digits.size(), nullptr, &length, nullptr) != 0)
        return std::nullopt;
    return length == size ? std::optional(bytes) : std::nullopt;
}

std::optional<unsigned> number_up_to(std::string_view text, unsigned most) {
    unsigned number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || number < 1 || number > most)
        return std::nullopt;
    return number;
}

} // namespace

Passphrase::Passphrase(std::string&& text) : size_(text.size()) {
    const bool fits = size_ > 0 && size_ <= size_limit;
    if (fits) {
        const std::shared_ptr<std::uint8_t> memory = guarded_memory(size_);
        std::copy(text.begin(), text.end(), memory.get());
        bytes_ = memory;
    }
    wipe(text);
    if (!fits)
        throw ParameterError(
            fmt::format("a passphrase has 1 to {} bytes; this one has {}", size_limit, size_));
}

ProtectedSecret protect(const Secret& secret, const Passphrase& passphrase, const ProtectionCost& cost) {
    start_sodium();
    ProtectedSecret result{cost, random_bytes(crypto_pwhash_SALTBYTES),
                           random_bytes(crypto_secretbox_NONCEBYTES),
                           std::string(crypto_secretbox_MACBYTES + Secret::size, '\0')};
    crypto_secretbox_easy(bytes_of(result.box), secret.bytes().data(), Secret::size,
                          key::bytes_of(result.nonce).data(), derived(result, passphrase).get());
    return result;
}

std::optional<Secret> opened(const ProtectedSecret& secret, const Passphrase& passphrase) {
    const std::shared_ptr<std::uint8_t> bytes = guarded_memory(Secret::size);
    if (crypto_secretbox_open_easy(bytes.get(), key::bytes_of(secret.box).data(), secret.box.size(),
                                   key::bytes_of(secret.nonce).data(),
                                   derived(secret, passphrase).get()) != 0)
        return std::nullopt;
    return Secret(std::span<const std::uint8_t, Secret::size>(bytes.get(), Secret::size));
}

std::string to_text(const ProtectedSecret& s) {
    return fmt::format("{} {} {} {} {} {}", method, s.cost.passes, s.cost.memory_mib,
                       to_hex(key::bytes_of(s.salt)), to_hex(key::bytes_of(s.nonce)),
                       to_hex(key::bytes_of(s.box)));
}

std::optional<ProtectedSecret> parse_protected(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (words.size() != 6 || words[0] != method)
        return std::nullopt;
    const auto passes = number_up_to(words[1], most_passes), memory = number_up_to(words[2], most_memory_mib);
    auto salt = from_hex(words[3], crypto_pwhash_SALTBYTES),
         nonce = from_hex(words[4], crypto_secretbox_NONCEBYTES),
         box = from_hex(words[5], crypto_secretbox_MACBYTES + Secret::size);
    if (!passes || !memory || !salt || !nonce || !box)
        return std::nullopt;
    return ProtectedSecret{{*passes, *memory}, *std::move(salt), *std::move(nonce), *std::move(box)};
}

} // namespace wm3d::key
