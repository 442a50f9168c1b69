// Closed outlines: which side of a capsule is outside.
#pragma once

#include <cstdint>
#include <span>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

struct Counts;
struct State;

/// A capsule of an outline, in the sense in which one walks round the body counter-clockwise: its
/// inside is to the left.
struct OutlineEdge {
    std::uint32_t from = 0, to = 0;  // particles, dense indices
    std::uint32_t joint = 0;         // dense index

    friend bool operator==(const OutlineEdge&, const OutlineEdge&) = default;
};

/// The closed outlines of all bodies, derived from their capsules and from where their particles
/// are in the blueprint, so that no deformation turns an outline inside out.
///
/// The capsules of a body make a plane graph. A walk round the outer face of each connected part
/// takes an edge once when it has the body on one side and nothing on the other: these are the
/// outline. It takes ropes, loose ends and bridges between two loops twice, and what is inside
/// never. Joints between bodies do not count.
///
/// A dynamic body is solid inside of its outline. A fixed or kinematic one may as well be the
/// room around all others, so that two things tell: if it is braced like the solids of
/// shapes.hpp, by joints without a radius that end on the outline, it is solid; if it is a mere
/// line of capsules, the ground is to the right of the line, so that it is solid when its joints
/// lead round clockwise, from a to b, and a room or a hollow ring otherwise. (A terrain drawn from
/// left to right has its ground below by the same rule.) A sensor is never a room.
class Outlines {
public:
    /// Complexity: linear in particles, n log n in capsules.
    void derive(const State& state);
    /// The same where bodies were added since it was derived of `before`, and nothing else changed.
    /// Complexity: linear in particles, n log n in the capsules that were added.
    void extend(const State& state, const Counts& before);

    /// +1 when the outside is to the right of the way from a to b, -1 when it is to the left, 0
    /// when the joint bounds nothing.
    std::int8_t outwardOf(std::uint32_t joint) const { return outward_[joint]; }
    /// The edges round a body, those of one loop in the order of a walk.
    std::span<const OutlineEdge> of(std::uint32_t body) const {
        return {edges_.data() + first_[body], edges_.data() + first_[body + 1]};
    }

private:
    std::vector<std::int8_t> outward_;  // by joint
    std::vector<OutlineEdge> edges_;    // by body
    std::vector<std::uint32_t> first_;  // of each body, and one past the last
};

/// Whether the outlines of a body wind round `point`, with its particles where they are now
/// (nonzero rule; Sunday 2001, without divisions). What is exactly on an outline belongs to one of
/// its sides. False for what has no outline. Complexity: linear in the edges of the body.
bool encloses(const State& state, std::uint32_t body, const Point& point);

}  // namespace sulfur::detail
