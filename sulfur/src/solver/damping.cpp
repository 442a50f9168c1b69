// Stage: damping of single bodies, as wholes.
#include <algorithm>

#include "core/trigonometry.hpp"
#include "rigid/disc_turns.hpp"
#include "solver/fields.hpp"

namespace sulfur::detail {

namespace {

/// How a body moves as a whole, and how the forces so far accelerate it.
struct Whole {
    Point centre{0, 0};                // m
    Point velocity{0, 0}, push{0, 0};  // m/s and m/s^2, of the centre
    double spin = 0, turning = 0;      // rad/s and rad/s^2, about it; 0 where nothing can turn
};

/// Calls f(particle, its mass in kg) for all of a body.
template <class Function>
void forEachMass(const State& state, const BodyRecord& body, Function&& f) {
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        f(i, static_cast<double>(state.particles.mass[i]));
    }
}

/// Calls f(cluster) for the discs of a body that turn by themselves.
template <class Function>
void forEachDisc(State& state, const BodyRecord& body, Function&& f) {
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto cluster = state.particles.cluster[body.firstParticle + k];
        if (cluster == none) continue;
        Cluster& c = state.clusters.list[cluster];
        if (isDisc(c) && canTurn(c)) f(c);
    }
}

/// What its pins will bear nobody knows yet, nor so how forces accelerate a body that has some.
bool isPinned(const State& state, const BodyRecord& body) {
    const auto first = state.particles.pinned.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](std::uint8_t pinned) { return pinned != 0; });
}

/// Without turning. Places count from the first particle, so that nothing is lost far from the
/// origin.
Whole straightMotionOf(const State& state, const BodyRecord& body) {
    const Particles& p = state.particles;
    const Point origin = p.position[body.firstParticle];
    Point place(0, 0), momentum(0, 0), force(0, 0);
    double mass = 0;
    forEachMass(state, body, [&](std::uint32_t i, double m) {
        mass += m;
        place += m * (p.position[i] - origin);
        momentum += m * p.velocity[i];
        force += p.force[i];
    });
    return {origin + place / mass, momentum / mass,
            state.settings.gravity.cast<double>() + force / mass};
}

Whole wholeOf(State& state, const BodyRecord& body) {
    const Particles& p = state.particles;
    Whole whole = straightMotionOf(state, body);
    double inertia = 0, angular = 0, torque = 0;
    forEachMass(state, body, [&](std::uint32_t i, double m) {
        const Point arm = p.position[i] - whole.centre;
        inertia += m * arm.squaredNorm();
        angular += m * cross(arm, Point(p.velocity[i] - whole.velocity));
        torque += cross(arm, p.force[i]);
    });
    forEachDisc(state, body, [&](const Cluster& c) {
        inertia += 1 / c.freeInverseInertia;
        angular += c.spin / c.freeInverseInertia;
        torque += torqueOn(state, c);
    });
    if (inertia > 0) {
        whole.spin = angular / inertia;
        whole.turning = torque / inertia;
    }
    if (isPinned(state, body)) {
        whole.push = Point(0, 0);
        whole.turning = 0;
    }
    return whole;
}

/// Damping is air friction that acts on the motion of a body as a whole, by the same trapezoidal
/// rule: with a for all other accelerations, k for the kick's duration and c for both together,
/// v' - v = k a - k c (v + v') / 2. Solved for v' it is an acceleration of what is known before.
/// It turns no motion around, not even where the rate has changed and a kick is longer than a tick.
void damp(State& state, const BodyRecord& body) {
    const double h = static_cast<double>(state.h), kick = (state.lastStep + h) / 2;
    const double air = static_cast<double>(state.settings.airFriction);
    const auto share = [&](Real damping) {
        const double c = std::clamp(2 / kick - air, 0.0, static_cast<double>(damping));
        return -c / (1 + kick * (air + c) / 2);
    };
    const Whole whole = wholeOf(state, body);
    const Point straight = share(body.linearDamping) * (whole.velocity + kick / 2 * whole.push);
    const double turning = share(body.angularDamping) * (whole.spin + kick / 2 * whole.turning);
    Particles& p = state.particles;
    forEachMass(state, body, [&](std::uint32_t i, double m) {
        if (p.inverseMass[i] == 0) return;
        const Point arm = p.position[i] - whole.centre;
        p.force[i] += m * (straight + turning * perpendicular(arm));
    });
    forEachDisc(state, body, [&](Cluster& c) { c.spin += kick * turning; });
}

}  // namespace

void dampBodies(State& state) {
    for (const auto index : state.work.bodies) {
        const BodyRecord& body = state.bodies[index];
        if (body.kind != BodyKind::dynamic || !isDamped(body)) continue;
        state.anyForced = true;
        state.looked(Stage::fields, body.particles.size());
        damp(state, body);
    }
}

}  // namespace sulfur::detail
