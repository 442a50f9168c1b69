#include "collision/outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// A capsule as it leaves one of its ends.
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

/// The plane graph of the capsules of all bodies at rest.
struct PlaneGraph {
    std::vector<HalfEdge> halves;                    // by particle, then counter-clockwise
    std::vector<std::uint32_t> first;                // of each particle, and one past the last
    std::vector<std::array<std::uint32_t, 2>> ends;  // by joint: leaving its a, leaving its b

    /// Of the joints from `firstJoint` on.
    PlaneGraph(const State& state, std::uint32_t firstJoint) {
        collect(state, firstJoint);
        dropCovered();
        index(state);
    }

    std::uint32_t twin(std::uint32_t half) const {
        const auto& pair = ends[halves[half].joint];
        return pair[0] == half ? pair[1] : pair[0];
    }
    /// The next edge of a walk that keeps its face to the right: the first one counter-clockwise
    /// from the way back.
    std::uint32_t next(std::uint32_t half) const {
        const auto back = twin(half);
        return back + 1 < first[halves[half].to + 1] ? back + 1 : first[halves[half].to];
    }

private:
    void collect(const State& state, std::uint32_t firstJoint) {
        const Joints& joints = state.joints;
        const auto& rest = state.particles.rest;
        for (auto j = firstJoint; j < joints.size(); ++j) {
            if (joints.body[j] == none || !(joints.radius[j] > 0)) continue;
            const auto a = joints.a[j], b = joints.b[j];
            const Point way = rest[b].cast<double>() - rest[a].cast<double>();
            if (way.isZero(0)) continue;
            halves.push_back({a, b, j, turnOf(way), way.squaredNorm()});
            halves.push_back({b, a, j, turnOf(-way), way.squaredNorm()});
        }
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

    void index(const State& state) {
        first.assign(state.particles.size() + 1, 0);
        ends.resize(state.joints.size());
        for (std::uint32_t i = 0; i < halves.size(); ++i) {
            ++first[halves[i].from + 1];
            ends[halves[i].joint][halves[i].from == state.joints.a[halves[i].joint] ? 0 : 1] = i;
        }
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    }
};

/// Of each connected part the particle that is lowest, then leftmost, in the order of the parts'
/// first particles: it is on the outer face.
std::vector<std::uint32_t> startsOfWalks(const State& state, const PlaneGraph& graph) {
    DisjointSets parts(state.particles.size());
    for (const HalfEdge& half : graph.halves) parts.unite(half.from, half.to);
    const auto& rest = state.particles.rest;
    std::vector<std::uint32_t> lowest(state.particles.size(), none);
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
void walkOutline(const PlaneGraph& graph, std::uint32_t start, std::vector<bool>& walked,
                 std::vector<OutlineEdge>& outline) {
    thread_local std::vector<std::uint32_t> walk;
    walk.clear();
    // Nothing is below: the outer face is to the right of the edge that turns least.
    std::uint32_t half = graph.first[start];
    do {
        walk.push_back(half);
        walked[half] = true;
        half = graph.next(half);
    } while (half != walk.front());
    outline.clear();
    for (const auto taken : walk) {
        const HalfEdge& edge = graph.halves[taken];
        if (!walked[graph.twin(taken)]) outline.push_back({edge.from, edge.to, edge.joint});
    }
}

/// Twice the area that a closed outline has at rest. Capsules that cross without a particle may
/// leave none; then there is no inside.
double twiceArea(const State& state, const std::vector<OutlineEdge>& outline) {
    const auto& rest = state.particles.rest;
    double sum = 0;
    for (const OutlineEdge& edge : outline) {
        const Point origin = rest[outline.front().from].cast<double>();
        sum += cross(Point(rest[edge.from].cast<double>() - origin),
                     Point(rest[edge.to].cast<double>() - origin));
    }
    return sum;
}

/// Which particles a joint without a radius braces, of the joints from `firstJoint` on.
std::vector<bool> bracedParticles(const State& state, std::uint32_t firstJoint) {
    const Joints& joints = state.joints;
    std::vector<bool> braced(state.particles.size(), false);
    for (auto j = firstJoint; j < joints.size(); ++j)
        if (joints.body[j] != none && joints.radius[j] == 0)
            braced[joints.a[j]] = braced[joints.b[j]] = true;
    return braced;
}

bool isSolid(const State& state, const std::vector<OutlineEdge>& outline,
             const std::vector<bool>& braced) {
    if (!(twiceArea(state, outline) > 0)) return false;
    const BodyRecord& body = state.bodies[state.particles.body[outline.front().from]];
    if (body.kind == BodyKind::dynamic || body.sensor) return true;
    const auto isBraced = [&](const OutlineEdge& edge) { return braced[edge.from]; };
    const auto againstWalk = [&](const OutlineEdge& edge) {
        return state.joints.a[edge.joint] != edge.from;
    };
    return std::any_of(outline.begin(), outline.end(), isBraced) ||
           std::all_of(outline.begin(), outline.end(), againstWalk);
}

}  // namespace

void Outlines::derive(const State& state) {
    outward_.clear();
    first_.assign(1, 0);
    edges_.clear();
    extend(state, {});
}

void Outlines::extend(const State& state, const Counts& before) {
    outward_.resize(state.joints.size(), 0);
    first_.resize(state.bodies.size() + 1, 0);
    const PlaneGraph graph(state, before.joints);
    const auto braced = bracedParticles(state, before.joints);
    std::vector<bool> walked(graph.halves.size(), false);
    std::vector<OutlineEdge> outline;
    for (const auto start : startsOfWalks(state, graph)) {
        walkOutline(graph, start, walked, outline);
        if (outline.empty() || !isSolid(state, outline, braced)) continue;
        for (const OutlineEdge& edge : outline)
            outward_[edge.joint] = state.joints.a[edge.joint] == edge.from ? 1 : -1;
        edges_.insert(edges_.end(), outline.begin(), outline.end());
        first_[state.particles.body[start] + 1] += static_cast<std::uint32_t>(outline.size());
    }
    for (std::size_t i = before.bodies + 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

bool encloses(const State& state, std::uint32_t body, const Point& point) {
    const auto& x = state.particles.position;
    int winding = 0;
    for (const OutlineEdge& edge : state.broad.outlines.of(body)) {
        const Point from = x[edge.from] - point, to = x[edge.to] - point;
        // Half-open: an edge has its lower end and lacks its upper one.
        if ((from[1] <= 0) == (to[1] <= 0)) continue;
        const double side = cross(from, to);
        if (from[1] <= 0 && side > 0) ++winding;
        if (to[1] <= 0 && side < 0) --winding;
    }
    return winding != 0;
}

}  // namespace sulfur::detail
