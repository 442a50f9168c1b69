// Blows act from their moment within the step on: what was gone before is taken off the places.
#include <algorithm>
#include <vector>

#include "contacts/blows.hpp"
#include "contacts/stages.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

bool movesAlone(const State& state, std::uint32_t m) {
    const auto slot = state.core.movers.body[m];
    const BodyRecord& body = state.bodies[state.bodySlots.denseOf(slot)];
    if (hasLinks(state.core, slot)) return false;
    if (!state.core.moverIsCluster[m]) return body.particles.size() == 1;
    const Cluster& c = state.clusters.list[state.core.denseOfMover[m]];
    return c.last - c.first == body.particles.size();
}

void endBlows(State& state) {
    // Before the blow nobody answered it either; who stands fast answers all of it.
    for (Blow& blow : state.core.blows) {
        const auto i = state.core.denseOfMover[blow.mover];
        const bool turns = state.core.moverIsCluster[blow.mover] != 0;
        const Cluster* c = turns ? &state.clusters.list[i] : nullptr;
        const Vec2 now = turns ? c->displacement : state.particles.displacement[i];
        const Real angle = turns ? static_cast<Real>(c->angle) : 0;
        const auto left = [](Real given, Real kept) {
            return given == 0 ? Real(1) : std::clamp<Real>(kept / given, 0, 1);
        };
        blow.late.x *= left(blow.velocity[0], now[0] - blow.before.x);
        blow.late.y *= left(blow.velocity[1], now[1] - blow.before.y);
        blow.late.turn *= left(blow.spin, angle - blow.before.turn);
    }
    std::erase_if(state.core.blows,
                  [&](const Blow& blow) { return !movesAlone(state, blow.mover); });
    for (const Blow& blow : state.core.blows) {
        const auto i = state.core.denseOfMover[blow.mover];
        const Vec2 back(-blow.late.x, -blow.late.y);
        if (state.core.moverIsCluster[blow.mover]) {
            state.clusters.list[i].shift += back;
            state.clusters.list[i].twist -= static_cast<double>(blow.late.turn);
        } else {
            state.particles.position[i] += back.cast<double>();
        }
    }
}

}  // namespace sulfur::detail
