// Bodies that are made or put by hand into each other are led apart as wholes: along the shortest
// way on which their outlines, taken as convex, come free, not faster than any overlap is pushed
// apart, and without leaving velocity behind. Until then no rows act between them.
#include <algorithm>
#include <limits>
#include <memory_resource>
#include <optional>
#include <unordered_map>
#include <utility>

#include "contacts/row_pushes.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/clusters.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "shape/arc.hpp"

namespace sulfur::detail {

namespace {

using tuned::entangled;
using tuned::leadingSpeed;
using tuned::tolerated;
/// Of the way out, in a step: who is in several others follows the deepest.
constexpr double leadingShare = tuned::recoveryShare;
/// Steps after which bodies that press on each other are looked at again.
constexpr std::uint64_t lookEvery = tuned::seldom;

/// A capsule or disc of a body: where its ends are now.
struct Thick {
    Point a{0, 0}, b{0, 0};
    double radius = 0;
    std::int32_t outward = 0;
    bool disc = false;
};

Point placeOf(const ContactCore& core, std::uint32_t corner) {
    const Corner& c = core.shapes.corners[corner];
    return placeOnMover(core.movers, c.mover, c.x, c.y);
}

using Outline = std::pmr::vector<Thick>;

Outline surfacesOfBody(State& state, std::uint32_t bodySlot) {
    const ContactCore& core = state.core;
    Outline list(&state.arena);
    for (auto c = core.shapes.firstChunk[bodySlot]; c != none;
         c = core.shapes.chunks[c].nextOfBody) {
        const Chunk& chunk = core.shapes.chunks[c];
        for (auto s = chunk.firstSide; s < chunk.firstSide + chunk.sides; ++s) {
            const Side& side = core.shapes.sides[s];
            const auto add = [&](const Point& a, const Point& b) {
                list.push_back(
                    {a, b, static_cast<double>(side.radius), side.outward, side.a == side.b});
            };
            const Point a = placeOf(core, side.a), b = placeOf(core, side.b);
            if (arcRadius(side) > 0) {
                const auto j = state.jointSlots.denseOf(side.joint);
                forEachChord(
                    arcBetween(a, b, static_cast<double>(state.joints.bend[j].angle)),
                    static_cast<double>(side.radius) / 4,
                    [&](const Point& from, const Point& to, double, double) { add(from, to); });
            } else {
                add(a, b);
            }
        }
    }
    return list;
}

/// Whether a point is within the outline that one-sided capsules make, by its winding number.
bool encloses(const Outline& outline, const Point& p) {
    int turns = 0;
    for (const Thick& t : outline) {
        if (t.outward == 0 || t.disc) continue;
        const Point& from = t.outward > 0 ? t.a : t.b;
        const Point& to = t.outward > 0 ? t.b : t.a;
        const bool above = from[1] > p[1];
        if (above == (to[1] > p[1])) continue;
        const double turn = cross(to - from, p - from);
        if (above ? turn < 0 : turn > 0) turns += above ? -1 : 1;
    }
    return turns > 0;
}

bool doCross(const Thick& s, const Thick& t) {
    const auto side = [](const Point& a, const Point& b, const Point& p) {
        return cross(b - a, p - a);
    };
    return side(s.a, s.b, t.a) * side(s.a, s.b, t.b) < 0 &&
           side(t.a, t.b, s.a) * side(t.a, t.b, s.b) < 0;
}

/// Whether test(surface) for any of those that are compared with all of another outline: of a long
/// one some, evenly spread.
template <class Test>
bool anyCompared(const Outline& outline, Test&& test) {
    const std::size_t every = outline.size() / (tuned::mostCompared + 1) + 1;
    for (std::size_t k = 0; k < outline.size(); k += every)
        if (test(outline[k])) return true;
    return false;
}

/// Deeper than their surfaces are thick: an end of one is within the other's outline, or two lines
/// cross: the ends of one would be held off the other on both sides of it. Two discs, when each has
/// the other's centre in it.
bool areInEachOther(const Outline& one, const Outline& other) {
    if (one.size() == 1 && other.size() == 1 && one[0].disc && other[0].disc)
        return (one[0].a - other[0].a).norm() < std::min(one[0].radius, other[0].radius);
    const auto holds = [](const Outline& outer, const Outline& inner) {
        return anyCompared(
            inner, [&](const Thick& t) { return encloses(outer, t.a) || encloses(outer, t.b); });
    };
    if (holds(one, other) || holds(other, one)) return true;
    return anyCompared(one, [&](const Thick& s) {
        return std::any_of(other.begin(), other.end(),
                           [&](const Thick& t) { return !s.disc && !t.disc && doCross(s, t); });
    });
}

double distanceToSegment(const Point& p, const Thick& t) {
    const Point along = t.b - t.a;
    const double square = along.squaredNorm();
    const double share = square > 0 ? std::clamp((p - t.a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (p - t.a - share * along).norm();
}

/// Whether two surfaces are nearer than this share of their thickness.
bool areNear(const Thick& s, const Thick& t, double share) {
    const double near = share * (s.radius + t.radius);
    return distanceToSegment(s.a, t) < near || distanceToSegment(s.b, t) < near ||
           distanceToSegment(t.a, s) < near || distanceToSegment(t.b, s) < near;
}

/// Whether the surfaces still overlap by a good part of their thickness.
bool overlap(const Outline& one, const Outline& other) {
    return anyCompared(one, [&](const Thick& s) {
        return std::any_of(other.begin(), other.end(),
                           [&](const Thick& t) { return areNear(s, t, tolerated); });
    });
}

/// Whether lines that have no inside lie in each other: each corner would be pushed out on whatever
/// side it happens to be.
bool areEntangled(const Outline& one, const Outline& other) {
    const auto hasInside = [](const Thick& t) { return t.disc || t.outward != 0; };
    return anyCompared(one, [&](const Thick& s) {
        return std::any_of(other.begin(), other.end(), [&](const Thick& t) {
            return !hasInside(s) && !hasInside(t) && areNear(s, t, entangled);
        });
    });
}

/// A way out: the first body moves by `depth` along `direction` against the second.
struct WayOut {
    Point direction{0, 1};
    double depth = std::numeric_limits<double>::max();  // m
};

double extentOf(const Outline& body, const Point& direction) {
    double most = -std::numeric_limits<double>::max();
    for (const Thick& t : body)
        most = std::max(most, std::max(direction.dot(t.a), direction.dot(t.b)) + t.radius);
    return most;
}

WayOut shortestWayOut(const Outline& one, const Outline& other) {
    WayOut best;
    const auto consider = [&](const Point& way) {
        const double length = way.norm();
        if (!(length > 1e-9)) return;
        const Point direction = way / length;
        const double depth = extentOf(other, direction) + extentOf(one, -direction);
        // A way that is as short as one before it to rounding does not take its place.
        if (depth < best.depth * (1 - 1e-9) - 1e-9) best = {direction, depth};
    };
    consider(one.front().a - other.front().a);
    for (const auto& [body, sign] : {std::pair(&one, -1.0), std::pair(&other, 1.0)})
        anyCompared(*body, [&, sign = sign](const Thick& t) {
            if (t.disc) return false;
            const Point right = sign * Point(t.b[1] - t.a[1], t.a[0] - t.b[0]);
            if (t.outward >= 0) consider(right);
            if (t.outward <= 0) consider(-right);
            return false;
        });
    if (best.depth == std::numeric_limits<double>::max()) consider(Point(0, 1));
    return best;
}

/// A body as a whole.
struct Whole {
    std::uint32_t body = 0;  // dense index
    double inverseMass = 0;  // 1/kg; 0 if anything holds it
    Point way{0, 0};         // m, mean displacement in this step
};

Whole wholeOf(const State& state, std::uint32_t body) {
    const BodyRecord& record = state.bodies[body];
    Whole whole{body};
    double mass = 0;
    bool isHeld = record.kind != BodyKind::dynamic;
    const auto last = record.firstParticle + record.particles.size();
    for (auto i = record.firstParticle; i < last; ++i) {
        const double m = static_cast<double>(state.particles.mass[i]);
        const auto c = state.particles.cluster[i];
        mass += m;
        isHeld = isHeld || state.particles.pinned[i];
        whole.way +=
            m * (c == none ? state.particles.displacement[i] : state.clusters.list[c].displacement)
                    .cast<double>();
    }
    whole.way /= mass;
    whole.inverseMass = isHeld ? 0 : 1 / mass;
    return whole;
}

template <class OfParticle, class OfCluster>
void forEachPart(State& state, std::uint32_t body, OfParticle&& ofParticle, OfCluster&& ofCluster) {
    const BodyRecord& record = state.bodies[body];
    const auto last = record.firstParticle + record.particles.size();
    for (auto i = record.firstParticle; i < last; ++i)
        if (state.particles.cluster[i] == none) ofParticle(i);
    // Both lists are in the order of bodies.
    const auto& awake = state.work.awakeClusters;
    const auto ofBody = std::partition_point(awake.begin(), awake.end(), [&](std::uint32_t c) {
        return state.clusters.list[c].body < body;
    });
    for (auto c = ofBody; c != awake.end() && state.clusters.list[*c].body == body; ++c)
        ofCluster(state.clusters.list[*c]);
}

/// Whoever was put somewhere is looked at once.
void findOverlaps(State& state) {
    ContactCore& core = state.core;
    for (const auto slot : state.placed) {
        if (slot >= core.shapes.firstChunk.size()) continue;
        for (auto c = core.shapes.firstChunk[slot]; c != none; c = core.shapes.chunks[c].nextOfBody)
            for (auto at = core.shapes.chunks[c].firstPair; at != none;
                 at = core.pairs[at / 2].next[at % 2])
                core.leading.push_back(core.pairs[at / 2].encounter);
    }
    state.placed.clear();
}

bool isFree(const State& state, BodyId id) {
    return state.bodies[state.bodySlots.dense(id)].kind == BodyKind::dynamic;
}

/// Convex outlines part along their shortest way out by themselves.
bool isConvex(const ContactCore& core, const Encounter& encounter) {
    for (auto p = encounter.firstPair; p != none; p = core.pairs[p].nextOfEncounter)
        if (core.pairs[p].isManifold == 0) return false;
    return true;
}

/// What is squeezed or broken can come to be through something else: the rows then hold it on the
/// far side. Most of that mends itself; what is still so at the next look is led apart.
void findEntwined(State& state) {
    ContactCore& core = state.core;
    for (auto e = stepNumber(state) % lookEvery; e < core.encounters.size(); e += lookEvery) {
        Encounter& encounter = core.encounters[e];
        if (encounter.firstPair == none || encounter.rowless != 0 || encounter.pressing == 0 ||
            isConvex(core, encounter) || !isFree(state, encounter.a) || !isFree(state, encounter.b))
            continue;
        const Outline one = surfacesOfBody(state, encounter.a.index - 1),
                      other = surfacesOfBody(state, encounter.b.index - 1);
        const bool entwined = areInEachOther(one, other);
        if (std::exchange(encounter.entwined, entwined ? 1u : 0u) != 0 && entwined)
            core.leading.push_back(static_cast<std::uint32_t>(e));
    }
}

class Leader {
public:
    explicit Leader(State& state) : state_(state), core_(state.core), parts_(&state.arena) {}

    /// Whether two bodies still are in each other; then they are led on.
    bool lead(const Encounter& encounter) {
        if (!encounter.a || encounter.firstPair == none || encounter.a == encounter.b) return false;
        const auto slotA = encounter.a.index - 1, slotB = encounter.b.index - 1;
        if (std::binary_search(core_.linkedBodies.begin(), core_.linkedBodies.end(),
                               std::pair(slotA, slotB)))
            return false;
        Part &a = partOf(slotA), &b = partOf(slotB);
        if (a.whole.inverseMass + b.whole.inverseMass == 0) return false;
        const bool goesOn = encounter.rowless != 0 ? overlap(a.outline, b.outline)
                                                   : areEntangled(a.outline, b.outline);
        if (!goesOn && !areInEachOther(a.outline, b.outline)) return false;
        for (const Part* part : {&a, &b})
            if (state_.bodies[part->whole.body].asleep)
                core_.toWake.push_back(state_.bodies[part->whole.body].id.index - 1);
        const WayOut way = shortestWayOut(a.outline, b.outline);
        const double closing = way.direction.dot(a.whole.way - b.whole.way);
        const double move = leadingShare * way.depth;
        const auto [weightA, weightB] = weightsOf(a, b, way.direction);
        for (const auto& [part, weight] : {std::pair(&a, weightA), std::pair(&b, -weightB)}) {
            const Point out = weight * way.direction;
            if (closing < 0) addVelocity(part->whole, -closing * out);
            core_.leads.push_back({part->whole.body, (move * out).cast<Real>()});
        }
        return true;
    }

private:
    /// What is asked for each of the bodies that a body is in.
    struct Part {
        Outline outline;
        Whole whole;
        std::optional<Point> support;  // once it was asked for
    };

    Part& partOf(std::uint32_t slot) {
        const auto at = parts_.find(slot);
        if (at != parts_.end()) return at->second;
        return parts_
            .emplace(slot, Part{surfacesOfBody(state_, slot),
                                wholeOf(state_, state_.bodySlots.denseOf(slot)),
                                {}})
            .first->second;
    }

    /// By which share of the way each of two goes: as their masses have it, but a lighter one that
    /// stands against something fixed goes no farther than the other, who else would never go.
    std::pair<double, double> weightsOf(Part& a, Part& b, const Point& way) {
        double weightA = a.whole.inverseMass, weightB = b.whole.inverseMass;
        if (weightA > weightB && weightB > 0 && supportOf(a).dot(way) < 0) weightA = weightB;
        if (weightB > weightA && weightA > 0 && supportOf(b).dot(way) > 0) weightB = weightA;
        return {weightA / (weightA + weightB), weightB / (weightA + weightB)};
    }
    /// kg m, by which rows with something that nothing pushes press a body.
    const Point& supportOf(Part& part) {
        if (part.support) return *part.support;
        Point& support = part.support.emplace(0, 0);
        const auto slot = state_.bodies[part.whole.body].id.index - 1;
        forEachRow(core_, slot, [&](const auto& block, std::uint32_t lane) {
            Vec2 onBody(0, 0);
            bool isFixed = false;
            forEachPush(block, lane, [&](std::uint32_t m, const Vec2& push, Real) {
                const SolverBody& solver = core_.movers.bodies[m];
                if (solver.inverseMass == 0 && solver.inverseInertia == 0)
                    isFixed = isFixed || !push.isZero(0);
                else
                    onBody += push;
            });
            if (isFixed) support += onBody.cast<double>();
        });
        return support;
    }

    void addVelocity(Whole& whole, const Point& by) {
        whole.way += by;
        const Vec2 more = by.cast<Real>();
        forEachPart(
            state_, whole.body, [&](std::uint32_t i) { state_.particles.displacement[i] += more; },
            [&](Cluster& c) { c.displacement += more; });
    }

    State& state_;
    ContactCore& core_;
    std::pmr::unordered_map<std::uint32_t, Part> parts_;  // by slot
};

}  // namespace

void leadApart(State& state) {
    ContactCore& core = state.core;
    core.leads.clear();
    if (!state.placed.empty()) findOverlaps(state);
    findEntwined(state);
    if (core.leading.empty()) return;
    std::sort(core.leading.begin(), core.leading.end());
    core.leading.erase(std::unique(core.leading.begin(), core.leading.end()), core.leading.end());
    Leader leader(state);
    std::erase_if(core.leading, [&](std::uint32_t index) {
        Encounter& encounter = core.encounters[index];
        if (encounter.rowless == Encounter::letPass) return true;
        const bool goesOn = leader.lead(encounter);
        encounter.rowless = goesOn ? Encounter::ledApart : 0;
        return !goesOn;
    });
    takeMotionAgain(state);
}

void endLeads(State& state) {
    ContactCore& core = state.core;
    std::stable_sort(core.leads.begin(), core.leads.end(),
                     [](const Lead& a, const Lead& b) { return a.body < b.body; });
    for (std::size_t k = 0; k < core.leads.size();) {
        const auto body = core.leads[k].body;
        Vec2 move(0, 0);
        for (; k < core.leads.size() && core.leads[k].body == body; ++k) move += core.leads[k].way;
        const Real length = move.norm(), most = static_cast<Real>(leadingSpeed) * state.h;
        if (length == 0) continue;
        if (length > most) move *= most / length;
        forEachPart(
            state, body,
            [&](std::uint32_t i) { state.particles.position[i] += move.cast<double>(); },
            [&](Cluster& c) { c.shift += move; });
        for (auto c = core.shapes.firstChunk[state.bodies[body].id.index - 1]; c != none;
             c = core.shapes.chunks[c].nextOfBody) {
            const Chunk& chunk = core.shapes.chunks[c];
            if (chunk.uses > 1) core.movers.odometer[chunk.frame] += static_cast<double>(length);
            for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
                core.movers.odometer[core.shapes.uses[u].mover] += static_cast<double>(length);
        }
        state.bodies[body].restingTime = 0;
    }
}

}  // namespace sulfur::detail
