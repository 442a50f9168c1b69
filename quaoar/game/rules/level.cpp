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

Surface Level::surface(std::string_view bodyId) const {
    const auto found = surfaces.find(bodyId);
    return found == surfaces.end() ? Surface{} : found->second;
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
