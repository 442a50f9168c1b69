#include "solver/areas.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/counting_sort.hpp"
#include "core/pieces.hpp"
#include "core/settings.hpp"
#include "kernels/area_look.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

constexpr Real leastShare = Real(tuned::leastShare);
constexpr Real watchedShare = Real(tuned::watchedShare);
constexpr Real recoveredShare = Real(tuned::recoveredShare);
constexpr Real givenShare = Real(tuned::givenShare);
constexpr Real recoveryShare = Real(tuned::recoveryShare);
constexpr Real recoverySpeed = Real(tuned::recoverySpeed);
constexpr Real mostRecoverySpeed = Real(tuned::mostRecoverySpeed);

/// In a microsecond: blocks of triangles that are looked at, triangles that are pressed anew,
/// pushed, led back.
constexpr std::size_t seenInMicrosecond = 130, pressedInMicrosecond = 50, pushedInMicrosecond = 100,
                      ledInMicrosecond = 60;

using Slopes = std::array<Vec2, 3>;

/// By how much each corner's displacement changes twice the area.
Slopes slopesOf(const Vec2& toB, const Vec2& toC) {
    const Vec2 b(toC[1], -toC[0]), c(-toB[1], toB[0]);
    return {-b - c, b, c};
}

/// What a push along `by` of all corners does to the area whose slopes are `slopes`. Corners in one
/// rigid component feel each other's push.
template <bool held>
[[gnu::always_inline]] inline Real response(const State& state, const PressedTriangle& t,
                                            const Slopes& by, const Slopes& slopes) {
    Real sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Grip& at = t.corners[i];
        if (!held || at.cluster == none) {
            sum += t.inverseMass[i] * by[i].dot(slopes[i]);
            continue;
        }
        const Cluster& c = state.clusters.list[at.cluster];
        for (std::size_t k = 0; k < 3; ++k)
            if (t.corners[k].cluster == at.cluster)
                sum += c.inverseMass * by[i].dot(slopes[k]) +
                       c.inverseInertia * cross(at.arm, by[i]) * cross(t.corners[k].arm, slopes[k]);
    }
    return sum;
}
Real response(const State& state, const PressedTriangle& t, const Slopes& by,
              const Slopes& slopes) {
    return t.held ? response<true>(state, t, by, slopes) : response<false>(state, t, by, slopes);
}

/// A triangle that is pressed from now on.
void press(const State& state, const Triangle& t, PressedTriangle& pressed) {
    const Particles& p = state.particles;
    pressed.corners = {gripOf(state, t.a), gripOf(state, t.b), gripOf(state, t.c)};
    for (std::size_t i = 0; i < 3; ++i) {
        pressed.inverseMass[i] = p.inverseMass[pressed.corners[i].particle];
        pressed.held |= pressed.corners[i].cluster != none;
    }
    pressed.startB = (p.position[t.b] - p.position[t.a]).cast<Real>();
    pressed.startC = (p.position[t.c] - p.position[t.a]).cast<Real>();
    pressed.slopes = slopesOf(pressed.startB, pressed.startC);
    pressed.rest = t.rest;
    const Real area = cross(pressed.startB, pressed.startC);
    pressed.least = std::min(leastShare * t.rest, area < 0 ? area - givenShare * t.rest : area);
    pressed.response = response(state, pressed, pressed.slopes, pressed.slopes);
}

/// Where the sides from a have come to.
template <bool held>
[[gnu::always_inline]] inline std::array<Vec2, 2> sidesOf(const State& state,
                                                          const PressedTriangle& t) {
    const auto moved = [&](std::size_t i) {
        const Grip& corner = t.corners[i];
        return held ? displacementOf(state, corner) : state.particles.displacement[corner.particle];
    };
    const Vec2 a = moved(0);
    return {t.startB + (moved(1) - a), t.startC + (moved(2) - a)};
}
std::array<Vec2, 2> sidesOf(const State& state, const PressedTriangle& t) {
    return t.held ? sidesOf<true>(state, t) : sidesOf<false>(state, t);
}

template <bool held>
void pushCorners(State& state, const PressedTriangle& t, Real by, const Slopes& slopes) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 impulse = by * slopes[i];
        if (held)
            push(state, t.corners[i], impulse);
        else
            state.particles.displacement[t.corners[i].particle] += t.inverseMass[i] * impulse;
    }
}

/// An inequality on displacements (position based dynamics, Mueller et al. 2007). It pushes along
/// the slopes of the tick's start, as rigid joints do, which keeps angular momentum. What has
/// turned so far that this widens it less than half as well as its slopes of now waits for the next
/// step.
template <bool held>
void solveArea(State& state, PressedTriangle& t) {
    const auto [toB, toC] = sidesOf<held>(state, t);
    const Real lacks = t.least - cross(toB, toC);
    if (lacks <= 0 && t.lambda <= 0) return;
    const Slopes now = slopesOf(toB, toC);
    const Real best = response<held>(state, t, now, now);
    const Real along = response<held>(state, t, t.slopes, now);
    // (Compared as squares, which takes no root.)
    if (!(along > 0 && along * along > Real(0.25) * (best * t.response))) return;
    const Real before = t.lambda;
    t.lambda = std::max<Real>(before + lacks / along, 0);
    pushCorners<held>(state, t, t.lambda - before, t.slopes);
}

/// Finds out whether a triangle is to be led back, along the slopes to which the tick leads.
void startRecovery(const State& state, PressedTriangle& t) {
    const auto [toB, toC] = sidesOf(state, t);
    const Real lacks = recoveredShare * t.rest - cross(toB, toC);
    // (Less is rounding, and what sweeps leave.)
    if (!(lacks > Real(0.01) * t.rest)) return;
    t.slopes = slopesOf(toB, toC);
    t.response = response(state, t, t.slopes, t.slopes);
    if (!(t.response > 0)) return;
    const Real most = recoverySpeed * state.h * std::sqrt(t.rest);
    t.rise = std::min(lacks * recoveryShare, most);
    t.lambda = 0;
    t.led = true;
}

template <bool held>
void recover(State& state, PressedTriangle& t) {
    auto& shifts = state.particles.shift;
    Real risen = 0;
    for (std::size_t i = 0; i < 3; ++i)
        risen +=
            t.slopes[i].dot(held ? shiftOf(state, t.corners[i]) : shifts[t.corners[i].particle]);
    const Real before = t.lambda;
    t.lambda = std::max<Real>(before + (t.rise - risen) / t.response, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 impulse = (t.lambda - before) * t.slopes[i];
        if (held)
            shift(state, t.corners[i], impulse);
        else
            shifts[t.corners[i].particle] += t.inverseMass[i] * impulse;
    }
}

/// The pressed triangles of some bodies.
struct Share {
    std::uint32_t first = 0, last = std::numeric_limits<std::uint32_t>::max();  // particles

    bool has(const PressedTriangle& t) const {
        const auto particle = t.corners[0].particle;
        return particle >= first && particle < last;
    }
};

/// Calls f(Share) for shares of the pressed triangles, at once: triangles of two bodies have no
/// corner in common, and those of one body keep their order.
template <class Function>
void inShares(State& state, std::size_t inMicrosecond, Function&& f) {
    constexpr std::size_t mostShares = 16;
    const Triangles& triangles = state.triangles;
    const std::size_t count = triangles.pressed.size();
    // (Rigid components may be parts of several bodies.)
    const std::size_t pieces =
        triangles.anyHeld ? 1 : std::min(mostShares, piecesOf(state.tasks, count, inMicrosecond));
    if (pieces == 1) return f(Share{});
    // They come in turns, one of each body, so that some tell where the bodies of most are.
    std::array<std::uint32_t, 4 * mostShares> sample{};
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const auto& triangle = triangles.pressed[i * count / sample.size()];
        const auto body = state.particles.body[triangle.corners[0].particle];
        sample[i] = state.bodies[body].firstParticle;
    }
    std::sort(sample.begin(), sample.end());
    const auto begin = [&](std::size_t i) { return sample[pieceStart(i, pieces, sample.size())]; };
    runPieces(state.tasks, pieces, [&](std::size_t i) {
        Share share;
        if (i > 0) share.first = begin(i);
        if (i + 1 < pieces) share.last = begin(i + 1);
        f(share);
    });
}

/// Twice the area to which the displacements so far lead a triangle that a rigid component holds.
/// (The kernel looks at all others.)
Real areaAhead(const State& state, const Triangle& t) {
    const Particles& p = state.particles;
    const auto moved = [&](std::uint32_t i) { return displacementOf(state, gripOf(state, i)); };
    const Vec2 a = moved(t.a);
    const auto way = [&](std::uint32_t to) {
        return Vec2((p.position[to] - p.position[t.a]).cast<Real>() + (moved(to) - a));
    };
    return cross(way(t.b), way(t.c));
}

AreaView viewOf(State& state) {
    const Particles& p = state.particles;
    AwakeTriangles& t = state.triangles.awake;
    return {p.position.data()->data(),
            p.displacement.data()->data(),
            t.a.data(),
            t.b.data(),
            t.c.data(),
            t.rest.data(),
            t.flat.data()};
}

/// Notes of the triangles in some blocks which ones the displacements so far lead to less than a
/// share of their area.
void noteFlat(State& state, Real share, std::size_t firstBlock, std::size_t lastBlock) {
    areaKernels().look(viewOf(state), share, firstBlock, lastBlock);
    AwakeTriangles& awake = state.triangles.awake;
    auto held = std::lower_bound(awake.held.begin(), awake.held.end(), firstBlock * sweepLanes);
    for (; held != awake.held.end() && *held < lastBlock * sweepLanes; ++held) {
        const Triangle t = awake[*held];
        const auto bit = static_cast<std::uint8_t>(1u << *held % sweepLanes);
        std::uint8_t& flat = awake.flat[*held / sweepLanes];
        flat = areaAhead(state, t) >= share * t.rest ? flat & ~bit : flat | bit;
    }
}

/// A triangle that is pressed anew.
struct Found {
    std::uint32_t triangle = 0, turn = 0;  // among those of its body
};
using FoundTriangles = std::pmr::vector<Found>;

/// Orders triangles, which come body by body, so that the first of each body come first, then the
/// second ones, and so on: those of one body keep their order and wait for each other, those of
/// several do not.
void interleave(State& state, FoundTriangles& triangles) {
    std::uint32_t body = none, next = 0, most = 0;
    for (Found& found : triangles) {
        const auto owner = state.particles.body[state.triangles.awake[found.triangle].a];
        next = owner == std::exchange(body, owner) ? next + 1 : 0;
        most = std::max(most, next);
        found.turn = next;
    }
    FoundTriangles scratch(&state.arena);
    std::pmr::vector<std::uint32_t> start(&state.arena);
    countingSort(triangles, scratch, start, most + 1, [](const Found& f) { return f.turn; });
}

/// Finds the triangles that are pressed anew where the displacements so far lead to less than a
/// share of their area.
FoundTriangles findPressed(State& state, Real share) {
    FoundTriangles found(&state.arena);
    AwakeTriangles& awake = state.triangles.awake;
    inPieces(state.tasks, awake.blocks(), seenInMicrosecond,
             [&](std::size_t first, std::size_t last) { noteFlat(state, share, first, last); });
    for (std::size_t block = 0; block < awake.blocks(); ++block) {
        std::uint32_t fresh = awake.flat[block] & ~awake.pressed[block];
        for (; fresh != 0; fresh &= fresh - 1) {
            const auto i = block * sweepLanes + static_cast<std::size_t>(std::countr_zero(fresh));
            if (i < awake.count) found.push_back({static_cast<std::uint32_t>(i)});
        }
        awake.pressed[block] |= awake.flat[block];
    }
    // (Rigid components may be parts of several bodies.)
    if (awake.held.empty()) interleave(state, found);
    return found;
}

/// Adds the triangles that the displacements so far lead to less than a share of their area.
void pressBelow(State& state, Real share) {
    Triangles& triangles = state.triangles;
    if (triangles.awake.count == 0) return;
    const FoundTriangles found = findPressed(state, share);
    const std::size_t before = triangles.pressed.size();
    triangles.pressed.resize(before + found.size());
    inPieces(
        state.tasks, found.size(), pressedInMicrosecond, [&](std::size_t first, std::size_t last) {
            for (auto k = first; k < last; ++k)
                press(state, triangles.awake[found[k].triangle], triangles.pressed[before + k]);
        });
    triangles.anyHeld |=
        std::any_of(triangles.pressed.begin() + static_cast<std::ptrdiff_t>(before),
                    triangles.pressed.end(), [](const PressedTriangle& t) { return t.held; });
}

}  // namespace

void startAreas(State& state) {
    Triangles& triangles = state.triangles;
    if (!triangles.pressed.empty()) {
        triangles.pressed.clear();
        std::fill(triangles.awake.pressed.begin(), triangles.awake.pressed.end(), std::uint8_t{0});
    }
    triangles.anyHeld = false;
    pressBelow(state, watchedShare);
}

void solveAreas(State& state) {
    inShares(state, pushedInMicrosecond, [&](const Share& share) {
        for (PressedTriangle& t : state.triangles.pressed)
            if (share.has(t)) t.held ? solveArea<true>(state, t) : solveArea<false>(state, t);
    });
}

namespace {

Vec2 shortened(const Vec2& v, Real most) {
    const Real length = v.norm();
    return length > most ? Vec2(most / length * v) : v;
}

/// Moves what the grip holds by what was added up for it, within a bound of speed.
void applyRecovery(State& state, const Grip& grip) {
    const Real most = mostRecoverySpeed * state.h;
    if (grip.cluster != none) {
        Cluster& c = state.clusters.list[grip.cluster];
        const double turn = static_cast<double>(most) / c.reach;
        c.shift = shortened(c.shift, most);
        c.twist = std::clamp(c.twist, -turn, turn);
        return;
    }
    Vec2& shift = state.particles.shift[grip.particle];
    state.particles.position[grip.particle] += shortened(shift, most).cast<double>();
    shift = Vec2(0, 0);
}

}  // namespace

void recoverAreas(State& state) {
    if (state.triangles.pressed.empty()) return;
    inShares(state, ledInMicrosecond, [&](const Share& share) {
        auto& pressed = state.triangles.pressed;
        for (PressedTriangle& t : pressed)
            if (share.has(t)) startRecovery(state, t);
        for (int sweep = 0; sweep < state.settings.sweeps; ++sweep)
            for (PressedTriangle& t : pressed)
                if (share.has(t) && t.led)
                    t.held ? recover<true>(state, t) : recover<false>(state, t);
        for (const PressedTriangle& t : pressed) {
            if (!share.has(t) || !t.led) continue;
            for (const Grip& grip : t.corners) applyRecovery(state, grip);
            // It must not fall asleep as it is.
            state.bodies[state.particles.body[t.corners[0].particle]].restingTime = 0;
        }
    });
}

}  // namespace sulfur::detail
