#include "collision/materials.hpp"

#include <algorithm>
#include <cmath>

namespace sulfur::detail {

namespace {

/// The geometric mean, exact for equal ones.
Real mean(Real a, Real b) {
    return a == b ? a : std::sqrt(a * b);
}

}  // namespace

const Material& surfaceOf(const State& state, std::uint32_t joint, std::uint32_t body) {
    if (joint != none && state.joints.ownMaterial[joint]) return state.joints.material[joint];
    return state.bodies[body].material;
}

void giveSurface(const State& state, ContactPlan& c) {
    const Material& a = surfaceOf(state, state.broad.surface[c.particle], c.bodyA);
    const Material& b = surfaceOf(state, c.joint, c.bodyB);
    c.staticFriction = mean(a.staticFriction, b.staticFriction);
    c.kineticFriction = mean(a.kineticFriction, b.kineticFriction);
    c.restitution = std::max(a.restitution, b.restitution);
    c.rough = c.staticFriction > 0 && state.settings.friction == Friction::coulomb;
    c.surfaceSpeed = a.surfaceSpeed + b.surfaceSpeed;
}

}  // namespace sulfur::detail
