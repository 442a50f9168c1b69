// Which sides of capsules are outside.
#pragma once

#include <cstdint>
#include <vector>

namespace sulfur::detail {

struct State;

/// An edge of a body's outer face: whoever walks along it has the body to the left.
struct RimEdge {
    std::uint32_t from = 0, to = 0;  // particles
    std::uint32_t joint = 0;
};
/// Loops that bound a body, those that are solid inside, by its capsules and where its particles
/// are in the blueprint (see outline.cpp).
std::vector<std::vector<RimEdge>> findOutlines(const State& state, std::uint32_t body,
                                               const std::vector<std::uint32_t>& capsules);
/// The same, by all capsules of the body.
std::vector<std::vector<RimEdge>> findOutlines(const State& state, std::uint32_t body);

}  // namespace sulfur::detail
