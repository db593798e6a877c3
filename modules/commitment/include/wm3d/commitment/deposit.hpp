// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A text in the forms in which it can be dated by others.
#pragma once

#include <string>
#include <string_view>

namespace wm3d::commitment {

/// The SHA-256 digest as `sha256sum` prints and checks it: 64 hexadecimal digits, two spaces, `file_name`.
std::string sha256_line(std::string_view text, std::string_view file_name);

/// Whether this build can make time stamp requests.
bool has_timestamps();

/// A time stamp request for the text: TimeStampReq of RFC 3161 in DER, with its SHA-256 digest, a random
/// nonce, and the wish for the authority's certificate. `openssl ts -query -in FILE -text` shows one.
/// \throw Error  if this build has no time stamps, or OpenSSL fails
std::string timestamp_request(std::string_view text);

} // namespace wm3d::commitment
