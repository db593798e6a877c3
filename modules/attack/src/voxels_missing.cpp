// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>
#include <wm3d/core/error.hpp>

namespace wm3d::attack {

bool has_voxels() {
    return false;
}

TriangleMesh extract_voxels(const TriangleMesh&, int) {
    throw ParameterError("this build has no attack voxels: install OpenVDB and build wm3d again",
                         ErrorCode::missing_feature);
}

} // namespace wm3d::attack
