#include "solver/hold_back.hpp"

#include <algorithm>
#include <vector>

#include "collision/entwined.hpp"
#include "collision/meeting.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

/// Things that stop change what others run into.
constexpr int rounds = 5;
/// This much of the thickness may be pressed in on the way.
constexpr Real pressed = Real(0.5);

Vec2 displacementOf(const State& state, std::uint32_t particle) {
    return displacementOf(state, gripOf(state, particle));
}

/// The share of the tick after which they meet, 1 if they do not, or did before it began.
Real meetingTime(const State& state, const Candidate& candidate) {
    const Collider& c = state.broad.collider(candidate.collider);
    const auto& x = state.particles.position;
    Local l;
    l.dp = displacementOf(state, candidate.particle);
    l.da = displacementOf(state, c.a);
    l.db = c.a == c.b ? l.da : displacementOf(state, c.b);
    const Real thickness = state.particles.reach[candidate.particle] + c.radius;
    const Real travel = std::max((l.dp - l.da).lpNorm<1>(), (l.dp - l.db).lpNorm<1>());
    if (travel < pressed * thickness) return 1;
    l.p = (x[candidate.particle] - x[c.a]).cast<Real>();
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

class Brakes {
public:
    explicit Brakes(State& state) : state_(state), share_(scratch()) {
        share_.assign(state.bodies.size(), 1);
    }

    void stopAt(std::uint32_t body, Real share) {
        if (state_.bodies[body].kind == BodyKind::dynamic)
            share_[body] = std::min(share_[body], share);
    }

    /// Returns whether any body was held back.
    bool apply() {
        bool any = false;
        for (std::uint32_t i = 0; i < share_.size(); ++i) {
            if (share_[i] >= 1) continue;
            any = true;
            const BodyRecord& body = state_.bodies[i];
            for (std::uint32_t k = 0; k < body.particles.size(); ++k)
                state_.particles.displacement[body.firstParticle + k] *= share_[i];
        }
        if (!any) return false;
        for (const auto c : state_.work.awakeClusters) {
            Cluster& cluster = state_.clusters.list[c];
            const Real share = share_[cluster.body];
            if (share >= 1) continue;
            cluster.displacement *= share;
            cluster.angle *= static_cast<double>(share);
            updateTurn(cluster);
        }
        std::fill(share_.begin(), share_.end(), Real(1));
        return true;
    }

private:
    static std::vector<Real>& scratch() {
        thread_local std::vector<Real> share;
        return share;
    }

    State& state_;
    std::vector<Real>& share_;  // by body
};

}  // namespace

void holdBack(State& state) {
    if (state.broad.candidates.empty() || !anyFast(state)) return;
    Brakes brakes(state);
    for (int round = 0; round < rounds; ++round) {
        for (const Candidate& candidate : state.broad.candidates) {
            if (areEntwined(state, state.particles.body[candidate.particle],
                            state.broad.collider(candidate.collider).body))
                continue;
            const Real share = meetingTime(state, candidate);
            if (share >= 1) continue;
            // Whoever still moves in the last round stays where it is.
            const Real kept = round + 1 < rounds ? share : 0;
            brakes.stopAt(state.particles.body[candidate.particle], kept);
            brakes.stopAt(state.broad.collider(candidate.collider).body, kept);
        }
        if (!brakes.apply()) return;
    }
}

}  // namespace sulfur::detail
