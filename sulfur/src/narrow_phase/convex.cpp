// The separating axis with the largest gap decides which side is the reference; the side of the
// other outline that faces it most is clipped to it (Gregorius 2013). Corners are round: a point is
// a corner before a side, and its gap that of the round shapes, also round the ends of the side.
#include "narrow_phase/convex.hpp"

#include <algorithm>
#include <cmath>

#include "core/settings.hpp"
#include "core/trigonometry.hpp"
#include "model/contact_core.hpp"
#include "narrow_phase/time_of_impact.hpp"

namespace sulfur::detail {

namespace {

constexpr std::size_t most = 32;

/// What comes nearer in a step by more than this share of the thickness is fast. If other features
/// may come near in this step, it is looked at where it comes to touch.
constexpr Real fast = unnoticed;
constexpr int mostRounds = tuned::momentRounds;
/// rad, up to which the series for small turns is good to rounding.
constexpr Real largeTurn = Real(0.3);

struct Xy {
    Real x, y;  // (arrays of them are not filled with zeros)
};
Xy operator-(Xy a, Xy b) {
    return {a.x - b.x, a.y - b.y};
}
Real dot(Xy a, Xy b) {
    return a.x * b.x + a.y * b.y;
}
Xy turned(const Heading& h, Xy v) {
    return {h.cosine * v.x - h.sine * v.y, h.sine * v.x + h.cosine * v.y};
}
Xy turnedBack(const Heading& h, Xy v) {
    return {h.cosine * v.x + h.sine * v.y, h.cosine * v.y - h.sine * v.x};
}

/// Corners and sides of an outline, each axis by itself, so that several are computed at once.
struct Outline {
    std::uint32_t corners = 0, sides = 0;
    std::array<Real, most> x, y, outX, outY;

    /// In its own frame.
    Outline(const Shapes& shapes, const Chunk& chunk)
        : corners(chunk.corners), sides(chunk.corners > 1 ? chunk.sides : 0) {
        for (std::uint32_t k = 0; k < corners; ++k) {
            const Corner& c = shapes.corners[chunk.firstCorner + k];
            x[k] = c.x;
            y[k] = c.y;
        }
        for (std::uint32_t k = 0; k < sides; ++k) {
            const Side& s = shapes.sides[chunk.firstSide + k];
            outX[k] = s.outX;
            outY[k] = s.outY;
        }
    }
    /// One in its own frame, seen from another frame.
    Outline(const Outline& own, const Heading& heading, Xy centre)
        : corners(own.corners), sides(own.sides) {
        for (std::uint32_t k = 0; k < corners; ++k) {
            const Xy way = turned(heading, own.at(k));
            x[k] = centre.x + way.x;
            y[k] = centre.y + way.y;
        }
        for (std::uint32_t k = 0; k < sides; ++k) {
            const Xy way = turned(heading, own.out(k));
            outX[k] = way.x;
            outY[k] = way.y;
        }
    }
    Xy at(std::uint32_t corner) const { return {x[corner], y[corner]}; }
    Xy out(std::uint32_t side) const { return {outX[side], outY[side]}; }
    std::uint32_t after(std::uint32_t side) const { return side + 1 < corners ? side + 1 : 0; }
};

/// The gaps of all sides to all of the other outline, and the side with the largest.
struct Gaps {
    std::array<Real, most> of;  // m
    std::uint32_t widest = 0;

    Gaps(const Outline& own, const Outline& other) {
        for (std::uint32_t i = 0; i < own.sides; ++i) of[i] = Real(1e30);
        for (std::uint32_t j = 0; j < other.corners; ++j) {
            const Xy corner = other.at(j);
            for (std::uint32_t i = 0; i < own.sides; ++i)
                of[i] = std::min(of[i], dot(own.out(i), corner - own.at(i)));
        }
        for (std::uint32_t i = 1; i < own.sides; ++i)
            if (of[i] > of[widest]) widest = i;
    }
    Real largest() const { return of[widest]; }
    Real largestBut(std::uint32_t side, std::uint32_t sides) const {
        Real gap = Real(-1e30);
        for (std::uint32_t i = 0; i < sides; ++i)
            if (i != side) gap = std::max(gap, of[i]);
        return gap;
    }
};

/// From a segment, or a point, to the nearest point of another.
Xy wayBetween(Xy from, Xy to, Xy p) {
    const Xy along = to - from, v = p - from;
    const Real length2 = dot(along, along);
    const Real share = length2 > 0 ? std::clamp<Real>(dot(along, v) / length2, 0, 1) : 0;
    return {v.x - share * along.x, v.y - share * along.y};
}
/// The shortest way from a side of an outline to another one that is in front of it. What is
/// farther from the line of the side than another one is from the side, beyond rounding, is not
/// looked at.
Xy shortestWay(const Outline& own, std::uint32_t side, const Outline& other) {
    const std::uint32_t next = own.after(side);
    std::array<Real, most> height;
    std::uint32_t lowest = 0;
    for (std::uint32_t k = 0; k < other.corners; ++k) {
        height[k] = dot(own.out(side), other.at(k) - own.at(side));
        if (height[k] < height[lowest]) lowest = k;
    }
    const Xy first = wayBetween(own.at(side), own.at(next), other.at(lowest));
    const Real enough = Real(1.01) * dot(first, first);
    const auto mayBeNearest = [&](Real h) { return !(h * h > enough); };
    Xy shortest{Real(1e18), 0};
    const auto take = [&](Xy way) {
        if (dot(way, way) < dot(shortest, shortest)) shortest = way;
    };
    for (std::uint32_t k = 0; k < other.corners; ++k)
        if (mayBeNearest(height[k]))
            take(k == lowest ? first : wayBetween(own.at(side), own.at(next), other.at(k)));
    for (std::uint32_t k = 0; k < other.sides; ++k) {
        if (!mayBeNearest(std::min(height[k], height[other.after(k)]))) continue;
        for (const auto end : {side, next}) {
            const Xy way = wayBetween(other.at(k), other.at(other.after(k)), own.at(end));
            take({-way.x, -way.y});
        }
    }
    return shortest;
}

/// The axis along which two outlines are farthest apart, from the first to the second: the normal
/// of the side with the largest gap, or, where corners are nearest, the way between them, which
/// are an end of that side and a corner of the other.
struct Separation {
    Xy axis;
    Real gap = 0;  // m
};

/// The side of either outline with the largest gap to the other.
struct WidestSide {
    const Outline *own, *other;
    Real sign = 1;  // of its normal, from the first outline to the second
    std::uint32_t side = 0;
    Real gap = Real(-1e30);  // m

    WidestSide(const Outline& a, const Outline& b) : own(&a), other(&b) {
        if (a.sides > 0) take(a, b, 1);
        if (b.sides > 0) take(b, a, -1);
    }
    Xy axis() const { return {sign * own->out(side).x, sign * own->out(side).y}; }

private:
    void take(const Outline& one, const Outline& another, Real direction) {
        const Gaps gaps(one, another);
        if (!(gaps.largest() > gap)) return;
        own = &one;
        other = &another;
        sign = direction;
        side = gaps.widest;
        gap = gaps.largest();
    }
};

Separation separationOf(const WidestSide& widest) {
    const Separation best{widest.axis(), widest.gap};
    if (best.gap < 0) return best;
    Xy way = shortestWay(*widest.own, widest.side, *widest.other);
    way = {widest.sign * way.x, widest.sign * way.y};
    const Real far = std::sqrt(dot(way, way));
    if (!(far > best.gap)) return best;
    return {{way.x / far, way.y / far}, far};
}
Separation separationOf(const Outline& a, const Outline& b, const WidestSide& widest) {
    if (a.sides > 0 || b.sides > 0) return separationOf(widest);
    const Xy d = b.at(0) - a.at(0);
    const Real far = std::sqrt(dot(d, d));
    return far > 0 ? Separation{{d.x / far, d.y / far}, far} : Separation{{0, 1}, 0};
}

/// Distance from a point to a side's segment: negative behind a side, also beside its ends, where
/// an outline has an inside.
Real distanceTo(const Outline& o, std::uint32_t side, Xy p) {
    const Xy from = o.at(side), to = o.at(o.after(side)), way = to - from, v = p - from;
    const Real height = dot(o.out(side), v);
    const Real length2 = dot(way, way), along = dot(way, v);
    if (along >= 0 && along <= length2) return height;
    const Xy d = p - (along < 0 ? from : to);
    const Real far = std::sqrt(dot(d, d));
    return height < 0 && o.corners > 2 ? height : far;
}

class Finder {
public:
    Finder(const Chunk& a, const Chunk& b, const Outline& outA, const Outline& outB, Real near,
           Real reach, Manifold& result)
        : a_(a), b_(b), outA_(outA), outB_(outB), near_(near), reach_(reach), result_(result) {
        thickness_ = a.radius + b.radius;
    }

    void run() {
        if (outA_.sides == 0 || outB_.sides == 0) return pointAgainst();
        const Gaps gapsA(outA_, outB_), gapsB(outB_, outA_);
        const bool ofA = gapsA.largest() >= gapsB.largest() - Real(0.025) * thickness_;
        const Gaps& gaps = ofA ? gapsA : gapsB;
        result_.gap = gaps.largest() - thickness_;
        if (result_.gap > near_) return;
        clip(ofA, gaps, ofA ? gapsB : gapsA);
    }

private:
    /// A disc before the nearest of what the other has.
    void pointAgainst() {
        const bool discIsB = outB_.sides == 0;
        const Outline &disc = discIsB ? outB_ : outA_, &other = discIsB ? outA_ : outB_;
        const Chunk &discChunk = discIsB ? b_ : a_, &otherChunk = discIsB ? a_ : b_;
        std::uint32_t side = 0;
        Real distance = 0;
        if (other.sides == 0) {
            const Xy d = disc.at(0) - other.at(0);
            distance = std::sqrt(dot(d, d));
        } else {
            Real height = Real(-1e30);
            for (std::uint32_t i = 0; i < other.sides; ++i) {
                const Real h = dot(other.out(i), disc.at(0) - other.at(i));
                if (h > height) {
                    height = h;
                    side = i;
                }
            }
            distance = distanceTo(other, side, disc.at(0));
        }
        result_.gap = distance - thickness_;
        result_.margin = thickness_ / 4;
        if (result_.gap > near_) return;
        add({discChunk.firstCorner, otherChunk.firstSide + side, discIsB, result_.gap});
    }

    void clip(bool ofA, const Gaps& gaps, const Gaps& otherGaps) {
        const Outline &own = ofA ? outA_ : outB_, &other = ofA ? outB_ : outA_;
        const Chunk &ownChunk = ofA ? a_ : b_, &otherChunk = ofA ? b_ : a_;
        const auto side = gaps.widest;
        const Xy out = own.out(side), tangent{-out.y, out.x};
        std::uint32_t facing = 0;
        Real deepest = 2, next = 2;
        for (std::uint32_t i = 0; i < other.sides; ++i) {
            const Real d = dot(out, other.out(i));
            if (d < deepest) {
                next = deepest;
                deepest = d;
                facing = i;
            } else {
                next = std::min(next, d);
            }
        }
        // Along the tangent the reference goes from `end` to `start`, the facing side the other
        // way.
        const std::uint32_t r0 = side, r1 = own.after(side), f0 = facing, f1 = other.after(facing);
        const Real start = dot(tangent, own.at(r0)), end = dot(tangent, own.at(r1));
        const Real low = std::min(start, end), high = std::max(start, end);
        std::uint32_t lowCorner = f0, highCorner = f1;
        if (dot(tangent, other.at(f0)) > dot(tangent, other.at(f1)))
            std::swap(lowCorner, highCorner);
        const Real lowAt = dot(tangent, other.at(lowCorner));
        const Real highAt = dot(tangent, other.at(highCorner));
        const std::uint32_t lowEnd = start < end ? r0 : r1, highEnd = start < end ? r1 : r0;
        const auto corner = [&](std::uint32_t c) {
            addNear({otherChunk.firstCorner + c, ownChunk.firstSide + side, ofA,
                     distanceTo(own, side, other.at(c)) - thickness_});
        };
        const auto ownEnd = [&](std::uint32_t c) {
            addNear({ownChunk.firstCorner + c, otherChunk.firstSide + facing, !ofA,
                     distanceTo(other, facing, own.at(c)) - thickness_});
        };
        // Where the facing side has the largest gap instead, the same corners touch.
        const Real second =
            std::max(gaps.largestBut(side, own.sides), otherGaps.largestBut(facing, other.sides));
        slack_ = std::min((gaps.largest() - second) / 2, (next - deepest) / 2 * reach_);
        least_ = Real(1e30);
        // Beside each other, an end of the reference is nearest to the other side or its ends.
        const auto beside = [&](std::uint32_t c) {
            const Xy way = other.at(f1) - other.at(f0), v = own.at(c) - other.at(f0);
            const Real along = dot(way, v);
            if (along > 0 && along < dot(way, way))
                ownEnd(c);
            else
                corner(along > 0 ? f1 : f0);
            slack_ = 0;
        };
        if (lowAt > high) {
            beside(highEnd);
        } else if (highAt < low) {
            beside(lowEnd);
        } else {
            lowAt >= low ? corner(lowCorner) : ownEnd(lowEnd);
            highAt <= high ? corner(highCorner) : ownEnd(highEnd);
            slack_ = std::min({slack_, std::abs(lowAt - low), std::abs(highAt - high), high - lowAt,
                               highAt - low});
        }
        result_.gap = least_;
        const Real room = std::min(far_ - Real(0.3) * thickness_, slack_ + thickness_ / 5);
        result_.margin =
            std::max({thickness_ / 5, room,
                      std::min(least_ - thickness_ / 4, near_ - Real(0.3) * thickness_)});
    }

    void addNear(const Feature& feature) {
        least_ = std::min(least_, feature.gap);
        if (feature.gap < near_)
            add(feature);
        else
            far_ = std::min(far_, feature.gap);
    }
    void add(const Feature& feature) {
        result_.features[static_cast<std::size_t>(result_.count++)] = feature;
    }

    const Chunk &a_, &b_;
    const Outline &outA_, &outB_;
    Real near_, reach_, thickness_ = 0;
    Manifold& result_;
    Real slack_ = 0, least_ = 0, far_ = Real(1e30);
};

}  // namespace

Heading turnedBy(const Movers& movers, std::uint32_t m, Real angle) {
    const Heading h = movers.headingAtReference(m);
    const Real t = movers.bodies[m].turn + angle;
    if (std::abs(t) > largeTurn) {
        const Point by = unitVector(static_cast<double>(t));
        const Real c = static_cast<Real>(by[0]), s = static_cast<Real>(by[1]);
        return {h.cosine * c - h.sine * s, h.sine * c + h.cosine * s};
    }
    const Real square = t * t;
    const Real c =
        1 - square * (Real(1.0 / 2) - square * (Real(1.0 / 24) - square * Real(1.0 / 720)));
    const Real s = t * (1 - square * (Real(1.0 / 6) - square * Real(1.0 / 120)));
    return {h.cosine * c - h.sine * s, h.sine * c + h.cosine * s};
}
Heading headingNow(const Movers& movers, std::uint32_t m) {
    return turnedBy(movers, m, 0);
}

namespace {

/// b in the frame of a.
struct Pose {
    Xy at;
    Heading heading;
    Heading ofA;  // its own
};
/// Two bodies and how they go in this step.
struct Ways {
    std::uint32_t a = 0, b = 0;
    Motion3 ofA, ofB;
};
Pose poseAt(const Movers& movers, const Ways& w, Real moment) {
    const Heading ha = turnedBy(movers, w.a, moment * w.ofA.turn),
                  hb = turnedBy(movers, w.b, moment * w.ofB.turn);
    const Point apart = movers.placeAtReference(w.b) - movers.placeAtReference(w.a);
    const SolverBody &bodyA = movers.bodies[w.a], &bodyB = movers.bodies[w.b];
    const Real dx =
        static_cast<Real>(apart[0]) + (bodyB.x - bodyA.x) + moment * (w.ofB.x - w.ofA.x);
    const Real dy =
        static_cast<Real>(apart[1]) + (bodyB.y - bodyA.y) + moment * (w.ofB.y - w.ofA.y);
    return {{ha.cosine * dx + ha.sine * dy, ha.cosine * dy - ha.sine * dx},
            {ha.cosine * hb.cosine + ha.sine * hb.sine, ha.cosine * hb.sine - ha.sine * hb.cosine},
            ha};
}

/// m, by how much surfaces have moved against each other: b turns where it is, reaching so far.
Real movedBetween(const Pose& p, const Pose& q, Real reach) {
    return std::abs(q.at.x - p.at.x) + std::abs(q.at.y - p.at.y) +
           reach * (std::abs(q.heading.cosine - p.heading.cosine) +
                    std::abs(q.heading.sine - p.heading.sine));
}

/// When two outlines come as near as a limit, as a share of the step, or 1; and how they are then.
struct Approach {
    Real moment = 1;
    Pose pose{};
    Xy axis{0, 1};  // that separates them, from a to b in the frame of a
};

/// Conservative advancement along the axis that separates two outlines (Mirtich 1996) until their
/// axes are as near as a limit, which follows from how near they begin and is `most` at most, m.
template <class Limit>
Approach advance(const Movers& movers, const Outline& outA, const Outline& ownB, const Ways& ways,
                 Real most, Limit&& limitFrom) {
    const Real turning = movers.reach[ways.a] * std::abs(ways.ofA.turn) +
                         movers.reach[ways.b] * std::abs(ways.ofB.turn);
    const Real wx = ways.ofB.x - ways.ofA.x, wy = ways.ofB.y - ways.ofA.y;
    Real moment = 0, limit = 0;
    for (int round = 0; round <= mostRounds && moment < 1; ++round) {
        const Pose pose = poseAt(movers, ways, moment);
        const Heading h = pose.ofA;
        const auto closingAlong = [&](Xy axis) {
            return turning - dot(axis, {h.cosine * wx + h.sine * wy, h.cosine * wy - h.sine * wx});
        };
        const Outline outB(ownB, pose.heading, pose.at);
        const WidestSide widest(outA, outB);
        // Mostly one side tells that they do not come so near, without the shortest way.
        if (widest.gap > most && widest.gap - most > closingAlong(widest.axis())) return {};
        const Separation s = separationOf(outA, outB, widest);
        if (round == 0) limit = limitFrom(s.gap);
        const Real closing = closingAlong(s.axis);
        if (round == mostRounds) return {moment, pose, s.axis};
        if (closing <= 0) return {};
        // A hundredth of the limit is near enough.
        if (s.gap <= limit + std::abs(limit) / 100) return {moment, pose, s.axis};
        moment = moment + (s.gap - limit) / closing;
    }
    return {};
}

}  // namespace

void findPassing(const ContactCore& core, const Chunk& a, const Chunk& b, Real left,
                 std::vector<Passing>& passings) {
    passings.clear();
    const Ways ways{a.frame, b.frame, motionOf(core.ways[a.frame]), motionOf(core.ways[b.frame])};
    const Real thickness = a.radius + b.radius;
    const Outline outA(core.shapes, a), ownB(core.shapes, b);
    Real limit = 0, before = 0;
    const auto limitFrom = [&](Real gap) {
        before = gap - thickness;
        return limit = gap > 0 ? std::min(left * thickness, gap) : Real(-1e30);
    };
    const auto [moment, then, axis] =
        advance(core.movers, outA, ownB, ways, left * thickness, limitFrom);
    if (moment >= 1) return;
    // The axis that separates them then stays, or turns with one of them, on whose side it stands;
    // they end as near as they do along the best one.
    const Pose end = poseAt(core.movers, ways, 1);
    const Outline outB(ownB, end.heading, end.at);
    const Xy still = turnedBack(end.ofA, turned(then.ofA, axis));
    const Xy withA = outA.sides > 0 ? axis : still;
    const Xy withB = outB.sides > 0 ? turned(end.heading, turnedBack(then.heading, axis)) : still;
    Separation best{still, Real(-1e30)};
    Xy nearest = outB.at(0);
    for (const Xy along : {still, withA, withB}) {
        Real highA = Real(-1e30);
        std::uint32_t low = 0;
        for (std::uint32_t k = 0; k < outA.corners; ++k)
            highA = std::max(highA, dot(along, outA.at(k)));
        for (std::uint32_t k = 1; k < outB.corners; ++k)
            if (dot(along, outB.at(k)) < dot(along, outB.at(low))) low = k;
        const Real gap = dot(along, outB.at(low)) - highA;
        if (!(gap > best.gap)) continue;
        best = {along, gap};
        nearest = outB.at(low);
    }
    const Real depth = limit - best.gap;
    if (!(depth > 0)) return;
    const Xy normal = turned(end.ofA, best.axis);
    const Xy arm = turned(end.ofA, nearest);
    const SolverBody& bodyA = core.movers.bodies[a.frame];
    const Vec2 at(bodyA.x + ways.ofA.x + arm.x - b.radius * normal.x,
                  bodyA.y + ways.ofA.y + arm.y - b.radius * normal.y);
    passings.push_back({b.frame,
                        {a.frame, a.frame},
                        0,
                        moment,
                        {normal.x, normal.y},
                        depth,
                        before,
                        core.movers.placeAtReference(a.frame) + at.cast<double>()});
}

Manifold findManifold(const Movers& movers, const Shapes& shapes, const Chunk& a, const Chunk& b,
                      Real closing) {
    const Real thickness = a.radius + b.radius, near = thickness / 2 + 2 * closing;
    const Ways ways{a.frame, b.frame, motionNow(movers, a.frame), motionNow(movers, b.frame)};
    const Pose start = poseAt(movers, ways, 0);
    const Real reach = movers.reach[b.frame];
    Manifold m;
    m.x = start.at.x;
    m.y = start.at.y;
    m.cosine = start.heading.cosine;
    m.sine = start.heading.sine;
    const Outline outA(shapes, a), ownB(shapes, b), outB(ownB, start.heading, start.at);
    Finder(a, b, outA, outB, near, reach, m).run();
    // What is near stays what it is until the step ends, or hardly changes.
    if (m.count == 0 || closing <= fast * thickness) return m;
    const Pose end = poseAt(movers, ways, 1);
    if (movedBetween(start, end, reach) <= m.margin + fast * thickness) return m;
    const Real gap = m.gap;
    const Approach approach =
        advance(movers, outA, ownB, ways, thickness, [&](Real) { return thickness; });
    if (approach.moment > 0) {
        const Pose& then = approach.moment < 1 ? approach.pose : end;
        m.count = 0;
        Finder(a, b, outA, Outline(ownB, then.heading, then.at), near, reach, m).run();
    }
    m.gap = std::min(m.gap, gap);
    // Nobody knows whether they go as is predicted.
    m.margin = 0;
    return m;
}

}  // namespace sulfur::detail
