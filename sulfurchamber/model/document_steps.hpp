// The parts of a document's history, for its own sources.
#pragma once

#include "document.hpp"
#include "text_change.hpp"

namespace sulfurchamber {

/// How messages name the text of a plan.
inline constexpr const char* planName = "the scene";

/// What a document was on one side of a step, beside its plan.
struct Document::Side {
    Constants constants;
    std::uint64_t state = 0;
    bool moved = false;   ///< else the world is the plan's, and there is no moment
    Shelf::Place moment;  ///< the world's snapshot
    Timeline::Place place = {};
};

/// One step of the history: how it changed the plan, and the side of it on which one is not.
struct Document::Step {
    std::string label;
    Shelf::Place change;  ///< bytes of a TextChange
    Side other;
};

/// What rains bears such a key: the place of its blueprint, with the topmost bit.
inline constexpr std::uint64_t passingBit = std::uint64_t{1} << 63;
inline bool isPassing(std::uint64_t key) {
    return (key & passingBit) != 0;
}
inline std::size_t passingPlace(std::uint64_t key) {
    return static_cast<std::size_t>(key & ~passingBit);
}

}  // namespace sulfurchamber
