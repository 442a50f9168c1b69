#include <quaoar/workings.hpp>

#include "hash.hpp"

namespace quaoar {

Workings::Workings(const Attempt& attempt)
    : signals(attempt.level),
      switches(attempt),
      movers(attempt),
      zones(attempt),
      crumbling(attempt),
      respawns(attempt),
      monsters(attempt) {}

std::uint64_t Workings::hash() const {
    Hash hash;
    hash.add(switches.hash()).add(movers.hash()).add(zones.hash());
    hash.add(crumbling.hash()).add(respawns.hash()).add(monsters.hash());
    return hash.value();
}

}  // namespace quaoar
