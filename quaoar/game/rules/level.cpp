#include <quaoar/level.hpp>

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

std::uint64_t contentHash(std::string_view bytes) {
    return Hash().bytes(bytes).value();
}

}  // namespace quaoar
