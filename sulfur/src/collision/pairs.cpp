#include "collision/pairs.hpp"

#include <algorithm>
#include <array>

#include "collision/covering.hpp"
#include "collision/geometry.hpp"
#include "core/bucket_sort.hpp"

namespace sulfur::detail {

namespace {

bool isVetoed(const State& state, std::uint32_t a, std::uint32_t b) {
    if (state.vetoes.empty()) return false;
    return std::binary_search(state.vetoes.begin(), state.vetoes.end(),
                              BodyPair::of(state.bodies[a].id, state.bodies[b].id));
}

bool mayTouch(const State& state, std::uint32_t a, std::uint32_t b) {
    if (!state.movable(a) && !state.movable(b)) return false;
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

/// Pairs of colliders by their numbers, the smaller one first, while they are being collected.
struct Found {
    std::uint32_t first = 0, second = 0;
    friend auto operator<=>(const Found&, const Found&) = default;
};

/// Scratch memory only.
struct Finder {
    std::vector<Found> found, foundScratch;
    std::vector<Watch> watchScratch;
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

/// All that shares a cell, sorted, each pair once.
void collectFound(const State& state, Finder& finder) {
    const BroadPhase& broad = state.broad;
    auto& found = finder.found;
    found.clear();
    const auto keep = [&](std::uint32_t i, std::uint32_t j) {
        const auto a = broad.collider(i).body, b = broad.collider(j).body;
        if (a == b && !state.bodies[a].selfCollision) return;
        found.push_back({std::min(i, j), std::max(i, j)});
    };
    broad.movingGrid.forEachPair(keep);
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    for (const auto& entry : broad.movingGrid.entries())
        broad.fixedGrid.forEachIn(entry.cell,
                                  [&](std::uint32_t fixed) { keep(entry.item, offset + fixed); });
    for (std::size_t level = 1; level <= broad.coarse.size(); ++level)
        collectCoarsePairs(state, level, keep);
    bucketSort(found, finder.foundScratch, finder.start, broad.moving.size(),
               [](const Found& pair) { return pair.first; });
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

/// How far the axes of two colliders are apart, and each end of one from the axis of the other.
struct Distances {
    double least = 0;                   // m; 0 when they cross
    std::array<double, 2> ofA{}, ofB{};  // m
};

/// A margin for the rounding of places that are 1e9 m away.
constexpr double rounding = 1e-6;

/// Whether circles round the axes are so far apart that the colliders cannot be within `reach`.
bool circlesApart(const Point& a, const Point& halfOfA, const Point& b, const Point& halfOfB,
                  double reach) {
    const double most = reach + halfOfA.norm() + halfOfB.norm() + rounding;
    return (b + halfOfB - a - halfOfA).squaredNorm() > most * most;
}

/// The distances of two colliders as they were rasterised, unless they are clearly further apart
/// than `reach`.
bool measure(const BroadPhase& broad, const Collider& a, const Collider& b, double reach,
             Distances& d) {
    const auto& x = broad.reference;
    const Point origin = x[a.a];
    const Point a1(0, 0), a2 = x[a.b] - origin, b1 = x[b.a] - origin, b2 = x[b.b] - origin;
    if (circlesApart(a1, a2 / 2, b1, (b2 - b1) / 2, reach)) return false;
    const auto distance = [](const Point& p, const Point& from, const Point& to) {
        return (from + nearestAlong<Point>(p, from, to) * (to - from) - p).norm();
    };
    d.ofA = {distance(a1, b1, b2), distance(a2, b1, b2)};
    d.ofB = {distance(b1, a1, a2), distance(b2, a1, a2)};
    d.least = segmentsCross(a1, a2, b1, b2) ? 0 : std::min({d.ofA[0], d.ofA[1], d.ofB[0], d.ofB[1]});
    return true;
}

/// Adds the candidate of an end of one collider against another one, `distance` apart, if it can
/// touch before anything leaves its skin.
void watchEnd(State& state, std::uint32_t particle, std::uint32_t collider, double distance) {
    BroadPhase& broad = state.broad;
    const Collider& c = broad.collider(collider);
    const Real thickness = state.particles.reach[particle] + c.radius;
    // What is fast may be stopped up to half of its thickness before it touches.
    const Real reach = Real(1.5) * thickness + broad.skin[particle] + skinOf(broad, c);
    if (distance > static_cast<double>(reach) + rounding) return;
    if (areLinked(broad, particle, c.body) || belongsTogether(state, particle, c)) return;
    // A thousandth for rounding.
    const Real needed = Real(1.001) * thickness + broad.watchedGap(thickness);
    broad.watches.push_back({{particle, collider},
                             c.a,
                             c.b,
                             static_cast<Real>(distance - static_cast<double>(needed))});
}

void watchPair(State& state, const Found& pair) {
    BroadPhase& broad = state.broad;
    const Collider &a = broad.collider(pair.first), &b = broad.collider(pair.second);
    const Real radii = a.radius + b.radius;
    const Real skins = skinOf(broad, a) + skinOf(broad, b);
    // Ends may be thicker than the capsule that ends there.
    const auto reachOf = [&](const Collider& c) {
        return std::max({c.radius, state.particles.reach[c.a], state.particles.reach[c.b]});
    };
    const Real most = Real(1.5) * (reachOf(a) + reachOf(b)) + skins;
    Distances d;
    if (!measure(broad, a, b, static_cast<double>(most), d)) return;
    if (d.least <= static_cast<double>(radii + skins) + rounding)
        broad.pairs.push_back({pair.first, pair.second,
                               static_cast<Real>(d.least - static_cast<double>(radii))});
    watchEnd(state, a.a, pair.second, d.ofA[0]);
    if (a.b != a.a) watchEnd(state, a.b, pair.second, d.ofA[1]);
    watchEnd(state, b.a, pair.first, d.ofB[0]);
    if (b.b != b.a) watchEnd(state, b.b, pair.first, d.ofB[1]);
}

/// Joins neighbours that have the same key (two numbers) into runs.
template <class Item, class KeyOf>
void collectRuns(const std::vector<Item>& items, std::vector<WatchRun>& runs, KeyOf&& keyOf) {
    runs.clear();
    for (std::uint32_t k = 0; k < items.size(); ++k) {
        const auto [one, other] = keyOf(items[k]);
        if (runs.empty() || runs.back().one != one || runs.back().other != other)
            runs.push_back({k, k, one, other, items[k].spare});
        runs.back().last = k + 1;
        runs.back().spare = std::min(runs.back().spare, items[k].spare);
    }
}

}  // namespace

void findPairs(State& state) {
    thread_local Finder finder;
    BroadPhase& broad = state.broad;
    collectFound(state, finder);
    broad.pairs.clear();
    broad.watches.clear();
    for (const Found& pair : finder.found)
        if (mayTouch(state, broad.collider(pair.first).body, broad.collider(pair.second).body))
            watchPair(state, pair);
    bucketSort(broad.watches, finder.watchScratch, finder.start, state.particles.size(),
               [](const Watch& w) { return w.candidate.particle; });
    const auto same = [](const Watch& p, const Watch& q) { return p.candidate == q.candidate; };
    broad.watches.erase(std::unique(broad.watches.begin(), broad.watches.end(), same),
                        broad.watches.end());
    const auto bodyOf = [&](std::uint32_t collider) { return broad.collider(collider).body; };
    collectRuns(broad.watches, broad.watchRuns, [&](const Watch& w) {
        return std::pair(w.candidate.particle, bodyOf(w.candidate.collider));
    });
    collectRuns(broad.pairs, broad.pairRuns, [&](const WatchedPair& pair) {
        return std::pair(bodyOf(pair.first), bodyOf(pair.second));
    });
}

void measureOutings(const State& state, const std::vector<Vec2>& displacements, Outings& outings) {
    const Particles& p = state.particles;
    auto& [ofParticle, ofBody] = outings;
    ofParticle.resize(p.size(), 0);
    ofBody.assign(state.bodies.size(), 0);
    for (const Range range : state.work.awake)
        for (auto i = range.first; i < range.last; ++i) {
            ofParticle[i] = (p.position[i] - state.broad.reference[i]).cast<Real>().norm() +
                            displacements[i].norm();
            Real& most = ofBody[p.body[i]];
            most = std::max(most, ofParticle[i]);
        }
    for (const auto& [one, other] : state.broad.tied)
        ofBody[one] = ofBody[other] = std::max(ofBody[one], ofBody[other]);
}

}  // namespace sulfur::detail
