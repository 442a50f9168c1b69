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
#include <cmath>

#include "collision/contact_memory.hpp"
#include "collision/entwined.hpp"
#include "collision/geometry.hpp"
#include "collision/materials.hpp"
#include "collision/meeting.hpp"
#include "collision/outlines.hpp"
#include "core/pieces.hpp"
#include "solver/contact_motion.hpp"
#include "solver/restitution.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// What the contact acts on: the capsule's point is one grip if a rigid component has both ends.
void takeHold(const State& state, Contact& c) {
    c.gripOfParticle = gripOf(state, c.particle);
    c.gripOfA = gripOf(state, c.a);
    c.gripOfB = gripOf(state, c.b);
    c.shareA = c.weightA;
    c.shareB = c.weightB;
    if (c.gripOfA.cluster == none || c.gripOfA.cluster != c.gripOfB.cluster) return;
    c.gripOfA.arm = c.weightA * c.gripOfA.arm + c.weightB * c.gripOfB.arm;
    c.shareA = 1;
    c.shareB = 0;
}

/// Adds what pushes along the normal and the tangent meet at one of the contact's grips.
[[gnu::always_inline]] inline void addInverseMasses(const State& state, const Grip& grip,
                                                    Real share, Contact& c) {
    const Real share2 = share * share;
    c.inverseEffectiveMass += share2 * inverseMassAlong(state, grip, c.normal);
    c.tangentInverseMass += share2 * inverseMassAlong(state, grip, perpendicular(c.normal));
}

/// A particle and what it is held off: a point of a capsule, or the corner `a` (then a == b).
struct Touch {
    std::uint32_t particle = 0, a = 0, b = 0;
    const Collider* collider = nullptr;
    Meeting meeting;
    Real thickness = 0;
};

/// All but what depends on how it moves. (In its place: to copy a contact takes as long as this.)
void fillContact(const State& state, const Touch& t, Contact& contact) {
    contact.particle = t.particle;
    contact.a = t.a;
    contact.b = t.b;
    contact.joint = t.collider->joint;
    contact.bodyA = state.particles.body[t.particle];
    contact.bodyB = t.collider->body;
    contact.weightA = t.a == t.b ? 1 : 1 - t.meeting.along;
    contact.weightB = t.a == t.b ? 0 : t.meeting.along;
    contact.normal = t.meeting.normal;
    contact.thickness = t.thickness;
    contact.gap = t.meeting.distance - t.thickness;
    takeHold(state, contact);
    addInverseMasses(state, contact.gripOfParticle, 1, contact);
    addInverseMasses(state, contact.gripOfA, contact.shareA, contact);
    if (contact.shareB != 0) addInverseMasses(state, contact.gripOfB, contact.shareB, contact);
    giveSurface(state, contact);
}

Vec2 relativeDisplacement(const Particles& particles, const Touch& t) {
    const auto& d = particles.displacement;
    if (t.a == t.b) return d[t.particle] - d[t.a];
    return d[t.particle] - (1 - t.meeting.along) * d[t.a] - t.meeting.along * d[t.b];
}

/// What rests may stand this much off the surface: as far as four times the earth's gravity moves
/// it in a tick from rest, but no more than a share of the thickness. Within it a contact only
/// stops what closes it, so that no sweep's remainder sets a stack rocking. (What rebounds does so
/// at the surface itself, and has none.)
Real slackOf(const State& state, const Contact& c) {
    return std::min<Real>(Real(0.005) * c.thickness, Real(40) * state.h * state.h);
}

bool comesSliding(const State& state, const Contact& c, const Vec2& moved) {
    return std::abs(c.conveyed + perpendicular(c.normal).dot(moved)) > slipOfRest(state);
}

/// Whether it closes or slides, by the predicted motion, by so large a share of its thickness that
/// its direction, which is that of the tick's start, may be wrong at the end.
bool isFast(const Contact& c, Real closing, const Vec2& moved) {
    return -closing > Real(0.05) * c.thickness || moved.norm() > Real(0.25) * c.thickness;
}

/// How a particle is inside of a body. Candidates of the same two come one after the other, so that
/// the answer for the last one is mostly that for the next.
struct Inside {
    std::uint32_t particle = none, body = none;
    bool enclosed = false;
    std::uint32_t nearest = none;  // edge of its outline, by joint; none until somebody asks
};

/// What a piece of the stage finds.
struct Found {
    std::vector<Contact>& contacts;
    std::vector<std::uint32_t>& knocked;  // sleepers that something ran into
    Inside inside{};                      // what was asked last
};

/// A kinematic body that runs into a sleeper can only wake it in this tick.
void knock(const State& state, const Contact& c, Real closing, Found& found) {
    if (c.gap + closing > 0) return;
    for (const auto body : {c.bodyA, c.bodyB})
        if (state.bodies[body].asleep) found.knocked.push_back(body);
}

/// Adds the contact if the predicted displacements could close its gap.
void keepIfNear(const State& state, const Touch& t, Found& found) {
    const Vec2 moved = relativeDisplacement(state.particles, t);
    const Real closing = t.meeting.normal.dot(moved);
    const Real gap = t.meeting.distance - t.thickness;
    if (gap + std::min<Real>(closing, 0) > state.broad.watchedGap(t.thickness)) return;
    static const Contact blank;  // to copy it is faster than to clear a new one
    Contact& contact = found.contacts.emplace_back(blank);
    fillContact(state, t, contact);
    if (contact.inverseEffectiveMass == 0) {
        knock(state, contact, closing, found);
        return found.contacts.pop_back();
    }
    contact.approach = -closing / state.h;
    const bool rebounds = mayRebound(contact);
    contact.slack = rebounds ? 0 : slackOf(state, contact);
    contact.sliding = comesSliding(state, contact, moved);
    contact.fast = isFast(contact, closing, moved);
    if (rebounds) planRebound(state, contact);
}

Real thicknessOf(const State& state, const Candidate& candidate) {
    return state.particles.reach[candidate.particle] +
           state.broad.collider(candidate.collider).radius;
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
        return Vec2((x[p] - x[corner]).cast<Real>() + fraction * (d[p] - d[corner]));
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

bool meetsCorner(const State& state, const Touch& t, std::uint32_t corner, const Found& found) {
    const Real fraction = t.meeting.fraction;
    return !isOtherCorners(t.particle, corner) && isNew(found, t.particle, corner) &&
           isNearestAt(state, corner, t.particle, fraction) &&
           isNearestAt(state, t.particle, corner, fraction);
}

/// What was held off on one side stays on that side: when it is found on the other, it has been
/// pressed through, and the normal keeps its direction.
void keepSide(const State& state, Touch& t) {
    if (t.meeting.distance > t.thickness || t.meeting.fraction > 0) return;
    const ContactMemory* before = recall(state, t.particle, t.a, t.b);
    if (!before || before->normal.dot(t.meeting.normal) >= 0) return;
    t.meeting.normal = -t.meeting.normal;
    t.meeting.distance = -t.meeting.distance;
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

/// A capsule of an outline pushes to its outer side only. What is behind it without being inside of
/// the body is in front of another one; what is inside leaves through the nearest. Returns false
/// when this capsule has nothing to say.
bool keepOutside(const State& state, Touch& t, Found& found) {
    const Collider& c = *t.collider;
    if (c.joint == none || state.particles.body[t.particle] == c.body) return true;
    const int outward = state.broad.outlines.outwardOf(c.joint);
    if (outward == 0 || t.meeting.fraction > 0) return true;
    const auto& x = state.particles.position;
    const Point along = x[c.b] - x[c.a], offset = x[t.particle] - x[c.a];
    if (outward * cross(along, offset) <= 0) return true;  // to the right of a->b: outside
    if (!isEnclosed(state, t.particle, c.body, found.inside) || t.meeting.atEnd) return false;
    if (nearestOf(state, found.inside) != c.joint) return false;
    t.meeting.normal = -t.meeting.normal;
    t.meeting.distance = -t.meeting.distance;
    return true;
}

/// A first look at a particle and a capsule.
struct Look {
    Real along = 0;   // place on the axis that is nearest at the start of the tick
    Real travel = 0;  // m, by which the fastest part moves against the other
    bool far = true;  // this tick cannot bring them together
};

Look lookAt(const Local& l, Real thickness, Real margin) {
    Look look;
    look.travel = std::max((l.dp - l.da).lpNorm<1>(), (l.dp - l.db).lpNorm<1>());
    look.along = nearestAlong<Vec2>(l.p, Vec2(0, 0), l.b);
    const Real reach = thickness + margin + look.travel;
    look.far = (l.p - look.along * l.b).squaredNorm() > reach * reach;
    return look;
}

std::uint32_t cornerAt(const Collider& c, Real along) {
    return along < Real(0.5) ? c.a : c.b;
}

/// Parts of one rigid component never move against each other. (Asked here, not where candidates
/// are found: a query may look for these before the components are up to date.)
bool moveAsOne(const State& state, std::uint32_t particle, const Collider& c) {
    const auto& cluster = state.particles.cluster;
    return cluster[particle] != none && cluster[particle] == cluster[c.a] &&
           cluster[particle] == cluster[c.b];
}

void consider(const State& state, const Candidate& candidate, Found& found) {
    const Collider& c = state.broad.collider(candidate.collider);
    const Real thickness = thicknessOf(state, candidate);
    const Local local = localise(state.particles, candidate.particle, c);
    const Look look = lookAt(local, thickness, state.broad.watchedGap(thickness));
    if (look.far) return;
    const bool fast = look.travel > thickness;
    if (!fast && isEnd(look.along) && isOtherCorners(candidate.particle, cornerAt(c, look.along)))
        return;
    if (moveAsOne(state, candidate.particle, c)) return;
    Touch t{candidate.particle, c.a, c.b, &c, {}, thickness};
    t.meeting = fast ? meetOnTheWay(local, thickness) : meetAt(local, look.along);
    if (areEntwined(state, state.particles.body[candidate.particle], c.body)) return;
    if (t.meeting.atEnd) {
        const auto corner = cornerAt(c, t.meeting.along);
        if (!meetsCorner(state, t, corner, found)) return;
        t.a = t.b = corner;
    }
    if (!keepOutside(state, t, found)) return;  // may search all of an outline: comes last
    if (t.meeting.fraction > 0) {
        // The plane of the impact, seen from the start of the tick.
        const Vec2 offset = t.a == t.b && t.a == c.b ? Vec2(local.p - local.b)
                            : t.a == t.b             ? local.p
                                                     : Vec2(local.p - t.meeting.along * local.b);
        t.meeting.distance = t.meeting.normal.dot(offset);
    }
    if (t.meeting.distance > 0) keepSide(state, t);
    keepIfNear(state, t, found);
}

/// For two capsules that cross, the end that is nearest to the other's axis is led back to the
/// side that it came from.
struct Crossing {
    Candidate end;
    Meeting meeting;
};

void considerEnd(const State& state, std::uint32_t particle, std::uint32_t collider,
                 Crossing& best) {
    const Meeting m = meet(localise(state.particles, particle, state.broad.collider(collider)));
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
    explicit CrossingWalk(const std::vector<Crossing>& crossings)
        : next_(crossings.begin()), end_(crossings.end()) {}

    bool has(const Candidate& candidate) {
        while (next_ != end_ && next_->end < candidate) ++next_;
        return next_ != end_ && next_->end == candidate;
    }

private:
    std::vector<Crossing>::const_iterator next_, end_;
};

void considerCrossing(const State& state, const Crossing& crossing, Found& found) {
    const Collider& c = state.broad.collider(crossing.end.collider);
    Touch t{crossing.end.particle,           c.a, c.b, &c, crossing.meeting,
            thicknessOf(state, crossing.end)};
    t.meeting.normal = -t.meeting.normal;
    t.meeting.distance = -t.meeting.distance;
    keepIfNear(state, t, found);
}

/// A piece of work for a thread has at least so many runs of candidates.
constexpr std::size_t leastRuns = 1024;

/// The first run from `i` on that is of another particle than the one before: contacts of one
/// particle are found by one thread.
std::size_t particleStart(const std::vector<WatchRun>& runs, std::size_t i) {
    while (i > 0 && i < runs.size() && runs[i].one == runs[i - 1].one) ++i;
    return i;
}

/// What the pieces but the first find, which writes to the state; scratch memory only.
struct Piece {
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> knocked;
};

/// Looks at all candidates but those that cross, and leaves what they find in their order.
void considerCandidates(State& state, const std::vector<Crossing>& crossings) {
    thread_local std::vector<Piece> scratch;
    std::vector<Piece>& others = scratch;
    const BroadPhase& broad = state.broad;
    const std::size_t count = broad.watchRuns.size();
    const std::size_t pieces = piecesOf(state.tasks, count, leastRuns);
    if (others.size() < pieces) others.resize(pieces);
    runPieces(state.tasks, pieces, [&](std::size_t i) {
        Found found = i == 0 ? Found{state.contacts, state.knocked}
                             : Found{others[i].contacts, others[i].knocked};
        if (i > 0) found.contacts.clear(), found.knocked.clear();
        const auto start = [&](std::size_t piece) {
            return particleStart(broad.watchRuns, pieceStart(piece, pieces, count));
        };
        CrossingWalk crossing(crossings);
        forEachNear(broad, broad.outings, start(i), start(i + 1), [&](const Watch& watch) {
            if (!crossing.has(watch.candidate)) consider(state, watch.candidate, found);
        });
    });
    for (std::size_t i = 1; i < pieces; ++i) {
        state.contacts.insert(state.contacts.end(), others[i].contacts.begin(),
                              others[i].contacts.end());
        state.knocked.insert(state.knocked.end(), others[i].knocked.begin(),
                             others[i].knocked.end());
    }
}

}  // namespace

void findContacts(State& state) {
    state.contacts.clear();
    state.knocked.clear();
    partEntwined(state);
    indexMemory(state);
    thread_local std::vector<Crossing> crossings;  // nearly always empty
    crossings.clear();
    findCrossings(state, crossings);
    considerCandidates(state, crossings);
    Found found{state.contacts, state.knocked};
    for (const Crossing& crossing : crossings) considerCrossing(state, crossing, found);
    state.statistics.contacts = static_cast<std::uint32_t>(state.contacts.size());
}

}  // namespace sulfur::detail
