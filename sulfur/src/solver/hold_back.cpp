#include "solver/hold_back.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/entwined.hpp"
#include "collision/meeting.hpp"
#include "collision/pairs.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

/// Things that stop change what others run into.
constexpr int rounds = 5;
/// This much of the thickness may be pressed in on the way.
constexpr Real pressed = Real(0.5);

/// What stays below this share of what could cross is not looked at. Less than 1, for rounding.
constexpr Real calmBelow = Real(0.98);

/// Where a particle goes in this tick, as the constraints left it.
Vec2 wayOf(const State& state, std::uint32_t particle) {
    const Particles& p = state.particles;
    const bool led = p.cluster[particle] != none && state.awake(p.body[particle]);
    return led ? displacementOf(state, gripOf(state, particle)) : p.displacement[particle];
}

/// Where the bodies go, roughly: which particle of one can cross which capsule of another.
class Courses {
public:
    /// Returns whether anything moves so far that it could cross something that stays: is restless.
    bool find(const State& state) {
        courses_.assign(state.bodies.size(), {});
        for (std::size_t i = 0; i < courses_.size(); ++i)
            courses_[i].room = calmBelow * pressed * state.broad.thinnest[i];
        addClusters(state);
        addParticles(state);
        for (const auto& [one, other] : state.broad.tied) merge(courses_[one], courses_[other]);
        isRestless_.resize(courses_.size());
        std::transform(courses_.begin(), courses_.end(), isRestless_.begin(), [](const Course& c) {
            return c.way.lpNorm<1>() + c.spread >= c.room ? 1 : 0;
        });
        return std::find(isRestless_.begin(), isRestless_.end(), 1) != isRestless_.end();
    }

    /// Whether nothing of the two can move past the other by as much as may be pressed in.
    bool stayApart(std::uint32_t one, std::uint32_t other) const {
        if ((isRestless_[one] | isRestless_[other]) == 0) return true;
        const Course &a = courses_[one], &b = courses_[other];
        return (a.way - b.way).lpNorm<1>() + (a.spread + b.spread) < a.room + b.room;
    }

private:
    /// All of a body goes along `way`, but for `spread` at most (the sum of both coordinates).
    struct Course {
        Vec2 way{0, 0};   // m
        Real spread = 0;  // m
        Real room = 0;    // m, the way that is too short to cross anything that stays
        bool known = false;
    };

    static void add(Course& course, const Vec2& way, Real spread) {
        if (!course.known) {
            course.way = way;
            course.spread = spread;
            course.known = true;
            return;
        }
        course.spread = std::max(course.way.lpNorm<1>() + course.spread, way.lpNorm<1>() + spread);
        course.way = Vec2(0, 0);
    }

    /// Bodies that a capsule joins: it is part of both.
    static void merge(Course& a, Course& b) {
        a.known = b.known = true;  // that they stay, where nothing moves them
        add(a, b.way, b.spread);
        a.room = std::min(a.room, b.room);
        b = a;
    }

    void addClusters(const State& state) {
        constexpr Real diagonal = Real(1.4143);  // the sum of a vector's coordinates by its length
        for (const auto i : state.work.awakeClusters) {
            const Cluster& c = state.clusters.list[i];
            const Real turn = std::abs(c.sine) + std::abs(c.versine);
            add(courses_[c.body], c.displacement, diagonal * turn * static_cast<Real>(c.reach));
        }
    }

    void addParticles(const State& state) {
        const Particles& p = state.particles;
        for (const Range range : state.work.points)
            for (auto i = range.first; i < range.last; ++i)
                add(courses_[p.body[i]], p.displacement[i], 0);
    }

    std::vector<Course> courses_;  // by body
    std::vector<std::uint8_t> isRestless_;
};

/// A particle and a collider, with their ways.
struct Crossers {
    Local local;
    Real thickness = 0;  // m
    Real travel = 0;     // m, past each other at most
};

Crossers crossersOf(const State& state, const Watch& watch) {
    const Collider& c = state.broad.collider(watch.candidate.collider);
    Crossers found;
    found.local.dp = wayOf(state, watch.candidate.particle);
    found.local.da = wayOf(state, c.a);
    found.local.db = c.b == c.a ? found.local.da : wayOf(state, c.b);
    const Local& l = found.local;
    found.thickness = state.particles.reach[watch.candidate.particle] + c.radius;
    found.travel = std::max((l.dp - l.da).lpNorm<1>(), (l.dp - l.db).lpNorm<1>());
    return found;
}

/// How far a particle will be from where it was rasterised.
Real outingOf(const State& state, std::uint32_t particle, const Vec2& way) {
    const Point& from = state.broad.reference[particle];
    return (state.particles.position[particle] - from).cast<Real>().norm() + way.norm();
}

/// Whether the sides can have come near enough to each other, as in forEachNear().
bool mayMeet(const State& state, const Watch& watch, const Local& l) {
    const Real out = outingOf(state, watch.candidate.particle, l.dp);
    const Real outA = outingOf(state, watch.a, l.da), outB = outingOf(state, watch.b, l.db);
    return 2 * (out + std::max(outA, outB)) >= watch.spare;
}

/// The share of the tick after which they meet, 1 if they do not, or did before it began.
Real meetingTime(const State& state, const Watch& watch) {
    Crossers found = crossersOf(state, watch);
    const Real most = pressed * found.thickness;
    if (found.travel < most || !mayMeet(state, watch, found.local)) return 1;
    const auto& x = state.particles.position;
    Local& l = found.local;
    l.p = (x[watch.candidate.particle] - x[watch.a]).cast<Real>();
    l.b = (x[watch.b] - x[watch.a]).cast<Real>();
    if (meet(l).distance <= most) return 1;
    const Meeting m = meetOnTheWay(l, most);
    return m.fraction > 0 ? m.fraction : 1;
}

/// Calls f(const Watch&) for the candidates of all bodies that may move past each other.
template <class Function>
void forEachCrossing(State& state, const Courses& courses, Function&& f) {
    for (const WatchRun& run : watchRuns(state)) {
        if (courses.stayApart(run.one, run.other)) continue;
        for (auto k = run.first; k < run.last; ++k) f(state.broad.watches[k]);
    }
}

/// Whether anything was predicted to move so fast that it could pass a surface within the tick.
bool anyFast(const State& state) {
    for (const Range range : state.work.awake)
        for (auto i = range.first; i < range.last; ++i) {
            const Real reach = state.particles.reach[i];
            if (reach > 0 && state.particles.displacement[i].lpNorm<1>() > pressed * reach)
                return true;
        }
    return false;
}

/// What holding back took of the displacement of a particle that keeps its velocity.
struct LostWay {
    std::uint32_t particle = 0;
    Vec2 displacement{0, 0};  // m
};

/// Of the present tick, until keepVelocities().
std::vector<LostWay>& lostWays() {
    thread_local std::vector<LostWay> ways;
    return ways;
}

class Brakes {
public:
    explicit Brakes(State& state) : state_(state), held_(scratch()) {
        held_.assign(state.bodies.size(), {});
    }

    /// Two bodies that meet after a share of the tick.
    void stopAt(std::uint32_t a, std::uint32_t b, Real share) {
        const bool rigid = !isSoft(a) && !isSoft(b);
        for (const auto body : {a, b}) {
            if (state_.bodies[body].kind != BodyKind::dynamic) continue;
            held_[body].share = std::min(held_[body].share, share);
            held_[body].keepsVelocity &= rigid;
        }
    }

    /// Returns whether any body was held back.
    bool apply() {
        bool any = false;
        for (std::uint32_t i = 0; i < held_.size(); ++i) {
            if (held_[i].share >= 1) continue;
            any = true;
            const BodyRecord& body = state_.bodies[i];
            for (std::uint32_t k = 0; k < body.particles.size(); ++k)
                hold(body.firstParticle + k, held_[i]);
        }
        if (!any) return false;
        for (const auto c : state_.work.awakeClusters) {
            Cluster& cluster = state_.clusters.list[c];
            if (held_[cluster.body].share < 1) hold(cluster, held_[cluster.body]);
        }
        std::fill(held_.begin(), held_.end(), Held{});
        return true;
    }

private:
    /// What is held back keeps its velocity, and with it the momentum that it shares in the next
    /// tick with what it runs into; but not where something soft would go on to be run through.
    struct Held {
        Real share = 1;
        bool keepsVelocity = true;
    };

    bool isSoft(std::uint32_t body) const {
        const BodyRecord& b = state_.bodies[body];
        return b.particles.size() > 1 && state_.particles.cluster[b.firstParticle] == none &&
               state_.trees.ofParticle[b.firstParticle] == none;
    }

    /// Whether its velocity will be that of its displacement, as that of a chain that nothing
    /// touches is not.
    bool followsDisplacement(std::uint32_t particle) const {
        const auto tree = state_.trees.ofParticle[particle];
        return tree == none || !state_.trees.list[tree].alone || state_.trees.touched[tree] != 0;
    }

    void hold(std::uint32_t particle, const Held& held) {
        Particles& p = state_.particles;
        if (p.cluster[particle] != none || p.inverseMass[particle] == 0) return;
        Vec2& displacement = p.displacement[particle];
        if (held.keepsVelocity && followsDisplacement(particle))
            lostWays().push_back({particle, (1 - held.share) * displacement});
        displacement *= held.share;
    }

    void hold(Cluster& c, const Held& held) {
        if (held.keepsVelocity) {
            const double lost = static_cast<double>((1 - held.share) / state_.h);
            c.velocity += lost * c.displacement.cast<double>();
            c.spin += lost * c.angle;
        }
        c.displacement *= held.share;
        c.angle *= static_cast<double>(held.share);
        updateTurn(c);
    }

    static std::vector<Held>& scratch() {
        thread_local std::vector<Held> held;
        return held;
    }

    State& state_;
    std::vector<Held>& held_;  // by body
};

}  // namespace

void holdBack(State& state) {
    lostWays().clear();
    if (state.broad.watches.empty()) return;
    thread_local Courses scratch;
    Courses& courses = scratch;
    if (!courses.find(state) || !anyFast(state)) return;
    Brakes brakes(state);
    for (int round = 0; round < rounds; ++round) {
        if (round > 0) courses.find(state);
        forEachCrossing(state, courses, [&](const Watch& watch) {
            ++state.statistics.heldBack;
            const Real share = meetingTime(state, watch);
            if (share >= 1) return;
            const auto body = state.particles.body[watch.candidate.particle];
            const auto other = state.broad.collider(watch.candidate.collider).body;
            if (areEntwined(state, body, other)) return;
            // Whoever still moves in the last round stays where it is.
            brakes.stopAt(body, other, round + 1 < rounds ? share : 0);
        });
        if (!brakes.apply()) return;
    }
}

void keepVelocities(State& state) {
    for (const LostWay& way : lostWays())
        state.particles.velocity[way.particle] += (way.displacement / state.h).cast<double>();
    lostWays().clear();
}

}  // namespace sulfur::detail
