// What is fast never passes through anything: where rows that were found at the start of a step and
// swept a few times have not stopped two surfaces, both bodies are moved apart along the normal
// that these have when they come to touch, each as its mass allows. Only places change, of a body
// as a whole, so that no joint of it is strained; what is left of the velocity is for the next
// step's rows. A body with a pinned particle cannot be moved as a whole: it stays where it was when
// they came to touch.
//
// The ways of a step are taken as straight. Whoever is moved may get in the way of others, so that
// this is repeated until nobody is.
#include <algorithm>
#include <cmath>

#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/clusters.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"
#include "narrow_phase/time_of_impact.hpp"

namespace sulfur::detail {

namespace {

/// What comes nearer in a step by more than this share of the thickness is fast. It may overlap by
/// as much.
constexpr Real fast = Real(tuned::fast);
constexpr int mostRounds = tuned::keepingRounds;

class Keeper {
public:
    explicit Keeper(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          pairs_(&state.arena),
          whole_(&state.arena),
          fast_(&state.arena),
          holds_(&state.arena),
          held_(&state.arena),
          everHeld_(&state.arena) {}

    void run() {
        takeBlowsOff();
        measureStrips();
        findFast();
        collectFirst();
        if (pairs_.empty()) return;
        whole_.assign(core_.ways.begin(), core_.ways.end());
        holds_.assign(state_.bodies.size(), {});
        for (int round = 0; round < mostRounds && !pairs_.empty(); ++round) {
            state_.statistics.fastPairs += static_cast<std::uint32_t>(pairs_.size());
            held_.assign(state_.bodies.size(), 0);
            anyHeld_ = false;
            for (const auto pair : pairs_) hold(core_.pairs[pair]);
            if (!anyHeld_) break;
            // Who was held back may be in the way of whoever went along with him.
            pairs_.clear();
            collect([&](std::uint32_t chunk) { return isFast(chunk); },
                    [&](const Pair& pair) { return wasHeld(pair.a) || wasHeld(pair.b); });
        }
        giveBack();
    }

private:
    /// What becomes of the way of a body: a share of it and a shift.
    struct Hold {
        Real share = 1;
        Vec2 shift{0, 0};  // m
        Vec2 way{0, 0};    // m, mean way of its mass before anything was held
        Real mass = 0;     // kg; 0: not yet asked
        bool isPinned = false, isRigid = true, listed = false;

        bool changed() const { return share != 1 || shift[0] != 0 || shift[1] != 0; }
    };

    /// Whoever was struck goes as blown from that moment on.
    void takeBlowsOff() {
        for (const Blow& blow : core_.blows) {
            Motion3& way = core_.ways[blow.mover];
            way.x -= blow.when * blow.velocity[0];
            way.y -= blow.when * blow.velocity[1];
            way.turn -= blow.when * blow.spin;
            core_.lengths[blow.mover] = lengthOf(blow.mover, {});
        }
    }

    void measureStrips() {
        for (const auto c : core_.awakeStrips) {
            const Chunk& chunk = core_.shapes.chunks[c];
            core_.lengths[chunk.frame] = lengthOf(chunk, {});
        }
    }

    /// Lists the chunks that are fast by themselves.
    void findFast() {
        const Real least = fast / 2 * static_cast<Real>(core_.finest);
        for (const auto m : core_.awakeMovers) {
            if (!(core_.lengths[m] > least)) continue;
            for (auto u = movers_.firstUse[m]; u != none; u = core_.shapes.uses[u].next) {
                const auto chunk = core_.shapes.uses[u].chunk;
                if (core_.shapes.chunks[chunk].uses == 1) fast_.push_back(chunk);
            }
        }
        for (const auto c : core_.awakeStrips)
            if (core_.lengths[core_.shapes.chunks[c].frame] > least) fast_.push_back(c);
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

    bool isFast(std::uint32_t chunk) const {
        return 2 * core_.lengths[core_.shapes.chunks[chunk].frame] >
               fast * static_cast<Real>(core_.finest);
    }

    /// Whether a chunk goes otherwise than was predicted when its pairs were judged.
    bool goesOtherwise(std::uint32_t index) const {
        const Chunk& chunk = core_.shapes.chunks[index];
        if (chunk.uses != 1 || movers_.colours[chunk.frame] != 0) return true;
        const Motion3& way = core_.ways[chunk.frame];
        const Prediction& p = movers_.predictions[chunk.frame];
        return way.x != p.goesX || way.y != p.goesY || way.turn != p.turn;
    }

    /// One side of a fast pair is fast by itself. A pair that was judged to stay apart does, where
    /// that side goes as was predicted, and the other one too, or is slow.
    void collectFirst() {
        pairs_.clear();
        const auto isAsked = [&](std::uint32_t chunk) {
            return isFast(chunk) && goesOtherwise(chunk);
        };
        collect(isAsked, [](const Pair&) { return true; });
        auto& looked = core_.looked;
        std::sort(looked.begin(), looked.end());
        looked.erase(std::unique(looked.begin(), looked.end()), looked.end());
        for (const auto index : looked) {
            const Pair& pair = core_.pairs[index];
            if (pair.a == none || pair.watch == none || isAsked(pair.a) || isAsked(pair.b))
                continue;
            if (mayPass(core_.watches[pair.watch], pair)) pairs_.push_back(index);
        }
    }

    /// Pairs of chunks that are asked which count and may have come near.
    template <class IsAsked, class Counts>
    void collect(IsAsked&& isAsked, Counts&& counts) {
        const auto& chunks = core_.shapes.chunks;
        for (const auto c : fast_) {
            if (!isAsked(c)) continue;
            for (auto at = chunks[c].firstPair; at != none;) {
                const Pair& pair = core_.pairs[at / 2];
                const bool isSecond = at % 2 == 1;
                const auto index = at / 2;
                at = pair.next[at % 2];
                if (pair.watch == none || (isSecond && isAsked(pair.a))) continue;
                if (counts(pair) && mayPass(core_.watches[pair.watch], pair))
                    pairs_.push_back(index);
            }
        }
    }

    /// What is asked comes in the order of what it costs: most pairs are answered by their watch.
    bool mayPass(const PairWatch& w, const Pair& pair) const {
        const Real least = fast * static_cast<Real>(w.fineness);
        if (!(core_.lengths[w.a] + core_.lengths[w.b] > least)) return false;
        const Real ways = waysOf(w);
        if (!(ways > least)) return false;
        const double odometers = movers_.odometer[w.a] + movers_.odometer[w.b];
        if (!hasRows(w) && odometers + static_cast<double>(ways) < w.limit) return false;
        if (pair.row && rowHolds(pair)) return false;
        return !staysApart(core_, w, core_.ways[w.a], core_.ways[w.b]) &&
               core_.encounters[pair.encounter].overlapping == 0;
    }

    /// What has none is far from each other until its limit.
    bool hasRows(const PairWatch& w) const {
        return w.isManifold != 0 ? w.limit == PairWatch::never
                                 : core_.pairs[w.pair].firstTouch != none;
    }

    /// How far the surfaces of a pair go at most, seen from each other.
    Real waysOf(const PairWatch& w) const {
        if (w.isManifold != 0) {
            const Motion3& frame = core_.ways[w.a];
            return lengthOf(w.a, {frame.x, frame.y, 0}) + lengthOf(w.b, frame);
        }
        const Pair& pair = core_.pairs[w.pair];
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        const Motion3& frame = core_.ways[core_.shapes.uses[a.firstUse].mover];
        return lengthOf(a, frame) + lengthOf(b, frame);
    }

    /// Whether the row of two convex chunks, whose points are known to be the right ones until the
    /// step ends, has stopped them.
    bool rowHolds(const Pair& pair) const {
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        const ManifoldBlock& r = core_.rows.manifold(pair.row);
        const ManifoldShape& shape = core_.rows.manifoldShape(pair.row);
        const auto l = RowGraph::laneOf(pair.row);
        const Motion3 &wayA = core_.ways[a.frame], &wayB = core_.ways[b.frame];
        const Real turn = std::max(std::abs(wayA.turn), std::abs(wayB.turn));
        const Real most = fast / 2 * shape.thickness[l];
        if (movers_.reach[a.frame] * turn * turn > most) return false;
        if (movedSinceLook(movers_, a, b, wayA, wayB, shape, l) > shape.margin[l]) return false;
        const SolverBody &p = movers_.bodies[a.frame], &q = movers_.bodies[b.frame];
        const Vec2 way(q.x - p.x + wayB.x - wayA.x, q.y - p.y + wayB.y - wayA.y);
        const Real turnA = p.turn + wayA.turn, turnB = q.turn + wayB.turn;
        for (const ManifoldPoint& point : r.points)
            if (point.gap[l] + point.normalX[l] * way[0] + point.normalY[l] * way[1] +
                    point.normalArmB[l] * turnB - point.normalArmA[l] * turnA <
                -most)
                return false;
        return true;
    }

    void hold(const Pair& pair) {
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        const auto find = [&] {
            if (pair.isManifold)
                findPassing(core_, a, b, 1 - fast, core_.passings);
            else
                findPassings(state_, a, b, 1 - fast, core_.passings);
            return !core_.passings.empty();
        };
        if (!find()) return;
        Real moment = 1;
        for (const Passing& p : core_.passings) moment = std::min(moment, p.moment);
        const auto one = state_.bodySlots.denseOf(a.body), other = state_.bodySlots.denseOf(b.body);
        bool bends = stiffen(one, moment);
        if (one == other) return;
        bends = stiffen(other, moment) || bends;
        if (bends && !find()) return;
        Vec2 apart(0, 0);  // m, that the one has been shifted from the other
        for (const Passing& p : core_.passings) {
            const Real side = p.one == a.body ? Real(1) : Real(-1);
            const Real depth = p.depth - side * p.normal.dot(apart);
            if (depth > 0) apart += push(one, other, side * depth * p.normal);
        }
    }

    /// From a moment on, a body that bends goes as its centre of mass does, and a pinned one stays.
    /// Returns whether it is such a body.
    bool stiffen(std::uint32_t body, Real moment) {
        if (!canBeHeld(body)) return false;
        Hold& hold = askedHold(body);
        if (hold.isRigid && !hold.isPinned) return false;
        const Vec2 mean = hold.isPinned ? Vec2(0, 0) : Vec2(hold.share * hold.way + hold.shift);
        hold.share *= moment;
        hold.shift = moment * hold.shift + (1 - moment) * mean;
        follow(body);
        return true;
    }

    /// Moves the one by a way from the other, each as its mass allows. Returns by how much it was.
    Vec2 push(std::uint32_t one, std::uint32_t other, const Vec2& way) {
        const Real p = mobility(one), q = mobility(other);
        if (p + q == 0) return {0, 0};
        if (p > 0) shift(one, p / (p + q) * way);
        if (q > 0) shift(other, -q / (p + q) * way);
        return way;
    }
    bool canBeHeld(std::uint32_t body) const {
        return state_.bodies[body].kind == BodyKind::dynamic && !state_.bodies[body].asleep;
    }
    /// 1/kg, of a body that can be moved as a whole.
    Real mobility(std::uint32_t body) {
        if (!canBeHeld(body)) return 0;
        const Hold& hold = askedHold(body);
        return hold.isPinned ? 0 : 1 / hold.mass;
    }

    void shift(std::uint32_t body, const Vec2& way) {
        holds_[body].shift += way;
        follow(body);
    }
    void follow(std::uint32_t body) {
        if (!holds_[body].listed) everHeld_.push_back(body);
        holds_[body].listed = true;
        held_[body] = 1;
        anyHeld_ = true;
        const Hold& hold = holds_[body];
        const auto slot = state_.bodies[body].id.index - 1;
        for (auto c = core_.shapes.firstChunk[slot]; c != none;
             c = core_.shapes.chunks[c].nextOfBody) {
            const Chunk& chunk = core_.shapes.chunks[c];
            for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u) {
                const auto m = core_.shapes.uses[u].mover;
                const Motion3& whole = whole_[m];
                core_.ways[m] = {hold.share * whole.x + hold.shift[0],
                                 hold.share * whole.y + hold.shift[1], hold.share * whole.turn};
            }
        }
    }

    Hold& askedHold(std::uint32_t body) {
        Hold& hold = holds_[body];
        if (hold.mass > 0) return hold;
        const Particles& p = state_.particles;
        const BodyRecord& record = state_.bodies[body];
        Vec2 momentum(0, 0);
        for (auto i = record.firstParticle; i < record.firstParticle + record.particles.size();
             ++i) {
            hold.isPinned = hold.isPinned || p.pinned[i] != 0;
            hold.mass += p.mass[i];
            const auto c = p.cluster[i];
            hold.isRigid = hold.isRigid && c != none && c == p.cluster[record.firstParticle];
            momentum +=
                p.mass[i] * (c == none ? p.displacement[i] : state_.clusters.list[c].displacement);
        }
        hold.isRigid = hold.isRigid || record.particles.size() == 1;
        hold.way = momentum / hold.mass;
        return hold;
    }

    void giveBack() {
        for (const auto b : everHeld_) {
            const Hold& hold = holds_[b];
            if (!hold.changed()) continue;
            ++state_.statistics.heldBack;
            const Real back = hold.share - 1;
            Particles& p = state_.particles;
            const auto first = state_.bodies[b].firstParticle;
            for (auto i = first; i < first + state_.bodies[b].particles.size(); ++i) {
                const auto c = p.cluster[i];
                if (c == none) {
                    if (p.inverseMass[i] > 0)
                        p.position[i] += (back * p.displacement[i] + hold.shift).cast<double>();
                    continue;
                }
                Cluster& cluster = state_.clusters.list[c];
                if (state_.clusters.members[cluster.first] != i || cluster.inverseMass == 0)
                    continue;
                cluster.shift += back * cluster.displacement + hold.shift;
                cluster.twist += static_cast<double>(back) * cluster.angle;
            }
        }
        // Blows have taken their part of the way off already.
        for (const Blow& blow : core_.blows) {
            const Real share = holds_[state_.bodySlots.denseOf(movers_.body[blow.mover])].share;
            if (share == 1) continue;
            const Vec2 more = (1 - share) * blow.when * blow.velocity;
            const auto i = core_.denseOfMover[blow.mover];
            if (core_.moverIsCluster[blow.mover] != 0) {
                state_.clusters.list[i].shift += more;
                state_.clusters.list[i].twist +=
                    static_cast<double>((1 - share) * blow.when * blow.spin);
            } else {
                state_.particles.position[i] += more.cast<double>();
            }
        }
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    std::pmr::vector<std::uint32_t> pairs_;
    std::pmr::vector<Motion3> whole_;
    std::pmr::vector<std::uint32_t> fast_;  // chunks
    std::pmr::vector<Hold> holds_;          // by body, dense index
    std::pmr::vector<std::uint8_t> held_;   // the same, 1: in this round
    std::pmr::vector<std::uint32_t> everHeld_;
    bool anyHeld_ = false;  // somebody, in this round
};

}  // namespace

void holdBackFast(State& state) {
    Keeper(state).run();
}

}  // namespace sulfur::detail
