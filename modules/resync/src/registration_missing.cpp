// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/error.hpp>
#include <wm3d/resync/registration.hpp>
#include <wm3d/resync/surface_difference.hpp>

namespace wm3d::resync {

namespace {

[[noreturn]] void refuse() {
    throw ParameterError(
        "this build of wm3d can't register against a receipt or a reference, because it was made "
        "without Ceres; build it with -DWM3D_RESYNC=ON",
        ErrorCode::missing_feature);
}

} // namespace

bool has_registration() {
    return false;
}

Registration register_template(const PoseTemplate&, const TriangleMesh&, const RegistrationOptions&,
                               const Progress&) {
    refuse();
}

SurfaceDifference surface_difference(const TriangleMesh&, const TriangleMesh&, double) {
    refuse();
}

} // namespace wm3d::resync
