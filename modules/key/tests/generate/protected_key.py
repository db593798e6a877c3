#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the frozen protected key of ../protection_test.cpp, made from the definitions with PyNaCl (Debian: python3-nacl).

The secret is the bytes 0, 1, ..., 31; salt and nonce are fixed here, which no real key's are."""
import hashlib

from nacl.bindings import crypto_pwhash_ALG_ARGON2ID13, crypto_pwhash_alg, crypto_secretbox

PASSES, MEMORY_MIB = 1, 8
SALT, NONCE = bytes(range(100, 116)), bytes(range(200, 224))

key = crypto_pwhash_alg(32, "correct horse ë".encode(), SALT, PASSES, MEMORY_MIB << 20, crypto_pwhash_ALG_ARGON2ID13)
box = crypto_secretbox(bytes(range(32)), NONCE, key)
lines = ["wm3d key, version 2", "# A comment.", "name: Museum of Casts",
         f"protected-secret: argon2id {PASSES} {MEMORY_MIB} {SALT.hex()} {NONCE.hex()} {box.hex()}",
         "levels: 4 6", "rmax: 0.2", "reference-strength: 0.03", "created-by: wm3d 0.1.0"]
text = "".join(f"{line}\n" for line in lines)
print(text + f"checksum: {hashlib.blake2b(text.encode(), digest_size=16).hexdigest()}")
