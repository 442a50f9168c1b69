#include "solver/paces.hpp"

#include <algorithm>
#include <utility>

#include "core/limits.hpp"
#include "rigid/cluster_motion.hpp"
#include "solver/substeps.hpp"

namespace sulfur::detail {

namespace {

void stopClusters(State& state, std::uint32_t body) {
    auto& list = state.clusters.list;
    auto at = std::lower_bound(list.begin(), list.end(), body,
                               [](const Cluster& c, std::uint32_t b) { return c.body < b; });
    for (; at != list.end() && at->body == body; ++at) {
        at->displacement = at->predicted = Vec2(0, 0);
        at->angle = at->predictedAngle = 0;
        at->sine = at->versine = 0;
    }
}

/// How far it is from where the broad phase has drawn it; it goes no farther.
void measureOuting(State& state, const BodyRecord& body, std::uint32_t b) {
    BroadPhase& broad = state.broad;
    auto& [ofParticle, ofBody] = broad.outings;
    const std::size_t last = body.firstParticle + body.particles.size();
    // What has never been drawn is drawn before anybody asks.
    if (broad.reference.size() < last || ofParticle.size() < last || ofBody.size() <= b) return;
    ofBody[b] = 0;
    for (std::size_t i = body.firstParticle; i < last; ++i) {
        ofParticle[i] = (state.particles.position[i] - broad.reference[i]).cast<Real>().norm();
        ofBody[b] = std::max(ofBody[b], ofParticle[i]);
    }
}

/// Nothing moves it, and it bears what runs into it.
void standBy(State& state, std::uint32_t b) {
    BodyRecord& body = state.bodies[b];
    body.standsBy = true;
    restoreInverseMass(state, b);
    stopClusters(state, b);
    const auto first = state.particles.displacement.begin() + body.firstParticle;
    const auto last = first + static_cast<std::ptrdiff_t>(body.particles.size());
    auto& stored = state.steps.displacements;
    state.steps.standing.push_back({body.id, static_cast<std::uint32_t>(stored.size())});
    stored.insert(stored.end(), first, last);
    std::fill(first, last, Vec2(0, 0));
    measureOuting(state, body, b);
}

void takePart(State& state, std::uint32_t b) {
    state.bodies[b].standsBy = false;
    restoreInverseMass(state, b);
}

/// Those with which it stood by, for whoever asks between ticks.
void restoreDisplacements(State& state) {
    const Steps& steps = state.steps;
    for (const Standing& standing : steps.standing) {
        if (!state.bodySlots.contains(standing.body)) continue;
        const BodyRecord& body = state.bodies[state.bodySlots.dense(standing.body)];
        if (!body.standsBy) continue;
        std::copy_n(steps.displacements.begin() + standing.first, body.particles.size(),
                    state.particles.displacement.begin() + body.firstParticle);
    }
}

void swapLists(State& state) {
    std::swap(state.work, state.steps.parkedWork);
    std::swap(state.triangles.awake, state.steps.parkedTriangles.awake);
    std::swap(state.triangles.pressed, state.steps.parkedTriangles.pressed);
}

/// The lists for the present steps, to be made again if they are not those of its movers.
void takeLists(State& state) {
    Steps& steps = state.steps;
    const ListedMovers wanted = wantedMovers(state);
    if (state.work.stale && state.work.madeAfter == state.listChanges) ++state.listChanges;
    if (steps.mixed && state.work.movers != wanted) swapLists(state);
    if (state.work.movers != wanted) state.work.madeAfter = 0;  // those of others
    state.work.stale = state.work.madeAfter != state.listChanges;
}

}  // namespace

ListedMovers wantedMovers(const State& state) {
    if (!state.steps.mixed) return ListedMovers::all;
    return state.steps.pace == Pace::whole ? ListedMovers::whole : ListedMovers::divided;
}

void enterPace(State& state, Pace pace) {
    Steps& steps = state.steps;
    steps.pace = pace;
    steps.count = stepsPerTick(state, pace);
    steps.done = 0;
    state.h = stepDuration(state, pace);
    if (steps.mixed) {
        // What follows from who takes part was found for the others.
        state.idle = state.touchingFrozen = false;
        steps.standing.clear();
        steps.displacements.clear();
        for (std::uint32_t b = 0; b < state.bodies.size(); ++b) {
            const BodyRecord& body = state.bodies[b];
            const bool standsBy = state.awake(b) && body.divided != (pace == Pace::divided);
            if (standsBy != body.standsBy) (standsBy ? standBy : takePart)(state, b);
        }
        noteStill(state);
    }
    takeLists(state);
}

void leavePaces(State& state) {
    Steps& steps = state.steps;
    if (steps.mixed) {
        state.idle = state.touchingFrozen = false;
        restoreDisplacements(state);
        for (std::uint32_t b = 0; b < state.bodies.size(); ++b)
            if (state.bodies[b].standsBy) takePart(state, b);
    }
    steps.still.clear();
    steps.mixed = false;
    steps.pace = Pace::whole;
    steps.count = steps.done = 1;
    state.h = stepDuration(state, Pace::whole);
}

void joinPace(State& state, std::uint32_t body) {
    setDivided(state, body, state.steps.pace == Pace::divided);
}

void noteStill(State& state) {
    if (!state.steps.mixed) return;
    auto& still = state.steps.still;
    still.resize(state.bodies.size());
    for (std::uint32_t b = 0; b < still.size(); ++b) still[b] = state.movable(b) ? 0 : 1;
}

void keepAppliedForces(State& state) {
    auto& applied = state.steps.applied;
    applied.clear();
    const Particles& p = state.particles;
    for (const BodyRecord& body : state.bodies) {
        if (!body.divided || body.asleep) continue;
        for (std::uint32_t k = 0; k < body.particles.size(); ++k)
            if (const Point& force = p.force[body.firstParticle + k]; force != Point(0, 0))
                applied.push_back({body.particles[k], force});
    }
}

void applyForcesAgain(State& state) {
    for (const AppliedForce& applied : state.steps.applied)
        if (state.particleSlots.contains(applied.particle))
            state.particles.force[state.particleSlots.dense(applied.particle)] += applied.force;
}

namespace {

void start(State& state, std::uint32_t i, double late) {
    Particles& p = state.particles;
    const double w = static_cast<double>(p.inverseMass[i]);
    if (w == 0) return;
    const double air = static_cast<double>(state.settings.airFriction);
    const Point gravity = state.settings.gravity.cast<double>();
    p.velocity[i] =
        limited(p.velocity[i] + late * (gravity + w * p.force[i] - air * p.velocity[i]));
}

void start(State& state, Cluster& c, double late) {
    const double air = static_cast<double>(state.settings.airFriction);
    const ClusterLoad load = loadOf(state, c);
    c.velocity = limited(c.velocity + late * (load.acceleration - air * c.velocity));
    c.spin += late * (load.turning - air * c.spin);
}

}  // namespace

void startLateParticles(State& state) {
    std::erase_if(state.steps.late, [&](const LateParticle& late) {
        if (!state.particleSlots.contains(late.particle)) return true;
        const auto i = state.particleSlots.dense(late.particle);
        if (!state.movable(state.particles.body[i])) return false;
        const auto cluster = state.particles.cluster[i];
        if (cluster == none) {
            start(state, i, late.late);
        } else if (Cluster& c = state.clusters.list[cluster];
                   state.clusters.members[c.first] == i) {
            start(state, c, late.late);
        }
        return true;
    });
}

}  // namespace sulfur::detail
