#include "narrow_phase/time_of_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"
#include "narrow_phase/loose.hpp"

namespace sulfur::detail {

namespace {

constexpr int mostSteps = tuned::momentRounds;
/// Of a chunk: more than any has (see make_shapes.cpp).
constexpr std::size_t mostCorners = 32;

struct Xy {
    Real x = 0, y = 0;
};
Xy operator-(Xy a, Xy b) {
    return {a.x - b.x, a.y - b.y};
}
Real dot(Xy a, Xy b) {
    return a.x * b.x + a.y * b.y;
}
Real cross(Xy a, Xy b) {
    return a.x * b.y - a.y * b.x;
}

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
        const SolverBody& body = movers_.bodies[c.mover];
        const BodyWay& way = state_.core.ways[c.mover];
        const Point from = movers_.placeAtReference(c.mover) - origin_;
        const Xy centre{static_cast<Real>(from[0]) + body.x, static_cast<Real>(from[1]) + body.y};
        if (c.x == 0 && c.y == 0) return {centre, {centre.x + way.x, centre.y + way.y}};
        const Heading h = turnedBy(movers_, c.mover, 0), g = turnedBy(movers_, c.mover, way.turn);
        return {
            {centre.x + h.cosine * c.x - h.sine * c.y, centre.y + h.sine * c.x + h.cosine * c.y},
            {centre.x + way.x + g.cosine * c.x - g.sine * c.y,
             centre.y + way.y + g.sine * c.x + g.cosine * c.y}};
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
                if (box.isBeside(sides) || neverTouches(state_, c, side, other.body)) continue;
                const Real thickness = shapes_.corners[c].radius + side.radius;
                meet(c, p, side.a, a, thickness);
                if (side.a == side.b) continue;
                meet(c, p, side.b, b, thickness);
                cross(c, p, side, a, b, thickness);
            }
        }
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

    /// A corner and the straight part of a side.
    void cross(std::uint32_t corner, const Way& p, const Side& side, const Way& a, const Way& b,
               Real thickness) {
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
        // The height of what turns is no line: its first fall below the limit by halving.
        Real low = 0, high = 1;
        for (int i = 0; i < mostSteps; ++i) {
            const Real middle = (low + high) / 2;
            (outward * heightAt(middle) < limit ? high : low) = middle;
        }
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
