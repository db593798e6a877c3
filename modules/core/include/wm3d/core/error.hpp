// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Exceptions that cross module borders. Every message is one sentence: what, where, what would mend
/// it. A verdict, an absence or an early stop is a result, never an exception.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace wm3d {

/// What a program may want to tell apart. Names are stable: the same in every language and under --json.
enum class ErrorCode {
    usage,             ///< a command line that can't be understood
    bad_parameter,     ///< a value outside its range, or values that exclude each other
    missing_feature,   ///< this build lacks a part
    unreadable_input,  ///< a file that is missing, a folder, or not for this user
    malformed_input,   ///< a file that is not what it should be
    altered_input,     ///< a file whose checksum says that it was changed or cut
    newer_version,     ///< a file of a version that this library doesn't know yet
    wrong_key,         ///< a file that belongs to another key
    unusable_geometry, ///< a mesh that the operation can't work on
    output_exists,     ///< a file in the way
    unwritable_output, ///< a file or stream that can't be written
    self_check,        ///< a mark that would not be found again; nothing was written
    system,            ///< a program, memory or service of the system that is missing
    internal,          ///< a fault of wm3d itself
};

/// "bad_parameter" and so on.
std::string_view name(ErrorCode code);

/// Base of everything wm3d throws on purpose; the commands print `what()` and exit with status 2.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& sentence, ErrorCode code = ErrorCode::system)
        : std::runtime_error(sentence), code_(code) {}

    ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

/// A file or stream that can't be read as what it should be (missing, truncated, malformed, wrong version).
class InputError : public Error {
public:
    explicit InputError(const std::string& sentence, ErrorCode code = ErrorCode::malformed_input)
        : Error(sentence, code) {}
};

/// A file or stream that can't be written.
class OutputError : public Error {
public:
    explicit OutputError(const std::string& sentence, ErrorCode code = ErrorCode::unwritable_output)
        : Error(sentence, code) {}
};

/// A mesh that is readable but that the operation can't work on (no area, all points equal, too small).
class GeometryError : public Error {
public:
    explicit GeometryError(const std::string& sentence, ErrorCode code = ErrorCode::unusable_geometry)
        : Error(sentence, code) {}
};

/// A parameter outside its range, or parameters that exclude each other.
class ParameterError : public Error {
public:
    explicit ParameterError(const std::string& sentence, ErrorCode code = ErrorCode::bad_parameter)
        : Error(sentence, code) {}
};

} // namespace wm3d
