// Which capsules meet in a particle.
#pragma once

#include <cstdint>
#include <vector>

namespace sulfur::detail {

struct Counts;
struct State;

/// The other ends of the capsules that end in each particle: those of particle i are
/// end[start[i]] to end[start[i + 1]]. Ends of fixed capsules that lie on the same spot count as
/// one corner, so that ground made of many bodies has no more corners than ground made of one.
struct Spokes {
    std::vector<std::uint32_t> start, end;
};

void findSpokes(const State& state, Spokes& spokes);
/// The same where bodies that can move were added since they were found for `before`, and nothing
/// else changed.
void addSpokes(const State& state, const Counts& before, Spokes& spokes);

}  // namespace sulfur::detail
