// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are read as a mesh or refused with wm3d::Error; what was read can be patched and read again. The
// first byte chooses the format.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <wm3d/core/error.hpp>
#include <wm3d/io.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace wm3d;
    using namespace wm3d::io;
    if (size == 0)
        return 0;
    const auto format = static_cast<Format>(data[0] % 6);
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        const Model model = parse(bytes, format, "fuzz");
        if (model.patched(model.mesh().positions) != bytes)
            std::abort(); // nothing moved, so nothing may change
        std::vector<Vec3> wanted = model.mesh().positions;
        for (Vec3& p : wanted)
            p *= 0.75;
        static_cast<void>(model.stored_positions(wanted));
        static_cast<void>(parse(model.patched(wanted), format, "again"));
    } catch (const Error&) {
    }
    return 0;
}
