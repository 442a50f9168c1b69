#include "collision/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/covering.hpp"
#include "collision/geometry.hpp"
#include "core/bucket_sort.hpp"
#include "core/pieces.hpp"

namespace sulfur::detail {

namespace {

bool isVetoed(const State& state, std::uint32_t a, std::uint32_t b) {
    if (state.vetoes.empty()) return false;
    return std::binary_search(state.vetoes.begin(), state.vetoes.end(),
                              BodyPair::of(state.bodies[a].id, state.bodies[b].id));
}

bool mayTouch(const State& state, std::uint32_t a, std::uint32_t b) {
    if (!state.awake(a) && !state.awake(b)) return false;
    if (state.bodies[a].sensor || state.bodies[b].sensor) return false;
    if (a == b) return state.bodies[a].selfCollision;
    return mayCollide(state.bodies[a].filter, state.bodies[b].filter) && !isVetoed(state, a, b);
}

/// Parts of one body that are this near to each other in the blueprint, in thicknesses, belong
/// together and never touch.
constexpr Real togetherWithin = Real(1.2);

bool belongsTogether(const State& state, std::uint32_t particle, const Collider& c) {
    const Particles& p = state.particles;
    if (p.body[particle] != c.body) return false;
    if (particle == c.a || particle == c.b) return true;
    const Vec2 a = p.rest[c.a], b = p.rest[c.b], at = p.rest[particle];
    const Vec2 nearest = a + nearestAlong<Vec2>(at, a, b) * (b - a);
    return (at - nearest).norm() < togetherWithin * (p.reach[particle] + c.radius);
}

bool areLinked(const BroadPhase& broad, std::uint32_t particle, std::uint32_t body) {
    return !broad.linked.empty() &&
           std::binary_search(broad.linked.begin(), broad.linked.end(), std::pair(particle, body));
}

/// Two colliders, the one of the smaller number first, while they are being collected: both numbers
/// in one, so that they are quickly sorted.
class Found {
public:
    Found() = default;
    Found(std::uint32_t i, std::uint32_t j)
        : both_(std::uint64_t{std::min(i, j)} << 32 | std::max(i, j)) {}
    std::uint32_t first() const { return static_cast<std::uint32_t>(both_ >> 32); }
    std::uint32_t second() const { return static_cast<std::uint32_t>(both_); }
    friend auto operator<=>(const Found&, const Found&) = default;

private:
    std::uint64_t both_ = 0;
};

/// What one piece of the pairs that were found came to.
struct Watched {
    std::vector<WatchedPair> pairs;
    std::vector<Watch> watches;
};

/// Scratch memory only.
struct Finder {
    std::vector<Found> found, foundScratch;
    std::vector<WatchedPair> pairs, mergedPairs;
    std::vector<Watch> watches, watchScratch;
    std::vector<Watched> watched;  // of all pieces but the first
    std::vector<std::uint32_t> start;
};

/// What finer colliders share cells of a coarse grid with. Each is rasterised there too, which for
/// most gives a cell or two.
template <class Keep>
void collectCoarsePairs(const State& state, std::size_t level, Keep&& keep) {
    const BroadPhase& broad = state.broad;
    const CoarseGrid& grid = broad.coarse[level - 1];
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    grid.moving.forEachPair(keep);
    for (const auto& entry : grid.moving.entries())
        grid.fixed.forEachIn(entry.cell,
                             [&](std::uint32_t other) { keep(entry.item, offset + other); });
    const bool moving = !grid.moving.entries().empty();
    if (!moving && grid.fixed.entries().empty()) return;
    for (std::uint32_t i = 0; i < offset; ++i) {
        if (broad.levelOfMoving[i] >= level) continue;
        rasterise(state, broad.moving[i], skinOf(broad, broad.moving[i]), level, [&](Cell cell) {
            grid.moving.forEachIn(cell, [&](std::uint32_t large) { keep(i, large); });
            grid.fixed.forEachIn(cell, [&](std::uint32_t large) { keep(i, offset + large); });
        });
    }
    for (std::uint32_t i = 0; moving && i < broad.fixed.size(); ++i) {
        if (broad.levelOfFixed[i] >= level) continue;
        rasterise(state, broad.fixed[i], 0, level, [&](Cell cell) {
            grid.moving.forEachIn(cell, [&](std::uint32_t large) { keep(large, offset + i); });
        });
    }
}

/// A margin for the rounding of places that are 1e9 m away.
constexpr double rounding = 1e-6;

/// The thickest part of a collider: of its ends, where other capsules end too.
Real reachOf(const State& state, const Collider& c) {
    return std::max({c.radius, state.particles.reach[c.a], state.particles.reach[c.b]});
}

/// What is fast may be stopped up to half of its thickness before it touches.
constexpr Real farthestTouch = Real(1.5);  // thicknesses

Surroundings surroundingsOf(const State& state, const Collider& c) {
    const auto& x = state.broad.reference;
    const double around =
        static_cast<double>(farthestTouch * reachOf(state, c) + skinOf(state.broad, c)) + rounding;
    const Point margin(around, around);
    return {x[c.a].cwiseMin(x[c.b]) - margin, x[c.a].cwiseMax(x[c.b]) + margin, c.body,
            state.bodies[c.body].selfCollision};
}

/// Writes down a pair that shares a cell, if it is near enough.
struct Keep {
    void operator()(std::uint32_t i, std::uint32_t j) {
        const Surroundings &a = broad.surroundings[i], &b = broad.surroundings[j];
        if (a.body == b.body && !a.meetsItself) return;
        if (a.low[0] > b.high[0] || b.low[0] > a.high[0]) return;
        if (a.low[1] > b.high[1] || b.low[1] > a.high[1]) return;
        found.emplace_back(i, j);
    }
    const BroadPhase& broad;
    std::vector<Found>& found;
};

void sortFound(const BroadPhase& broad, Finder& finder) {
    auto& found = finder.found;
    bucketSort(found, finder.foundScratch, finder.start, broad.moving.size(),
               [](const Found& pair) { return pair.first(); });
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

/// All that shares a cell and is near, sorted, each pair once.
void collectFound(const State& state, Finder& finder) {
    const BroadPhase& broad = state.broad;
    finder.found.clear();
    Keep keep{broad, finder.found};
    broad.movingGrid.forEachPair(keep);
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    for (const auto& entry : broad.movingGrid.entries())
        broad.fixedGrid.forEachIn(entry.cell,
                                  [&](std::uint32_t fixed) { keep(entry.item, offset + fixed); });
    for (std::size_t level = 1; level <= broad.coarse.size(); ++level)
        collectCoarsePairs(state, level, keep);
    sortFound(broad, finder);
}

/// The same for colliders of the pieces that have left their skins, against all others.
void collectFoundOfLeft(const State& state, Finder& finder) {
    const BroadPhase& broad = state.broad;
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    finder.found.clear();
    Keep keep{broad, finder.found};
    const auto look = [&](std::uint32_t i, const Grid& moving, const Grid& fixed,
                          std::size_t level) {
        if (moving.entries().empty() && fixed.entries().empty()) return;
        const Collider& c = broad.moving[i];
        rasterise(state, c, skinOf(broad, c), level, [&](Cell cell) {
            moving.forEachIn(cell, [&](std::uint32_t j) {
                if (j != i) keep(i, j);
            });
            fixed.forEachIn(cell, [&](std::uint32_t j) { keep(i, offset + j); });
        });
    };
    for (const auto piece : broad.left)
        for (auto k = broad.pieces.colliderStart[piece]; k < broad.pieces.colliderStart[piece + 1];
             ++k) {
            const auto i = broad.pieces.colliders[k];
            look(i, broad.movingGrid, broad.fixedGrid, 0);
            for (std::size_t level = 1; level <= broad.coarse.size(); ++level)
                look(i, broad.coarse[level - 1].moving, broad.coarse[level - 1].fixed, level);
        }
    sortFound(broad, finder);
}

/// A segment from the origin of its frame, ready to be measured from.
struct Axis {
    Axis(const Point& from, const Point& to)
        : start(from), along(to - from), scale(along.squaredNorm()) {
        scale = scale > 0 ? 1 / scale : 0;
    }
    double squaredDistance(const Point& p) const {
        const Point offset = p - start;
        return (std::clamp(offset.dot(along) * scale, 0.0, 1.0) * along - offset).squaredNorm();
    }
    Point start, along;  // m
    double scale;        // 1/m^2
};

/// How far the axes of two colliders are apart, and each end of one from the axis of the other.
struct Distances {
    double least = 0;                    // m^2; 0 when they cross
    std::array<double, 2> ofA{}, ofB{};  // m^2
};

/// The squared distances of two colliders as they were rasterised.
Distances measure(const BroadPhase& broad, const Collider& a, const Collider& b) {
    const auto& x = broad.reference;
    const Point origin = x[a.a];
    const Point a1(0, 0), a2 = x[a.b] - origin, b1 = x[b.a] - origin, b2 = x[b.b] - origin;
    const Axis axisA(a1, a2), axisB(b1, b2);
    Distances d;
    d.ofA = {axisB.squaredDistance(a1), axisB.squaredDistance(a2)};
    d.ofB = {axisA.squaredDistance(b1), axisA.squaredDistance(b2)};
    d.least =
        segmentsCross(a1, a2, b1, b2) ? 0 : std::min({d.ofA[0], d.ofA[1], d.ofB[0], d.ofB[1]});
    return d;
}

/// How far both sides of a candidate may go, together, before it must be looked at, when they are
/// `apart` further from each other than a contact needs. lookAt() lets through what comes as near
/// as both coordinates of a step add up to, at most the square root of 2 of its length, and the end
/// of a capsule that has gone far need not be the one that steps. (What is passed over although it
/// would be let through would depend on when candidates were found, as after a restore.)
Real spareOf(Real apart) {
    constexpr Real share = Real(0.41);  // 1 / (1 + sqrt 2), rounded down
    return apart < 0 ? apart : share * apart;
}

/// An end of one collider and another collider, while candidates are being collected.
struct End {
    std::uint32_t particle = 0, collider = 0;
    double squaredDistance = 0;  // m^2
};

/// Adds the candidate of an end that is near.
void addWatch(const State& state, const End& end, const Collider& c, Real thickness,
              std::vector<Watch>& watches) {
    const BroadPhase& broad = state.broad;
    if (areLinked(broad, end.particle, c.body) || belongsTogether(state, end.particle, c)) return;
    // A thousandth for rounding.
    const Real needed = Real(1.001) * thickness + broad.watchedGap(thickness);
    const double distance = std::sqrt(end.squaredDistance);
    const Real apart = static_cast<Real>(distance - static_cast<double>(needed));
    watches.push_back({{end.particle, end.collider}, c.a, c.b, c.body, spareOf(apart), thickness});
}

/// Adds the candidate of an end against a collider, rasterised with a skin of so many m, if it can
/// touch before anything leaves its skin.
inline void watchEnd(const State& state, const End& end, const Collider& c, Real skin,
                     std::vector<Watch>& watches) {
    const Real thickness = state.particles.reach[end.particle] + c.radius;
    const Real reach = farthestTouch * thickness + state.broad.skin[end.particle] + skin;
    const double most = static_cast<double>(reach) + rounding;
    if (end.squaredDistance <= most * most) addWatch(state, end, c, thickness, watches);
}

void watchPair(const State& state, const Found& pair, std::vector<WatchedPair>& pairs,
               std::vector<Watch>& watches) {
    const BroadPhase& broad = state.broad;
    const auto i = pair.first(), j = pair.second();
    const Collider &a = broad.collider(i), &b = broad.collider(j);
    const Real radii = a.radius + b.radius;
    const Real skinA = skinOf(broad, a), skinB = skinOf(broad, b);
    const Distances d = measure(broad, a, b);
    // Axes may come as near as they are before they cross; a thousandth of the radii for rounding.
    const double most = static_cast<double>(radii + (skinA + skinB)) + rounding;
    if (d.least <= most * most)
        pairs.push_back({i, j,
                         static_cast<Real>(std::sqrt(d.least) - 0.001 * static_cast<double>(radii) -
                                           rounding)});
    watchEnd(state, {a.a, j, d.ofA[0]}, b, skinB, watches);
    if (a.b != a.a) watchEnd(state, {a.b, j, d.ofA[1]}, b, skinB, watches);
    watchEnd(state, {b.a, i, d.ofB[0]}, a, skinA, watches);
    if (b.b != b.a) watchEnd(state, {b.b, i, d.ofB[1]}, a, skinA, watches);
}

/// Joins neighbours that have the same key, keyOf(item) with two numbers, into runs.
template <class Item, class KeyOf>
void collectRuns(const std::vector<Item>& items, std::vector<WatchRun>& runs, KeyOf&& keyOf) {
    runs.clear();
    const auto size = static_cast<std::uint32_t>(items.size());
    for (std::uint32_t k = 0; k < size;) {
        const auto key = keyOf(items[k]);
        WatchRun run{k, k, key.first, key.second, items[k].spare};
        do {
            run.spare = std::min(run.spare, items[k].spare);
            ++k;
        } while (k < size && keyOf(items[k]) == key);
        run.last = k;
        runs.push_back(run);
    }
}

/// Makes pairs and candidates of what was found, both sorted and each once.
void watchFound(const State& state, Finder& finder, std::vector<WatchedPair>& pairs,
                std::vector<Watch>& watches) {
    const BroadPhase& broad = state.broad;
    pairs.clear();
    watches.clear();
    constexpr std::size_t foundInMicrosecond = 40;
    const std::size_t count = finder.found.size();
    const std::size_t pieces = piecesOf(state.tasks, count, foundInMicrosecond);
    if (finder.watched.size() < pieces) finder.watched.resize(pieces);
    runPieces(state.tasks, pieces, [&](std::size_t i) {
        auto& [itsPairs, itsWatches] = finder.watched[i];
        itsPairs.clear();
        itsWatches.clear();
        // One day most are in one piece.
        if (i > 0) {
            itsWatches.reserve(broad.watches.capacity());
            itsPairs.reserve(broad.pairs.capacity());
        }
        const auto last = pieceStart(i + 1, pieces, count);
        for (auto k = pieceStart(i, pieces, count); k < last; ++k) {
            const Found& pair = finder.found[k];
            if (mayTouch(state, broad.surroundings[pair.first()].body,
                         broad.surroundings[pair.second()].body))
                watchPair(state, pair, i == 0 ? pairs : itsPairs, i == 0 ? watches : itsWatches);
        }
    });
    for (std::size_t i = 1; i < pieces; ++i) {
        const Watched& more = finder.watched[i];
        pairs.insert(pairs.end(), more.pairs.begin(), more.pairs.end());
        watches.insert(watches.end(), more.watches.begin(), more.watches.end());
    }
    bucketSort(watches, finder.watchScratch, finder.start, state.particles.size(),
               [](const Watch& w) { return w.candidate.particle; });
    const auto same = [](const Watch& p, const Watch& q) { return p.candidate == q.candidate; };
    watches.erase(std::unique(watches.begin(), watches.end(), same), watches.end());
}

void collectAllRuns(BroadPhase& broad) {
    collectRuns(broad.watches, broad.watchRuns,
                [](const Watch& w) { return std::pair(w.candidate.particle, w.body); });
    const auto bodyOf = [&](std::uint32_t i) { return broad.surroundings[i].body; };
    collectRuns(broad.pairs, broad.pairRuns, [&](const WatchedPair& pair) {
        return std::pair(bodyOf(pair.first), bodyOf(pair.second));
    });
}

/// Drops what concerns a piece that has left its skin.
void forgetLeft(BroadPhase& broad) {
    const auto hasLeft = [&](std::uint32_t particle) {
        const auto piece = broad.pieces.ofParticle[particle];
        return piece != none && broad.hasLeft[piece] != 0;
    };
    std::erase_if(broad.watches,
                  [&](const Watch& w) { return hasLeft(w.candidate.particle) || hasLeft(w.a); });
    std::erase_if(broad.pairs, [&](const WatchedPair& pair) {
        return hasLeft(broad.collider(pair.first).a) || hasLeft(broad.collider(pair.second).a);
    });
}

template <class Item>
void mergeInto(std::vector<Item>& items, const std::vector<Item>& more,
               std::vector<Item>& scratch) {
    scratch.resize(items.size() + more.size());
    std::merge(items.begin(), items.end(), more.begin(), more.end(), scratch.begin());
    std::swap(items, scratch);
}

Finder& finder() {
    thread_local Finder scratch;
    return scratch;
}

}  // namespace

void findPairs(State& state) {
    BroadPhase& broad = state.broad;
    broad.surroundings.clear();
    for (const auto* colliders : {&broad.moving, &broad.fixed})
        for (const Collider& c : *colliders) broad.surroundings.push_back(surroundingsOf(state, c));
    collectFound(state, finder());
    watchFound(state, finder(), broad.pairs, broad.watches);
    broad.plans.clear();
    broad.plansStale = false;
    collectAllRuns(broad);
}

void renewPairs(State& state) {
    BroadPhase& broad = state.broad;
    const Pieces& pieces = broad.pieces;
    for (const auto piece : broad.left)
        for (auto k = pieces.colliderStart[piece]; k < pieces.colliderStart[piece + 1]; ++k)
            broad.surroundings[pieces.colliders[k]] =
                surroundingsOf(state, broad.moving[pieces.colliders[k]]);
    forgetLeft(broad);
    Finder& lists = finder();
    collectFoundOfLeft(state, lists);
    watchFound(state, lists, lists.pairs, lists.watches);
    mergeInto(broad.pairs, lists.pairs, lists.mergedPairs);
    mergeInto(broad.watches, lists.watches, lists.watchScratch);
    collectAllRuns(broad);
    // Those of candidates that are gone are still there.
    if (2 * broad.plans.size() > broad.watches.size()) broad.plansStale = true;
}

OutingView outingsOf(const State& state, const std::vector<Vec2>& displacements) {
    // (An empty list has no first element whose numbers could be pointed to.)
    const auto numbersOf = [](const auto& list) {
        return list.empty() ? nullptr : list.data()->data();
    };
    return {numbersOf(state.particles.position), numbersOf(state.broad.reference),
            numbersOf(displacements)};
}

void measureOutings(const State& state, const std::vector<Vec2>& displacements, Outings& outings) {
    const Particles& p = state.particles;
    auto& ofParticle = outings.ofParticle;
    auto& ofBody = outings.ofBody;
    ofParticle.resize(p.size(), 0);
    if (state.steps.mixed) {
        // What stands by is as far out as its own steps have led it.
        ofBody.resize(state.bodies.size(), 0);
        for (const auto body : state.work.bodies) ofBody[body] = 0;
    } else {
        ofBody.assign(state.bodies.size(), 0);
    }
    // Pieces end where bodies do.
    const auto bodyStart = [&](std::size_t i) {
        while (i > 0 && i < p.size() && p.body[i] == p.body[i - 1]) ++i;
        return static_cast<std::uint32_t>(i);
    };
    const OutingView view = outingsOf(state, displacements);
    constexpr std::size_t particlesInMicrosecond = 500;
    inPieces(
        state.tasks, p.size(), particlesInMicrosecond, [&](std::size_t begin, std::size_t end) {
            const auto from = bodyStart(begin), to = bodyStart(end);
            for (const Range range : state.work.awake) {
                const auto first = std::max(range.first, from), last = std::min(range.last, to);
                if (first >= last) continue;
                outingKernels().measure(view, ofParticle.data(), first, last);
                for (auto i = first; i < last; ++i) {
                    if (p.reach[i] == 0) continue;
                    Real& most = ofBody[p.body[i]];
                    most = std::max(most, ofParticle[i]);
                }
            }
        });
    for (const auto& [one, other] : state.broad.tied)
        ofBody[one] = ofBody[other] = std::max(ofBody[one], ofBody[other]);
}

}  // namespace sulfur::detail
