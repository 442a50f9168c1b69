#include "solver/substeps.hpp"

#include <algorithm>
#include <limits>

#include "core/disjoint_sets.hpp"
#include "solver/contact_rows.hpp"
#include "solver/driven.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

constexpr int wantedRate = 480;     // Hz, of steps, while something asks for it
constexpr double calmAfter = 0.5;   // s
constexpr double fastTravel = 0.1;  // radii in a tick
/// Islands are found once in so many ticks, and where something new asks or goes astray.
constexpr int ticksAhead = 8;

double tickOf(const State& state) {
    return 1.0 / state.settings.tickRate;
}

/// Calls f(body) for all that may move in this tick, physics or its caller moving it.
template <class Function>
void forEachAwake(const State& state, Function&& f) {
    for (const auto body : state.work.bodies) f(body);
    if (state.work.movers != ListedMovers::all)
        for (const auto body : state.steps.parkedWork.bodies) f(body);
}

/// Whether anything of it that can touch covers too much of its own thickness in a tick.
bool isFast(const State& state, const BodyRecord& body) {
    const Particles& p = state.particles;
    const double tick = tickOf(state);
    const auto last = body.firstParticle + body.particles.size();
    for (std::size_t i = body.firstParticle; i < last; ++i) {
        const double most = fastTravel * static_cast<double>(p.reach[i]);
        if (most > 0 && tick * tick * p.velocity[i].squaredNorm() > most * most) return true;
    }
    return false;
}

/// Whether the caller has just put it somewhere where it can touch.
bool isPlacedSurface(const State& state, const BodyRecord& body) {
    if (!body.placed) return false;
    const auto first = state.particles.reach.begin() + body.firstParticle;
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                       [](Real reach) { return reach > 0; });
}

/// Finds out which bodies ask for short steps.
void ask(State& state) {
    forEachAwake(state, [&](std::uint32_t b) {
        BodyRecord& body = state.bodies[b];
        const bool stiff = body.kind == BodyKind::dynamic && state.structure.unresolved[b] != 0;
        if (body.asksForShortSteps || stiff || isPlacedSurface(state, body) || isFast(state, body))
            body.asksForShortSteps = true;
    });
    for (const BodyPair& pair : state.entwined)
        for (const BodyId id : {pair.a, pair.b})
            if (state.bodySlots.contains(id))
                state.bodies[state.bodySlots.dense(id)].asksForShortSteps = true;
}

/// Which of those that are awake have a reason of their own for short steps.
struct Reasons {
    bool any = false, all = true;
    bool changed = false;  // some have one, or have one no longer, other than in the last tick
};

/// Sets, of each body by itself, for how long its ticks go on being divided.
Reasons countDown(State& state) {
    const double tick = tickOf(state);
    Reasons reasons;
    forEachAwake(state, [&](std::uint32_t b) {
        BodyRecord& body = state.bodies[b];
        body.dividedFor =
            body.asksForShortSteps ? calmAfter : std::max(body.dividedFor - tick, 0.0);
        body.asksForShortSteps = false;
        if (body.kind != BodyKind::dynamic && !(body.dividedFor > 0)) return;
        reasons.any |= body.dividedFor > 0;
        reasons.all &= body.dividedFor > 0;
        reasons.changed |= body.divided != (body.dividedFor > 0);
    });
    return reasons;
}

/// What a body can touch in some time, for one that has no surface nothing.
struct Reach {
    Point low, high;
    std::uint32_t body = 0;

    bool isEmpty() const { return low[0] > high[0]; }
};

/// Of so many ticks from now on, as velocities lead, as far as contacts are watched.
Reach reachOf(const State& state, std::uint32_t b, int ticks) {
    const Particles& p = state.particles;
    const BodyRecord& body = state.bodies[b];
    const double ahead = ticks * tickOf(state);
    const double fall = static_cast<double>(state.settings.gravity.norm()) * ahead * ahead / 2;
    const double most = std::numeric_limits<double>::max();
    Reach reach{{most, most}, {-most, -most}, b};
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        if (p.reach[i] == 0) continue;
        const double margin = 1.5 * static_cast<double>(p.reach[i]) + fall;
        const Point way = body.moving ? Point(ticks * (goalOf(state, body, i) - p.position[i]))
                                      : Point(ahead * p.velocity[i]);
        const Point end = p.position[i] + way;
        reach.low = reach.low.cwiseMin(p.position[i].cwiseMin(end) - Point(margin, margin));
        reach.high = reach.high.cwiseMax(p.position[i].cwiseMax(end) + Point(margin, margin));
    }
    return reach;
}

/// Whether any body can touch in this tick what it could not when islands were found.
bool anyLeavesItsReach(const State& state) {
    bool any = false;
    forEachAwake(state, [&](std::uint32_t b) {
        if (any) return;
        const BodyRecord& body = state.bodies[b];
        const Reach now = reachOf(state, b, 1);
        any = !body.hasReach ||
              (!now.isEmpty() && ((now.low.array() < body.reachLow.array()).any() ||
                                  (now.high.array() > body.reachHigh.array()).any()));
    });
    return any;
}

/// Of bodies that move and have a surface, by their left ends. From geometry alone: candidates
/// depend on when they were found, and how the world goes on must not.
void findReaches(State& state, std::vector<Reach>& reaches) {
    reaches.clear();
    forEachAwake(state, [&](std::uint32_t b) {
        const Reach reach = reachOf(state, b, ticksAhead + 1);
        BodyRecord& body = state.bodies[b];
        body.hasReach = true;
        body.reachLow = reach.low;
        body.reachHigh = reach.high;
        if (!reach.isEmpty()) reaches.push_back(reach);
    });
    std::sort(reaches.begin(), reaches.end(), [](const Reach& a, const Reach& b) {
        return a.low[0] != b.low[0] ? a.low[0] < b.low[0] : a.body < b.body;
    });
}

/// Bodies that physics moves and that may act on each other, also by what their caller drives.
class Islands {
public:
    void find(State& state) {
        state_ = &state;
        sets_.reset(state.bodies.size());
        findReaches(state, reaches_);
        joinNeighbours();
        joinTied();
    }
    std::uint32_t of(std::uint32_t body) { return sets_.find(body); }

private:
    void join(std::uint32_t a, std::uint32_t b) {
        if (a != b && joins(a) && joins(b)) sets_.unite(a, b);
    }
    bool joins(std::uint32_t b) const {
        const BodyRecord& body = state_->bodies[b];
        return (body.kind == BodyKind::dynamic && !body.asleep) || isDriven(*state_, b);
    }

    /// Sweep and prune along x (Baraff 1992).
    void joinNeighbours() {
        active_.clear();
        for (const Reach& next : reaches_) {
            std::erase_if(active_, [&](const Reach& r) { return r.high[0] < next.low[0]; });
            for (const Reach& r : active_)
                if (r.low[1] <= next.high[1] && next.low[1] <= r.high[1]) join(r.body, next.body);
            active_.push_back(next);
        }
    }

    void joinTied() {
        const State& state = *state_;
        const auto& body = state.particles.body;
        for (const auto j : state.work.tiedJoints)
            join(body[state.joints.a[j]], body[state.joints.b[j]]);
        for (const Attachment& held : state.attachments)
            for (std::uint32_t k = 0; k < held.count; ++k)
                join(body[held.particle], body[held.support[k]]);
        const auto exists = [&](BodyId id) { return state.bodySlots.contains(id); };
        for (const BodyPair& pair : state.entwined)
            if (exists(pair.a) && exists(pair.b))
                join(state.bodySlots.dense(pair.a), state.bodySlots.dense(pair.b));
    }

    const State* state_ = nullptr;
    DisjointSets sets_;
    std::vector<Reach> reaches_, active_;
};

/// All of an island go on for as long as the one that needs it for the longest.
void spreadReasons(State& state) {
    thread_local Islands scratch;
    thread_local std::vector<double> longest;
    Islands& islands = scratch;
    islands.find(state);
    longest.assign(state.bodies.size(), 0);
    forEachAwake(state, [&](std::uint32_t b) {
        double& most = longest[islands.of(b)];
        most = std::max(most, state.bodies[b].dividedFor);
    });
    forEachAwake(state,
                 [&](std::uint32_t b) { state.bodies[b].dividedFor = longest[islands.of(b)]; });
}

/// The velocities of a body's particles stand in the middle of its last step. Those of trees have
/// steps of their own.
void noteLate(State& state, const BodyRecord& body, double late) {
    if (late == 0 || body.kind != BodyKind::dynamic || body.asleep) return;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        const bool fresh = std::binary_search(state.fresh.begin(), state.fresh.end(), i);
        if (!fresh && !movesInTree(state, i)) state.steps.late.push_back({body.particles[k], late});
    }
}

/// Bodies that their caller does not drive go with the others, if those have one pace.
void givePaces(State& state, bool anyDivided) {
    std::sort(state.fresh.begin(), state.fresh.end());
    bool anyWhole = false, changed = false;
    forEachAwake(state, [&](std::uint32_t b) {
        const BodyRecord& body = state.bodies[b];
        anyWhole |= body.kind == BodyKind::dynamic && !(body.dividedFor > 0);
    });
    std::uint32_t divided = 0;
    forEachAwake(state, [&](std::uint32_t b) {
        const bool divide = anyDivided && (state.bodies[b].dividedFor > 0 || !anyWhole);
        divided += divide ? 1 : 0;
        if (state.bodies[b].divided == divide) return;
        changed = true;
        setDivided(state, b, divide);
    });
    const bool mixed = anyDivided && anyWhole;
    if (mixed ? changed : state.work.movers != ListedMovers::all) state.work.stale = true;
    state.anyDivided = anyDivided;
    state.steps.mixed = mixed;
    state.statistics.dividedBodies = divided;
    state.statistics.substeps = anyDivided ? stepsPerTick(state, Pace::divided) : 1;
}

}  // namespace

std::uint32_t stepsPerTick(const State& state, Pace pace) {
    if (pace == Pace::whole) return 1;
    const int rate = state.settings.tickRate;
    return static_cast<std::uint32_t>((wantedRate + rate - 1) / rate);
}

Real stepDuration(const State& state, Pace pace) {
    const Real tick = 1 / static_cast<Real>(state.settings.tickRate);
    return tick / static_cast<Real>(stepsPerTick(state, pace));
}

bool mayDivideTicks(const State& state) {
    return stepsPerTick(state, Pace::divided) > 1;
}

void setDivided(State& state, std::uint32_t b, bool divided) {
    BodyRecord& body = state.bodies[b];
    if (body.divided == divided) return;
    const double before = state.lastStepOfBody(b);
    body.divided = divided;
    noteLate(state, body, (before - state.lastStepOfBody(b)) / 2);
    Structure& structure = state.structure;
    const bool known =
        (!structure.stale || structure.onlyAdded) && b < structure.dependsOnStep.size();
    if (known && structure.dependsOnStep[b] != 0) structure.changed();
}

void choosePaces(State& state, bool changed) {
    state.steps.late.clear();
    ask(state);
    const Reasons reasons = countDown(state);
    const bool divides = reasons.any && mayDivideTicks(state);
    if (divides && !reasons.all) {
        const bool due = changed || reasons.changed || state.tick % ticksAhead == 0;
        if (due || anyLeavesItsReach(state)) spreadReasons(state);
    }
    if (divides || state.anyDivided) givePaces(state, divides);
}

void noteStrain(State& state, const ContactRows& rows) {
    const auto moves = [&](std::uint32_t body) {
        return state.bodies[body].kind == BodyKind::dynamic && !state.bodies[body].asleep;
    };
    const auto asks = [&](const Contact& c) {
        return c.normalLambda > 0 && (c.fast || c.rebound > 0 || (c.rough && c.sliding) ||
                                      (moves(c.bodyA) && moves(c.bodyB)));
    };
    const bool anyError = rows.anyError(state);
    for (const Contact& c : state.contacts) {
        if (!asks(c) && !(anyError && rows.isLeftWithError(state, c))) continue;
        for (const auto body : {c.bodyA, c.bodyB})
            if (moves(body)) state.bodies[body].asksForShortSteps = true;
    }
}

}  // namespace sulfur::detail
