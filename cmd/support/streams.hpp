// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Standard input and output as bytes, with their failures noticed.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace wm3d::cmd {

/// The reader of our standard output went away (`wm3d ... | head`). Nobody is left to tell: the program ends
/// without a word.
class ClosedPipe : public std::exception {
public:
    const char* what() const noexcept override { return "the reader of the output is gone"; }
};

/// Makes a write to a closed pipe an error instead of a signal, and gives every missing standard stream a
/// place, so that no file we open later can end up as "standard output".
void prepare_standard_streams();

/// Writes all bytes to a file descriptor, 1 for standard output.
/// \throw ClosedPipe   if nobody reads any more
/// \throw OutputError  on any other failure
void write_all(int descriptor, std::string_view bytes);

/// Writes to standard error as well as can be: a message that nobody can see is no reason to fail.
void write_message(std::string_view text);

/// Everything on standard input, to its end.
/// \throw InputError  if it can't be read
std::string read_standard_input();

} // namespace wm3d::cmd
