// The coordinate of a mechanism: its value, and how that changes with what moves.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "model/state.hpp"

namespace sulfur::detail {

/// Which of the rows of a mechanism: what its drive acts on, a slider's distance from its line, and
/// its angle.
enum class RowOf : std::uint32_t { drive, across, angle };

/// Whether what a mechanism holds is still there; of a gear both of its parts.
bool holds(const State& state, const Mechanism& mechanism);

/// Of the present places; with `moved` after the displacements of this step, so far. Rad or m;
/// angles are the ones nearest to those of the last step.
double valueOf(const State& state, const Mechanism& mechanism, RowOf row, bool moved);
/// The same of what moves, quickly, in the sweeps.
inline double valueNow(const State& state, const MechanismRow& row) {
    const Mechanism& m = state.mechanisms.list[row.mechanism];
    if (row.turning[0] == none) return valueOf(state, m, RowOf(row.number), true);
    const auto angle = [&](std::size_t k) {
        return m.arms[k].angle + state.clusters.list[row.turning[k]].angle;
    };
    return angle(1) - angle(0) - m.zero;
}
/// Of a hinge or weld: the rigid components whose angles its arms show, or none.
std::array<std::uint32_t, 2> turningOf(const State& state, const Mechanism& mechanism, RowOf row);
/// Of the present places. Empty where a coordinate has none, as two points at one place have no
/// direction.
CoordinateSlopes slopesOf(const State& state, const Mechanism& mechanism, RowOf row);
/// How the way of a slider's point along a direction (unit) changes against its link, which has a
/// rail.
CoordinateSlopes slopesFromLink(const State& state, const Mechanism& slider,
                                const Point& direction);
/// rad/s or m/s, of the drive's, with the velocities that there are.
double speedOf(const State& state, const Mechanism& mechanism);
double speedOf(const State& state, std::span<const TurnedMover> slopes);
/// 1/kg or 1/(kg m^2): how fast a coordinate changes after a unit of impulse, if nothing else holds
/// what moves.
double freeMobility(std::span<const TurnedMover> slopes);
/// Changes velocities by an impulse (N s or N m s) along a coordinate.
void strike(State& state, std::span<const TurnedMover> slopes, double impulse);
/// rad, of a body as its arm shows it, with whole turns. `moved` after startMechanisms() only.
double angleOf(const State& state, const MechanismArm& arm, bool moved);
/// rad, by how much the second arm is turned more than the first. Within a body, which a call may
/// turn as a whole, it is the one nearest to that of the last step.
double angleApart(const State& state, const Mechanism& mechanism, bool moved);
/// Where a point of a body is.
Point placeOf(const State& state, const MechanismPoint& point, bool moved);

}  // namespace sulfur::detail
