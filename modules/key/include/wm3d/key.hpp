// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The owner's key: file, secret, and the pseudo-random streams derived from it.
#pragma once

#include <wm3d/key/key_file.hpp>
#include <wm3d/key/passphrase.hpp>
#include <wm3d/key/secret.hpp>
#include <wm3d/key/stream.hpp>
