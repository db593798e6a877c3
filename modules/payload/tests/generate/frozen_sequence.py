#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes frozen signs of a payload's and a copy's sequence, ../frozen_sequence.hpp, from the definitions alone.

Nothing of wm3d takes part but the key module's generator of words, which is independent too. The output is committed.
"""
import hashlib
import pathlib
import struct
import sys

HERE = pathlib.Path(__file__).resolve().parent
LEVEL, LENGTH = 3, 512
VERTICES = 10 * 4**LEVEL + 2


def load_streams():
    """The generator of words, without what it writes."""
    path = HERE.parents[2] / "key" / "tests" / "generate" / "streams.py"
    source = path.read_text(encoding="ascii").replace("\nmain()\n", "\n")
    module = type(sys)("streams")
    exec(compile(source, str(path), "exec"), module.__dict__)
    return module


def bits(value, count):
    return [value >> k & 1 for k in reversed(range(count))]


def crc16(message):
    crc = 0xFFFF
    for bit in message:
        top = crc >> 15 ^ bit
        crc = (crc << 1 & 0xFFFF) ^ (0x1021 if top else 0)
    return crc


def frame64(text):
    """8 lengths of texts and 16 of numbers need 5 bits."""
    body = bits(len(text) - 1, 5)
    for byte in text.encode():
        body += bits(byte, 8)
    body += [0] * (5 + 64 - len(body))
    return body + bits(crc16(body), 16)


def encode(information, length):
    weight = lambda i: sum(2 ** (k / 4) for k in range(10) if i >> k & 1)
    places = sorted(sorted(range(length), key=weight, reverse=True)[:len(information)])
    u = dict(zip(places, information))
    # x_i is the sum of the u_k whose digits cover those of i.
    return [sum(bit for k, bit in u.items() if i & k == i) % 2 for i in range(length)]


def main():
    streams = load_streams()
    secret = streams.null_secret(3, 1)
    words = [streams.word(secret, "payload", 16 * LEVEL + 1, k) for k in range(2 * VERTICES)]
    order = sorted(range(VERTICES), key=lambda j: words[j])
    coded = encode(frame64("frozen"), LENGTH)
    payload = [0] * VERTICES
    for k, j in enumerate(order):
        payload[j] = (words[VERTICES + j] >> 63) ^ coded[k % LENGTH]
    label = f"copy {LEVEL} work Ann".encode()
    number = struct.unpack_from("<Q", hashlib.blake2b(label, key=b"wm3d/1 label", digest_size=16).digest())[0]
    copy = [1 - (streams.word(secret, "recipient", number, j // 64) >> j % 64 & 1) for j in range(VERTICES)]
    text = lambda signs: "".join("-" if s else "+" for s in signs[:96])
    (HERE.parent / "frozen_sequence.hpp").write_text(
        "// SPDX-License-Identifier: GPL-3.0-or-later\n"
        "// Written by generate/frozen_sequence.py: level 3, secret number 1 of family 3.\n#pragma once\n\n"
        f'inline constexpr const char* frozen_payload = // "frozen"\n    "{text(payload)}";\n'
        f'inline constexpr const char* frozen_copy = // of work "work" for "Ann"\n    "{text(copy)}";\n', encoding="ascii")


main()
