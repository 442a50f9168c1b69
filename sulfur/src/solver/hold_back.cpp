#include "solver/hold_back.hpp"

#include <algorithm>
#include <vector>

#include "collision/entwined.hpp"
#include "collision/meeting.hpp"
#include "collision/pairs.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

/// Things that stop change what others run into.
constexpr int rounds = 5;
/// This much of the thickness may be pressed in on the way.
constexpr Real pressed = Real(0.5);

/// Where the particles go in this tick, as the constraints left it, and how far that is from where
/// they were rasterised.
struct Ways {
    std::vector<Vec2> displacements;  // m
    Outings outings;

    void find(const State& state) {
        displacements = state.particles.displacement;
        for (const auto i : state.work.awakeClusters) {
            const Cluster& c = state.clusters.list[i];
            for (auto k = c.first; k < c.last; ++k) {
                const auto m = state.clusters.members[k];
                displacements[m] = displacementOf(state, gripOf(state, m));
            }
        }
        measureOutings(state, displacements, outings);
    }
};

/// The share of the tick after which they meet, 1 if they do not, or did before it began.
Real meetingTime(const State& state, const Ways& ways, const Watch& watch) {
    const auto particle = watch.candidate.particle;
    const Collider& c = state.broad.collider(watch.candidate.collider);
    const auto& x = state.particles.position;
    Local l;
    l.dp = ways.displacements[particle];
    l.da = ways.displacements[c.a];
    l.db = ways.displacements[c.b];
    const Real thickness = state.particles.reach[particle] + c.radius;
    const Real travel = std::max((l.dp - l.da).lpNorm<1>(), (l.dp - l.db).lpNorm<1>());
    if (travel < pressed * thickness) return 1;
    l.p = (x[particle] - x[c.a]).cast<Real>();
    l.b = (x[c.b] - x[c.a]).cast<Real>();
    if (meet(l).distance <= pressed * thickness) return 1;
    const Meeting m = meetOnTheWay(l, pressed * thickness);
    return m.fraction > 0 ? m.fraction : 1;
}

/// Whether anything moves so fast that it could pass a surface within the tick.
bool anyFast(const State& state) {
    for (const Range range : state.work.awake)
        for (auto i = range.first; i < range.last; ++i) {
            const Real reach = state.particles.reach[i];
            if (reach > 0 && state.particles.displacement[i].lpNorm<1>() > pressed * reach)
                return true;
        }
    return false;
}

/// What holding back took of the displacement of a particle that keeps its velocity.
struct LostWay {
    std::uint32_t particle = 0;
    Vec2 displacement{0, 0};  // m
};

/// Of the present tick, until keepVelocities().
std::vector<LostWay>& lostWays() {
    thread_local std::vector<LostWay> ways;
    return ways;
}

class Brakes {
public:
    explicit Brakes(State& state) : state_(state), held_(scratch()) {
        held_.assign(state.bodies.size(), {});
    }

    /// Two bodies that meet after a share of the tick.
    void stopAt(std::uint32_t a, std::uint32_t b, Real share) {
        const bool rigid = !isSoft(a) && !isSoft(b);
        for (const auto body : {a, b}) {
            if (state_.bodies[body].kind != BodyKind::dynamic) continue;
            held_[body].share = std::min(held_[body].share, share);
            held_[body].keepsVelocity &= rigid;
        }
    }

    /// Returns whether any body was held back.
    bool apply() {
        bool any = false;
        for (std::uint32_t i = 0; i < held_.size(); ++i) {
            if (held_[i].share >= 1) continue;
            any = true;
            const BodyRecord& body = state_.bodies[i];
            for (std::uint32_t k = 0; k < body.particles.size(); ++k)
                hold(body.firstParticle + k, held_[i]);
        }
        if (!any) return false;
        for (const auto c : state_.work.awakeClusters) {
            Cluster& cluster = state_.clusters.list[c];
            if (held_[cluster.body].share < 1) hold(cluster, held_[cluster.body]);
        }
        std::fill(held_.begin(), held_.end(), Held{});
        return true;
    }

private:
    /// What is held back keeps its velocity, and with it the momentum that it shares in the next
    /// tick with what it runs into; but not where something soft would go on to be run through.
    struct Held {
        Real share = 1;
        bool keepsVelocity = true;
    };

    bool isSoft(std::uint32_t body) const {
        const BodyRecord& b = state_.bodies[body];
        return b.particles.size() > 1 && state_.particles.cluster[b.firstParticle] == none &&
               state_.trees.ofParticle[b.firstParticle] == none;
    }

    /// Whether its velocity will be that of its displacement, as that of a chain that nothing
    /// touches is not.
    bool followsDisplacement(std::uint32_t particle) const {
        const auto tree = state_.trees.ofParticle[particle];
        return tree == none || !state_.trees.list[tree].alone || state_.trees.touched[tree] != 0;
    }

    void hold(std::uint32_t particle, const Held& held) {
        Particles& p = state_.particles;
        if (p.cluster[particle] != none || p.inverseMass[particle] == 0) return;
        Vec2& displacement = p.displacement[particle];
        if (held.keepsVelocity && followsDisplacement(particle))
            lostWays().push_back({particle, (1 - held.share) * displacement});
        displacement *= held.share;
    }

    void hold(Cluster& c, const Held& held) {
        if (held.keepsVelocity) {
            const double lost = static_cast<double>((1 - held.share) / state_.h);
            c.velocity += lost * c.displacement.cast<double>();
            c.spin += lost * c.angle;
        }
        c.displacement *= held.share;
        c.angle *= static_cast<double>(held.share);
        updateTurn(c);
    }

    static std::vector<Held>& scratch() {
        thread_local std::vector<Held> held;
        return held;
    }

    State& state_;
    std::vector<Held>& held_;  // by body
};

}  // namespace

void holdBack(State& state) {
    lostWays().clear();
    if (state.broad.watches.empty() || !anyFast(state)) return;
    thread_local Ways ways;
    Brakes brakes(state);
    for (int round = 0; round < rounds; ++round) {
        state.statistics.heldBack += static_cast<std::uint32_t>(state.broad.watches.size());
        ways.find(state);
        forEachNear(state.broad, ways.outings, [&](const Watch& watch) {
            const Real share = meetingTime(state, ways, watch);
            if (share >= 1) return;
            const auto body = state.particles.body[watch.candidate.particle];
            const auto other = state.broad.collider(watch.candidate.collider).body;
            if (areEntwined(state, body, other)) return;
            // Whoever still moves in the last round stays where it is.
            brakes.stopAt(body, other, round + 1 < rounds ? share : 0);
        });
        if (!brakes.apply()) return;
    }
}

void keepVelocities(State& state) {
    for (const LostWay& way : lostWays())
        state.particles.velocity[way.particle] += (way.displacement / state.h).cast<double>();
    lostWays().clear();
}

}  // namespace sulfur::detail
