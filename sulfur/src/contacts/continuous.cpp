// What is fast never passes through anything: where rows that were found at the start of a step and
// swept a few times have not stopped two surfaces, both bodies stay where these come to touch. Only
// places are held back, of a body as a whole, so that no joint of it is strained; what is left of
// the velocity is for the next step's rows.
//
// The ways of a step are taken as straight. Whoever is held back may get in the way of others, so
// that this is repeated until nobody is.
#include <algorithm>
#include <cmath>

#include "contacts/contact_core.hpp"
#include "contacts/stages.hpp"
#include "narrow_phase/time_of_impact.hpp"
#include "rigid/clusters.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// What comes nearer in a step by more than this share of the thickness is fast. It may overlap by
/// as much.
constexpr Real fast = Real(0.125);
constexpr int mostRounds = 8;

class Keeper {
public:
    explicit Keeper(State& state) : state_(state), core_(state.core), movers_(core_.movers) {}

    void run() {
        takeWays();
        measure();
        collect([](const Pair&) { return true; });
        if (pairs_.empty()) return;
        whole_ = core_.ways;
        shares_.assign(state_.bodies.size(), 1);
        for (int round = 0; round < mostRounds && !pairs_.empty(); ++round) {
            state_.statistics.fastPairs += static_cast<std::uint32_t>(pairs_.size());
            held_.assign(state_.bodies.size(), 0);
            for (const auto pair : pairs_) hold(core_.pairs[pair]);
            // Who was held back may be in the way of whoever went along with him.
            collect([&](const Pair& pair) { return wasHeld(pair.a) || wasHeld(pair.b); });
        }
        giveBack();
    }

private:
    /// How each mover goes in this step, blows and all.
    void takeWays() {
        core_.ways.assign(movers_.size(), {});
        for (std::size_t k = 0; k < core_.awakeMovers.size(); ++k) {
            const auto i = core_.awakeDense[k];
            Motion3& way = core_.ways[core_.awakeMovers[k]];
            if (core_.awakeIsCluster[k] != 0) {
                const Cluster& c = state_.clusters.list[i];
                way = {c.displacement[0], c.displacement[1], static_cast<Real>(c.angle)};
            } else {
                const Vec2& d = state_.particles.displacement[i];
                way = {d[0], d[1], 0};
            }
        }
        for (const Blow& blow : core_.blows) {
            Motion3& way = core_.ways[blow.mover];
            way.x -= blow.when * blow.velocity[0];
            way.y -= blow.when * blow.velocity[1];
            way.turn -= blow.when * blow.spin;
        }
    }

    /// How far each mover, and each chunk of several, goes at most.
    void measure() {
        lengths_.assign(movers_.size(), 0);
        for (const auto m : core_.awakeMovers) lengths_[m] = lengthOf(m, {});
        for (const auto c : core_.awakeStrips) {
            const Chunk& chunk = core_.shapes.chunks[c];
            lengths_[chunk.frame] = lengthOf(chunk, {});
        }
    }
    Real lengthOf(std::uint32_t m, const Motion3& frame) const {
        const Motion3& way = core_.ways[m];
        return std::abs(way.x - frame.x) + std::abs(way.y - frame.y) +
               movers_.reach[m] * std::abs(way.turn);
    }

    /// How far a chunk goes at most, seen from what goes along with `frame`.
    Real lengthOf(const Chunk& chunk, const Motion3& frame) const {
        Real most = 0;
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            most = std::max(most, lengthOf(core_.shapes.uses[u].mover, frame));
        return most;
    }

    bool wasHeld(std::uint32_t chunk) const {
        return held_[state_.bodySlots.denseOf(core_.shapes.chunks[chunk].body)] != 0;
    }

    /// Pairs that are fast and may have come near: rows they have, or the next look is due; of
    /// those that count.
    template <class Counts>
    void collect(Counts&& counts) {
        pairs_.clear();
        const auto& chunks = core_.shapes.chunks;
        for (const PairWatch& w : core_.watches) {
            if (!(lengths_[w.a] + lengths_[w.b] > fast * static_cast<Real>(w.fineness))) continue;
            const Pair& pair = core_.pairs[w.pair];
            if (!counts(pair)) continue;
            const Chunk &a = chunks[pair.a], &b = chunks[pair.b];
            const Motion3& frame = core_.ways[core_.shapes.uses[a.firstUse].mover];
            const Real ways = lengthOf(a, frame) + lengthOf(b, frame);
            if (!(ways > fast * static_cast<Real>(w.fineness))) continue;
            const bool has = pair.row || pair.firstTouch != none;
            const double odometers = movers_.odometer[w.a] + movers_.odometer[w.b];
            if (!has && odometers + static_cast<double>(ways) < w.limit) continue;
            if (core_.encounters[pair.encounter].overlapping == 0) pairs_.push_back(w.pair);
        }
    }

    void hold(const Pair& pair) {
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        if (pair.isManifold) {
            const Real moment = timeOfImpact(core_, a, b, 1 - fast);
            if (moment >= 1) return;
            scale(a.frame, moment);
            scale(b.frame, moment);
            return;
        }
        findPassings(state_, a, b, 1 - fast, core_.passings);
        for (const Passing& c : core_.passings) {
            const auto one = core_.shapes.corners[c.corner].mover,
                       other = core_.shapes.corners[c.a].mover;
            scale(one, c.moment);
            if (movers_.body[one] != movers_.body[other]) scale(other, c.moment);
        }
    }

    /// The body of a mover goes only a share of its way.
    void scale(std::uint32_t m, Real share) {
        const auto body = state_.bodySlots.denseOf(movers_.body[m]);
        if (state_.bodies[body].kind != BodyKind::dynamic) return;
        shares_[body] *= share;
        held_[body] = 1;
        const auto slot = state_.bodies[body].id.index - 1;
        for (auto c = core_.shapes.firstChunk[slot]; c != none;
             c = core_.shapes.chunks[c].nextOfBody) {
            const Chunk& chunk = core_.shapes.chunks[c];
            for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u) {
                const auto mover = core_.shapes.uses[u].mover;
                const Motion3& whole = whole_[mover];
                core_.ways[mover] = {shares_[body] * whole.x, shares_[body] * whole.y,
                                     shares_[body] * whole.turn};
            }
        }
    }

    void giveBack() {
        for (std::uint32_t b = 0; b < state_.bodies.size(); ++b) {
            if (shares_[b] == 1) continue;
            ++state_.statistics.heldBack;
            const Real back = shares_[b] - 1;
            const auto first = state_.bodies[b].firstParticle;
            for (auto i = first; i < first + state_.bodies[b].particles.size(); ++i)
                if (state_.particles.cluster[i] == none && state_.particles.inverseMass[i] > 0)
                    state_.particles.position[i] +=
                        (back * state_.particles.displacement[i]).cast<double>();
        }
        for (const auto c : state_.work.awakeClusters) {
            Cluster& cluster = state_.clusters.list[c];
            const Real back = shares_[cluster.body] - 1;
            if (back == 0 || cluster.inverseMass == 0) continue;
            cluster.shift += back * cluster.displacement;
            cluster.twist += static_cast<double>(back) * cluster.angle;
        }
        // Blows have taken their part of the way off already.
        for (const Blow& blow : core_.blows) {
            const auto b = state_.bodySlots.denseOf(movers_.body[blow.mover]);
            if (shares_[b] == 1) continue;
            const Vec2 more = (1 - shares_[b]) * blow.when * blow.velocity;
            const auto i = core_.denseOfMover[blow.mover];
            if (core_.moverIsCluster[blow.mover] != 0) {
                state_.clusters.list[i].shift += more;
                state_.clusters.list[i].twist +=
                    static_cast<double>((1 - shares_[b]) * blow.when * blow.spin);
            } else {
                state_.particles.position[i] += more.cast<double>();
            }
        }
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    std::vector<std::uint32_t> pairs_;
    std::vector<Motion3> whole_;
    std::vector<Real> lengths_;       // by mover, m
    std::vector<Real> shares_;        // by body, dense index
    std::vector<std::uint8_t> held_;  // the same, 1: in this round
};

}  // namespace

void holdBackFast(State& state) {
    Keeper(state).run();
}

}  // namespace sulfur::detail
