#include "queries/nearby.hpp"

#include "model/shapes.hpp"
#include "shape/outline.hpp"

namespace sulfur::detail {

namespace {

/// What boxes hold of a body is not where it is: it was changed by hand, or a blow in the last step
/// has carried it farther than its box allows.
void listApart(State& state) {
    Nearby& nearby = state.nearby;
    const ContactCore& core = state.core;
    nearby.apart.clear();
    std::size_t slots = core.shapes.firstChunk.size();
    for (const BodyRecord& body : state.bodies) slots = std::max<std::size_t>(slots, body.id.index);
    nearby.isApart.assign(slots, 0);
    const auto add = [&](std::uint32_t slot) {
        const auto body = state.bodySlots.denseOf(slot);
        if (body == none || nearby.isApart[slot] != 0) return;
        nearby.isApart[slot] = 1;
        nearby.apart.push_back(body);
    };
    for (const BodyRecord& body : state.bodies)
        if (body.clustersStale) add(body.id.index - 1);
    for (const auto slot : core.staleShapes) add(slot);
    // What is tied may be tied no more, and what it was tied to may be gone.
    if (state.structure.stale)
        for (const auto& link : core.linkedBodies) add(link.first);
    for (const auto c : core.newChunks) add(core.shapes.chunks[c].body);
    for (const auto c : core.awakeChunks) {
        const Chunk& chunk = core.shapes.chunks[c];
        if (chunk.body != none && core.movers.odometer[chunk.frame] >= chunk.leaveAt)
            add(chunk.body);
    }
    std::sort(nearby.apart.begin(), nearby.apart.end());
    nearby.tied.clear();
    if (nearby.apart.empty()) return;
    const Joints& joints = state.joints;
    const auto isApart = [&](std::uint32_t i) {
        return nearby.isApart[state.bodies[state.particles.body[i]].id.index - 1] != 0;
    };
    for (std::uint32_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none && joints.radius[j] > 0 &&
            (isApart(joints.a[j]) || isApart(joints.b[j])))
            nearby.tied.push_back(j);
}

/// Whether a chunk has part in an outline whose inside no box of it covers.
bool isRim(const Shapes& shapes, const Chunk& chunk) {
    if (chunk.kind == ChunkKind::convex) return false;
    const auto first = shapes.sides.begin() + chunk.firstSide;
    return std::any_of(first, first + chunk.sides,
                       [](const Side& side) { return side.outward != 0; });
}

void listHollows(State& state) {
    Nearby& nearby = state.nearby;
    const Shapes& shapes = state.core.shapes;
    nearby.hollows.clear();
    for (std::uint32_t slot = 0; slot < shapes.firstChunk.size(); ++slot) {
        if (nearby.isApart[slot] != 0) continue;
        Hollow hollow{slot, {1e300, 1e300}, {-1e300, -1e300}};
        for (auto c = shapes.firstChunk[slot]; c != none; c = shapes.chunks[c].nextOfBody) {
            const Chunk& chunk = shapes.chunks[c];
            if (!isRim(shapes, chunk)) continue;
            hollow.low = hollow.low.cwiseMin(Point(chunk.low[0], chunk.low[1]));
            hollow.high = hollow.high.cwiseMax(Point(chunk.high[0], chunk.high[1]));
        }
        if (hollow.low[0] <= hollow.high[0]) nearby.hollows.push_back(hollow);
    }
    nearby.hollowsListed = true;
}

/// Adds up how often edges wind round a point.
class Winding {
public:
    explicit Winding(const Point& point) : point_(point) {}

    void add(const Point& a, const Point& b) {
        const Point from = a - point_, to = b - point_;
        // Half-open: an edge has its lower end and lacks its upper one.
        if ((from[1] <= 0) == (to[1] <= 0)) return;
        const double side = cross(from, to);
        if (from[1] <= 0 && side > 0) ++turns_;
        if (to[1] <= 0 && side < 0) --turns_;
    }
    bool encloses() const { return turns_ != 0; }

private:
    Point point_;
    int turns_ = 0;
};

/// Whether the chunks of a body say how it is now.
bool hasShape(const State& state, std::uint32_t body) {
    const auto slot = state.bodies[body].id.index - 1;
    return slot < state.core.shapes.firstChunk.size() && state.nearby.isApart[slot] == 0;
}

}  // namespace

void prepareNearby(State& state) {
    requireOutside(state.callbacks);
    Nearby& nearby = state.nearby;
    if (nearby.valid && !state.structure.stale && state.core.staleShapes.empty()) return;
    listApart(state);
    nearby.hollowsListed = false;
    nearby.valid = true;
}

bool encloses(const State& state, std::uint32_t body, const Point& point) {
    const Joints& joints = state.joints;
    Winding winding(point);
    // From the end a of a joint to b, or back.
    const auto add = [&](std::uint32_t joint, bool forth) {
        const auto& x = state.particles.position;
        forEachPieceOf(state, joint, x[joints.a[joint]], x[joints.b[joint]],
                       [&](const Point& from, const Point& to, double, double) {
                           if (forth)
                               winding.add(from, to);
                           else
                               winding.add(to, from);
                       });
    };
    if (!hasShape(state, body)) {
        for (const auto& loop : findOutlines(state, body))
            for (const RimEdge& edge : loop) add(edge.joint, joints.a[edge.joint] == edge.from);
        return winding.encloses();
    }
    const Shapes& shapes = state.core.shapes;
    for (auto c = shapes.firstChunk[state.bodies[body].id.index - 1]; c != none;
         c = shapes.chunks[c].nextOfBody) {
        const Chunk& chunk = shapes.chunks[c];
        for (auto s = chunk.firstSide; s < chunk.firstSide + chunk.sides; ++s) {
            const Side& side = shapes.sides[s];
            if (side.outward != 0) add(state.jointSlots.denseOf(side.joint), side.outward > 0);
        }
    }
    return winding.encloses();
}

const std::vector<std::uint32_t>& bodiesAround(State& state, const Point& point) {
    if (!state.nearby.hollowsListed) listHollows(state);
    const ContactCore& core = state.core;
    auto& near = state.nearby.around;
    near = state.nearby.apart;
    core.grid.forEachIn(
        core.shapes.chunks, {point[0], point[1]}, {point[0], point[1]}, [&](std::uint32_t c) {
            const Chunk& chunk = core.shapes.chunks[c];
            if (chunk.kind == ChunkKind::convex && !state.nearby.isApart[chunk.body])
                near.push_back(state.bodySlots.denseOf(chunk.body));
        });
    for (const Hollow& hollow : state.nearby.hollows)
        if ((point.array() >= hollow.low.array()).all() &&
            (point.array() <= hollow.high.array()).all())
            near.push_back(state.bodySlots.denseOf(hollow.body));
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase_if(near, [&](std::uint32_t body) { return !encloses(state, body, point); });
    return near;
}

}  // namespace sulfur::detail
