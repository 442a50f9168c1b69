// Rails: a slider's point goes along a run of links, straight ones and arcs. It is on one of them
// at a time, which is chosen when a step begins.
#pragma once

#include <limits>
#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Where the point of a slider is on its link.
struct OnRail {
    Point share{0, 0};      // from end to end, as a complex number: the begin is 0, the end 1
    Point perLength{0, 0};  // 1/m, along the chord: away from the line `off` grows with its length
    /// How place and distance change with the point; the second is a unit vector. Zero where the
    /// ends of the link, or the point and the centre of the arc, meet.
    Point along{0, 0}, across{0, 0};
    double place = 0;   // m, along the link at rest
    double off = 0;     // m, to the left of the line
    double length = 0;  // m, of the link at rest

    /// Which way the line goes there, unit.
    Point tangent() const { return {across[1], -across[0]}; }
};
OnRail onRail(const State& state, const Mechanism& slider, bool moved);

/// m or rad, between which a drive leaves its coordinate.
struct DriveLimits {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};
/// Those of its drive, on a rail within its free ends. An end that is farther than `reach` from the
/// value `now` may count as none.
DriveLimits limitsOf(const State& state, const Mechanism& mechanism, double now, double reach);

/// The links that are left on both sides of the one that a slider is on, in order.
struct RailRun {
    std::vector<JointId> links;
    double begin = 0;  // m, of its coordinate, where the first one begins
};
RailRun runOf(const State& state, const Mechanism& slider);

/// m, along a link at rest.
double lengthOfLink(const State& state, std::uint32_t joint);
/// Puts a slider on a link of its rail; `from` is the particle where that begins.
void putOnLink(const State& state, Mechanism& slider, std::uint32_t link, ParticleId from);

/// When a step begins: where it has passed an end of its link, a slider goes on to the neighbour.
void followRail(State& state, Mechanism& slider);

}  // namespace sulfur::detail
