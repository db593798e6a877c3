// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>
#include <array>

#include "command_keygen.hpp"
#include "command_sample.hpp"
#include "command_simplify.hpp"
#include "command_sphere.hpp"

namespace wm3d::cmd {

namespace {

constexpr std::array table{
    Command{"keygen", "Marks", "make an owner's key", declare_keygen},
    Command{"simplify", "Parts of the method", "simplify a mesh to a number of vertices", declare_simplify},
    Command{"sphere", "Parts of the method", "write the watermarking sphere as a mesh", declare_sphere},
    Command{"sample", "Meshes", "write the built-in demonstration model", declare_sample},
};

} // namespace

std::span<const Command> commands() {
    return table;
}

const Command* find_command(std::string_view name) {
    const auto found = std::ranges::find(table, name, &Command::name);
    return found == table.end() ? nullptr : &*found;
}

} // namespace wm3d::cmd
