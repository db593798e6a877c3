// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/secret.hpp>

#include <algorithm>
#include <new>

#include <sodium.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/hex.hpp>

#include "sodium.hpp"

namespace wm3d::key {

void start_sodium() {
    static const bool started = sodium_init() >= 0;
    if (!started)
        throw Error("libsodium can't be started, so no key can be used; check the system's random generator");
}

void blake2b(std::span<std::uint8_t> out, std::span<const std::uint8_t> message,
             std::span<const std::uint8_t> key) {
    start_sodium();
    crypto_generichash(out.data(), out.size(), message.data(), message.size(), key.data(), key.size());
}

std::array<std::uint8_t, 8> little_endian(std::uint64_t number) {
    std::array<std::uint8_t, 8> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(number >> (8 * i));
    return bytes;
}

std::shared_ptr<std::uint8_t> guarded_memory(std::size_t size) {
    start_sodium();
    void* const memory = sodium_malloc(size);
    if (memory == nullptr)
        throw std::bad_alloc();
    return {static_cast<std::uint8_t*>(memory), [](std::uint8_t* bytes) { sodium_free(bytes); }};
}

void wipe(std::string& text) {
    sodium_memzero(text.data(), text.size());
    text.clear();
}

Secret::Secret(std::span<const std::uint8_t, size> bytes) {
    const std::shared_ptr<std::uint8_t> memory = guarded_memory(size);
    std::ranges::copy(bytes, memory.get());
    bytes_ = memory;
}

Secret Secret::random() {
    const std::shared_ptr<std::uint8_t> memory = guarded_memory(size);
    randombytes_buf(memory.get(), size);
    return Secret(memory);
}

bool operator==(const Secret& a, const Secret& b) {
    return sodium_memcmp(a.bytes_.get(), b.bytes_.get(), Secret::size) == 0;
}

Secret null_secret(std::uint64_t seed, std::uint64_t number) {
    std::string message = "wm3d/1 null secret";
    for (const std::uint64_t part : {seed, number})
        for (const std::uint8_t byte : little_endian(part))
            message += static_cast<char>(byte);
    // Anybody can make it and calibration makes very many, so it needs no pages of its own.
    const std::shared_ptr<std::uint8_t> bytes(new std::uint8_t[Secret::size],
                                              std::default_delete<std::uint8_t[]>());
    blake2b({bytes.get(), Secret::size}, bytes_of(message), {});
    return Secret(bytes);
}

std::string fingerprint(const Secret& secret) {
    // BLAKE2b digests below 16 bytes are not offered, so this is the head of a longer one.
    std::array<std::uint8_t, 16> digest;
    blake2b(digest, bytes_of("wm3d/1 fingerprint"), secret.bytes());
    return to_hex(std::span(digest).first(8));
}

std::string commitment(const Secret& secret) {
    std::array<std::uint8_t, 32> digest;
    blake2b(digest, bytes_of("wm3d/1 commitment"), secret.bytes());
    return to_hex(digest);
}

} // namespace wm3d::key
