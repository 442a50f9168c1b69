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

/// Round a collider with its skin and all that may make a contact with it.
struct Circle {
    Point centre{0, 0};  // m
    double radius = 0;   // m
    std::uint32_t body = 0;
    bool meetsItself = false;  // its body
};

/// Scratch memory only.
struct Finder {
    std::vector<Circle> circles;
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

/// A margin for the rounding of places that are 1e9 m away.
constexpr double rounding = 1e-6;

/// The thickest part of a collider: of its ends, where other capsules end too.
Real reachOf(const State& state, const Collider& c) {
    return std::max({c.radius, state.particles.reach[c.a], state.particles.reach[c.b]});
}

/// What is fast may be stopped up to half of its thickness before it touches.
constexpr Real farthestTouch = Real(1.5);  // thicknesses

void drawCircles(const State& state, std::vector<Circle>& circles) {
    const BroadPhase& broad = state.broad;
    const auto& x = broad.reference;
    circles.clear();
    const auto add = [&](const Collider& c) {
        const double around =
            static_cast<double>(farthestTouch * reachOf(state, c) + skinOf(broad, c));
        circles.push_back({(x[c.a] + x[c.b]) / 2, (x[c.b] - x[c.a]).norm() / 2 + around + rounding,
                           c.body, state.bodies[c.body].selfCollision});
    };
    for (const Collider& c : broad.moving) add(c);
    for (const Collider& c : broad.fixed) add(c);
}

/// All that shares a cell and is near, sorted, each pair once.
void collectFound(const State& state, Finder& finder) {
    const BroadPhase& broad = state.broad;
    auto& found = finder.found;
    found.clear();
    const auto keep = [&](std::uint32_t i, std::uint32_t j) {
        const Circle &a = finder.circles[i], &b = finder.circles[j];
        if (a.body == b.body && !a.meetsItself) return;
        const double most = a.radius + b.radius;
        if ((a.centre - b.centre).squaredNorm() > most * most) return;
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

/// A segment from the origin of its frame, ready to be measured from.
struct Axis {
    Axis(const Point& from, const Point& to)
        : start(from), along(to - from), scale(along.squaredNorm()) {
        scale = scale > 0 ? 1 / scale : 0;
    }
    double distance(const Point& p) const {
        const Point offset = p - start;
        return (std::clamp(offset.dot(along) * scale, 0.0, 1.0) * along - offset).norm();
    }
    Point start, along;  // m
    double scale;        // 1/m^2
};

/// The distances of two colliders as they were rasterised.
Distances measure(const BroadPhase& broad, const Collider& a, const Collider& b) {
    const auto& x = broad.reference;
    const Point origin = x[a.a];
    const Point a1(0, 0), a2 = x[a.b] - origin, b1 = x[b.a] - origin, b2 = x[b.b] - origin;
    const Axis axisA(a1, a2), axisB(b1, b2);
    Distances d;
    d.ofA = {axisB.distance(a1), axisB.distance(a2)};
    d.ofB = {axisA.distance(b1), axisA.distance(b2)};
    d.least = segmentsCross(a1, a2, b1, b2) ? 0 : std::min({d.ofA[0], d.ofA[1], d.ofB[0], d.ofB[1]});
    return d;
}

/// Adds the candidate of an end of one collider against another one, `distance` apart, if it can
/// touch before anything leaves its skin.
void watchEnd(State& state, std::uint32_t particle, std::uint32_t collider, double distance) {
    BroadPhase& broad = state.broad;
    const Collider& c = broad.collider(collider);
    const Real thickness = state.particles.reach[particle] + c.radius;
    const Real reach = farthestTouch * thickness + broad.skin[particle] + skinOf(broad, c);
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
    const Distances d = measure(broad, a, b);
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
    drawCircles(state, finder.circles);
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
