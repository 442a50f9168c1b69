// Two segments that do not cross are closest at an end of one of them, so that corners before sides
// are all that can touch. A corner counts
// - before a side, where the foot of its perpendicular is between the ends;
// - before a corner, where each is the nearest point of all capsules that end in the other.
// So seams of a floor, of one body or of many, make no bump. An outline pushes outwards only: what
// is inside leaves through the nearest side.
#include "narrow_phase/loose.hpp"

#include <algorithm>
#include <cmath>

#include "narrow_phase/convex.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// Parts of one body that are this near to each other in the blueprint, in thicknesses, belong
/// together and never touch.
constexpr Real togetherWithin = Real(1.2);

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
Real norm(Xy a) {
    return std::sqrt(dot(a, a));
}

/// Where a corner is, from the origin of the look, and where it goes in this step.
struct Place {
    Xy at, way;
};

class Looker {
public:
    Looker(const State& state, const Chunk& a, const Chunk& b, LooseLook& result)
        : state_(state),
          shapes_(state.core.shapes),
          movers_(state.core.movers),
          a_(a),
          b_(b),
          result_(result) {
        origin_ = movers_.reference[shapes_.corners[a.firstCorner].mover];
        thickness_ = a.radius + b.radius;
        finest_ = a.fineness + b.fineness;
    }

    void run() {
        result_.near.clear();
        spare_ = Real(1e30);
        againstSides(a_, b_);
        if (&a_ != &b_) againstSides(b_, a_);
        againstCorners();
        result_.slack = std::max(spare_ - Real(0.25) * finest_, Real(0.25) * finest_);
        if (anyCorner_) result_.slack = std::min(result_.slack, Real(0.2) * finest_);
    }

private:
    Place placeOf(std::uint32_t corner) const {
        const Corner& c = shapes_.corners[corner];
        const SolverBody& body = movers_.bodies[c.mover];
        const Point from = movers_.reference[c.mover] - origin_;
        const Motion3 motion = motionNow(movers_, c.mover);
        Place place{{static_cast<Real>(from[0]) + body.x, static_cast<Real>(from[1]) + body.y},
                    {motion.x, motion.y}};
        if (c.x == 0 && c.y == 0) return place;
        const Heading h = headingNow(movers_, c.mover);
        const Xy arm{h.cosine * c.x - h.sine * c.y, h.sine * c.x + h.cosine * c.y};
        place.at = place.at + arm;
        place.way = place.way + Xy{-motion.turn * arm.y, motion.turn * arm.x};
        return place;
    }

    // --- who may touch whom -----------------------------------------------------------------

    std::uint32_t denseParticle(std::uint32_t corner) const {
        return state_.particleSlots.denseOf(shapes_.corners[corner].particle);
    }
    bool isTied(std::uint32_t corner, std::uint32_t body) const {
        const auto& linked = state_.core.linked;
        return !linked.empty() &&
               std::binary_search(linked.begin(), linked.end(),
                                  std::pair(shapes_.corners[corner].particle, body));
    }
    /// Whether a corner never touches a side (or, where both ends are the same, a corner).
    bool isBarred(std::uint32_t corner, std::uint32_t sideA, std::uint32_t sideB,
                  std::uint32_t body, Real radius) const {
        const Corner &p = shapes_.corners[corner], &a = shapes_.corners[sideA],
                     &b = shapes_.corners[sideB];
        if (p.particle == a.particle || p.particle == b.particle) return true;
        if (p.mover == a.mover || p.mover == b.mover) return true;
        const auto i = denseParticle(corner);
        if (isTied(corner, body)) return true;
        const auto own = state_.bodies[state_.particles.body[i]].id.index - 1;
        if (isTied(sideA, own) && isTied(sideB, own)) return true;
        if (own != body) return false;
        const auto& rest = state_.particles.rest;
        const Vec2 from = rest[denseParticle(sideA)], to = rest[denseParticle(sideB)];
        const Vec2 way = to - from, v = rest[i] - from;
        const Real length2 = way.squaredNorm();
        const Real t = length2 > 0 ? std::clamp(v.dot(way) / length2, Real(0), Real(1)) : Real(0);
        return (v - t * way).norm() < togetherWithin * (p.radius + radius);
    }

    // --- corners before sides ----------------------------------------------------------------

    /// A side as one corner sees it.
    struct View {
        std::uint32_t side = none;
        Real height = 0;  // m, above the side that is outside; either way where both are
        Real far = 0;     // m, to the nearest point of the segment
        std::int32_t outward = 0;
        Real near = 0;  // m, up to which it counts
    };

    void againstSides(const Chunk& own, const Chunk& other) {
        for (auto c = own.firstCorner; c < own.firstCorner + own.corners; ++c)
            if (shapes_.corners[c].owned) againstSides(c, other);
    }

    void againstSides(std::uint32_t corner, const Chunk& other) {
        const Place p = placeOf(corner);
        const Corner& self = shapes_.corners[corner];
        views_.clear();
        View nearest;
        nearest.far = Real(1e30);
        for (auto s = other.firstSide; s < other.firstSide + other.sides; ++s) {
            const Side& side = shapes_.sides[s];
            if (side.a == side.b || isBarred(corner, side.a, side.b, other.body, side.radius))
                continue;
            const Place a = placeOf(side.a), b = placeOf(side.b);
            const Xy way = b.at - a.at, v = p.at - a.at;
            const Real length = norm(way);
            if (!(length > 0)) continue;
            const Real t = dot(v, way) / (length * length);
            const Real share = std::clamp(t, Real(0), Real(1));
            const Real right = (v.x * way.y - v.y * way.x) / length;
            const Xy foot = a.at + share * way;
            View view{s, right, norm(p.at - foot), side.outward, 0};
            if (side.outward == 0) view.outward = right < 0 ? -1 : 1;
            view.height = static_cast<Real>(view.outward) * right;
            const Xy closing = p.way - (a.way + share * (b.way - a.way));
            const Real thickness = self.radius + side.radius;
            view.near = Real(0.5) * thickness + 2 * norm(closing);
            if (view.far - thickness > view.near) {
                spare_ = std::min(spare_, view.far - thickness);
                continue;
            }
            if (view.far < nearest.far) nearest = view;
            if (t > 0 && t < 1)
                views_.push_back(view);
            else
                spare_ = std::min(spare_, Real(0.5) * finest_);
        }
        if (nearest.side == none) return;
        const bool inside = nearest.height < 0;
        for (const View& view : views_) {
            if (inside && view.side != nearest.side) continue;
            if (!inside && view.height < 0) continue;
            result_.near.push_back({corner, view.side, 0, view.outward,
                                    view.height - self.radius - shapes_.sides[view.side].radius});
        }
    }

    // --- corners before corners ---------------------------------------------------------------

    /// Whether `p` is before the corner and not before a capsule that ends there.
    bool isBeyond(std::uint32_t corner, Xy at, Xy p) const {
        const Corner& c = shapes_.corners[corner];
        for (auto k = c.firstSpoke; k < c.firstSpoke + c.spokes; ++k)
            if (dot(p - at, placeOf(shapes_.spokes[k]).at - at) > 0) return false;
        return true;
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
        const Place q = placeOf(corner);
        for (auto c = a_.firstCorner; c < a_.firstCorner + a_.corners; ++c) {
            if (!shapes_.corners[c].owned || (&a_ == &b_ && c >= corner)) continue;
            if (isBarred(c, corner, corner, b_.body, shapes_.corners[corner].radius)) continue;
            const Place p = placeOf(c);
            const Real thickness = shapes_.corners[c].radius + shapes_.corners[corner].radius;
            const Real far = norm(p.at - q.at);
            const Real near = Real(0.5) * thickness + 2 * norm(p.way - q.way);
            if (far - thickness > near) {
                spare_ = std::min(spare_, far - thickness);
                continue;
            }
            anyCorner_ = true;
            if (!isBeyond(corner, q.at, p.at) || !isBeyond(c, p.at, q.at)) continue;
            result_.near.push_back({c, side, end, 0, far - thickness});
        }
    }

    const State& state_;
    const Shapes& shapes_;
    const Movers& movers_;
    const Chunk &a_, &b_;
    LooseLook& result_;
    Point origin_{0, 0};
    Real thickness_ = 0, finest_ = 0, spare_ = 0;
    bool anyCorner_ = false;
    std::vector<View> views_;
};

}  // namespace

void lookLoosely(const State& state, const Chunk& a, const Chunk& b, LooseLook& result) {
    Looker(state, a, b, result).run();
}

}  // namespace sulfur::detail
