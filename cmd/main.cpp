// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

int main(int argc, char** argv) {
    return wm3d::cmd::run_program({argv, static_cast<std::size_t>(argc)});
}
