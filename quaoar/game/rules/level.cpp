#include <quaoar/level.hpp>

#include <algorithm>

#include "hash.hpp"

namespace quaoar {

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
