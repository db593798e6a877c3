// SPDX-License-Identifier: GPL-3.0-or-later
// Any text is a chain of attacks or is refused with wm3d::Error; what was understood is understood again as
// it is written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <wm3d/attack/spec.hpp>
#include <wm3d/core/error.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        for (const wm3d::attack::AttackSpec& spec : wm3d::attack::parse_chain(text)) {
            const std::string written = wm3d::attack::to_string(spec);
            if (wm3d::attack::to_string(wm3d::attack::parse(written)) != written)
                std::abort();
        }
    } catch (const wm3d::Error&) {
    }
    return 0;
}
