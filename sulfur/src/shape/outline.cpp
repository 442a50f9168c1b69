// The outer faces of a body's capsules: which side of a capsule is outside.
//
// The capsules of a body make a plane graph. A walk round the outer face of each connected part
// takes an edge once when it has the body on one side and nothing on the other: these are the
// outline. It takes ropes, loose ends and bridges between two loops twice, and what is inside
// never.
//
// A dynamic body is solid inside of the outline of its triangles. A loop of rods without triangles,
// such as a cell of a wall whose diagonals broke, folds and turns over: which of its sides is
// inside would change, so that it is hollow. A fixed or kinematic body may as well be the room
// around all others, so that two things tell: if it is braced like the solids of shapes.hpp, by
// joints without a radius that end on the outline, it is solid; if it is a mere line of capsules,
// the ground is to the right of the line, so that it is solid when its joints lead round clockwise,
// from a to b, and a room or a hollow ring otherwise. A sensor is never a room.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "model/shapes.hpp"
#include "model/state.hpp"
#include "shape/outline.hpp"

namespace sulfur::detail {

namespace {

/// A capsule as it leaves one of its ends. Particles count from the body's first.
struct HalfEdge {
    std::uint32_t from = 0, to = 0, joint = 0;
    double turn = 0;     // from the x axis, growing counter-clockwise, 0 to 4
    double length2 = 0;  // m^2
};

/// Grows like the angle of a direction, a full turn being 4: a number, so that directions have an
/// order that rounding cannot make contradict itself.
double turnOf(const Point& way) {
    const double part = way[1] / (std::abs(way[0]) + std::abs(way[1]));
    if (way[0] < 0) return 2 - part;
    return part < 0 ? 4 + part : part;
}

/// The plane graph of the capsules of one body at rest.
class PlaneGraph {
public:
    PlaneGraph(const State& state, std::uint32_t first, std::size_t particles,
               const std::vector<std::uint32_t>& capsules) {
        const Joints& joints = state.joints;
        const auto& rest = state.particles.rest;
        for (const auto j : capsules) {
            const auto a = joints.a[j], b = joints.b[j];
            const Point way = rest[b].cast<double>() - rest[a].cast<double>();
            if (way.isZero(0)) continue;
            halves.push_back({a - first, b - first, j, turnOf(way), way.squaredNorm()});
            halves.push_back({b - first, a - first, j, turnOf(-way), way.squaredNorm()});
        }
        sortHalves();
        dropCovered();
        start.assign(particles + 1, 0);
        for (const HalfEdge& half : halves) ++start[half.from + 1];
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        findTwins();
    }

    /// The next edge of a walk that keeps its face to the right: the first one counter-clockwise
    /// from the way back.
    std::uint32_t next(std::uint32_t half) const {
        const auto back = twin[half];
        return back + 1 < start[halves[half].to + 1] ? back + 1 : start[halves[half].to];
    }

    std::vector<HalfEdge> halves;      // by particle, then counter-clockwise
    std::vector<std::uint32_t> start;  // of each particle, and one past the last
    std::vector<std::uint32_t> twin;   // the same capsule, the other way

private:
    void sortHalves() {
        std::sort(halves.begin(), halves.end(), [](const HalfEdge& x, const HalfEdge& y) {
            return std::tie(x.from, x.turn, x.length2, x.joint) <
                   std::tie(y.from, y.turn, y.length2, y.joint);
        });
    }
    /// Of capsules that lie on each other the shorter ones stay.
    void dropCovered() {
        std::vector<std::uint32_t> covered;
        for (std::size_t i = 1; i < halves.size(); ++i)
            if (halves[i].from == halves[i - 1].from && halves[i].turn == halves[i - 1].turn)
                covered.push_back(halves[i].joint);
        std::sort(covered.begin(), covered.end());
        std::erase_if(halves, [&](const HalfEdge& half) {
            return std::binary_search(covered.begin(), covered.end(), half.joint);
        });
    }
    void findTwins() {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> byJoint;
        for (std::uint32_t i = 0; i < halves.size(); ++i) byJoint.emplace_back(halves[i].joint, i);
        std::sort(byJoint.begin(), byJoint.end());
        twin.resize(halves.size());
        for (std::size_t i = 0; i + 1 < byJoint.size(); i += 2) {
            twin[byJoint[i].second] = byJoint[i + 1].second;
            twin[byJoint[i + 1].second] = byJoint[i].second;
        }
    }
};

/// Of each connected part the particle that is lowest, then leftmost: it is on the outer face.
std::vector<std::uint32_t> startsOfWalks(const PlaneGraph& graph, const Vec2* rest,
                                         std::size_t particles) {
    DisjointSets parts(particles);
    for (const HalfEdge& half : graph.halves) parts.unite(half.from, half.to);
    std::vector<std::uint32_t> lowest(particles, none);
    for (const HalfEdge& half : graph.halves) {
        auto& start = lowest[parts.find(half.from)];
        const auto i = half.from;
        if (start == none ||
            std::tie(rest[i][1], rest[i][0]) < std::tie(rest[start][1], rest[start][0]))
            start = i;
    }
    std::erase(lowest, none);
    return lowest;
}

/// The edges that a walk round the outer face from `start` takes once.
std::vector<RimEdge> walkOuterFace(const PlaneGraph& graph, std::uint32_t start,
                                   std::uint32_t first) {
    std::vector<std::uint32_t> walk;
    std::vector<bool> walked(graph.halves.size(), false);
    // Nothing is below: the outer face is to the right of the edge that turns least.
    std::uint32_t half = graph.start[start];
    do {
        walk.push_back(half);
        walked[half] = true;
        half = graph.next(half);
    } while (half != walk.front());
    std::vector<RimEdge> outline;
    for (const auto taken : walk) {
        const HalfEdge& edge = graph.halves[taken];
        if (!walked[graph.twin[taken]])
            outline.push_back({first + edge.from, first + edge.to, edge.joint});
    }
    return outline;
}

/// Twice the area that a closed outline has at rest. Capsules that cross without a particle may
/// leave none; then there is no inside.
double twiceArea(const State& state, const std::vector<RimEdge>& outline) {
    const auto& rest = state.particles.rest;
    const Point origin = rest[outline.front().from].cast<double>();
    double sum = 0;
    for (const RimEdge& edge : outline)
        sum += cross(Point(rest[edge.from].cast<double>() - origin),
                     Point(rest[edge.to].cast<double>() - origin));
    return sum;
}

bool isSolid(const State& state, const BodyRecord& body, const std::vector<RimEdge>& outline) {
    if (!(twiceArea(state, outline) > 0)) return false;
    if (body.kind == BodyKind::dynamic || body.sensor) return true;
    const Joints& joints = state.joints;
    const auto isBraced = [&](std::uint32_t particle) {
        return std::any_of(body.joints.begin(), body.joints.end(), [&](JointId id) {
            const auto j = state.jointSlots.dense(id);
            return joints.radius[j] == 0 && (joints.a[j] == particle || joints.b[j] == particle);
        });
    };
    const auto againstWalk = [&](const RimEdge& edge) { return joints.a[edge.joint] != edge.from; };
    return std::all_of(outline.begin(), outline.end(), againstWalk) ||
           std::any_of(outline.begin(), outline.end(),
                       [&](const RimEdge& edge) { return isBraced(edge.from); });
}

/// Of some capsules of a body those that are sides of a triangle of its joints.
std::vector<std::uint32_t> sidesOfTriangles(const State& state, const BodyRecord& body,
                                            std::vector<std::uint32_t> capsules) {
    const Joints& joints = state.joints;
    std::vector<std::vector<std::uint32_t>> neighbours(body.particles.size());
    for (const JointId id : body.joints) {
        const auto j = state.jointSlots.dense(id);
        const auto a = joints.a[j] - body.firstParticle, b = joints.b[j] - body.firstParticle;
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    for (auto& list : neighbours) std::sort(list.begin(), list.end());
    std::erase_if(capsules, [&](std::uint32_t j) {
        const auto& ofA = neighbours[joints.a[j] - body.firstParticle];
        const auto& ofB = neighbours[joints.b[j] - body.firstParticle];
        return std::none_of(ofA.begin(), ofA.end(), [&](std::uint32_t third) {
            return std::binary_search(ofB.begin(), ofB.end(), third);
        });
    });
    return capsules;
}

}  // namespace

std::vector<std::vector<RimEdge>> findOutlines(const State& state, std::uint32_t index,
                                               const std::vector<std::uint32_t>& given) {
    std::vector<std::vector<RimEdge>> loops;
    const BodyRecord& body = state.bodies[index];
    if (given.size() < 3) return loops;
    const bool turnsOver = body.kind == BodyKind::dynamic && !body.sensor;
    const auto capsules = turnsOver ? sidesOfTriangles(state, body, given) : given;
    const PlaneGraph graph(state, body.firstParticle, body.particles.size(), capsules);
    const Vec2* rest = state.particles.rest.data() + body.firstParticle;
    for (const auto start : startsOfWalks(graph, rest, body.particles.size())) {
        auto outline = walkOuterFace(graph, start, body.firstParticle);
        if (!outline.empty() && isSolid(state, body, outline)) loops.push_back(std::move(outline));
    }
    return loops;
}

std::vector<std::vector<RimEdge>> findOutlines(const State& state, std::uint32_t body) {
    std::vector<std::uint32_t> capsules;
    for (const JointId id : state.bodies[body].joints) {
        const auto j = state.jointSlots.dense(id);
        if (state.joints.radius[j] > 0) capsules.push_back(j);
    }
    return findOutlines(state, body, capsules);
}

}  // namespace sulfur::detail
