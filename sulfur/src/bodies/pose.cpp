#include "bodies/pose.hpp"

#include <cmath>

#include "core/trigonometry.hpp"
#include "rigid/disc_turns.hpp"
#include "rigid/find_clusters.hpp"

namespace sulfur::detail {

namespace {

/// The mass-weighted mean of `place(particle)`, in double; relative to the first one, so that
/// nothing is lost far from the origin, and what is in one place has no size.
template <class Place>
Point meanOf(const State& state, const BodyRecord& body, Place&& place) {
    const Point origin = place(body.firstParticle);
    Point sum(0, 0);
    double mass = 0;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const double m = static_cast<double>(state.particles.mass[i]);
        sum += m * (place(i) - origin);
        mass += m;
    }
    return origin + sum / mass;
}

/// The heading that its particles do not show.
Point storedHeading(const State& state, const BodyRecord& body, bool before) {
    const Point turn = before ? body.turnBefore : body.turn;
    const auto cluster = state.particles.cluster[body.firstParticle];
    if (body.particles.size() > 1 || cluster == none) return turn;
    const Cluster& c = state.clusters.list[cluster];
    return isDisc(c) ? turned(turn, before ? c.headingBefore : c.heading) : turn;
}

template <class Place>
Frame fit(const State& state, const BodyRecord& body, bool before, Place&& place) {
    // Sums that are smaller, relative to what they are of, are roundings.
    constexpr double vanishing = 1e-9;
    Frame frame{meanOf(state, body, place), restCentreOf(state, body), {1, 0}};
    double along = 0, across = 0, sizeAtRest = 0, size = 0;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const double m = static_cast<double>(state.particles.mass[i]);
        const Point q = state.particles.rest[i].cast<double>() - frame.restCentre;
        const Point x = place(i) - frame.centre;
        along += m * q.dot(x);
        across += m * cross(q, x);
        sizeAtRest += m * q.squaredNorm();
        size += m * x.squaredNorm();
    }
    const double length = std::sqrt(along * along + across * across);
    frame.heading = length > vanishing * std::sqrt(sizeAtRest * size)
                        ? Point(along / length, across / length)
                        : storedHeading(state, body, before);
    return frame;
}

}  // namespace

Point restCentreOf(const State& state, const BodyRecord& body) {
    return meanOf(state, body,
                  [&](std::uint32_t i) -> Point { return state.particles.rest[i].cast<double>(); });
}

Point meanVelocityOf(const State& state, const BodyRecord& body) {
    return meanOf(state, body,
                  [&](std::uint32_t i) -> Point { return state.particles.velocity[i]; });
}

Frame frameOf(const State& state, const BodyRecord& body) {
    return fit(state, body, false,
               [&](std::uint32_t i) -> Point { return state.particles.position[i]; });
}

Frame frameBefore(const State& state, const BodyRecord& body) {
    const Particles& p = state.particles;
    return fit(state, body, true, [&](std::uint32_t i) -> Point {
        return p.position[i] - p.displacement[i].cast<double>();
    });
}

Pose poseOf(const Frame& frame) {
    return {frame.centre - turned(frame.heading, frame.restCentre), angleOf(frame.heading)};
}

double inertiaOfDisc(const State& state, std::uint32_t particle) {
    return discInertia(static_cast<double>(state.particles.mass[particle]),
                       static_cast<double>(state.particles.radius[particle]));
}

RigidMotion rigidMotionOf(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    const Particles& p = state.particles;
    RigidMotion whole;
    whole.discs = discsOf(state, index);
    whole.centre = meanOf(state, body, [&](std::uint32_t i) -> Point { return p.position[i]; });
    whole.velocity = meanVelocityOf(state, body);
    double angular = 0;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const double m = static_cast<double>(p.mass[i]);
        const Point arm = p.position[i] - whole.centre;
        whole.mass += m;
        whole.inertia += m * arm.squaredNorm();
        angular += m * cross(arm, Point(p.velocity[i] - whole.velocity));
    }
    for (const auto i : whole.discs) {
        whole.inertia += inertiaOfDisc(state, i);
        angular += inertiaOfDisc(state, i) * spinOf(state, i);
    }
    whole.spin = body.spin != 0 ? body.spin : whole.inertia > 0 ? angular / whole.inertia : 0;
    return whole;
}

}  // namespace sulfur::detail
