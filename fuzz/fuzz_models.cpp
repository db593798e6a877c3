// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are read as a mesh or refused with wm3d::Error; what was read can be patched, with its normals
// kept or turned, and read again. The first byte chooses the format and the normals, the second how many of
// the bytes at the end are the buffer that a glTF file names.
#include <wm3d/io.hpp>

#include "target.hpp"

using namespace wm3d;

namespace {

void read_patch_and_read(const std::string& bytes, io::Format format, const io::Resolver& resolver,
                         io::Normals normals) {
    const io::Model model = io::parse(bytes, format, "fuzz", resolver);
    fuzz::require(model.patched(model.mesh().positions) == bytes); // nothing moved, so nothing may change
    std::vector<Vec3> wanted = model.mesh().positions;
    for (Vec3& p : wanted)
        p *= 0.75;
    fuzz::require(model.stored_positions(wanted).size() == wanted.size());
    fuzz::require(model.coordinate_step() >= 0);
    static_cast<void>(model.read_back(model.patched_files(wanted, "out", normals)));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2)
        return 0;
    const auto format = static_cast<io::Format>(data[0] % 6);
    const io::Normals normals = data[0] >= 128 ? io::Normals::turn : io::Normals::keep;
    const std::string all(reinterpret_cast<const char*>(data) + 2, size - 2);
    const std::size_t beside = all.size() * data[1] / 256;
    const std::string bytes = all.substr(0, all.size() - beside), buffer = all.substr(all.size() - beside);
    const io::Resolver resolver = [&](std::string_view uri) {
        if (uri.size() > 8)
            throw InputError("there is no such buffer");
        return buffer;
    };
    try {
        read_patch_and_read(bytes, format, resolver, normals);
    } catch (const Error&) {
    }
    return 0;
}
