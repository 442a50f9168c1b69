#include <quaoar/level.hpp>

#include <algorithm>

#include "hash.hpp"

namespace quaoar {

Theme themeOf(Theme::World world) {
    switch (world) {
        case Theme::World::dawn:
            break;
        case Theme::World::bog:
            return {world, 0x06151A, 0x1B4A3D, 0x2C4A38, 0xB9E27C, 1};
        case Theme::World::machine:
            return {world, 0x150D16, 0x5A2C22, 0x3A3A44, 0xFFB36B, 1};
        case Theme::World::deep:
            return {world, 0x06041C, 0x2A1B66, 0x2D2262, 0x8FF1FF, 1};
    }
    return {};
}

const char* name(Medal medal) {
    switch (medal) {
        case Medal::gold:
            return "gold";
        case Medal::silver:
            return "silver";
        case Medal::bronze:
            return "bronze";
        case Medal::none:
            break;
    }
    return "none";
}

/// Of several beginnings of an id, the longest counts.
Surface Level::surface(std::string_view bodyId) const {
    const auto found = surfaces.find(bodyId);
    if (found != surfaces.end()) return found->second;
    Surface best;
    std::size_t longest = 0;
    for (const auto& [key, surface] : surfaces) {
        if (!namesSeveral(key) || key.size() <= longest || !namesBody(key, bodyId)) continue;
        best = surface;
        longest = key.size();
    }
    return best;
}

bool namesSeveral(std::string_view surfaceKey) {
    return surfaceKey.ends_with('*');
}

bool namesBody(std::string_view surfaceKey, std::string_view bodyId) {
    if (!namesSeveral(surfaceKey)) return surfaceKey == bodyId;
    return bodyId.starts_with(surfaceKey.substr(0, surfaceKey.size() - 1));
}

Medal Level::medalFor(double seconds) const {
    if (seconds <= medals.gold) return Medal::gold;
    if (seconds <= medals.silver) return Medal::silver;
    if (seconds <= medals.bronze) return Medal::bronze;
    return Medal::none;
}

std::optional<std::size_t> Level::signal(std::string_view name) const {
    const auto found = std::lower_bound(signals.begin(), signals.end(), name);
    if (found == signals.end() || *found != name) return std::nullopt;
    return static_cast<std::size_t>(found - signals.begin());
}

std::uint64_t contentHash(std::string_view bytes) {
    return Hash().bytes(bytes).value();
}

}  // namespace quaoar
