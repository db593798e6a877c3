// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Laying a mark down: eq. (3) on the base domain, detail vectors, reconstruction, and faces that
/// must not turn over.
#pragma once

#include <wm3d/embed/embed.hpp>
#include <wm3d/embed/turned_faces.hpp>
