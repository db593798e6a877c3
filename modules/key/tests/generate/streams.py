#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the frozen vectors of the keyed streams, ../stream_vectors.hpp, from the definitions alone.

ChaCha20 is written out here and checked against the key stream of the zero key, BLAKE2b is Python's; nothing
of wm3d takes part. Run it without arguments; the output is committed.
"""
import hashlib
import pathlib
import struct

MASK = 0xFFFFFFFF
SECRET = bytes(range(32))


def rotate(x, n):
    return ((x << n) | (x >> (32 - n))) & MASK


def quarter_round(s, a, b, c, d):
    for x, y, z, n in ((a, b, d, 16), (c, d, b, 12), (a, b, d, 8), (c, d, b, 7)):
        s[x] = (s[x] + s[y]) & MASK
        s[z] = rotate(s[z] ^ s[x], n)


def chacha20_block(key, nonce, counter):
    """One 64-byte block of the original variant: 64-bit counter, 64-bit nonce."""
    start = list(struct.unpack("<4I", b"expand 32-byte k")) + list(struct.unpack("<8I", key))
    start += list(struct.unpack("<2I", struct.pack("<Q", counter))) + list(struct.unpack("<2I", nonce))
    s = start[:]
    for _ in range(10):
        for column in range(4):
            quarter_round(s, column, 4 + column, 8 + column, 12 + column)
        for a, b, c, d in ((0, 5, 10, 15), (1, 6, 11, 12), (2, 7, 8, 13), (3, 4, 9, 14)):
            quarter_round(s, a, b, c, d)
    return struct.pack("<16I", *((x + y) & MASK for x, y in zip(s, start)))


assert chacha20_block(bytes(32), bytes(8), 0).hex().startswith("76b8e0ada0f13d90405d6ae55386bd28")


def word(secret, purpose, index, position):
    subkey = hashlib.blake2b(f"wm3d/1 stream {purpose}".encode(), key=secret, digest_size=32).digest()
    block = chacha20_block(subkey, struct.pack("<Q", index), position // 8)
    return struct.unpack_from("<Q", block, 8 * (position % 8))[0]


def symmetric(w):
    return (2 * (w >> 11) + 1 - 2**53) / 2**53  # a quotient of integers that double says exactly


def null_secret(seed, number):
    message = b"wm3d/1 null secret" + struct.pack("<QQ", seed, number)
    return hashlib.blake2b(message, digest_size=32).digest()


def public(secret, what, size):
    return hashlib.blake2b(f"wm3d/1 {what}".encode(), key=secret, digest_size=size).hexdigest()


def main():
    lines = ["// SPDX-License-Identifier: GPL-3.0-or-later",
             "// Written by generate/streams.py; the secret is the bytes 0, 1, ..., 31.",
             "#pragma once", "", "#include <cstdint>", "", "#include <wm3d/key/stream.hpp>", "",
             "struct WordVector {", "    wm3d::key::Purpose purpose;",
             "    std::uint64_t index, position, word;", "};", "",
             "inline constexpr WordVector word_vectors[] = {"]
    positions = (0, 1, 7, 8, 511, 512, 65535, 65536, 200003)
    for purpose in ("watermark", "payload", "recipient", "trial"):
        for index in (0, 1, 5, 2**64 - 1):
            for position in positions:
                value = word(SECRET, purpose, index, position)
                lines.append(f"    {{wm3d::key::Purpose::{purpose}, {index}u, {position}, 0x{value:016x}u}},")
    lines += ["};", "", "struct HeightVector {", "    unsigned level;", "    std::uint64_t vertex;",
              "    double height; // for rmax = 0.1", "};", "", "inline constexpr HeightVector height_vectors[] = {"]
    for level in range(10):
        last = 10 * 4**level + 1
        for vertex in (0, 1, 2, 11, last):
            height = 0.1 * symmetric(word(SECRET, "watermark", level, vertex))
            lines.append(f"    {{{level}, {vertex}, {height.hex()}}},")
    lines += ["};", "", "struct NullVector {", "    std::uint64_t seed, number;", "    const char* secret;", "};", "",
              "inline constexpr NullVector null_vectors[] = {"]
    for seed, number in ((0, 0), (0, 1), (1, 0), (7, 123456789), (2**64 - 1, 2**64 - 1)):
        lines.append(f'    {{{seed}u, {number}u, "{null_secret(seed, number).hex()}"}},')
    lines += ["};", "", "struct LabelVector {", "    const char* label;", "    std::uint64_t index;", "};", "",
              "inline constexpr LabelVector label_vectors[] = {"]
    for label in ("", "a", "work and name"):
        digest = hashlib.blake2b(label.encode(), key=b"wm3d/1 label", digest_size=16).digest()
        lines.append(f'    {{"{label}", 0x{struct.unpack_from("<Q", digest)[0]:016x}u}},')
    lines += ["};", "", f'inline constexpr const char* fingerprint_vector = "{public(SECRET, "fingerprint", 16)[:16]}";',
              f'inline constexpr const char* commitment_vector =\n    "{public(SECRET, "commitment", 32)}";', ""]
    target = pathlib.Path(__file__).resolve().parent.parent / "stream_vectors.hpp"
    target.write_text("\n".join(lines), encoding="ascii")


main()
