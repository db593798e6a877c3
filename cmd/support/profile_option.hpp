// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The option that says how marks are laid out.
#pragma once

#include <wm3d/watermark/defaults.hpp>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace wm3d::cmd {

/// Adds --profile, which sets `profile`.
CLI::Option* add_profile(CLI::App& app, watermark::Profile& profile);

} // namespace wm3d::cmd
