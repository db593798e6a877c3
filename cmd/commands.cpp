// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>
#include <array>

#include "command_analyze.hpp"
#include "command_attack.hpp"
#include "command_bench.hpp"
#include "command_compare.hpp"
#include "command_identify.hpp"
#include "command_info.hpp"
#include "command_keygen.hpp"
#include "command_ledger.hpp"
#include "command_maps.hpp"
#include "command_mark.hpp"
#include "command_resync.hpp"
#include "command_sample.hpp"
#include "command_simplify.hpp"
#include "command_sphere.hpp"
#include "command_verify.hpp"

namespace wm3d::cmd {

namespace {

constexpr std::array table{
    Command{"keygen", "Marks", "make an owner's key", declare_keygen},
    Command{"mark", "Marks", "hide a key's mark in a mesh", declare_mark},
    Command{"verify", "Marks", "say whether a key's mark is in a mesh", declare_verify},
    Command{"identify", "Marks", "say whose copy a mesh was made from", declare_identify},
    Command{"ledger", "Marks", "tell which copies went to whom", declare_ledger},
    Command{"analyze", "Robustness", "tell how sure an owner can be: P_m over P_f", declare_analyze},
#ifdef WM3D_WITH_ATTACK
    Command{"attack", "Robustness", "do to a mesh what may happen to it", declare_attack},
#endif
    Command{"compare", "Robustness", "tell how far apart two meshes are", declare_compare},
#ifdef WM3D_WITH_ATTACK
    Command{"bench", "Robustness", "tell what marks survive, over models and attacks", declare_bench},
#endif
    Command{"resync", "Parts of the method", "lay a moved or cut mesh back on its model", declare_resync},
    Command{"simplify", "Parts of the method", "simplify a mesh to a number of vertices", declare_simplify},
    Command{"maps", "Parts of the method", "map a mesh onto its base domain", declare_maps},
    Command{"sphere", "Parts of the method", "write the watermarking sphere as a mesh", declare_sphere},
    Command{"info", "Meshes", "tell what a mesh file holds", declare_info},
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
