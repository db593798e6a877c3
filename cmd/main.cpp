// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

int main(int argc, char** argv) {
#ifdef __GLIBC__
    // Else each large block that is freed teaches glibc to keep the next: a sixth of verify's memory on dense models.
    mallopt(M_MMAP_THRESHOLD, 2 << 20);
    // And each smaller one that is freed would go back to the system, to come again page by page.
    mallopt(M_TRIM_THRESHOLD, 32 << 20);
#endif
    return wm3d::cmd::run_program({argv, static_cast<std::size_t>(argc)});
}
