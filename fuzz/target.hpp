// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What every fuzzing target has: the inputs that it begins with, the words of its language, its check.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <wm3d/core/error.hpp>

/// Tries one input; aborts, or is stopped by a sanitizer, if something is wrong. libFuzzer's name for it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace wm3d::fuzz {

inline constexpr std::string_view targets[] = {"models", "documents", "grammars", "marks"};

/// The first inputs of a target, made by code: valid ones of every kind.
std::vector<std::string> seeds(std::string_view target);

/// Words that its inputs are made of, for mutations.
std::vector<std::string> words(std::string_view target);

/// What every input has to hold, whatever it is.
void require(bool holds);

} // namespace wm3d::fuzz
