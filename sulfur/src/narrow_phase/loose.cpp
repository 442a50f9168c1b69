// Two segments that do not cross are closest at an end of one of them, so that corners before sides
// are all that can touch. A corner counts
// - before a side, where the foot of its perpendicular is between the ends;
// - before a corner, where each is the nearest point of all capsules that end in the other;
// each at the moment at which the two come to touch in this step, as far as is predicted. So what
// is fast meets what is in its way, and seams of a floor make no bump. An outline pushes outwards
// only: what is inside leaves through the nearest side.
#include "narrow_phase/loose.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/settings.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"

namespace sulfur::detail {

namespace {

constexpr Real togetherWithin = Real(tuned::togetherWithin);
/// Where a corner has a row already, whose refresh tells when it leaves what it is before, another
/// one may come so much too late.
constexpr Real held = Real(tuned::seam);

struct Xy {
    Real x = 0, y = 0;
};
Xy operator-(Xy a, Xy b) {
    return {a.x - b.x, a.y - b.y};
}
Xy operator*(Real s, Xy a) {
    return {s * a.x, s * a.y};
}
Real dot(Xy a, Xy b) {
    return a.x * b.x + a.y * b.y;
}
Real cross(Xy a, Xy b) {
    return a.x * b.y - a.y * b.x;
}
Real norm(Xy a) {
    return std::sqrt(dot(a, a));
}
Xy at(const CornerWay& c) {
    return {c.x, c.y};
}

/// Calls f(number) for each bit that is set, the lowest first.
template <class Function>
void forEachBit(std::uint32_t bits, Function&& f) {
    for (; bits != 0; bits &= bits - 1) f(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

// --- who may touch whom ---------------------------------------------------------------------

std::uint32_t denseParticle(const State& state, std::uint32_t corner) {
    return state.particleSlots.denseOf(state.core.shapes.corners[corner].particle);
}
bool isTied(const State& state, std::uint32_t corner, std::uint32_t body) {
    const auto& linked = state.core.linked;
    return !linked.empty() &&
           std::binary_search(linked.begin(), linked.end(),
                              std::pair(state.core.shapes.corners[corner].particle, body));
}
/// Whether a corner never touches a side (or, where both ends are the same, a corner).
bool isBarred(const State& state, std::uint32_t corner, std::uint32_t sideA, std::uint32_t sideB,
              std::uint32_t body, Real radius) {
    const auto& corners = state.core.shapes.corners;
    const Corner &p = corners[corner], &a = corners[sideA], &b = corners[sideB];
    if (p.particle == a.particle || p.particle == b.particle) return true;
    if (p.mover == a.mover || p.mover == b.mover) return true;
    const auto i = denseParticle(state, corner);
    if (isTied(state, corner, body)) return true;
    const auto own = state.bodies[state.particles.body[i]].id.index - 1;
    if (isTied(state, sideA, own) && isTied(state, sideB, own)) return true;
    if (own != body) return false;
    const auto& rest = state.particles.rest;
    const Vec2 from = rest[denseParticle(state, sideA)], to = rest[denseParticle(state, sideB)];
    const Vec2 along = to - from, v = rest[i] - from;
    const Real length2 = along.squaredNorm();
    const Real t = length2 > 0 ? std::clamp(v.dot(along) / length2, Real(0), Real(1)) : Real(0);
    return (v - t * along).norm() < togetherWithin * (p.radius + radius);
}

class Looker {
public:
    Looker(const State& state, const Chunk& a, const Chunk& b, const std::vector<KnownSide>& known,
           LooseLook& result)
        : state_(state),
          shapes_(state.core.shapes),
          movers_(state.core.movers),
          a_(a),
          b_(b),
          known_(known),
          result_(result) {
        origin_ = movers_.placeAtReference(shapes_.corners[a.firstCorner].mover);
        finest_ = a.fineness + b.fineness;
        mayBar_ = a.body == b.body || !state.core.linked.empty();
    }

    void run() {
        result_.near.clear();
        spare_ = entrance_ = result_.gap = lookedAway;
        place(a_, result_.a);
        ChunkLanes& other = &a_ == &b_ ? result_.a : result_.b;
        if (&a_ != &b_) place(b_, other);
        extentA_ = extentOf(a_, result_.a.corners);
        extentB_ = extentOf(b_, other.corners);
        againstSides(a_, result_.a, b_, other, extentB_);
        if (&a_ != &b_) againstSides(b_, other, a_, result_.a, extentA_);
        againstCorners(result_.a, other);
        result_.slack =
            std::min(entrance_, std::max(spare_ - Real(0.25) * finest_, Real(0.25) * finest_));
    }

private:
    static void put(CornerLanes& lanes, std::uint32_t k, const CornerWay& w) {
        lanes.x[k] = w.x;
        lanes.y[k] = w.y;
        lanes.wayX[k] = w.wayX;
        lanes.wayY[k] = w.wayY;
    }
    static CornerWay taken(const CornerLanes& lanes, std::uint32_t k) {
        return {lanes.x[k], lanes.y[k], lanes.wayX[k], lanes.wayY[k]};
    }

    void place(const Chunk& chunk, ChunkLanes& lanes) const {
        SpokedCorners& corners = lanes.corners;
        corners.count = chunk.corners;
        corners.mostSpokes = lanes.owned = 0;
        for (std::uint32_t k = 0; k < chunk.corners; ++k) {
            const Corner& corner = shapes_.corners[chunk.firstCorner + k];
            put(corners.at, k, wayOf(chunk.firstCorner + k));
            corners.radius[k] = corner.radius;
            lanes.owned |= corner.owned << k;
            if (corner.owned) corners.mostSpokes = std::max(corners.mostSpokes, corner.spokes);
        }
        placeSpokes(chunk, lanes);
        SideLanes& sides = lanes.sides;
        sides.count = chunk.sides;
        lanes.discs = lanes.twoSided = 0;
        for (std::uint32_t k = 0; k < chunk.sides; ++k) {
            const Side& side = shapes_.sides[chunk.firstSide + k];
            put(sides.a, k, taken(corners.at, side.a - chunk.firstCorner));
            put(sides.b, k, taken(corners.at, side.b - chunk.firstCorner));
            sides.radius[k] = side.radius;
            sides.outward[k] = static_cast<Real>(side.outward);
            lanes.discs |= (side.a == side.b ? 1u : 0u) << k;
            lanes.twoSided |= (side.outward == 0 ? 1u : 0u) << k;
        }
    }
    void placeSpokes(const Chunk& chunk, ChunkLanes& lanes) const {
        SpokedCorners& corners = lanes.corners;
        if (lanes.spokes.size() < corners.mostSpokes) lanes.spokes.resize(corners.mostSpokes);
        corners.spokes = lanes.spokes.data();
        for (std::uint32_t s = 0; s < corners.mostSpokes; ++s)
            for (std::uint32_t k = 0; k < chunk.corners; ++k) {
                const Corner& corner = shapes_.corners[chunk.firstCorner + k];
                const auto end = s < corner.spokes ? shapes_.spokes[corner.firstSpoke + s]
                                                   : chunk.firstCorner + k;
                const auto own = end - chunk.firstCorner;
                put(lanes.spokes[s], k, own < chunk.corners ? taken(corners.at, own) : wayOf(end));
            }
    }
    /// Where the corners of a chunk are, and how they go.
    struct Extent {
        Xy low{Real(1e30), Real(1e30)}, high{Real(-1e30), Real(-1e30)};
        Xy least{Real(1e30), Real(1e30)}, most{Real(-1e30), Real(-1e30)};
        Real radius = 0;
    };
    static Extent extentOf(const Chunk& chunk, const SpokedCorners& corners) {
        Extent e;
        e.radius = chunk.radius;
        for (std::uint32_t k = 0; k < corners.count; ++k) {
            const CornerWay c = taken(corners.at, k);
            e.low = {std::min(e.low.x, c.x), std::min(e.low.y, c.y)};
            e.high = {std::max(e.high.x, c.x), std::max(e.high.y, c.y)};
            e.least = {std::min(e.least.x, c.wayX), std::min(e.least.y, c.wayY)};
            e.most = {std::max(e.most.x, c.wayX), std::max(e.most.y, c.wayY)};
        }
        return e;
    }
    /// Whether a corner is so far from all of a chunk that it changes nothing of the result.
    bool isBeyond(const CornerWay& p, Real radius, const Extent& other) const {
        const Real far = std::max(
            {other.low.x - p.x, p.x - other.high.x, other.low.y - p.y, p.y - other.high.y});
        const Real closing = std::max(p.wayX - other.least.x, other.most.x - p.wayX) +
                             std::max(p.wayY - other.least.y, other.most.y - p.wayY);
        const Real thickness = radius + other.radius;
        return far - thickness > std::max({nearFrom(thickness, closing), spare_, result_.gap});
    }
    /// Its corners that are held off others and not beyond all of another chunk.
    std::uint32_t within(const ChunkLanes& own, const Extent& other) const {
        std::uint32_t found = 0;
        forEachBit(own.owned, [&](std::uint32_t k) {
            const bool beyond = isBeyond(taken(own.corners.at, k), own.corners.radius[k], other);
            found |= (beyond ? 0u : 1u) << k;
        });
        return found;
    }
    /// m: what comes nearer than that in a step may count.
    static Real nearFrom(Real thickness, Real closing) {
        return Real(0.5) * thickness + 2 * closing;
    }

    CornerWay wayOf(std::uint32_t corner) const {
        const Corner& c = shapes_.corners[corner];
        const SolverBody& body = movers_.bodies[c.mover];
        const Reference& from = movers_.references[c.mover];
        const Motion3 motion = motionNow(movers_, c.mover);
        CornerWay w{static_cast<Real>(from.x - origin_[0]) + body.x,
                    static_cast<Real>(from.y - origin_[1]) + body.y, motion.x, motion.y};
        if (c.x == 0 && c.y == 0) return w;
        const Heading h = headingNow(movers_, c.mover);
        const Xy arm{h.cosine * c.x - h.sine * c.y, h.sine * c.x + h.cosine * c.y};
        return {w.x + arm.x, w.y + arm.y, w.wayX - motion.turn * arm.y,
                w.wayY + motion.turn * arm.x};
    }

    /// Between two bodies that nothing ties everything may touch.
    bool bars(std::uint32_t corner, std::uint32_t sideA, std::uint32_t sideB, Real radius,
              const Chunk& other) const {
        return mayBar_ && isBarred(state_, corner, sideA, sideB, other.body, radius);
    }

    // --- corners before sides ----------------------------------------------------------------

    void againstSides(const Chunk& own, const ChunkLanes& corners, const Chunk& other,
                      ChunkLanes& lanes, const Extent& extent) {
        forEachBit(corners.owned, [&](std::uint32_t k) {
            const CornerWay p = taken(corners.corners.at, k);
            const Real radius = corners.corners.radius[k];
            if (!isBeyond(p, radius, extent))
                againstSides(own.firstCorner + k, p, radius, other, lanes);
        });
    }

    void againstSides(std::uint32_t corner, const CornerWay& p, Real radius, const Chunk& other,
                      ChunkLanes& lanes) {
        forEachBit(lanes.twoSided, [&](std::uint32_t k) {
            lanes.sides.outward[k] = static_cast<Real>(sideSoFar(corner, other.firstSide + k));
        });
        const auto every = static_cast<std::uint32_t>((std::uint64_t{1} << other.sides) - 1);
        SidesSeen& seen = result_.sidesSeen;
        kernels_.sides(p, radius, lanes.sides, every & ~lanes.discs & ~barred(corner, other), seen);
        result_.gap = std::min(result_.gap, seen.gap);
        spare_ = std::min(spare_, seen.spare);
        const auto nearest = seen.nearest;
        if (nearest == mostOfChunk) return;
        const bool oneSided = (lanes.twoSided >> nearest & 1) == 0;
        if (oneSided && -seen.height[nearest] > radius) {
            enter(seen.enter, false);
            // What is part of an outline is behind most of its sides, and not in it.
            if (movers_.body[shapes_.corners[corner].mover] != other.body)
                leaveThroughNearest(corner, at(p), other);
            return;
        }
        // Behind the nearest side, it counts before that alone.
        const bool behind = (seen.before >> nearest & 1) != 0 && seen.height[nearest] < 0;
        forEachBit(seen.before, [&](std::uint32_t k) {
            if (behind ? k == nearest : !(seen.height[k] < 0))
                result_.near.push_back({corner, other.firstSide + k, 0,
                                        static_cast<std::int32_t>(seen.outward[k]), seen.far[k]});
        });
        enter(seen.enter, seen.before != 0);
    }

    /// The sides of a chunk that a corner never touches.
    std::uint32_t barred(std::uint32_t corner, const Chunk& other) const {
        std::uint32_t found = 0;
        if (!mayBar_) return found;
        for (std::uint32_t k = 0; k < other.sides; ++k) {
            const Side& side = shapes_.sides[other.firstSide + k];
            const bool bar = side.a != side.b && bars(corner, side.a, side.b, side.radius, other);
            found |= (bar ? 1u : 0u) << k;
        }
        return found;
    }

    std::int32_t sideSoFar(std::uint32_t corner, std::uint32_t side) const {
        for (const KnownSide& k : known_)
            if (k.corner == corner && k.side == side) return k.outward;
        return 0;
    }

    /// Something that is near comes before a side or a corner, and touches it, after so many metres
    /// at the earliest, counted from where it is: nobody knows whether it goes as is predicted.
    /// `isHeld`: it has a row, whose refresh tells when it leaves what it is before.
    void enter(Real after, bool isHeld) {
        entrance_ = std::min(entrance_, std::max(after, isHeld ? held * finest_ : Real(0)));
    }
    bool isHeld(std::uint32_t corner) const {
        return std::any_of(result_.near.begin(), result_.near.end(),
                           [&](const Nearness& n) { return n.corner == corner; });
    }

    /// Deep in a body a corner counts before the nearest side of all its outline, if that is of
    /// this chunk.
    void leaveThroughNearest(std::uint32_t corner, Xy p, const Chunk& other) {
        Real nearest = Real(1e30);
        std::uint32_t nearestSide = none;
        int turns = 0;
        forEachOutlineSide(other.body, [&](std::uint32_t s, Xy a, Xy b, const Side& side) {
            const Xy along = b - a, from = p - a;
            // Walking with the body to the left.
            const bool forth = side.outward > 0;
            const Xy u = forth ? a : b, v = forth ? b : a;
            const bool above = u.y > p.y;
            if (above != (v.y > p.y)) {
                const Real turn = cross(v - u, p - u);
                if (above ? turn < 0 : turn > 0) turns += above ? -1 : 1;
            }
            const Real length2 = dot(along, along);
            if (!(length2 > 0)) return;
            const Real share = std::clamp<Real>(dot(from, along) / length2, 0, 1);
            const Real far = norm(from - share * along);
            if (far < nearest) {
                nearest = far;
                nearestSide = s;
            }
        });
        // Who is outside comes in through a side, of this chunk or of another.
        const Real within = turns <= 0 ? nearest : 0;
        entrance_ = std::min(entrance_, std::max(within, Real(0.25) * finest_));
        if (turns <= 0 || nearestSide == none) return;
        if (nearestSide < other.firstSide || nearestSide >= other.firstSide + other.sides) return;
        result_.near.push_back(
            {corner, nearestSide, 0, shapes_.sides[nearestSide].outward, nearest});
    }
    template <class Function>
    void forEachOutlineSide(std::uint32_t body, Function&& f) const {
        for (auto c = shapes_.firstChunk[body]; c != none; c = shapes_.chunks[c].nextOfBody) {
            const Chunk& chunk = shapes_.chunks[c];
            for (auto s = chunk.firstSide; s < chunk.firstSide + chunk.sides; ++s) {
                const Side& side = shapes_.sides[s];
                if (side.outward != 0 && side.a != side.b)
                    f(s, at(wayOf(side.a)), at(wayOf(side.b)), side);
            }
        }
    }

    // --- corners before corners ---------------------------------------------------------------

    void againstCorners(const ChunkLanes& a, const ChunkLanes& b) {
        const std::uint32_t reachable = within(a, extentB_);
        std::uint32_t taken = 0;
        for (auto s = b_.firstSide; s < b_.firstSide + b_.sides; ++s) {
            const Side& side = shapes_.sides[s];
            for (const auto& [corner, end] : {std::pair(side.a, 1u), std::pair(side.b, 2u)}) {
                // Of the sides of its chunk that end in a corner the first one stands for it.
                const auto k = corner - b_.firstCorner;
                if ((taken >> k & 1) != 0) continue;
                taken |= 1u << k;
                if ((b.owned >> k & 1) != 0) againstCorner(k, s, end, a, b, reachable);
            }
        }
    }

    /// `reachable`: of the other chunk's corners.
    void againstCorner(std::uint32_t number, std::uint32_t side, std::uint32_t end,
                       const ChunkLanes& a, const ChunkLanes& b, std::uint32_t reachable) {
        const auto corner = b_.firstCorner + number;
        if (isBeyond(taken(b.corners.at, number), b.corners.radius[number], extentA_)) return;
        std::uint32_t may = reachable;
        if (&a_ == &b_) may &= (1u << number) - 1;
        if (mayBar_)
            forEachBit(may, [&](std::uint32_t k) {
                if (bars(a_.firstCorner + k, corner, corner, b.corners.radius[number], b_))
                    may &= ~(1u << k);
            });
        if (may == 0) return;
        CornersSeen& seen = result_.cornersSeen;
        kernels_.corners(b.corners, number, a.corners, may, seen);
        result_.gap = std::min(result_.gap, seen.gap);
        spare_ = std::min(spare_, seen.spare);
        forEachBit(seen.near, [&](std::uint32_t k) {
            const auto c = a_.firstCorner + k;
            if ((seen.before >> k & 1) == 0)
                enter(seen.enter[k], isHeld(c) || isHeld(corner));
            else
                result_.near.push_back({c, side, end, 0, seen.far[k]});
        });
    }

    const State& state_;
    const Shapes& shapes_;
    const Movers& movers_;
    const Chunk &a_, &b_;
    const std::vector<KnownSide>& known_;
    LooseLook& result_;
    const LookKernels& kernels_ = lookKernels();
    Point origin_{0, 0};
    Real finest_ = 0;
    bool mayBar_ = true;
    Extent extentA_, extentB_;
    Real spare_ = 0;     // m, to what is farther than what counts
    Real entrance_ = 0;  // m, until something that is as near comes before a side or a corner
};

}  // namespace

bool neverTouches(const State& state, std::uint32_t corner, const Side& side, std::uint32_t body) {
    return isBarred(state, corner, side.a, side.b, body, side.radius);
}

void lookLoosely(const State& state, const Chunk& a, const Chunk& b,
                 const std::vector<KnownSide>& known, LooseLook& result) {
    Looker(state, a, b, known, result).run();
}

}  // namespace sulfur::detail
