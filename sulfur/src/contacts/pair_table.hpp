// Making and ending pairs of chunks.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur::detail {

struct State;
struct BodyRecord;
struct ContactCore;
struct Pair;
struct PairWatch;
struct Motion3;

/// Whether their kinds, filters and vetoes let two different bodies touch.
bool mayTouch(const State& state, const BodyRecord& a, const BodyRecord& b);
/// Makes pairs with all whose boxes have come to meet that of a chunk, and ends those that have
/// parted.
void updatePairs(State& state, std::uint32_t chunk);
/// Ends a pair with its rows, which leave impulses to heirs.
void endPair(State& state, std::uint32_t pair);
/// Ends all pairs of a chunk.
void endPairs(State& state, std::uint32_t chunk);
/// A pair is watched from now on, or no longer.
void watchPair(State& state, std::uint32_t pair, double limit);
void unwatchPair(State& state, std::uint32_t pair);
/// A pair of convex chunks has been found apart, with room for so much relative motion, m.
void watchApart(State& state, std::uint32_t pair, Real room);
/// Whether it still has room when both have gone these ways.
bool staysApart(const ContactCore& core, const PairWatch& watch, const Motion3& wayA,
                const Motion3& wayB);
/// Whether a pair has to be looked at whose odometers reach its limit in this step. The limit of
/// two that go alike is moved on.
bool isDue(ContactCore& core, PairWatch& watch);

/// How long it takes to look at a pair, or at its way, in looks at two convex chunks: longer the
/// more corners there are that may be before sides.
std::uint32_t priceOf(const ContactCore& core, const Pair& pair);
/// Takes the rows of a pair away; see endPair().
void dropRows(State& state, std::uint32_t pair);
/// Takes them away while what they hold sleeps: they begin with the same impulses when it wakes.
void keepRows(State& state, std::uint32_t pair);

}  // namespace sulfur::detail
