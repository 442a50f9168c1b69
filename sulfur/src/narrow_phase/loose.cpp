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
#include "narrow_phase/arc_at.hpp"
#include "narrow_phase/convex.hpp"
#include "narrow_phase/never_touches.hpp"

namespace sulfur::detail {

namespace {

/// Where a corner has a row already, whose refresh tells when it leaves what it is before, another
/// one may come so much too late.
constexpr Real held = Real(tuned::seam);

Xy at(const CornerWay& c) {
    return {c.x, c.y};
}

Xy atEnd(const CornerWay& c) {
    return {c.x + c.wayX, c.y + c.wayY};
}
Xy way(const CornerWay& c) {
    return {c.wayX, c.wayY};
}

constexpr Real reached = Real(1 + tuned::reached);

/// When a height falls to a limit, as a share of the step: 0 if it is there already, 1 if it does
/// not come so far.
Real momentOfHeight(Real start, Real end, Real limit) {
    if (!(start > reached * limit)) return 0;
    return start - end > start - limit ? (start - limit) / (start - end) : 1;
}

/// Calls f(number) for each bit that is set, the lowest first.
template <class Function>
void forEachBit(std::uint32_t bits, Function&& f) {
    for (; bits != 0; bits &= bits - 1) f(static_cast<std::uint32_t>(std::countr_zero(bits)));
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
        centresAgainstSides(a_, result_.a, b_, other);
        if (&a_ != &b_) centresAgainstSides(b_, other, a_, result_.a);
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
        lanes.discs = lanes.arcs = lanes.twoSided = 0;
        for (std::uint32_t k = 0; k < chunk.sides; ++k) {
            const Side& side = shapes_.sides[chunk.firstSide + k];
            put(sides.a, k, taken(corners.at, side.a - chunk.firstCorner));
            put(sides.b, k, taken(corners.at, side.b - chunk.firstCorner));
            sides.radius[k] = side.radius;
            sides.outward[k] = static_cast<Real>(side.outward);
            lanes.discs |= (side.a == side.b ? 1u : 0u) << k;
            lanes.arcs |= (arcRadius(side) > 0 ? 1u : 0u) << k;
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
        return wayAt(c.mover, c.x, c.y);
    }
    /// Of a place in the frame of a mover.
    CornerWay wayAt(std::uint32_t mover, Real x, Real y) const {
        const SolverBody& body = movers_.bodies[mover];
        const Reference& from = movers_.references[mover];
        const Motion3 motion = motionNow(movers_, mover);
        CornerWay w{static_cast<Real>(from.x - origin_[0]) + body.x,
                    static_cast<Real>(from.y - origin_[1]) + body.y, motion.x, motion.y};
        if (x == 0 && y == 0) return w;
        const Heading h = headingNow(movers_, mover);
        const Xy arm{h.cosine * x - h.sine * y, h.sine * x + h.cosine * y};
        return {w.x + arm.x, w.y + arm.y, w.wayX - motion.turn * arm.y,
                w.wayY + motion.turn * arm.x};
    }

    /// Between two bodies that nothing ties everything may touch.
    bool bars(std::uint32_t corner, std::uint32_t sideA, std::uint32_t sideB, Real radius,
              const Chunk& other) const {
        return mayBar_ && neverTouches(state_, corner, sideA, sideB, other.body, radius);
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

    /// Looks from a corner at all sides that it may touch. Returns their bits.
    std::uint32_t lookAtSides(std::uint32_t corner, const CornerWay& p, Real radius,
                              const Chunk& other, ChunkLanes& lanes) {
        forEachBit(lanes.twoSided, [&](std::uint32_t k) {
            lanes.sides.outward[k] = static_cast<Real>(sideSoFar(corner, other.firstSide + k));
        });
        const auto every = static_cast<std::uint32_t>((std::uint64_t{1} << other.sides) - 1);
        const auto may = every & ~lanes.discs & ~barred(corner, other);
        SidesSeen& seen = result_.sidesSeen;
        kernels_.sides(p, radius, lanes.sides, may & ~lanes.arcs, seen);
        forEachBit(may & lanes.arcs, [&](std::uint32_t k) {
            lookAtArc(p, radius, lanes, k, shapes_.sides[other.firstSide + k], seen);
        });
        return may;
    }

    void againstSides(std::uint32_t corner, const CornerWay& p, Real radius, const Chunk& other,
                      ChunkLanes& lanes) {
        lookAtSides(corner, p, radius, other, lanes);
        const SidesSeen& seen = result_.sidesSeen;
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

    // --- arcs ----------------------------------------------------------------------------------

    /// When the step begins, or (moment 1) ends.
    ArcAt arcOf(const Side& side, int moment) const {
        const auto mover = shapes_.corners[side.a].mover;
        const auto place = [&](const CornerWay& c) { return moment == 0 ? at(c) : atEnd(c); };
        const Circle circle(place(wayAt(mover, side.offset, side.middle)),
                            place(wayAt(mover, side.offset + side.outX, side.middle + side.outY)),
                            arcRadius(side));
        return {circle, place(wayOf(side.a)), place(wayOf(side.b))};
    }

    /// The same as the kernel does with straight sides. `outward` is +1 outside of the circle.
    void lookAtArc(const CornerWay& p, Real radius, const ChunkLanes& lanes, std::uint32_t k,
                   const Side& side, SidesSeen& seen) const {
        const ArcAt now = arcOf(side, 0), then = arcOf(side, 1);
        const Real thickness = radius + side.radius;
        const Real out = now.out(at(p)), besideNow = now.beside(at(p)), far = now.distance(at(p));
        const auto closingTo = [&](std::uint32_t end) { return norm(way(p) - way(wayOf(end))); };
        const Real closing = std::max(closingTo(side.a), closingTo(side.b)),
                   apart = far - thickness;
        // What is known of a side without an inside is of the circle already.
        Real outward = lanes.sides.outward[k] * (side.outward == 0 ? Real(1) : now.turns);
        if (outward == 0) outward = out < 0 ? Real(-1) : Real(1);
        seen.far[k] = far;
        seen.height[k] = outward * out;
        seen.outward[k] = outward;
        seen.gap = std::min(seen.gap, apart);
        if (seen.nearest == mostOfChunk || far < seen.far[seen.nearest]) seen.nearest = k;
        if (apart > nearFrom(thickness, closing)) {
            seen.spare = std::min(seen.spare, apart);
            return;
        }
        const Real moment = momentOfHeight(outward * out, outward * then.out(atEnd(p)), thickness);
        const Real besideThen = besideNow + moment * (then.beside(atEnd(p)) - besideNow);
        if (besideThen <= 0)
            seen.before |= 1u << k;
        else
            seen.enter = std::min(seen.enter, std::max(std::min(besideThen, besideNow), apart));
    }

    /// The curved surfaces of a chunk's arcs against the other's sides: discs, as far as they are
    /// there. What is within the circle of an arc without an inside is before its hollow surface.
    void centresAgainstSides(const Chunk& own, const ChunkLanes& lanes, const Chunk& other,
                             ChunkLanes& sides) {
        std::uint32_t centre = own.firstCorner + own.corners;
        forEachBit(lanes.arcs, [&](std::uint32_t k) {
            const Side& side = shapes_.sides[own.firstSide + k];
            const ArcAt arc = arcOf(side, 0);
            const bool isHollow = static_cast<Real>(side.outward) * arc.turns < 0;
            if (!isHollow) centreAgainstSides(centre, arc, side.outward == 0, other, sides);
            ++centre;
        });
    }
    void centreAgainstSides(std::uint32_t centre, const ArcAt& arc, bool hasNoInside,
                            const Chunk& other, ChunkLanes& sides) {
        const CornerWay p = wayOf(centre);
        const Real radius = shapes_.corners[centre].radius;
        const std::uint32_t may = lookAtSides(centre, p, radius, other, sides);
        const SidesSeen& seen = result_.sidesSeen;
        // What turns by an angle moves its own surface less than that of the whole circle.
        const Real lever = std::min<Real>(1, arc.halfChord / arc.radius);
        Real entrance = seen.enter;
        bool anyBefore = false;
        forEachBit(may, [&](std::uint32_t k) {
            const auto side = other.firstSide + k;
            const bool within = seen.far[k] < arc.radius && sideSoFar(centre, side) == 0;
            if (!(seen.height[k] > 0) || (hasNoInside && within)) return;
            const Real apart = seen.far[k] - radius - sides.sides.radius[k];
            if ((seen.before >> k & 1) == 0) {
                spare_ = std::min(spare_, std::max(apart, Real(0)));
                return;
            }
            const Xy toSide = seen.outward[k] * outOf(shapes_.sides[side], at(p));
            const Real beyond = arc.beside(at(p) - arc.radius * toSide);
            entrance = std::min(entrance, lever * std::abs(beyond));
            if (beyond > 0) return;
            anyBefore = true;
            result_.gap = std::min(result_.gap, apart);
            result_.near.push_back(
                {centre, side, 0, static_cast<std::int32_t>(seen.outward[k]), seen.far[k]});
        });
        enter(entrance, anyBefore);
    }
    /// Unit: to the right of a side, or out of its circle, at a place.
    Xy outOf(const Side& side, Xy p) const {
        if (arcRadius(side) > 0) return arcOf(side, 0).normalAt(p);
        const Xy along = at(wayOf(side.b)) - at(wayOf(side.a));
        return 1 / norm(along) * Xy{along.y, -along.x};
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
        std::int32_t outward = 0;
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
            Real far;
            std::int32_t outwardThere = side.outward;
            if (arcRadius(side) > 0) {
                const ArcAt arc = arcOf(side, 0);
                outwardThere *= static_cast<std::int32_t>(arc.turns);
                // What is between arc and chord is inside where the arc is bent outwards.
                if (arc.encloses(p)) turns += outwardThere;
                far = arc.distance(p);
            } else {
                const Real length2 = dot(along, along);
                if (!(length2 > 0)) return;
                const Real share = std::clamp<Real>(dot(from, along) / length2, 0, 1);
                far = norm(from - share * along);
            }
            if (far < nearest) {
                nearest = far;
                nearestSide = s;
                outward = outwardThere;
            }
        });
        // Who is outside comes in through a side, of this chunk or of another.
        const Real within = turns <= 0 ? nearest : 0;
        entrance_ = std::min(entrance_, std::max(within, Real(0.25) * finest_));
        if (turns <= 0 || nearestSide == none) return;
        if (nearestSide < other.firstSide || nearestSide >= other.firstSide + other.sides) return;
        result_.near.push_back({corner, nearestSide, 0, outward, nearest});
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

void lookLoosely(const State& state, const Chunk& a, const Chunk& b,
                 const std::vector<KnownSide>& known, LooseLook& result) {
    Looker(state, a, b, known, result).run();
}

}  // namespace sulfur::detail
