// The particles of a world as a structure of arrays.
#pragma once

#include <cstdint>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

/// Particle i is entry i of every array. The particles of a body are neighbours, bodies stand in
/// the order in which they were made.
///
/// The displacement of a tick and the velocity are numbers of their own and never recovered by
/// subtracting positions: that would lose them to rounding far from the origin. Velocities and
/// the sums of forces are double, so that a million ticks of forces that cancel leave no momentum.
/// (After a tick of several steps the displacement is a difference of positions: only drawing asks
/// for it then.)
struct Particles {
    // Hot: touched by every tick.
    std::vector<Point> position;         // m, at the start of the tick until the tick's end
    std::vector<Vec2> displacement;      // m, of this step (between ticks: of the last tick)
    std::vector<Point> velocity;         // m/s, mean over the last step
    std::vector<Point> force;            // N, gathered for the next prediction
    std::vector<Real> inverseMass;       // 1/kg, 0 for what physics does not move
    std::vector<std::uint32_t> cluster;  // rigid component that moves it, or none
    std::vector<Vec2> arm;               // m, from that component's centre
    std::vector<Vec2> shift;             // m, correction of this tick that becomes no velocity
    // Warm: collision.
    std::vector<Real> reach;          // m, own radius or that of the thickest capsule ending here
    std::vector<std::uint32_t> body;  // dense index
    // Cold.
    std::vector<Real> mass;    // kg
    std::vector<Real> radius;  // m, > 0: a disc
    std::vector<Vec2> rest;    // m, place in the blueprint's frame
    std::vector<std::uint8_t> pinned;
    std::vector<ParticleId> id;

    std::size_t size() const { return position.size(); }

    template <class Function>
    void forEachArray(Function&& f) {
        f(position);
        f(displacement);
        f(velocity);
        f(force);
        f(inverseMass);
        f(cluster);
        f(arm);
        f(shift);
        f(reach);
        f(body);
        f(mass);
        f(radius);
        f(rest);
        f(pinned);
        f(id);
    }

    template <class Archive>
    void archive(Archive& a) {
        forEachArray(a);
    }
};

}  // namespace sulfur::detail
