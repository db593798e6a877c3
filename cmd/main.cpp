// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
    wm3d::cmd::set_up_memory();
    return wm3d::cmd::run_program({argv, static_cast<std::size_t>(argc)});
}
