#include "narrow_phase/never_touches.hpp"

#include <algorithm>
#include <utility>

#include "core/settings.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

std::uint32_t denseParticle(const State& state, std::uint32_t corner) {
    return state.particleSlots.denseOf(state.core.shapes.corners[corner].particle);
}
bool isTied(const State& state, std::uint32_t corner, std::uint32_t body) {
    const auto& linked = state.core.linked;
    return !linked.empty() &&
           std::binary_search(linked.begin(), linked.end(),
                              std::pair(state.core.shapes.corners[corner].particle, body));
}
}  // namespace

bool neverTouches(const State& state, std::uint32_t corner, std::uint32_t sideA,
                  std::uint32_t sideB, std::uint32_t body, Real radius) {
    const auto& corners = state.core.shapes.corners;
    const Corner &p = corners[corner], &a = corners[sideA], &b = corners[sideB];
    if (p.particle == a.particle || p.particle == b.particle) return true;
    if (p.mover == a.mover || p.mover == b.mover) return true;
    const auto i = denseParticle(state, corner);
    if (isTied(state, corner, body)) return true;
    const auto own = state.bodies[state.particles.body[i]].id.index - 1;
    if (isTied(state, sideA, own) && isTied(state, sideB, own)) return true;
    if (own != body) return false;
    const auto& rest = state.particles.rest;
    const Vec2 from = rest[denseParticle(state, sideA)], to = rest[denseParticle(state, sideB)];
    const Vec2 along = to - from, v = rest[i] - from;
    const Real length2 = along.squaredNorm();
    const Real t = length2 > 0 ? std::clamp(v.dot(along) / length2, Real(0), Real(1)) : Real(0);
    return (v - t * along).norm() < Real(tuned::togetherWithin) * (p.radius + radius);
}

}  // namespace sulfur::detail
