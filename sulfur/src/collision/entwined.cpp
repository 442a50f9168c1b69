#include "collision/entwined.hpp"

#include <algorithm>
#include <limits>

#include "collision/geometry.hpp"
#include "collision/outlines.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

constexpr double partingSpeed = 0.9;  // m/s, of a pair
constexpr double mostSpeed = 0.9;     // m/s, of a body that is in several pairs

struct Span {
    std::uint32_t first = 0, last = 0;
};

Span particlesOf(const State& state, std::uint32_t body) {
    const BodyRecord& record = state.bodies[body];
    const auto size = static_cast<std::uint32_t>(record.particles.size());
    return {record.firstParticle, record.firstParticle + size};
}

bool hasSurface(const State& state, std::uint32_t body) {
    const Span span = particlesOf(state, body);
    const auto& reach = state.particles.reach;
    return std::any_of(reach.begin() + span.first, reach.begin() + span.last,
                       [](Real r) { return r > 0; });
}

/// 1/kg of the body as a whole; 0 if anything holds it.
double inverseMassOf(const State& state, std::uint32_t body) {
    const BodyRecord& record = state.bodies[body];
    if (record.kind != BodyKind::dynamic || !state.awake(body)) return 0;
    const Span span = particlesOf(state, body);
    double mass = 0;
    for (auto i = span.first; i < span.last; ++i) {
        if (state.particles.pinned[i]) return 0;
        mass += static_cast<double>(state.particles.mass[i]);
    }
    return 1 / mass;
}

struct Box {
    Point low, high;
};

Box boxOf(const State& state, std::uint32_t body) {
    const double most = std::numeric_limits<double>::max();
    Box box{{most, most}, {-most, -most}};
    const Span span = particlesOf(state, body);
    for (auto i = span.first; i < span.last; ++i) {
        const double r = static_cast<double>(state.particles.reach[i]);
        box.low = box.low.cwiseMin(state.particles.position[i] - Point(r, r));
        box.high = box.high.cwiseMax(state.particles.position[i] + Point(r, r));
    }
    return box;
}

bool apart(const Box& a, const Box& b) {
    return (a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any();
}

/// Whether the outline of `around` has a surface particle of `body` in it.
bool holds(const State& state, std::uint32_t around, std::uint32_t body) {
    if (state.broad.outlines.of(around).empty()) return false;
    const Span span = particlesOf(state, body);
    for (auto i = span.first; i < span.last; ++i)
        if (state.particles.reach[i] > 0 && encloses(state, around, state.particles.position[i]))
            return true;
    return false;
}

bool outlinesCross(const State& state, std::uint32_t a, std::uint32_t b) {
    const auto& x = state.particles.position;
    const Joints& joints = state.joints;
    for (const OutlineEdge& e : state.broad.outlines.of(a))
        for (const JointId id : state.bodies[b].joints) {
            const auto j = state.jointSlots.dense(id);
            if (joints.radius[j] > 0 &&
                segmentsCross(x[e.from], x[e.to], x[joints.a[j]], x[joints.b[j]]))
                return true;
        }
    return false;
}

/// Deeper than their surfaces are thick: something of one is within the other's outline, or
/// crosses it. Two discs count when each has the other's centre in it.
bool areInEachOther(const State& state, std::uint32_t a, std::uint32_t b) {
    const Span p = particlesOf(state, a), q = particlesOf(state, b);
    if (p.last - p.first == 1 && q.last - q.first == 1) {
        const double reach = static_cast<double>(
            std::min(state.particles.reach[p.first], state.particles.reach[q.first]));
        return (state.particles.position[p.first] - state.particles.position[q.first]).norm() <
               reach;
    }
    return holds(state, a, b) || holds(state, b, a) || outlinesCross(state, a, b) ||
           outlinesCross(state, b, a);
}

bool areLinked(const State& state, std::uint32_t a, std::uint32_t b) {
    const auto& linked = state.broad.linked;
    const Span span = particlesOf(state, a);
    for (auto i = span.first; i < span.last; ++i)
        if (std::binary_search(linked.begin(), linked.end(), std::pair(i, b))) return true;
    return false;
}

bool mayTouch(const State& state, std::uint32_t a, std::uint32_t b) {
    const BodyRecord &first = state.bodies[a], &second = state.bodies[b];
    if (first.sensor || second.sensor || !mayCollide(first.filter, second.filter)) return false;
    if (first.kind != BodyKind::dynamic && second.kind != BodyKind::dynamic) return false;
    return !std::binary_search(state.vetoes.begin(), state.vetoes.end(),
                               BodyPair::of(first.id, second.id)) &&
           !areLinked(state, a, b) && !areLinked(state, b, a);
}

/// Bodies that were made or moved by hand since the last tick are looked at once.
void findEntwined(State& state) {
    thread_local std::vector<Box> boxes;
    boxes.resize(state.bodies.size());
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) boxes[i] = boxOf(state, i);
    for (std::uint32_t a = 0; a < state.bodies.size(); ++a) {
        if (!state.bodies[a].placed || !hasSurface(state, a)) continue;
        for (std::uint32_t b = 0; b < state.bodies.size(); ++b) {
            if (b == a || apart(boxes[a], boxes[b]) || !mayTouch(state, a, b)) continue;
            if (!areInEachOther(state, a, b)) continue;
            state.entwined.push_back(BodyPair::of(state.bodies[a].id, state.bodies[b].id));
            for (const auto body : {a, b})
                if (state.bodies[body].asleep) state.knocked.push_back(body);
        }
    }
    for (BodyRecord& body : state.bodies) body.placed = false;
    auto& pairs = state.entwined;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// A way out: body a moves by `depth` along `direction` against body b.
struct WayOut {
    Point direction{0, 1};
    double depth = std::numeric_limits<double>::max();  // m
};

double extent(const State& state, std::uint32_t body, const Point& direction) {
    const Span span = particlesOf(state, body);
    double most = -std::numeric_limits<double>::max();
    for (auto i = span.first; i < span.last; ++i)
        if (state.particles.reach[i] > 0)
            most = std::max(most, direction.dot(state.particles.position[i]) +
                                      static_cast<double>(state.particles.reach[i]));
    return most;
}

WayOut shortestWayOut(const State& state, std::uint32_t a, std::uint32_t b) {
    const auto& x = state.particles.position;
    WayOut best;
    const auto consider = [&](const Point& way) {
        const double length = way.norm();
        if (!(length > 1e-9)) return;
        const Point direction = way / length;
        const double depth = extent(state, b, direction) + extent(state, a, -direction);
        // A way that is as short as one before it to rounding does not take its place.
        if (depth < best.depth * (1 - 1e-9) - 1e-9) best = {direction, depth};
    };
    consider(x[particlesOf(state, a).first] - x[particlesOf(state, b).first]);
    for (const auto& [body, sign] : {std::pair(a, -1.0), std::pair(b, 1.0)})
        for (const OutlineEdge& e : state.broad.outlines.of(body)) {
            const Point along = x[e.to] - x[e.from];
            consider(sign * Point(along[1], -along[0]));
        }
    if (best.depth == std::numeric_limits<double>::max()) consider(Point(0, 1));
    return best;
}

Point meanDisplacement(const State& state, std::uint32_t body) {
    const Span span = particlesOf(state, body);
    Point sum(0, 0);
    double mass = 0;
    for (auto i = span.first; i < span.last; ++i) {
        const double m = static_cast<double>(state.particles.mass[i]);
        sum += m * displacementOf(state, gripOf(state, i)).cast<double>();
        mass += m;
    }
    return sum / mass;
}

/// Moves all of a body: its displacements, which becomes velocity, or its places, which does not.
void moveWhole(State& state, std::uint32_t body, const Vec2& by, bool becomesVelocity) {
    const Span span = particlesOf(state, body);
    Particles& p = state.particles;
    for (auto i = span.first; i < span.last; ++i) {
        if (becomesVelocity)
            p.displacement[i] += by;
        else if (p.cluster[i] == none)
            p.position[i] += by.cast<double>();
    }
    for (const auto c : state.work.awakeClusters) {
        Cluster& cluster = state.clusters.list[c];
        if (cluster.body == body) (becomesVelocity ? cluster.displacement : cluster.shift) += by;
    }
}

void part(State& state, std::uint32_t a, std::uint32_t b, std::vector<Vec2>& moves) {
    const double wa = inverseMassOf(state, a), wb = inverseMassOf(state, b);
    if (wa + wb == 0) return;
    const WayOut way = shortestWayOut(state, a, b);
    const double h = static_cast<double>(state.h);
    const double closing =
        way.direction.dot(meanDisplacement(state, a) - meanDisplacement(state, b));
    const auto share = [&](double w, double by) {
        return Vec2((w / (wa + wb) * by * way.direction).cast<Real>());
    };
    if (closing < 0) {
        moveWhole(state, a, share(wa, -closing), true);
        moveWhole(state, b, share(wb, closing), true);
    }
    const double move = std::min(way.depth, partingSpeed * h);
    moves[a] += share(wa, move);
    moves[b] += share(wb, -move);
}

}  // namespace

bool isListedEntwined(const State& state, std::uint32_t a, std::uint32_t b) {
    return std::binary_search(state.entwined.begin(), state.entwined.end(),
                              BodyPair::of(state.bodies[a].id, state.bodies[b].id));
}

void partEntwined(State& state) {
    if (state.anyPlaced) findEntwined(state);
    state.anyPlaced = false;
    if (state.entwined.empty()) return;
    std::erase_if(state.entwined, [&](const BodyPair& pair) {
        if (!state.bodySlots.contains(pair.a) || !state.bodySlots.contains(pair.b)) return true;
        const auto a = state.bodySlots.dense(pair.a), b = state.bodySlots.dense(pair.b);
        return !mayTouch(state, a, b) || !areInEachOther(state, a, b);
    });
    thread_local std::vector<Vec2> moves;
    moves.assign(state.bodies.size(), Vec2(0, 0));
    for (const BodyPair& pair : state.entwined)
        part(state, state.bodySlots.dense(pair.a), state.bodySlots.dense(pair.b), moves);
    const Real most = static_cast<Real>(mostSpeed) * state.h;
    for (std::uint32_t i = 0; i < moves.size(); ++i) {
        const Real length = moves[i].norm();
        if (length == 0) continue;
        moveWhole(state, i, length > most ? Vec2(most / length * moves[i]) : moves[i], false);
        state.bodies[i].restingTime = 0;
    }
}

}  // namespace sulfur::detail
