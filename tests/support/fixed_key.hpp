// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Keys that are the same in every run, so that what fails once fails again.
#pragma once

#include <wm3d/key/key_file.hpp>

namespace wm3d {

inline key::Key fixed_key() {
    return key::Key::parse(
        "wm3d key, version 1\n"
        "# Keep this file secret and keep a copy: whoever has it can make and prove marks.\n"
        "name: golden cases: published, so worthless\n"
        "secret: 42d8929fbb0eb4be5907c8fffc8d1b9d50c011e90888ff4067590fae600b3298\n"
        "levels: 3 4 5 6\n"
        "rmax: 0.1\n"
        "reference-strength: 0.05\n"
        "created-by: wm3d 0.1.0\n"
        "checksum: a010771d47f24524723d6f4bc787bc18\n",
        "fixed.key");
}

inline key::Key another_fixed_key() {
    return key::Key::parse(
        "wm3d key, version 1\n"
        "# Keep this file secret and keep a copy: whoever has it can make and prove marks.\n"
        "name: another of the tests: published, so worthless\n"
        "secret: 61691b8b0ae73462d7d3742bc300d3a02e8fb473e48387a10822f423184b83d3\n"
        "levels: 3 4 5 6\n"
        "rmax: 0.1\n"
        "reference-strength: 0.05\n"
        "created-by: wm3d 0.1.0\n"
        "checksum: 56ce25c98f563a541c0c719640a0a3c5\n",
        "another.key");
}

} // namespace wm3d
