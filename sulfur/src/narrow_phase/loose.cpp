// Two segments that do not cross are closest at an end of one of them, so that corners before sides
// are all that can touch. A corner counts
// - before a side, where the foot of its perpendicular is between the ends;
// - before a corner, where each is the nearest point of all capsules that end in the other;
// each at the moment at which the two come to touch in this step, as far as is predicted. So what
// is fast meets what is in its way, and seams of a floor make no bump. An outline pushes outwards
// only: what is inside leaves through the nearest side.
#include "narrow_phase/loose.hpp"

#include <algorithm>
#include <cmath>

#include "core/settings.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"

namespace sulfur::detail {

namespace {

constexpr Real togetherWithin = Real(tuned::togetherWithin);
constexpr Real beyondEnds = Real(tuned::beyondEnds);
/// Where a corner has a row already, whose refresh tells when it leaves what it is before, another
/// one may come so much too late.
constexpr Real held = Real(tuned::seam);

struct Xy {
    Real x = 0, y = 0;
};
Xy operator-(Xy a, Xy b) {
    return {a.x - b.x, a.y - b.y};
}
Xy operator+(Xy a, Xy b) {
    return {a.x + b.x, a.y + b.y};
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
Xy at(const CornerWay& c, Real moment = 0) {
    return {c.x + moment * c.wayX, c.y + moment * c.wayY};
}
Xy way(const CornerWay& c) {
    return {c.wayX, c.wayY};
}

constexpr Real reached = Real(1 + tuned::reached), reachedRound = Real(1 + tuned::reachedRound);

/// When a height falls to a limit, as a share of the step: 0 if it is there already, 1 if it does
/// not come so far.
Real momentOfHeight(Real start, Real end, Real limit) {
    if (!(start > reached * limit)) return 0;
    return start - end > start - limit ? (start - limit) / (start - end) : 1;
}
/// When two points come as near as a limit; or when they are nearest, or 1 if that is later.
Real momentOfPoints(Xy start, Xy way, Real limit) {
    const Real a = dot(way, way), b = dot(start, way), c = dot(start, start) - limit * limit;
    if (!(dot(start, start) > reachedRound * reachedRound * limit * limit)) return 0;
    if (!(b < 0)) return 1;
    // Far beyond all that has a size the difference is no number; then it is 0.
    return std::clamp<Real>((-b - std::sqrt(std::max<Real>(0, b * b - a * c))) / a, 0, 1);
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
        spare_ = entrance_ = result_.gap = Real(1e30);
        place(a_, result_.cornersA);
        place(b_, result_.cornersB);
        extentA_ = extentOf(a_, result_.cornersA);
        extentB_ = extentOf(b_, result_.cornersB);
        againstSides(a_, result_.cornersA, b_, result_.cornersB, extentB_);
        if (&a_ != &b_) againstSides(b_, result_.cornersB, a_, result_.cornersA, extentA_);
        againstCorners();
        result_.slack =
            std::min(entrance_, std::max(spare_ - Real(0.25) * finest_, Real(0.25) * finest_));
    }

private:
    void place(const Chunk& chunk, std::vector<CornerWay>& corners) const {
        corners.resize(chunk.corners);
        for (std::uint32_t k = 0; k < chunk.corners; ++k) corners[k] = wayOf(chunk.firstCorner + k);
    }
    /// Where the corners of a chunk are, and how they go.
    struct Extent {
        Xy low{Real(1e30), Real(1e30)}, high{Real(-1e30), Real(-1e30)};
        Xy least{Real(1e30), Real(1e30)}, most{Real(-1e30), Real(-1e30)};
        Real radius = 0;
    };
    static Extent extentOf(const Chunk& chunk, const std::vector<CornerWay>& corners) {
        Extent e;
        e.radius = chunk.radius;
        for (const CornerWay& c : corners) {
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
    /// m: what comes nearer than that in a step may count.
    static Real nearFrom(Real thickness, Real closing) {
        return Real(0.5) * thickness + 2 * closing;
    }

    CornerWay wayOf(std::uint32_t corner) const {
        const Corner& c = shapes_.corners[corner];
        const SolverBody& body = movers_.bodies[c.mover];
        const Point from = movers_.placeAtReference(c.mover) - origin_;
        const Motion3 motion = motionNow(movers_, c.mover);
        CornerWay w{static_cast<Real>(from[0]) + body.x, static_cast<Real>(from[1]) + body.y,
                    motion.x, motion.y};
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

    void againstSides(const Chunk& own, const std::vector<CornerWay>& corners, const Chunk& other,
                      const std::vector<CornerWay>& ends, const Extent& extent) {
        for (std::uint32_t k = 0; k < own.corners; ++k) {
            const Corner& corner = shapes_.corners[own.firstCorner + k];
            if (corner.owned && !isBeyond(corners[k], corner.radius, extent))
                againstSides(own.firstCorner + k, corners[k], other, ends);
        }
    }

    void againstSides(std::uint32_t corner, const CornerWay& p, const Chunk& other,
                      const std::vector<CornerWay>& ends) {
        const Real radius = shapes_.corners[corner].radius;
        auto& before = result_.before;
        before.clear();
        Real nearest = Real(1e30), depth = 0, entrance = Real(1e30);
        std::uint32_t nearestSide = none;
        for (auto s = other.firstSide; s < other.firstSide + other.sides; ++s) {
            const Side& side = shapes_.sides[s];
            if (side.a == side.b || bars(corner, side.a, side.b, side.radius, other)) continue;
            const CornerWay &a = ends[side.a - other.firstCorner],
                            &b = ends[side.b - other.firstCorner];
            const Xy along = at(b) - at(a), from = at(p) - at(a);
            const Real length2 = dot(along, along);
            if (!(length2 > 0)) continue;
            const Real share = std::clamp<Real>(dot(from, along) / length2, 0, 1);
            const Real far = norm(from - share * along);
            const Xy closing = way(p) - (way(a) + share * (way(b) - way(a)));
            const Real thickness = radius + side.radius;
            const Real right = cross(from, along) / std::sqrt(length2);
            auto outward = side.outward != 0 ? side.outward : sideSoFar(corner, s);
            if (outward == 0) outward = right < 0 ? -1 : 1;
            const Real height = static_cast<Real>(outward) * right;
            if (far < nearest) {
                nearest = far;
                nearestSide = s;
                depth = side.outward != 0 ? -height : 0;
            }
            result_.gap = std::min(result_.gap, far - thickness);
            if (far - thickness > nearFrom(thickness, norm(closing))) {
                spare_ = std::min(spare_, far - thickness);
                continue;
            }
            const Real beside = besides(p, a, b, outward, height, thickness);
            if (beside <= 0)
                before.push_back({corner, s, height < 0 ? 1u : 0u, outward, far});
            else
                entrance = std::min(
                    entrance, std::max(std::min(beside, besidesAt(p, a, b, 0)), far - thickness));
        }
        if (nearestSide == none) return;
        if (depth > radius) {
            enter(entrance, false);
            // What is part of an outline is behind most of its sides, and not in it.
            if (movers_.body[shapes_.corners[corner].mover] != other.body)
                leaveThroughNearest(corner, at(p), other);
            return;
        }
        // Behind the nearest side, it counts before that alone.
        const bool behind = std::any_of(before.begin(), before.end(), [&](const Nearness& n) {
            return n.side == nearestSide && n.end == 1;
        });
        for (const Nearness& n : before)
            if (behind ? n.side == nearestSide : n.end == 0)
                result_.near.push_back({n.corner, n.side, 0, n.outward, n.far});
        enter(entrance, !before.empty());
    }

    std::int32_t sideSoFar(std::uint32_t corner, std::uint32_t side) const {
        for (const KnownSide& k : known_)
            if (k.corner == corner && k.side == side) return k.outward;
        return 0;
    }

    /// m, by which the foot of the perpendicular is beside a side when the two touch.
    static Real besides(const CornerWay& p, const CornerWay& a, const CornerWay& b,
                        std::int32_t outward, Real height, Real thickness) {
        const Xy alongEnd = at(b, 1) - at(a, 1), fromEnd = at(p, 1) - at(a, 1);
        const Real lengthEnd = norm(alongEnd);
        const Real turned = static_cast<Real>(outward) * cross(fromEnd, alongEnd);
        const Real end = lengthEnd > 0 ? turned / lengthEnd : height;
        const Real moment = momentOfHeight(height, end, thickness);
        return besidesAt(p, a, b, moment);
    }
    static Real besidesAt(const CornerWay& p, const CornerWay& a, const CornerWay& b, Real moment) {
        const Xy along = at(b, moment) - at(a, moment), from = at(p, moment) - at(a, moment);
        const Real length = norm(along);
        if (!(length > 0)) return norm(from);
        const Real foot = dot(from, along) / length;
        return std::max(-foot, foot - length) - beyondEnds * length;
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

    /// m, by which `p` is before a capsule that ends in the corner; not above 0 where it is before
    /// the corner alone.
    Real beforeSpokes(std::uint32_t corner, Xy place, Xy p, Real moment) const {
        const Corner& c = shapes_.corners[corner];
        Real most = 0;
        for (auto k = c.firstSpoke; k < c.firstSpoke + c.spokes; ++k) {
            const Xy spoke = at(wayOf(shapes_.spokes[k]), moment) - place;
            const Real along = dot(p - place, spoke);
            if (along > 0) most = std::max(most, along / norm(spoke));
        }
        return most;
    }

    void againstCorners() {
        for (auto s = b_.firstSide; s < b_.firstSide + b_.sides; ++s) {
            const Side& side = shapes_.sides[s];
            for (const auto& [corner, end] : {std::pair(side.a, 1u), std::pair(side.b, 2u)}) {
                if (!shapes_.corners[corner].owned || (end == 2 && side.a == side.b)) continue;
                if (takes(corner, s)) againstCorner(corner, s, end);
            }
        }
    }
    /// Of the sides of its chunk that end in a corner the first one stands for it.
    bool takes(std::uint32_t corner, std::uint32_t side) const {
        for (auto s = b_.firstSide; s < side; ++s)
            if (shapes_.sides[s].a == corner || shapes_.sides[s].b == corner) return false;
        return true;
    }

    void againstCorner(std::uint32_t corner, std::uint32_t side, std::uint32_t end) {
        const CornerWay& q = result_.cornersB[corner - b_.firstCorner];
        if (isBeyond(q, shapes_.corners[corner].radius, extentA_)) return;
        for (auto c = a_.firstCorner; c < a_.firstCorner + a_.corners; ++c) {
            if (!shapes_.corners[c].owned || (&a_ == &b_ && c >= corner)) continue;
            const CornerWay& p = result_.cornersA[c - a_.firstCorner];
            if (isBeyond(p, shapes_.corners[c].radius, extentB_)) continue;
            if (bars(c, corner, corner, shapes_.corners[corner].radius, b_)) continue;
            const Real thickness = shapes_.corners[c].radius + shapes_.corners[corner].radius;
            const Xy from = at(p) - at(q), closing = way(p) - way(q);
            const Real far = norm(from);
            result_.gap = std::min(result_.gap, far - thickness);
            if (far - thickness > nearFrom(thickness, norm(closing))) {
                spare_ = std::min(spare_, far - thickness);
                continue;
            }
            const Real moment = momentOfPoints(from, closing, thickness);
            const Xy pAt = at(p, moment), qAt = at(q, moment);
            const Real beside =
                std::max(beforeSpokes(corner, qAt, pAt, moment), beforeSpokes(c, pAt, qAt, moment));
            if (beside > 0)
                enter(std::max(std::min({beside, beforeSpokes(corner, at(q), at(p), 0),
                                         beforeSpokes(c, at(p), at(q), 0)}),
                               far - thickness),
                      isHeld(c) || isHeld(corner));
            else
                result_.near.push_back({c, side, end, 0, far});
        }
    }

    const State& state_;
    const Shapes& shapes_;
    const Movers& movers_;
    const Chunk &a_, &b_;
    const std::vector<KnownSide>& known_;
    LooseLook& result_;
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
