// Work lists of one body: what stages loop over follows who wakes, falls asleep or goes, without a
// look at anybody else.
#pragma once

#include <cstdint>

namespace sulfur::detail {

struct BodyRecord;
struct Range;
struct State;

/// Its rigid components [first, last).
Range clustersOf(const State& state, std::uint32_t body);

/// Whether any part of a body, by dense index, belongs to a tree. How bodies are solved must be
/// derived.
bool isInTree(const State& state, std::uint32_t body);
/// Whether a body consists of rigid components and single particles that no joint
/// outside of these, no tree and no other body holds. Only such bodies enter and leave the lists by
/// themselves.
bool isPlain(const State& state, std::uint32_t body);
/// Takes a plain body out of the lists, where it is in them.
void unlist(State& state, std::uint32_t body);
/// The same for one that goes away: it leaves gaps in the longer lists, so that this costs nothing
/// for others that are awake. They are closed all at once, before the next step needs the lists.
void retireFromLists(State& state, std::uint32_t body);
void closeListGaps(State& state);
/// Enters a plain body that is in no list as it is now, awake or asleep.
void enlist(State& state, std::uint32_t body);

/// How many particles of a body have a surface.
std::uint32_t countSurfaces(const State& state, const BodyRecord& body);

}  // namespace sulfur::detail
