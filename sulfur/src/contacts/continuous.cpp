// What is fast never passes through anything: where rows that were found at the start of a step and
// swept a few times have not stopped two surfaces, the movers that carry them are moved apart along
// the normal that these have when they come to touch, each as its mass allows. Only places change:
// what is left of the velocity is for the next step's rows, what it strains for the next step's
// joints. What turns about a pin stays where it was when they came to touch.
//
// The ways of a step are taken as straight. Whoever is moved may get in the way of others, so that
// this is repeated until nobody is.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "contacts/ask.hpp"
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
constexpr int mostKeepingRounds = tuned::keepingRounds;
// How much a thread looks through in a microsecond, about; see piecesOf().
constexpr std::size_t blocksInMicrosecond = 15, watchesInMicrosecond = 100;

class Keeper {
public:
    explicit Keeper(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          pairs_(&state.arena),
          unheld_(&state.arena),
          held_(&state.arena),
          everHeld_(&state.arena),
          moved_(&state.arena) {}

    void run() {
        core_.held.clear();
        takeBlowsOff();
        measureStrips();
        collect();
        if (pairs_.empty()) return;
        unheld_.assign(core_.ways.begin(), core_.ways.end());
        held_.assign(movers_.size(), 0);
        for (round_ = 1; round_ <= mostKeepingRounds && !pairs_.empty(); ++round_) {
            moved_.clear();
            for (const auto pair : pairs_)
                if (hasWorkFor(core_.pairs[pair])) hold(core_.pairs[pair]);
            collectAgain();
        }
        giveBack();
    }

private:
    /// Where there is no work left, what stands fast or is driven still holds everybody back.
    bool hasWorkFor(const Pair& p) const {
        const std::size_t most = tuned::keptPairs * (core_.awakeMovers.size() + tuned::fewMovers);
        return spent_ < most || !isDynamic(p.a) || !isDynamic(p.b);
    }
    bool isDynamic(std::uint32_t chunk) const {
        const auto slot = core_.shapes.chunks[chunk].body;
        return state_.bodies[state_.bodySlots.denseOf(slot)].kind == BodyKind::dynamic;
    }

    /// Whoever was struck goes as blown from that moment on.
    void takeBlowsOff() {
        for (const Blow& blow : core_.blows) {
            BodyWay& way = core_.ways[blow.mover];
            way.x -= blow.late.x;
            way.y -= blow.late.y;
            turnTo(blow.mover, way.turn - blow.late.turn);
            core_.lengths[blow.mover] = lengthOf(blow.mover, {});
        }
    }

    void measureStrips() {
        for (const auto c : core_.awakeStrips) {
            const Chunk& chunk = core_.shapes.chunks[c];
            core_.lengths[chunk.frame] = lengthOf(chunk, {});
        }
    }

    void turnTo(std::uint32_t m, Real turn) {
        core_.ways[m].turn = turn;
        core_.ways[m].around = movers_.reach[m] * std::abs(turn);
    }
    Real lengthOf(std::uint32_t m, const BodyWay& frame) const {
        const BodyWay& way = core_.ways[m];
        return std::abs(way.x - frame.x) + std::abs(way.y - frame.y) + way.around;
    }

    /// How far a chunk goes at most, seen from what goes along with `frame`.
    Real lengthOf(const Chunk& chunk, const BodyWay& frame) const {
        Real most = 0;
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            most = std::max(most, lengthOf(core_.shapes.uses[u].mover, frame));
        return most;
    }

    using List = std::vector<std::uint32_t>;

    /// Lists the pairs that may pass: those with rows of convex chunks block by block.
    void collect() {
        const RowKernels& kernels = rowKernels();
        List& found = core_.again;
        found.clear();
        for (const auto c : core_.rows.inUse()) {
            const ManifoldList& list = core_.rows.manifolds[c];
            core_.findInPieces(
                state_.tasks, list.blocks.size(), blocksInMicrosecond, rowLanes, found,
                [&](std::size_t first, std::size_t last, List& mine) {
                    for (std::size_t k = first; k < last; ++k)
                        for (auto lanes = passing(kernels, list, k); lanes != 0; lanes &= lanes - 1)
                            mine.push_back(list.shapes[k].pair[std::countr_zero(lanes)]);
                });
        }
        core_.findInPieces(
            state_.tasks, core_.watches.size(), watchesInMicrosecond, 1, found,
            [&](std::size_t first, std::size_t last, List& mine) {
                for (const PairWatch& w : std::span(core_.watches).subspan(first, last - first))
                    if ((w.isManifold == 0 || reachesLimit(w)) && passes(w)) mine.push_back(w.pair);
            });
        for (const auto pair : found) add(pair);
        std::sort(pairs_.begin(), pairs_.end());
    }
    /// By lanes; those without a row have the world on both sides.
    std::uint32_t passing(const RowKernels& kernels, const ManifoldList& list,
                          std::size_t block) const {
        return kernels.passingManifolds(movers_.bodies.data(), core_.ways.data(),
                                        list.blocks[block], list.shapes[block], fast);
    }
    /// Whether two convex chunks without a row may have come as near as mayPass() asks for: mostly
    /// not. (Their ways count twice, so that rounding does not matter.)
    bool reachesLimit(const PairWatch& w) const {
        const double odometers = movers_.odometer[w.a] + movers_.odometer[w.b];
        const Real ways = core_.lengths[w.a] + core_.lengths[w.b];
        return !(odometers + 2 * static_cast<double>(ways) < w.limit);
    }
    bool passes(const PairWatch& w) const {
        const Real least = leastOf(w);
        return core_.lengths[w.a] + core_.lengths[w.b] > least && mayPass(w, least);
    }
    static Real leastOf(const PairWatch& w) { return fast * static_cast<Real>(w.fineness); }
    void add(std::uint32_t pair) {
        const Pair& p = core_.pairs[pair];
        if (core_.encounters[p.encounter].rowless == 0 && hasWorkFor(p)) pairs_.push_back(pair);
    }

    /// Lists those of whoever was moved in this round, who may be in the way of others, and be fast
    /// himself.
    void collectAgain() {
        pairs_.clear();
        const auto& chunks = core_.shapes.chunks;
        const auto forEachChunk = [&](auto&& f) {
            for (const auto m : moved_)
                for (auto u = movers_.firstUse[m]; u != none; u = core_.shapes.uses[u].next)
                    f(chunks[core_.shapes.uses[u].chunk]);
        };
        forEachChunk([&](const Chunk& chunk) {
            if (chunk.uses > 1) core_.lengths[chunk.frame] = lengthOf(chunk, {});
        });
        forEachChunk([&](const Chunk& chunk) {
            for (auto at = chunk.firstPair; at != none; at = core_.pairs[at / 2].next[at % 2])
                if (const auto watch = core_.pairs[at / 2].watch;
                    watch != none && passes(core_.watches[watch]))
                    add(core_.watches[watch].pair);
        });
        std::sort(pairs_.begin(), pairs_.end());
        pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    }

    /// Whether the surfaces of a pair come nearer than `least`, m, and no row is known to have
    /// stopped them.
    bool mayPass(const PairWatch& w, Real least) const {
        if (w.limit == PairWatch::never) {
            const RowPlace row = core_.pairs[w.pair].row;
            const auto lanes =
                passing(rowKernels(), core_.rows.manifolds[row.colour], RowGraph::blockOf(row));
            return (lanes >> RowGraph::laneOf(row) & 1) != 0;
        }
        const Real ways = waysOf(w);
        if (!(ways > least)) return false;
        // What has no touches is far from each other until its limit.
        if (w.isManifold == 0 && core_.pairs[w.pair].firstTouch != none) return true;
        const double odometers = movers_.odometer[w.a] + movers_.odometer[w.b];
        if (odometers + static_cast<double>(ways) < w.limit) return false;
        return !staysApart(core_, w, motionOf(core_.ways[w.a]), motionOf(core_.ways[w.b]));
    }

    /// How far the surfaces of a pair go at most, seen from each other.
    Real waysOfFrames(const PairWatch& w) const {
        const BodyWay& frame = core_.ways[w.a];
        return frame.around + lengthOf(w.b, frame);
    }
    Real waysOf(const PairWatch& w) const {
        if (w.isManifold != 0) return waysOfFrames(w);
        const Pair& pair = core_.pairs[w.pair];
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        const BodyWay& frame = core_.ways[core_.shapes.uses[a.firstUse].mover];
        return lengthOf(a, frame) + lengthOf(b, frame);
    }

    void hold(const Pair& pair) {
        ++state_.statistics.fastPairs;
        spent_ += priceOf(core_, pair);
        find(pair);
        if (core_.passings.empty()) return;
        Real moment = 1;
        for (const Passing& p : core_.passings) moment = std::min(moment, p.moment);
        bool anyStops = false;
        for (const Passing& p : core_.passings)
            for (const auto m : {p.one, p.others[0], p.others[1]})
                anyStops = stop(m, moment) || anyStops;
        if (anyStops) find(pair);
        for (Passing& p : core_.passings) p.depth += apart(p);
        for (const Passing& p : core_.passings) push(p, p.depth - apart(p));
        core_.held.push_back(static_cast<std::uint32_t>(&pair - core_.pairs.data()));
    }
    void find(const Pair& pair) {
        const Chunk &a = core_.shapes.chunks[pair.a], &b = core_.shapes.chunks[pair.b];
        if (pair.isManifold)
            findPassing(core_, a, b, 1 - fast, core_.passings);
        else
            findPassings(state_, a, b, 1 - fast, core_.passings);
        if (state_.callbacks.preSolve && !core_.passings.empty())
            askAboutPassings(state_, pair, core_.passings);
    }

    /// What turns about a pin goes no farther than to a moment. Returns whether it is such a thing.
    bool stop(std::uint32_t m, Real moment) {
        const SolverBody& body = movers_.bodies[m];
        if (body.inverseMass > 0 || body.inverseInertia == 0 || !canBeHeld(m)) return false;
        turnTo(m, core_.ways[m].turn * moment);
        note(m);
        return true;
    }

    /// m, by which the ways of a pair lead it apart.
    Real apart(const Passing& p) const {
        const auto along = [&](std::uint32_t m) {
            return p.normal[0] * core_.ways[m].x + p.normal[1] * core_.ways[m].y;
        };
        return along(p.one) - (1 - p.share) * along(p.others[0]) - p.share * along(p.others[1]);
    }

    /// Leads a pair apart by `depth`, m.
    void push(const Passing& p, Real depth) {
        const std::array<std::uint32_t, 3> who{p.one, p.others[0], p.others[1]};
        const std::array<Real, 3> part{1, p.share - 1, -p.share};
        std::array<Real, 3> gives{};
        Real sum = 0;
        for (std::size_t i = 0; i < who.size(); ++i) {
            gives[i] = canBeHeld(who[i]) ? part[i] * movers_.bodies[who[i]].inverseMass : 0;
            sum += part[i] * gives[i];
        }
        if (!(depth > 0 && sum > 0)) return;
        for (std::size_t i = 0; i < who.size(); ++i) {
            if (gives[i] == 0) continue;
            core_.ways[who[i]].x += depth / sum * gives[i] * p.normal[0];
            core_.ways[who[i]].y += depth / sum * gives[i] * p.normal[1];
            note(who[i]);
        }
    }
    bool canBeHeld(std::uint32_t m) const {
        if (movers_.body[m] == none) return false;
        const BodyRecord& body = state_.bodies[state_.bodySlots.denseOf(movers_.body[m])];
        return body.kind == BodyKind::dynamic && !body.asleep;
    }
    void note(std::uint32_t m) {
        if (held_[m] == 0) everHeld_.push_back(m);
        if (held_[m] != round_) moved_.push_back(m);
        held_[m] = round_;
        core_.lengths[m] = lengthOf(m, {});
    }

    void giveBack() {
        for (const auto m : everHeld_) {
            ++state_.statistics.heldBack;
            const BodyWay &way = core_.ways[m], &unheld = unheld_[m];
            const Motion3 shift{way.x - unheld.x, way.y - unheld.y, way.turn - unheld.turn};
            noteWay(
                m, std::abs(shift.x) + std::abs(shift.y) + movers_.reach[m] * std::abs(shift.turn));
            const auto i = core_.denseOfMover[m];
            if (core_.moverIsCluster[m] != 0) {
                state_.clusters.list[i].shift += Vec2(shift.x, shift.y);
                state_.clusters.list[i].twist += static_cast<double>(shift.turn);
            } else {
                state_.particles.position[i] += Vec2(shift.x, shift.y).cast<double>();
            }
        }
    }
    /// On the odometers of a mover and of the strips that it carries.
    void noteWay(std::uint32_t m, Real length) {
        movers_.odometer[m] += static_cast<double>(length);
        for (auto u = movers_.firstUse[m]; u != none; u = core_.shapes.uses[u].next) {
            const Chunk& chunk = core_.shapes.chunks[core_.shapes.uses[u].chunk];
            if (chunk.uses > 1) movers_.odometer[chunk.frame] += static_cast<double>(length);
        }
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    std::pmr::vector<std::uint32_t> pairs_;
    std::pmr::vector<BodyWay> unheld_;  // ways of movers before anybody was held
    std::pmr::vector<int> held_;        // by mover, the last round in which it was moved
    std::pmr::vector<std::uint32_t> everHeld_, moved_;  // movers; those of this round
    int round_ = 0;
    std::size_t spent_ = 0;  // pairs that were held, as tuned::keptPairs counts them
};

}  // namespace

void holdBackFast(State& state) {
    Keeper(state).run();
}

}  // namespace sulfur::detail
