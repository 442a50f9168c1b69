#include "narrow_phase/time_of_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "narrow_phase/arc_at.hpp"
#include "narrow_phase/convex.hpp"
#include "narrow_phase/never_touches.hpp"

namespace sulfur::detail {

namespace {

constexpr int mostSteps = tuned::momentRounds;
/// Of a chunk: more than any has (see make_shapes.cpp).
constexpr std::size_t mostCorners = 32;

/// Where a corner begins and ends, from an origin.
struct Way {
    Xy start, end;

    Xy at(Real moment) const {
        return {start.x + moment * (end.x - start.x), start.y + moment * (end.y - start.y)};
    }
};

/// Corners of two chunks against each other.
class Crosser {
public:
    Crosser(const State& state, const Chunk& a, const Chunk& b, Real left,
            std::vector<Passing>& passings)
        : state_(state),
          shapes_(state.core.shapes),
          movers_(state.core.movers),
          a_(a),
          b_(b),
          left_(left),
          passings_(passings) {
        origin_ = movers_.placeAtReference(shapes_.corners[a.firstCorner].mover);
    }

    void run() {
        passings_.clear();
        const Course ofA = courseOf(a_), ofB = courseOf(b_);
        if (ofA.box.isBeside(ofB.box)) return;
        against(a_, ofA, b_, ofB);
        if (&a_ != &b_) against(b_, ofB, a_, ofA);
    }

private:
    struct Box {
        Xy low{Real(1e30), Real(1e30)}, high{Real(-1e30), Real(-1e30)};

        void add(const Way& way, Real around) {
            for (const Xy p : {way.start, way.end}) {
                low = {std::min(low.x, p.x - around), std::min(low.y, p.y - around)};
                high = {std::max(high.x, p.x + around), std::max(high.y, p.y + around)};
            }
        }
        bool isBeside(const Box& other) const {
            return low.x > other.high.x || other.low.x > high.x || low.y > other.high.y ||
                   other.low.y > high.y;
        }
    };
    /// How all corners of a chunk go, and the box in which they do, with their thickness.
    struct Course {
        std::array<Way, mostCorners> ways;
        Box box;
    };
    Course courseOf(const Chunk& chunk) const {
        Course course;
        for (std::uint32_t k = 0; k < chunk.corners; ++k)
            course.box.add(course.ways[k] = wayOf(chunk.firstCorner + k), chunk.radius);
        return course;
    }
    Way wayOf(std::uint32_t corner) const {
        const Corner& c = shapes_.corners[corner];
        return wayAt(c.mover, c.x, c.y);
    }
    /// Of a place in the frame of a mover.
    Way wayAt(std::uint32_t mover, Real x, Real y) const {
        const SolverBody& body = movers_.bodies[mover];
        const BodyWay& way = state_.core.ways[mover];
        const Point from = movers_.placeAtReference(mover) - origin_;
        const Xy centre{static_cast<Real>(from[0]) + body.x, static_cast<Real>(from[1]) + body.y};
        if (x == 0 && y == 0) return {centre, {centre.x + way.x, centre.y + way.y}};
        const Heading h = turnedBy(movers_, mover, 0), g = turnedBy(movers_, mover, way.turn);
        return {{centre.x + h.cosine * x - h.sine * y, centre.y + h.sine * x + h.cosine * y},
                {centre.x + way.x + g.cosine * x - g.sine * y,
                 centre.y + way.y + g.sine * x + g.cosine * y}};
    }

    void against(const Chunk& own, const Course& corners, const Chunk& other, const Course& ends) {
        for (auto c = own.firstCorner; c < own.firstCorner + own.corners; ++c) {
            if (!shapes_.corners[c].owned) continue;
            const Way& p = corners.ways[c - own.firstCorner];
            Box box;
            box.add(p, shapes_.corners[c].radius);
            if (box.isBeside(ends.box)) continue;
            for (auto s = other.firstSide; s < other.firstSide + other.sides; ++s) {
                const Side& side = shapes_.sides[s];
                const Way& a = ends.ways[side.a - other.firstCorner];
                const Way& b = ends.ways[side.b - other.firstCorner];
                Box sides;
                sides.add(a, side.radius);
                sides.add(b, side.radius);
                const bool isBeside = arcRadius(side) == 0 && box.isBeside(sides);
                if (isBeside || never(c, side, other)) continue;
                const Real thickness = shapes_.corners[c].radius + side.radius;
                meet(c, p, side.a, a, thickness);
                if (side.a == side.b) continue;
                meet(c, p, side.b, b, thickness);
                crossAny(c, p, side, a, b, thickness, [](Xy) { return true; });
            }
        }
        crossCentres(own, corners, other, ends);
    }

    bool never(std::uint32_t corner, const Side& side, const Chunk& other) const {
        return neverTouches(state_, corner, side.a, side.b, other.body, side.radius);
    }

    template <class Counts>
    void crossAny(std::uint32_t corner, const Way& p, const Side& side, const Way& a, const Way& b,
                  Real thickness, Counts&& counts) {
        if (arcRadius(side) > 0)
            crossArc(corner, p, side, a, b, thickness, counts);
        else
            cross(corner, p, side, a, b, thickness, counts);
    }

    /// Circles of a chunk's arcs, as far as these go, against the other's sides.
    void crossCentres(const Chunk& own, const Course& corners, const Chunk& other,
                      const Course& ends) {
        auto centre = own.firstCorner + own.corners;
        for (auto k = own.firstSide; k < own.firstSide + own.sides; ++k) {
            const Side& arcSide = shapes_.sides[k];
            if (!(arcRadius(arcSide) > 0)) continue;
            const auto c = centre++;
            const ArcAt arc(circleAt(arcSide, 0), corners.ways[arcSide.a - own.firstCorner].start,
                            corners.ways[arcSide.b - own.firstCorner].start);
            const bool isHollow = static_cast<Real>(arcSide.outward) * arc.turns < 0;
            if (isHollow) continue;
            const Way p = wayOf(c);
            const auto isOnArc = [&](Xy normal) {
                return arc.beside(p.start - arc.radius * normal) <= 0;
            };
            for (auto s = other.firstSide; s < other.firstSide + other.sides; ++s) {
                const Side& side = shapes_.sides[s];
                if (side.a == side.b || never(c, side, other)) continue;
                const Way& a = ends.ways[side.a - other.firstCorner];
                const Way& b = ends.ways[side.b - other.firstCorner];
                // Within its circle is before the hollow surface of an arc without an inside.
                const Real height = std::abs(heightOver(side, a.start, b.start, p.start));
                if (arcSide.outward == 0 && height < arc.radius) continue;
                crossAny(c, p, side, a, b, shapes_.corners[c].radius + side.radius, isOnArc);
            }
        }
    }
    /// m, to the right of a side, or outside of its circle, when the step begins.
    Real heightOver(const Side& side, Xy a, Xy b, Xy p) const {
        if (arcRadius(side) > 0) return circleAt(side, 0).out(p);
        return detail::cross(p - a, b - a) / std::max(norm(b - a), Real(1e-30));
    }
    Circle circleAt(const Side& side, Real moment) const {
        const auto mover = shapes_.corners[side.a].mover;
        return {wayAt(mover, side.offset, side.middle).at(moment),
                wayAt(mover, side.offset + side.outX, side.middle + side.outY).at(moment),
                arcRadius(side)};
    }

    /// A corner and the rounding of a side's end.
    void meet(std::uint32_t corner, const Way& p, std::uint32_t end, const Way& a, Real thickness) {
        const Xy from = p.start - a.start, way = (p.end - a.end) - from;
        const Real distance2 = dot(from, from), closing = -dot(from, way), way2 = dot(way, way);
        const Real limit = std::min(left_ * thickness, std::sqrt(distance2));
        if (!(closing > 0)) return;
        // They are at the limit where way2 t^2 - 2 closing t + distance2 = limit^2.
        const Real missing = closing * closing - way2 * (distance2 - limit * limit);
        if (!(missing > 0)) return;
        const Real moment = std::max<Real>((closing - std::sqrt(missing)) / way2, 0);
        if (!(moment < 1)) return;
        const Xy then = p.at(moment) - a.at(moment);
        const Real length = std::sqrt(dot(then, then));
        if (!(length > 0)) return;
        const Xy normal{then.x / length, then.y / length};
        note(corner, p, end, end, 0, moment, normal, limit - dot(normal, p.end - a.end),
             std::sqrt(distance2) - thickness);
    }

    /// A corner and an arc, where `counts(normal)`.
    template <class Counts>
    void crossArc(std::uint32_t corner, const Way& p, const Side& side, const Way& a, const Way& b,
                  Real thickness, Counts&& counts) {
        const auto outAt = [&](Real moment) { return circleAt(side, moment).out(p.at(moment)); };
        const ArcAt before(circleAt(side, 0), a.start, b.start);
        Real outward = static_cast<Real>(side.outward) * before.turns;
        if (outward == 0) outward = before.out(p.start) < 0 ? Real(-1) : Real(1);
        const Real start = outward * outAt(0), end = outward * outAt(1);
        if (!(start > 0)) return;
        const Real limit = std::min(left_ * thickness, start);
        if (!(end < limit)) return;
        const auto [low, high] =
            firstBelow([&](Real moment) { return outward * outAt(moment); }, limit);
        const ArcAt then(circleAt(side, high), a.at(high), b.at(high));
        if (then.beside(p.at(high)) > 0) return;
        const Xy normal = outward * then.normalAt(p.at(high));
        if (!counts(normal)) return;
        note(corner, p, side.a, side.a, 0, low, normal, limit - end, start - thickness);
    }

    /// The moments between which a height that begins above the limit first falls below it, by
    /// halving: that of what turns is no line.
    template <class Height>
    static std::pair<Real, Real> firstBelow(Height&& heightAt, Real limit) {
        Real low = 0, high = 1;
        for (int i = 0; i < mostSteps; ++i) {
            const Real middle = (low + high) / 2;
            (heightAt(middle) < limit ? high : low) = middle;
        }
        return {low, high};
    }

    /// A corner and the straight part of a side, where `counts(normal)`.
    template <class Counts>
    void cross(std::uint32_t corner, const Way& p, const Side& side, const Way& a, const Way& b,
               Real thickness, Counts&& counts) {
        const auto heightAt = [&](Real moment) {
            const Xy along = b.at(moment) - a.at(moment);
            const Real length = std::sqrt(dot(along, along));
            return length > 0 ? detail::cross(p.at(moment) - a.at(moment), along) / length : 0;
        };
        Real start = heightAt(0), end = heightAt(1);
        Real outward = static_cast<Real>(side.outward);
        if (outward == 0) outward = start < 0 ? Real(-1) : Real(1);
        start *= outward;
        end *= outward;
        if (!(start > 0)) return;
        const Real limit = std::min(left_ * thickness, start);
        if (!(end < limit)) return;
        const auto [low, high] =
            firstBelow([&](Real moment) { return outward * heightAt(moment); }, limit);
        const Xy along = b.at(high) - a.at(high);
        const Real foot = dot(p.at(high) - a.at(high), along), length2 = dot(along, along);
        if (foot < 0 || foot > length2 || !(length2 > 0)) return;
        // The side may turn on until the step ends, and its normal with it: they end as near as
        // they do along the better one.
        const Real length = std::sqrt(length2), share = foot / length2;
        Xy normal{outward * along.y / length, -outward * along.x / length};
        const Xy onSide{a.end.x + share * (b.end.x - a.end.x),
                        a.end.y + share * (b.end.y - a.end.y)};
        Real last = dot(normal, p.end - onSide);
        const Xy turned = b.end - a.end;
        const Real lengthNow = std::sqrt(dot(turned, turned));
        if (end > last && lengthNow > 0) {
            last = end;
            normal = {outward * turned.y / lengthNow, -outward * turned.x / lengthNow};
        }
        if (!counts(normal)) return;
        note(corner, p, side.a, side.b, share, low, normal, limit - last, start - thickness);
    }

    void note(std::uint32_t corner, const Way& p, std::uint32_t a, std::uint32_t b, Real share,
              Real moment, Xy normal, Real depth, Real gap) {
        if (!(depth > 0)) return;
        const auto mover = [&](std::uint32_t c) { return shapes_.corners[c].mover; };
        if (mover(a) == mover(b)) share = 0;
        const Xy then = p.at(moment);
        const Real radius = shapes_.corners[corner].radius;
        const Vec2 at(then.x - radius * normal.x, then.y - radius * normal.y);
        passings_.push_back({mover(corner),
                             {mover(a), mover(b)},
                             share,
                             moment,
                             {normal.x, normal.y},
                             depth,
                             gap,
                             origin_ + at.cast<double>()});
    }

    const State& state_;
    const Shapes& shapes_;
    const Movers& movers_;
    const Chunk &a_, &b_;
    Real left_;
    std::vector<Passing>& passings_;
    Point origin_{0, 0};
};

}  // namespace

void findPassings(const State& state, const Chunk& a, const Chunk& b, Real left,
                  std::vector<Passing>& passings) {
    Crosser(state, a, b, left, passings).run();
}

}  // namespace sulfur::detail
