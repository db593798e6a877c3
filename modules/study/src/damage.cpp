// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/damage.hpp>

#include <wm3d/core/error.hpp>

#ifdef WM3D_WITH_ATTACK
#include <algorithm>

#include <wm3d/attack.hpp>
#endif

namespace wm3d::study {

#ifdef WM3D_WITH_ATTACK

namespace {

/// Whether a part between commas is an attack and no value of the attack before it.
bool starts_attack(std::string_view part) {
    if (part.substr(0, part.find_first_of("+=")).find(':') != std::string_view::npos)
        return true; // whether its name is known or not: values have no colon
    const std::string_view name = part.substr(0, part.find('+'));
    return std::ranges::any_of(attack::known_attacks(), [&](const attack::AttackInfo& info) {
        return name == info.name || (!info.alias.empty() && name == info.alias);
    });
}

std::vector<std::string> split_attacks(std::string_view text) {
    std::vector<std::string> attacks;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view part = text.substr(0, comma);
        if (attacks.empty() || starts_attack(part) ||
            part.find_first_of("0123456789=") == std::string_view::npos)
            attacks.emplace_back(part);
        else
            attacks.back().append(1, ',').append(part);
        if (comma == std::string_view::npos)
            return attacks;
        text.remove_prefix(comma + 1);
    }
}

} // namespace

std::vector<NamedDamage> parse_damages(std::string_view text) {
    std::vector<NamedDamage> damages;
    for (const std::string& part : split_attacks(text)) {
        std::vector<attack::AttackSpec> chain = attack::parse_chain(part);
        std::string name = attack::to_string(chain);
        damages.push_back(
            {std::move(name), [chain = std::move(chain)](const TriangleMesh& mesh, std::uint64_t seed) {
                 return attack::apply(mesh, chain, seed);
             }});
    }
    return damages;
}

#else

std::vector<NamedDamage> parse_damages(std::string_view) {
    throw ParameterError(
        "this build has no attacks; build it with the module attack, which needs CGAL and OpenMesh",
        ErrorCode::missing_feature);
}

#endif

} // namespace wm3d::study
