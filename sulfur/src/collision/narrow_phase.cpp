// Stage: candidates to contacts.
//
// Two segments that do not cross are nearest at an end of one of them, so particle against
// capsule is all there is in two dimensions, beside pairs that cross already.
//
// Contacts are found for the positions at the start of the tick, where nothing has passed through
// anything yet, or, between things so fast that they would pass each other within the tick, at the
// time of impact. They are kept when the predicted displacements could close the gap; the
// constraint gap + n . d >= 0 then stops even what would jump over a thin wall.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "collision/contact_memory.hpp"
#include "collision/entwined.hpp"
#include "collision/filling.hpp"
#include "collision/geometry.hpp"
#include "collision/meeting.hpp"
#include "collision/outlines.hpp"
#include "collision/pairs.hpp"
#include "core/pieces.hpp"
#include "kernels/meeting_lanes.hpp"
#include "kernels/outings.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

Vec2 relativeDisplacement(const Particles& particles, const FoundTouch& t) {
    const auto& d = particles.displacement;
    const ContactPlan& plan = t.plan;
    const Vec2 &p = d[plan.particle], &a = d[plan.a], &b = d[plan.b];
    if (t.atCorner()) return {p[0] - a[0], p[1] - a[1]};
    const Real onA = 1 - t.meeting.along, onB = t.meeting.along;
    return {p[0] - onA * a[0] - onB * b[0], p[1] - onA * a[1] - onB * b[1]};
}

void keepIfNear(const State& state, const FoundTouch& t, Found& found) {
    const Vec2 moved = relativeDisplacement(state.particles, t);
    keepIfNear(state, t, moved, t.meeting.normal.dot(moved), found);
}

/// From where on, as a share of its length, a capsule's side counts as nearer than its end; less
/// is lost in the rounding of meet().
constexpr Real besideAt = Real(1e-5);

/// Whether `corner` is the point nearest to `other` of all capsules that end in it. Otherwise the
/// side of one of them is nearer, and the corner must not push: it would make a bump where a
/// thing slides over the seam of two segments.
bool isNearestAt(const State& state, std::uint32_t corner, std::uint32_t other, Real fraction) {
    const auto& x = state.particles.position;
    const auto& d = state.particles.displacement;
    const auto towards = [&](std::uint32_t p) {
        const Vec2 now = (x[p] - x[corner]).cast<Real>();
        return fraction > 0 ? Vec2(now + fraction * (d[p] - d[corner])) : now;
    };
    const Vec2 way = towards(other);
    const Spokes& spokes = state.broad.spokes;
    for (auto k = spokes.start[corner]; k < spokes.start[corner + 1]; ++k) {
        const Vec2 spoke = towards(spokes.end[k]);
        if (way.dot(spoke) > besideAt * spoke.squaredNorm()) return false;
    }
    return true;
}

/// Two corners that face each other come up as several candidates; the first of them counts.
bool isNew(const Found& found, std::uint32_t particle, std::uint32_t corner) {
    for (auto c = found.contacts.rbegin(); c != found.contacts.rend(); ++c) {
        if (c->particle != particle) return true;
        if (c->a == corner && c->b == corner) return false;
    }
    return true;
}

/// Whether the contact of two corners is that of the other one with this one.
bool isOtherCorners(std::uint32_t particle, std::uint32_t corner) {
    return particle >= corner;
}

/// Whether a candidate's particle meets this corner of its collider; most that come near it do not.
bool meetsCorner(const State& state, std::uint32_t watch, std::uint32_t corner, Real fraction,
                 const Found& found) {
    const auto particle = state.broad.looks.particle[watch];
    if (isOtherCorners(particle, corner) || !isNearestAt(state, corner, particle, fraction) ||
        !isNearestAt(state, particle, corner, fraction) || !isNew(found, particle, corner))
        return false;
    const Collider& c = state.broad.collider(state.broad.watches[watch].candidate.collider);
    return !moveAsOne(state, particle, c) &&
           !areEntwined(state, state.particles.body[particle], c.body);
}

/// What was held off on one side stays on that side: when it is found on the other, it has been
/// pressed through, and the normal keeps its direction.
bool isPressedThrough(const State& state, const ContactPlan& plan, Real normalX, Real normalY) {
    const ContactMemory* before = recall(state, plan.particle, plan.a, plan.b);
    return before && before->normal.dot(Vec2(normalX, normalY)) < 0;
}

[[gnu::always_inline]] inline void turnRound(Meeting& meeting) {
    meeting.normal = Vec2(-meeting.normal[0], -meeting.normal[1]);
    meeting.distance = -meeting.distance;
}

/// The edge of a body's outline that is nearest to a point.
std::uint32_t nearestEdge(const State& state, std::uint32_t body, const Point& point) {
    const auto& x = state.particles.position;
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t joint = none;
    for (const OutlineEdge& e : state.broad.outlines.of(body)) {
        const Point from = x[e.from] - point, to = x[e.to] - point;
        const double along = nearestAlong<Point>(Point(0, 0), from, to);
        const double distance = (from + along * (to - from)).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        joint = e.joint;
    }
    return joint;
}

bool isEnclosed(const State& state, std::uint32_t particle, std::uint32_t body, Inside& inside) {
    if (inside.particle != particle || inside.body != body)
        inside = {particle, body, encloses(state, body, state.particles.position[particle]), none};
    return inside.enclosed;
}

std::uint32_t nearestOf(const State& state, Inside& inside) {
    if (inside.nearest == none)
        inside.nearest = nearestEdge(state, inside.body, state.particles.position[inside.particle]);
    return inside.nearest;
}

/// Twice the area to the left of a capsule, up to a particle, in m^2: from `a` to `b` and to it.
[[gnu::always_inline]] inline double areaBeside(const Point& a, const Point& b, const Point& p) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// Whether a particle is behind a capsule that pushes to its outer side only, that to the right of
/// the way from a to b or, with `outward` < 0, to the left.
[[gnu::always_inline]] inline bool isBehind(int outward, double areaBeside) {
    return outward != 0 && !(outward * areaBeside <= 0);
}

/// What is behind a capsule without being inside of the body is in front of another one; what is
/// inside leaves through the nearest. (This may search all of an outline.)
bool leavesThrough(const State& state, const ContactPlan& plan, Found& found) {
    return isEnclosed(state, plan.particle, plan.bodyB, found.inside) &&
           nearestOf(state, found.inside) == plan.joint;
}

/// The particles of a candidate. (Those of a Watch are further off in memory.)
struct Sides {
    std::uint32_t particle = 0, a = 0, b = 0;
};
Sides sidesOf(const State& state, std::uint32_t watch) {
    const Looks& looks = state.broad.looks;
    return {looks.particle[watch], looks.a[watch], looks.b[watch]};
}

/// The end of a candidate's capsule that is nearer to a place on it.
std::uint32_t cornerAt(const Looks& looks, std::uint32_t watch, Real along) {
    return along < Real(0.5) ? looks.a[watch] : looks.b[watch];
}

/// The plane of an impact, seen from the start of the tick.
void seeFromStart(const Local& local, const Sides& sides, FoundTouch& t) {
    const Vec2 offset = t.atCorner() && t.plan.a == sides.b ? Vec2(local.p - local.b)
                        : t.atCorner()                      ? local.p
                                       : Vec2(local.p - t.meeting.along * local.b);
    t.meeting.distance = t.meeting.normal.dot(offset);
}

/// How a candidate meets at the start of the tick.
void considerNow(const State& state, const Sides& sides, FoundTouch t, Found& found) {
    Meeting& m = t.meeting;
    const auto& x = state.particles.position;
    if (isBehind(t.plan.outward, areaBeside(x[sides.a], x[sides.b], x[sides.particle]))) {
        if (m.atEnd || !leavesThrough(state, t.plan, found)) return;
        turnRound(m);
    }
    if (m.distance > 0 && m.distance <= t.plan.thickness &&
        isPressedThrough(state, t.plan, m.normal[0], m.normal[1]))
        turnRound(m);
    keepIfNear(state, t, found);
}

/// The same for one that may meet on its way.
void considerLater(const State& state, const Sides& sides, const Local& local, FoundTouch t,
                   Found& found) {
    if (!(t.meeting.fraction > 0)) return considerNow(state, sides, t, found);
    seeFromStart(local, sides, t);
    keepIfNear(state, t, found);
}

const ContactPlan& planFirst(const State& state, std::uint32_t watch, Found& found) {
    const Watch& w = state.broad.watches[watch];
    const auto& [particle, collider] = w.candidate;
    const Collider& c = state.broad.collider(collider);
    found.plans.push_back({watch, planContact(state, particle, w.a, w.b, c)});
    return found.plans.back().plan;
}

/// The plan of a candidate's own contact, not of that of its corners.
inline const ContactPlan& planOf(const State& state, std::uint32_t watch, Found& found) {
    const auto kept = state.broad.looks.plan[watch];
    return kept != none ? state.broad.plans[kept] : planFirst(state, watch, found);
}

/// The side of the axis is nearest.
void considerSide(const State& state, std::uint32_t watch, const Local& local, Real along,
                  Found& found) {
    const ContactPlan& plan = planOf(state, watch, found);
    if (plan.movesAsOne || areEntwined(state, plan.bodyA, plan.bodyB)) return;
    considerNow(state, sidesOf(state, watch), {plan, meetSide(local, along)}, found);
}

ContactPlan planCorner(const State& state, std::uint32_t watch, std::uint32_t corner) {
    const auto& [particle, collider] = state.broad.watches[watch].candidate;
    return planContact(state, particle, corner, corner, state.broad.collider(collider));
}

/// An end of the axis is nearest at the start of the tick: the corner there, if it is the one that
/// counts.
void considerCorner(const State& state, std::uint32_t watch, Real along, Found& found) {
    const auto corner = cornerAt(state.broad.looks, watch, along);
    if (!meetsCorner(state, watch, corner, 0, found)) return;
    const ContactPlan plan = planCorner(state, watch, corner);
    const Sides sides = sidesOf(state, watch);
    const Local local = localise(state.particles, sides.particle, sides.a, sides.b);
    considerNow(state, sides, {plan, meetEnd(local, along)}, found);
}

/// The same on the way.
void considerFastCorner(const State& state, std::uint32_t watch, const Local& local,
                        const Meeting& meeting, Found& found) {
    const auto corner = cornerAt(state.broad.looks, watch, meeting.along);
    if (!meetsCorner(state, watch, corner, meeting.fraction, found)) return;
    const ContactPlan plan = planCorner(state, watch, corner);
    considerLater(state, sidesOf(state, watch), local, {plan, meeting}, found);
}

/// What moves by more than its thickness in this tick.
void considerFast(const State& state, std::uint32_t watch, const Local& local, Found& found) {
    const Meeting meeting = meetOnTheWay(local, state.broad.looks.thickness[watch]);
    if (meeting.atEnd) return considerFastCorner(state, watch, local, meeting, found);
    const ContactPlan& plan = planOf(state, watch, found);
    if (plan.movesAsOne || areEntwined(state, plan.bodyA, plan.bodyB)) return;
    considerLater(state, sidesOf(state, watch), local, {plan, meeting}, found);
}

void considerAlone(const State& state, std::uint32_t watch, Found& found) {
    const Sides sides = sidesOf(state, watch);
    const Local local = localise(state.particles, sides.particle, sides.a, sides.b);
    const Real thickness = state.broad.looks.thickness[watch];
    const Look look = lookAt(local, thickness + state.broad.watchedGap(thickness));
    if (look.far) return;
    if (look.travel > thickness) return considerFast(state, watch, local, found);
    if (!isEnd(look.along)) return considerSide(state, watch, local, look.along, found);
    considerCorner(state, watch, look.along, found);
}

/// So many candidates are looked at together at most.
constexpr std::size_t nearBatch = 256;

/// Candidates that are looked at together. Most are far, near a corner that does not count, or lie
/// against the side of a capsule as they did in the last tick; that is settled here, and the others
/// are considered alone. Scratch memory only.
class Lookout {
public:
    void look(const State& state, std::span<const std::uint32_t> watches) {
        const Particles& particles = state.particles;
        MeetingBlock* block = blocks_.data();
        for (; !watches.empty(); ++block) {
            const std::size_t count = std::min(watches.size(), meetingLanes);
            place(state.broad, watches.first(count), *block);
            watches = watches.subspan(count);
        }
        const auto count = static_cast<std::size_t>(block - blocks_.data());
        meetingKernels().gather(
            {particles.position.data()->data(), particles.displacement.data()->data()},
            blocks_.data(), count);
        meetingKernels().meet(blocks_.data(), count);
    }

    /// What considerAlone() does, for the `k`th.
    void consider(const State& state, std::uint32_t watch, std::size_t k, Found& found) const {
        const MeetingBlock& b = blocks_[k / meetingLanes];
        const std::size_t i = k % meetingLanes;
        if (b.far[i] != 0) return;
        const Looks& looks = state.broad.looks;
        if (!(b.travel[i] > looks.thickness[watch])) {
            if (isEnd(b.along[i])) return considerCorner(state, watch, b.along[i], found);
            const auto plan = looks.plan[watch];
            if (plan != none && considerSide(state, state.broad.plans[plan], b, i, found)) return;
        }
        considerAlone(state, watch, found);
    }

private:
    static void place(const BroadPhase& broad, std::span<const std::uint32_t> watches,
                      MeetingBlock& block) {
        const Looks& looks = broad.looks;
        for (std::size_t i = 0; i < meetingLanes; ++i) {
            // Lanes behind the last candidate look at it once more.
            const auto k = watches[std::min(i, watches.size() - 1)];
            block.particle[i] = looks.particle[k];
            block.a[i] = looks.a[k];
            block.b[i] = looks.b[k];
            block.reach[i] = looks.thickness[k] + broad.watchedGap(looks.thickness[k]);
        }
    }

    /// Beside its capsule. Returns false where it is not where it belongs.
    static bool considerSide(const State& state, const ContactPlan& plan, const MeetingBlock& b,
                             std::size_t i, Found& found) {
        if (plan.movesAsOne || areEntwined(state, plan.bodyA, plan.bodyB)) return true;
        const Real distance = b.distance[i], x = b.normalX[i], y = b.normalY[i];
        if (isBehind(plan.outward, b.beside[i])) return false;
        if (distance > 0 && distance <= plan.thickness && isPressedThrough(state, plan, x, y))
            return false;
        const FoundTouch t{plan, {.along = b.along[i], .normal = Vec2(x, y), .distance = distance}};
        keepIfNear(state, t, Vec2(b.movedX[i], b.movedY[i]), b.closing[i], found);
        return true;
    }

    std::array<MeetingBlock, nearBatch / meetingLanes> blocks_;
};

/// For two capsules that cross, the end that is nearest to the other's axis is led back to the
/// side that it came from.
struct Crossing {
    Candidate end;
    Meeting meeting;
};

void considerEnd(const State& state, std::uint32_t particle, std::uint32_t collider,
                 Crossing& best) {
    const Collider& c = state.broad.collider(collider);
    const Meeting m = meet(localise(state.particles, particle, c.a, c.b));
    if (m.distance < best.meeting.distance) best = {{particle, collider}, m};
}

void findCrossings(const State& state, std::vector<Crossing>& found) {
    const BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    forEachNearPair(broad, broad.outings, [&](const WatchedPair& pair) {
        const auto i = pair.first, j = pair.second;
        const Collider& a = broad.collider(i);
        const Collider& b = broad.collider(j);
        if (a.a == a.b || b.a == b.b || !segmentsCross(x[a.a], x[a.b], x[b.a], x[b.b])) return;
        if (areEntwined(state, a.body, b.body) || moveAsOne(state, a.a, b)) return;
        Crossing best;
        best.meeting.distance = std::numeric_limits<Real>::max();
        considerEnd(state, a.a, j, best);
        considerEnd(state, a.b, j, best);
        considerEnd(state, b.a, i, best);
        considerEnd(state, b.b, i, best);
        found.push_back(best);
    });
    std::sort(found.begin(), found.end(),
              [](const Crossing& a, const Crossing& b) { return a.end < b.end; });
}

/// Walks along the crossings beside candidates that come in their order.
class CrossingWalk {
public:
    CrossingWalk(const BroadPhase& broad, const std::vector<Crossing>& crossings)
        : broad_(broad), next_(crossings.begin()), end_(crossings.end()) {}

    bool has(std::uint32_t watch) {
        if (next_ == end_ || broad_.looks.particle[watch] < next_->end.particle) return false;
        const Candidate& candidate = broad_.watches[watch].candidate;
        while (next_ != end_ && next_->end < candidate) ++next_;
        return next_ != end_ && next_->end == candidate;
    }

private:
    const BroadPhase& broad_;
    std::vector<Crossing>::const_iterator next_, end_;
};

void considerCrossing(const State& state, const Crossing& crossing, Found& found) {
    const Collider& c = state.broad.collider(crossing.end.collider);
    const ContactPlan plan = planContact(state, crossing.end.particle, c.a, c.b, c);
    FoundTouch t{plan, crossing.meeting};
    turnRound(t.meeting);
    keepIfNear(state, t, found);
}

/// Candidates, of which most are far.
constexpr std::size_t candidatesInMicrosecond = 200;

/// The first candidate from `i` on that is of another particle than the one before: contacts of one
/// particle are found by one thread.
std::size_t particleStart(const std::vector<std::uint32_t>& particle, std::size_t i) {
    while (i > 0 && i < particle.size() && particle[i] == particle[i - 1]) ++i;
    return i;
}

/// Calls f(numbers of candidates), in their order, for those in [first, last) whose sides can have
/// come near enough to each other.
template <class Function>
void forEachNear(const State& state, std::size_t first, std::size_t last, Function&& f) {
    const BroadPhase& broad = state.broad;
    const Looks& looks = broad.looks;
    const CandidateView view{looks.particle.data(), looks.a.data(), looks.b.data(),
                             looks.spare.data()};
    std::array<std::uint32_t, nearBatch> near;
    for (; first < last; first += nearBatch) {
        const auto end = std::min(first + nearBatch, last);
        const auto count = outingKernels().findNear(view, broad.outings.ofParticle.data(),
                                                    near.data(), first, end);
        f(std::span<const std::uint32_t>(near.data(), count));
    }
}

/// What the pieces but the first find, which writes to the state; scratch memory only.
struct Piece {
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> knocked;
    std::vector<FirstPlan> plans;
};

/// Writes down what the pieces planned, for the ticks to come.
void keepPlans(BroadPhase& broad, const std::vector<FirstPlan>& plans) {
    for (const FirstPlan& first : plans) {
        broad.watches[first.watch].plan = broad.looks.plan[first.watch] =
            static_cast<std::uint32_t>(broad.plans.size());
        broad.plans.push_back(first.plan);
    }
}

/// Looks at all candidates but those that cross, and leaves what they find in their order.
void considerCandidates(State& state, const std::vector<Crossing>& crossings) {
    thread_local std::vector<Piece> scratch;
    std::vector<Piece>& found = scratch;
    BroadPhase& broad = state.broad;
    const std::size_t count = broad.watches.size();
    const Real slip = slipOfRest(state);
    const std::size_t pieces = piecesOf(state.tasks, count, candidatesInMicrosecond);
    if (found.size() < pieces) found.resize(pieces);
    runPieces(state.tasks, pieces, [&](std::size_t i) {
        Piece& piece = found[i];
        piece.contacts.clear(), piece.knocked.clear(), piece.plans.clear();
        // One day all are planned anew in one tick.
        if (piece.plans.capacity() < broad.plans.capacity() / pieces)
            piece.plans.reserve(broad.plans.capacity() / pieces);
        Found here = i == 0 ? Found{state.contacts, state.knocked, piece.plans, slip}
                            : Found{piece.contacts, piece.knocked, piece.plans, slip};
        const auto start = [&](std::size_t k) {
            return particleStart(broad.looks.particle, pieceStart(k, pieces, count));
        };
        CrossingWalk crossing(broad, crossings);
        thread_local Lookout room;
        Lookout& lookout = room;
        forEachNear(state, start(i), start(i + 1), [&](auto watches) {
            lookout.look(state, watches);
            for (std::size_t k = 0; k < watches.size(); ++k)
                if (!crossing.has(watches[k])) lookout.consider(state, watches[k], k, here);
        });
    });
    for (std::size_t i = 0; i < pieces; ++i) {
        const Piece& piece = found[i];
        state.contacts.insert(state.contacts.end(), piece.contacts.begin(), piece.contacts.end());
        state.knocked.insert(state.knocked.end(), piece.knocked.begin(), piece.knocked.end());
        keepPlans(broad, piece.plans);
        state.statistics.plannedContacts += static_cast<std::uint32_t>(piece.plans.size());
    }
}

}  // namespace

void findContacts(State& state) {
    state.contacts.clear();
    state.knocked.clear();
    partEntwined(state);
    // Which has led some of them on since the grid was looked at.
    if (!state.entwined.empty()) updateBroadPhase(state);
    dropStalePlans(state.broad);
    indexMemory(state);
    thread_local std::vector<Crossing> crossings;  // nearly always empty
    crossings.clear();
    findCrossings(state, crossings);
    considerCandidates(state, crossings);
    std::vector<FirstPlan> noPlans;  // a crossing is none of the candidate's own
    Found found{state.contacts, state.knocked, noPlans, slipOfRest(state)};
    for (const Crossing& crossing : crossings) considerCrossing(state, crossing, found);
    state.statistics.contacts = static_cast<std::uint32_t>(state.contacts.size());
}

}  // namespace sulfur::detail
