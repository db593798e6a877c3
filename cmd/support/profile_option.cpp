// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/profile_option.hpp"

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace wm3d::cmd {

CLI::Option* add_profile(CLI::App& app, watermark::Profile& profile) {
    using enum watermark::Profile;
    return app
        .add_option("--profile", profile,
                    "How the mark is laid out: masked, where the surface hides it; robust, shaped for the "
                    "detector; or paper, eq. (3) alone [masked]")
        ->option_text("NAME")
        ->transform(CLI::CheckedTransformer(std::map<std::string, watermark::Profile>{
            {"masked", masked}, {"robust", robust}, {"paper", paper}}));
}

} // namespace wm3d::cmd
