// SPDX-License-Identifier: GPL-3.0-or-later
// Written by generate/frozen_sequence.py: level 3, secret number 1 of family 3.
#pragma once

inline constexpr const char* frozen_payload = // "frozen"
    "++-+-+-+--+-++-+-++-+-+++-+--++--++----+++--+++-+-+--+--++----+--+-++-+++++--+++-+-++--++++-++-+";
inline constexpr const char* frozen_copy = // of work "work" for "Ann"
    "-----+-++++-+------++-+++--+++++-+--++++++--++--+-++++-+-++--+-++++-------++++-++-+-+-++---+---+";
