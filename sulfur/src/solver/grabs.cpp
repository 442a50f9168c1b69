// Grabs: damped springs of any stiffness from a weighted mean of particles to a target.
#include "solver/grabs.hpp"

#include <algorithm>
#include <cmath>

#include "core/limits.hpp"
#include "particles/motion.hpp"
#include "rigid/held_point.hpp"

namespace sulfur::detail {

namespace {

/// With C = sum of weight_i x_i - target and D its change in this tick, implicit Euler asks for
///   lambda = h^2 F = -(h^2 k C + h b D),
/// both axes at once; each pass goes the way there that the particles' own masses allow, as a
/// compliant constraint does (Macklin, Mueller, Chentanez: XPBD, 2016).
void solve(State& state, Grab& grab) {
    HeldPoint point;
    Point held(0, 0);
    for (std::uint32_t k = 0; k < grab.count; ++k) {
        const auto i = state.particleSlots.dense(grab.support[k]);
        held += static_cast<double>(grab.weight[k]) * (state.particles.position[i] - grab.target);
        point.add(gripOf(state, i), grab.weight[k]);
    }
    const Vec2 change = point.displacement(state), error = held.cast<Real>() + change;
    const Matrix2 mobility = point.mobility(state);
    const Real h = state.h, newtons = newtonsPerMultiplier(state);
    const Real spring = grab.stiffness / newtons, damper = grab.damping / (newtons * h);
    const Vec2 missing = spring * error + damper * change + grab.impulse;
    const Vec2 wanted =
        grab.impulse - solve2((spring + damper) * mobility + Matrix2::Identity(), missing);
    // No more than the strongest pull, nor than what takes the point to the fastest speed.
    Real most = grab.maxForce / newtons;
    const Real easiest = mobility.diagonal().maxCoeff();
    if (easiest > 0) most = std::min(most, h * static_cast<Real>(maxSpeed) / easiest);
    const Real size = wanted.stableNorm();
    const Vec2 impulse = size > most ? Vec2(most / size * wanted) : wanted;
    point.push(state, impulse - grab.impulse);
    grab.impulse = impulse;
}

}  // namespace

bool holds(const State& state, const Grab& grab) {
    for (std::uint32_t k = 0; k < grab.count; ++k)
        if (!state.particleSlots.contains(grab.support[k])) return false;
    return true;
}

void startGrabs(State& state) {
    auto& grabs = state.influences.grabs;
    auto& grabSlots = state.influences.grabSlots;
    if (grabs.empty()) return;
    for (const Grab& grab : grabs)
        if (!holds(state, grab)) grabSlots.erase(grab.id);
    std::erase_if(grabs, [&](const Grab& grab) { return !grabSlots.contains(grab.id); });
    for (std::uint32_t i = 0; i < grabs.size(); ++i) {
        grabSlots.move(grabs[i].id, i);
        grabs[i].impulse = Vec2(0, 0);
    }
}

void solveGrabs(State& state) {
    for (Grab& grab : state.influences.grabs) solve(state, grab);
}

}  // namespace sulfur::detail
