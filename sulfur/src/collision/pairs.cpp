#include "collision/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "collision/geometry.hpp"
#include "collision/neighbours.hpp"
#include "collision/skins.hpp"
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

/// A candidate, while they are being collected.
struct Sighting {
    Candidate candidate;
    Real spare = 0;      // m
    Real thickness = 0;  // m
};

/// What one piece of the pairs that are near came to.
struct Watched {
    std::vector<WatchedPair> pairs;
    std::vector<Sighting> sightings;
    std::vector<std::uint32_t> place;  // by particle: how many, then where the next belongs
    Neighbours neighbours;
};

/// Scratch memory only.
struct Finder {
    FoundList found;
    std::vector<Watched> pieces;
    std::vector<std::uint32_t> entries;
    std::vector<WatchedPair> pairs, pairScratch;  // of what has left
    std::vector<Watch> watches, watchScratch;     // likewise
};

double squaredDistance(const Surroundings& axis, const Point& p) {
    const Point offset = p - axis.start;
    const double along = std::clamp(offset.dot(axis.along) * axis.scale, 0.0, 1.0);
    return (along * axis.along - offset).squaredNorm();
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

/// Sees who comes near enough to be a candidate, before anything leaves its skin.
class Lookout {
public:
    Lookout(const State& state, Watched& found)
        : state_(state), broad_(state.broad), found_(found) {
        found.pairs.clear();
        found.sightings.clear();
        found.place.assign(state.particles.size(), 0);
    }

    /// Two colliders that are near each other.
    void see(std::uint32_t i, std::uint32_t j) {
        const Surroundings &a = broad_.surroundings[i], &b = broad_.surroundings[j];
        if (!mayTouch(state_, a.body, b.body)) return;
        const Collider &first = broad_.collider(i), &second = broad_.collider(j);
        seeCrossing(i, j);
        seeEnd(first.a, first, j, second);
        if (first.b != first.a) seeEnd(first.b, first, j, second);
        seeEnd(second.a, second, i, first);
        if (second.b != second.a) seeEnd(second.b, second, i, first);
    }

private:
    /// Axes may come as near as their leeways before they cross.
    void seeCrossing(std::uint32_t i, std::uint32_t j) {
        const Surroundings &a = broad_.surroundings[i], &b = broad_.surroundings[j];
        const double most = static_cast<double>(a.leeway + b.leeway) + rounding;
        if (!areWithin(a, b, most)) return;
        const Point a2 = a.start + a.along, b2 = b.start + b.along;
        const double least = segmentsCross(a.start, a2, b.start, b2)
                                 ? 0
                                 : std::min({squaredDistance(b, a.start), squaredDistance(b, a2),
                                             squaredDistance(a, b.start), squaredDistance(a, b2)});
        if (least > most * most) return;
        const auto spare = static_cast<Real>(std::sqrt(least) * (1 - 1e-6) - rounding);
        found_.pairs.push_back({i, j, a.body, b.body, spare});
    }

    /// Whether a particle is looked at as an end of this collider: where several end in it, the
    /// thickest, whose skin holds it and all that it can touch, so that candidates come once. (The
    /// literal Bresenham line holds nothing for sure; a joint between bodies is of one of them.)
    bool speaksFor(const Collider& c, std::uint32_t particle) const {
        const auto joint = broad_.surface[particle];
        return c.joint == joint || (joint != none && state_.joints.body[joint] == none) ||
               state_.settings.rasterisation == Rasterisation::bresenham;
    }

    /// An end of a collider, and another collider.
    void seeEnd(std::uint32_t particle, const Collider& own, std::uint32_t collider,
                const Collider& c) {
        if (!speaksFor(own, particle)) return;
        const Surroundings& axis = broad_.surroundings[collider];
        const double distance2 = squaredDistance(axis, broad_.reference[particle]);
        const Real thickness = state_.particles.reach[particle] + c.radius;
        // A thousandth for rounding.
        const Real needed = Real(1.001) * thickness + broad_.watchedGap(thickness);
        const Real skin = skinOf(broad_, broad_.step[particle]) + axis.skin;
        const Real most = needed + skin - broad_.baseSkin / 4;
        const double reach = static_cast<double>(most) + rounding;
        if (distance2 > reach * reach) return;
        if (areLinked(broad_, particle, c.body) || belongsTogether(state_, particle, c)) return;
        const Real apart = static_cast<Real>(std::sqrt(distance2) - static_cast<double>(needed));
        found_.sightings.push_back({{particle, collider}, spareOf(apart), thickness});
        ++found_.place[particle];
    }

    const State& state_;
    const BroadPhase& broad_;
    Watched& found_;
};

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

/// Turns numbers of sightings by particles into places in the list of all; those of one particle
/// keep the order of the pieces. Returns how many there are.
std::uint32_t findPlaces(std::span<Watched> pieces) {
    std::uint32_t place = 0;
    for (std::size_t p = 0; p < pieces.front().place.size(); ++p)
        for (Watched& piece : pieces) {
            const auto count = piece.place[p];
            piece.place[p] = place;
            place += count;
        }
    return place;
}

/// Sorts those of each particle by colliders, and keeps each once, where they are not so already.
void mendOrder(std::vector<Watch>& watches) {
    const auto isInOrder = [](const Watch& p, const Watch& q) { return p < q; };
    const auto next = [&](auto from) {
        return std::adjacent_find(from, watches.end(), std::not_fn(isInOrder));
    };
    auto disorder = next(watches.begin());
    if (disorder == watches.end()) return;
    const auto particle = [](const Watch& w) { return w.candidate.particle; };
    for (; disorder != watches.end();) {
        auto first = disorder, last = disorder;
        while (first != watches.begin() && particle(first[-1]) == particle(*disorder)) --first;
        while (last != watches.end() && particle(*last) == particle(*disorder)) ++last;
        std::sort(first, last);
        disorder = next(last);
    }
    const auto same = [](const Watch& p, const Watch& q) { return p.candidate == q.candidate; };
    watches.erase(std::unique(watches.begin(), watches.end(), same), watches.end());
}

/// Makes lists of what was seen, sorted, each once: pairs come in order, and so do the colliders of
/// each particle.
void listSeen(const State& state, std::span<Watched> pieces, std::vector<WatchedPair>& pairs,
              std::vector<Watch>& watches) {
    pairs.clear();
    for (const Watched& piece : pieces)
        pairs.insert(pairs.end(), piece.pairs.begin(), piece.pairs.end());
    watches.resize(findPlaces(pieces));
    runPieces(state.tasks, pieces.size(), [&](std::size_t i) {
        for (const Sighting& s : pieces[i].sightings) {
            const Collider& c = state.broad.collider(s.candidate.collider);
            watches[pieces[i].place[s.candidate.particle]++] = {s.candidate, c.a,     c.b,
                                                                c.body,      s.spare, s.thickness};
        }
    });
    mendOrder(watches);
}

/// What follows from the lists of candidates and pairs.
void listLooks(BroadPhase& broad) {
    collectRuns(broad.pairs, broad.pairRuns,
                [](const WatchedPair& pair) { return std::pair(pair.one, pair.other); });
    broad.watchRunsStale = true;
    Looks& looks = broad.looks;
    looks.forEachArray([&](auto& list) { list.resize(broad.watches.size()); });
    for (std::size_t k = 0; k < broad.watches.size(); ++k) {
        const Watch& w = broad.watches[k];
        looks.particle[k] = w.candidate.particle;
        looks.a[k] = w.a;
        looks.b[k] = w.b;
        looks.spare[k] = w.spare;
        looks.thickness[k] = w.thickness;
        looks.plan[k] = w.plan;
    }
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

/// Lists with room for as much as those of the broad phase have, so that the first tick in which
/// only some of it is drawn again, or most of it is in one piece, takes no memory.
Finder& finder(const BroadPhase& broad) {
    thread_local Finder scratch;
    const std::size_t watches = broad.watches.capacity(), pairs = broad.pairs.capacity();
    scratch.found.reserve(watches);
    scratch.watches.reserve(watches);
    scratch.watchScratch.reserve(watches);
    scratch.pairs.reserve(pairs);
    scratch.pairScratch.reserve(pairs);
    return scratch;
}

/// So many pieces to collect into.
std::span<Watched> piecesFor(const State& state, Finder& finder, std::size_t count) {
    if (finder.pieces.size() < count) finder.pieces.resize(count);
    const std::span<Watched> pieces(finder.pieces.data(), count);
    for (Watched& piece : pieces) {
        piece.sightings.reserve(state.broad.watches.capacity());
        piece.pairs.reserve(state.broad.pairs.capacity());
        piece.place.reserve(state.particles.size());
        piece.neighbours.reserve(state.broad.surroundings.capacity());
    }
    return pieces;
}

void drawSurroundings(State& state) {
    BroadPhase& broad = state.broad;
    broad.surroundings.resize(broad.moving.size() + broad.fixed.size());
    constexpr std::size_t inMicrosecond = 50;
    inPieces(state.tasks, broad.surroundings.size(), inMicrosecond,
             [&](std::size_t begin, std::size_t end) {
                 for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
                     broad.surroundings[i] = surroundingsOf(state, broad.collider(i));
             });
}

}  // namespace

void findPairs(State& state) {
    BroadPhase& broad = state.broad;
    Finder& lists = finder(broad);
    drawSurroundings(state);
    collectCoarsePairs(state, lists.found);
    findEntries(broad, lists.entries);
    constexpr std::size_t collidersInMicrosecond = 1;
    const std::size_t count = broad.moving.size();
    const auto pieces =
        piecesFor(state, lists, piecesOf(state.tasks, count, collidersInMicrosecond));
    runPieces(state.tasks, pieces.size(), [&](std::size_t i) {
        Lookout lookout(state, pieces[i]);
        forEachNeighbour(broad, lists.entries, lists.found.pairs,
                         pieceStart(i, pieces.size(), count),
                         pieceStart(i + 1, pieces.size(), count), pieces[i].neighbours,
                         [&](std::uint32_t a, std::uint32_t b) { lookout.see(a, b); });
    });
    listSeen(state, pieces, broad.pairs, broad.watches);
    broad.plans.clear();
    broad.plansStale = false;
    listLooks(broad);
}

void renewPairs(State& state) {
    BroadPhase& broad = state.broad;
    const Pieces& drawn = broad.pieces;
    for (const auto piece : broad.left)
        for (auto k = drawn.colliderStart[piece]; k < drawn.colliderStart[piece + 1]; ++k)
            broad.surroundings[drawn.colliders[k]] =
                surroundingsOf(state, broad.moving[drawn.colliders[k]]);
    forgetLeft(broad);
    Finder& lists = finder(broad);
    collectPairsOfLeft(state, piecesFor(state, lists, 1).front().neighbours, lists.found);
    constexpr std::size_t pairsInMicrosecond = 20;
    const std::size_t count = lists.found.pairs.size();
    const auto pieces = piecesFor(state, lists, piecesOf(state.tasks, count, pairsInMicrosecond));
    runPieces(state.tasks, pieces.size(), [&](std::size_t i) {
        Lookout lookout(state, pieces[i]);
        for (auto k = pieceStart(i, pieces.size(), count);
             k < pieceStart(i + 1, pieces.size(), count); ++k)
            lookout.see(lists.found.pairs[k].first(), lists.found.pairs[k].second());
    });
    listSeen(state, pieces, lists.pairs, lists.watches);
    mergeInto(broad.pairs, lists.pairs, lists.pairScratch);
    mergeInto(broad.watches, lists.watches, lists.watchScratch);
    listLooks(broad);
    // Those of candidates that are gone are still there.
    if (2 * broad.plans.size() > broad.watches.size()) broad.plansStale = true;
}

const std::vector<WatchRun>& watchRuns(State& state) {
    BroadPhase& broad = state.broad;
    if (broad.watchRunsStale)
        collectRuns(broad.watches, broad.watchRuns, [&](const Watch& w) {
            return std::pair(state.particles.body[w.candidate.particle], w.body);
        });
    broad.watchRunsStale = false;
    return broad.watchRuns;
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
    ofBody.assign(state.bodies.size(), 0);
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
