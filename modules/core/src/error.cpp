// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/error.hpp>

namespace wm3d {

std::string_view name(ErrorCode code) {
    switch (code) {
    case ErrorCode::usage:
        return "usage";
    case ErrorCode::bad_parameter:
        return "bad_parameter";
    case ErrorCode::missing_feature:
        return "missing_feature";
    case ErrorCode::unreadable_input:
        return "unreadable_input";
    case ErrorCode::malformed_input:
        return "malformed_input";
    case ErrorCode::altered_input:
        return "altered_input";
    case ErrorCode::newer_version:
        return "newer_version";
    case ErrorCode::wrong_key:
        return "wrong_key";
    case ErrorCode::unusable_geometry:
        return "unusable_geometry";
    case ErrorCode::output_exists:
        return "output_exists";
    case ErrorCode::unwritable_output:
        return "unwritable_output";
    case ErrorCode::self_check:
        return "self_check";
    case ErrorCode::system:
        return "system";
    case ErrorCode::internal:
        break;
    }
    return "internal";
}

} // namespace wm3d
