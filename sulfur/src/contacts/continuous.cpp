// What is fast never passes through anything: where rows that were found at the start of a step and
// swept a few times have not stopped two surfaces, both stay where they come to touch. Only places
// are held back; what is left of the velocity is for the next step's rows.
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

/// What comes nearer in a step by more than this share of the thickness is fast. It may overlap up
/// to where as much of the thickness is left.
constexpr Real fast = Real(0.25);
constexpr int mostRounds = 8;

class Keeper {
public:
    explicit Keeper(State& state) : state_(state), core_(state.core), movers_(core_.movers) {}

    void run() {
        takeWays();
        collect();
        if (pairs_.empty()) return;
        bool any = true;
        for (int round = 0; round < mostRounds && any; ++round) {
            any = false;
            for (const auto pair : pairs_) any = hold(core_.pairs[pair]) || any;
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
        whole_ = core_.ways;
    }

    Real lengthOf(std::uint32_t m) const {
        const Motion3& way = core_.ways[m];
        return std::abs(way.x) + std::abs(way.y) + movers_.reach[m] * std::abs(way.turn);
    }
    Real lengthOf(const Chunk& chunk) const {
        Real most = 0;
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            most = std::max(most, lengthOf(core_.shapes.uses[u].mover));
        return most;
    }

    /// Pairs that are fast and may have come near: rows they have, or the next look is due.
    void collect() {
        const auto& chunks = core_.shapes.chunks;
        for (const PairWatch& w : core_.watches) {
            const Pair& pair = core_.pairs[w.pair];
            const Chunk &a = chunks[pair.a], &b = chunks[pair.b];
            const Real ways = lengthOf(a) + lengthOf(b);
            if (!(ways > fast * (a.fineness + b.fineness))) continue;
            const bool has = pair.row || pair.firstTouch != none;
            const double odometers = movers_.odometer[w.a] + movers_.odometer[w.b];
            if (!has && odometers + static_cast<double>(ways) < w.limit) continue;
            if (core_.encounters[pair.encounter].overlapping == 0) pairs_.push_back(w.pair);
        }
    }

    bool hold(const Pair& pair) {
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        if (pair.isManifold) {
            const Real moment = timeOfImpact(core_, a, b, fast);
            if (moment >= 1) return false;
            scale(a.frame, moment);
            scale(b.frame, moment);
            return true;
        }
        findPassings(state_, a, b, fast, core_.passings);
        for (const Passing& c : core_.passings) {
            const auto m = core_.shapes.corners[c.corner].mover,
                       first = core_.shapes.corners[c.a].mover,
                       second = core_.shapes.corners[c.b].mover;
            scale(m, c.moment);
            scale(first, c.moment);
            if (second != first) scale(second, c.moment);
        }
        return !core_.passings.empty();
    }

    void scale(std::uint32_t m, Real share) {
        Motion3& way = core_.ways[m];
        way = {share * way.x, share * way.y, share * way.turn};
    }

    void giveBack() {
        for (std::size_t k = 0; k < core_.awakeMovers.size(); ++k) {
            const auto m = core_.awakeMovers[k];
            const auto i = core_.awakeDense[k];
            const Motion3 &now = core_.ways[m], &whole = whole_[m];
            const Vec2 back(now.x - whole.x, now.y - whole.y);
            const Real turn = now.turn - whole.turn;
            if ((back[0] == 0 && back[1] == 0 && turn == 0) || movers_.bodies[m].inverseMass == 0)
                continue;
            if (core_.awakeIsCluster[k] != 0) {
                state_.clusters.list[i].shift += back;
                state_.clusters.list[i].twist += static_cast<double>(turn);
            } else {
                state_.particles.position[i] += back.cast<double>();
            }
        }
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    std::vector<std::uint32_t> pairs_;
    std::vector<Motion3> whole_;
};

}  // namespace

void holdBackFast(State& state) {
    Keeper(state).run();
}

}  // namespace sulfur::detail
