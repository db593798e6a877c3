// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Exceptions that cross module borders. Every message is one sentence: what, where, what would mend
/// it. A verdict, an absence or an early stop is a result, never an exception.
#pragma once

#include <stdexcept>

namespace wm3d {

/// Base of everything wm3d throws on purpose; the commands print `what()` and exit with status 2.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file or stream that can't be read as what it should be (missing, truncated, malformed, wrong version).
class InputError : public Error {
public:
    using Error::Error;
};

/// A file or stream that can't be written.
class OutputError : public Error {
public:
    using Error::Error;
};

/// A mesh that is readable but that the operation can't work on (no area, all points equal, too small).
class GeometryError : public Error {
public:
    using Error::Error;
};

/// A parameter outside its range, or parameters that exclude each other.
class ParameterError : public Error {
public:
    using Error::Error;
};

} // namespace wm3d
