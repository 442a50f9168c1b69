// How a timeline keeps what it has recorded. Only its own files include this.
#pragma once

#include <algorithm>
#include <cmath>

#include "timeline.hpp"

namespace sulfurchamber {

/// At least one.
inline std::uint64_t ticksOf(const sulfur::World& world, double seconds) {
    return static_cast<std::uint64_t>(
        std::max(1.0, std::round(seconds / static_cast<double>(world.tickDuration()))));
}

/// A snapshot, packed; most are what differs from the first of their group.
struct Timeline::Key {
    std::uint64_t tick = 0;
    std::uint64_t serial = 0;
    std::uint64_t base = 0;  // serial of the key that it differs from; its own when it is whole
    std::size_t size = 0;    // unpacked
    std::vector<std::byte> packed;
};

/// Two that have touched.
struct Timeline::Seen {
    std::uint64_t tick = 0;
    std::pair<sulfur::BodyId, sulfur::BodyId> pair;
};

/// A future: what follows from where it parted.
struct Timeline::Branch {
    struct Input {
        std::uint64_t tick = 0;
        std::variant<Push, Arrival, Thrust, DriveChange> what;
    };
    std::uint32_t parent = 0;  // 0: none
    std::uint64_t begin = 0;   // its first key's tick, at which it parted from its parent
    std::uint64_t last = 0;
    std::uint64_t used = 0;  // when it was last shown
    std::vector<Key> keys;   // one at least
    std::vector<Input> inputs;
    std::vector<Mark> marks;
    std::vector<Seen> seen;
};

}  // namespace sulfurchamber
