// From bodies to what collides of them.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/trigonometry.hpp"
#include "model/clusters.hpp"
#include "model/state.hpp"
#include "shape/bends.hpp"
#include "shape/make_shapes.hpp"
#include "shape/materials.hpp"
#include "shape/outline.hpp"
#include "shape/spokes.hpp"

namespace sulfur::detail {

namespace {

constexpr std::size_t mostConvexCorners = mostOfChunk;

/// Sine of the angle below which two edges go on in one line.
constexpr double straight = 1e-6;

template <class Id>
std::uint32_t slotOf(Id id) {
    return id.index - 1;
}

/// Makes the chunks of one body.
class ShapeMaker {
public:
    ShapeMaker(State& state, std::uint32_t body)
        : state_(state), shapes_(state.core.shapes), movers_(state.core.movers), body_(body) {}

    void run() {
        collectCapsules();
        giveMovers();
        std::vector<std::uint32_t> left = capsules_;
        for (const auto& loop : findOutlines(state_, body_, own())) {
            for (const RimEdge& edge : loop)
                outward_[edge.joint] = state_.joints.a[edge.joint] == edge.from ? 1 : -1;
            if (isConvex(loop)) {
                addConvex(loop);
                dropInside(loop, left);
            }
        }
        addLoose(left);
        addDiscs();
        giveSpokes(shapes_, slotOf(record().id), hulls_);
    }

private:
    const BodyRecord& record() const { return state_.bodies[body_]; }

    /// A joint between bodies counts as part of its first particle's body, or of the second's when
    /// the first cannot move.
    bool isOurs(std::uint32_t j) const {
        const Joints& joints = state_.joints;
        if (joints.body[j] != none) return joints.body[j] == body_;
        const auto first = state_.particles.body[joints.a[j]];
        const auto second = state_.particles.body[joints.b[j]];
        return (state_.bodies[first].kind == BodyKind::fixed ? second : first) == body_;
    }

    void collectCapsules() {
        for (const JointId id : record().joints) {
            const auto j = state_.jointSlots.dense(id);
            if (state_.joints.radius[j] > 0) capsules_.push_back(j);
        }
        own_ = std::ssize(capsules_);
        for (const TiedCapsule& tied : state_.core.tiedCapsules) {
            const auto j = state_.jointSlots.dense(tied.joint);
            if (isOurs(j) && !isCut(state_, j)) capsules_.push_back(j);
        }
    }
    std::vector<std::uint32_t> own() const { return {capsules_.begin(), capsules_.begin() + own_}; }

    // --- movers -----------------------------------------------------------------------------

    std::uint32_t newMover(std::uint32_t body, const Point& at, const Point& heading) {
        const auto slot = movers_.add();
        movers_.references[slot] = {at[0], at[1], heading[0], heading[1]};
        movers_.body[slot] = slotOf(state_.bodies[body].id);
        return slot;
    }

    /// The mover of a particle of any body, made when it is first asked for.
    std::uint32_t moverOf(std::uint32_t i) {
        const Particles& p = state_.particles;
        const auto owner = p.body[i];
        if (state_.bodies[owner].kind == BodyKind::fixed || isWhole(owner)) return frameOf(owner);
        const auto c = p.cluster[i];
        const auto leader = c == none ? i : state_.clusters.members[state_.clusters.list[c].first];
        auto& known = moverOfSlot(slotOf(p.id[leader]));
        if (known != none) return known;
        const auto mover = c == none ? newMover(owner, p.position[i], Point(1, 0))
                                     : newMover(owner, state_.clusters.list[c].centre,
                                                state_.clusters.list[c].heading);
        movers_.particle[mover] = slotOf(p.id[leader]);
        return known = mover;
    }
    std::uint32_t& moverOfSlot(std::uint32_t slot) {
        auto& known = shapes_.moverOfParticle;
        if (known.size() <= slot) known.resize(slot + 1, none);
        return known[slot];
    }
    /// (Remembered of the body whose shape is made.)
    bool isWhole(std::uint32_t body) {
        if (body != body_) return standsOnOneMover(state_, state_.bodies[body]);
        if (!whole_) whole_ = standsOnOneMover(state_, record());
        return *whole_;
    }
    /// All of a fixed body stands on one mover, and of a kinematic one with an arc, which goes as
    /// its first particle does.
    std::uint32_t frameOf(std::uint32_t body) {
        BodyRecord& owner = state_.bodies[body];
        if (owner.frame != none) return owner.frame;
        const Point at = state_.particles.position[owner.firstParticle];
        if (owner.kind == BodyKind::fixed) return owner.frame = newMover(body, at, Point(1, 0));
        owner.frame = newMover(body, at, headingOfWhole(state_, owner));
        const auto slot = slotOf(state_.particles.id[owner.firstParticle]);
        movers_.particle[owner.frame] = slot;
        return moverOfSlot(slot) = owner.frame;
    }

    void giveMovers() {
        for (const auto j : capsules_)
            for (const auto i : {state_.joints.a[j], state_.joints.b[j]}) moverOf(i);
    }

    // --- corners and sides -------------------------------------------------------------------

    Corner cornerAt(std::uint32_t i) {
        const Particles& p = state_.particles;
        Corner corner;
        corner.particle = slotOf(p.id[i]);
        corner.mover = moverOf(i);
        corner.radius = p.reach[i];
        const auto surface = state_.surface[i];
        corner.surface = surface == none ? none : slotOf(state_.joints.id[surface]);
        if (const auto c = p.cluster[i]; c != none) {
            const Clusters& clusters = state_.clusters;
            const auto from = clusters.members.begin() + clusters.list[c].first;
            const auto to = clusters.members.begin() + clusters.list[c].last;
            const auto k = std::lower_bound(from, to, i) - clusters.members.begin();
            const Point& place = clusters.places[static_cast<std::size_t>(k)];
            corner.x = static_cast<Real>(place[0]);
            corner.y = static_cast<Real>(place[1]);
        } else if (state_.bodies[p.body[i]].frame == corner.mover) {
            const BodyRecord& body = state_.bodies[p.body[i]];
            Point place = p.position[i] - p.position[body.firstParticle];
            if (body.kind == BodyKind::fixed) {
                place = p.position[i] - movers_.placeAtReference(corner.mover);
            } else {
                const Point turn = headingOfWhole(state_, body);
                place = {turn.dot(place), cross(turn, place)};
            }
            corner.x = static_cast<Real>(place[0]);
            corner.y = static_cast<Real>(place[1]);
        }
        return corner;
    }

    std::uint32_t addCorner(std::uint32_t i) {
        const auto [at, isNew] = corners_.try_emplace(i, none);
        if (isNew) {
            at->second = firstCorner_ + static_cast<std::uint32_t>(newCorners_.size());
            newCorners_.push_back(cornerAt(i));
            reachTo(newCorners_.back());
            auto& fineness = movers_.fineness[newCorners_.back().mover];
            const Real radius = newCorners_.back().radius;
            fineness = fineness > 0 ? std::min(fineness, radius) : radius;
        }
        return at->second;
    }
    void reachTo(const Corner& corner) {
        Real& reach = movers_.reach[corner.mover];
        reach = std::max(reach, std::hypot(corner.x, corner.y) + corner.radius);
    }

    // --- arcs --------------------------------------------------------------------------------

    bool isBent(std::uint32_t j) const { return state_.joints.bend[j].angle != 0; }

    /// In the frame of its mover.
    Arc arcOf(std::uint32_t j, const Corner& a, const Corner& b) const {
        return arcBetween(Vec2(a.x, a.y).cast<double>(), Vec2(b.x, b.y).cast<double>(),
                          static_cast<double>(state_.joints.bend[j].angle));
    }
    /// A corner beside those of particles, at a place that the mover of one of these carries.
    static Corner beside(Corner corner, const Point& place, Real radius) {
        corner.x = static_cast<Real>(place[0]);
        corner.y = static_cast<Real>(place[1]);
        corner.radius = radius;
        return corner;
    }
    /// The hull of an arc, to which its tangents lead, and its centre.
    void addArc(std::uint32_t j, const Side& side) {
        const Corner a = newCorners_[side.a], b = newCorners_[side.b];
        const Arc arc = arcOf(j, a, b);
        hulls_[side.joint] = static_cast<std::uint32_t>(newCorners_.size());
        for (const Point& place : arc.hull()) {
            newCorners_.push_back(beside(a, place, side.radius));
            newCorners_.back().owned = cornerOfHull;
            reachTo(newCorners_.back());
        }
        newCentres_.push_back(beside(a, arc.centre, static_cast<Real>(arc.radius) + side.radius));
        newCentres_.back().surface = side.joint;
    }

    Side sideOf(std::uint32_t j) {
        Side side;
        side.a = addCorner(state_.joints.a[j]);
        side.b = addCorner(state_.joints.b[j]);
        side.joint = slotOf(state_.joints.id[j]);
        side.radius = state_.joints.radius[j];
        const auto found = outward_.find(j);
        side.outward = found == outward_.end() ? 0 : found->second;
        if (isBent(j) && newCorners_[side.a].mover == newCorners_[side.b].mover) addArc(j, side);
        return side;
    }

    /// The line on which a side lies, with the outside to the right of the way from a to b, or its
    /// circle.
    void placeSide(Side& side, const Corner& a, const Corner& b) const {
        if (side.joint != none)
            if (const auto j = state_.jointSlots.denseOf(side.joint);
                isBent(j) && a.mover == b.mover) {
                const Arc arc = arcOf(j, a, b);
                side.outX = static_cast<Real>(arc.middle[0]);
                side.outY = static_cast<Real>(arc.middle[1]);
                side.offset = static_cast<Real>(arc.top()[0]);
                side.middle = static_cast<Real>(arc.top()[1]);
                side.half = static_cast<Real>(-arc.radius);
                return;
            }
        const double ax = static_cast<double>(a.x), ay = static_cast<double>(a.y);
        const double wx = static_cast<double>(b.x) - ax, wy = static_cast<double>(b.y) - ay;
        const double length = std::hypot(wx, wy);
        const double ox = length > 0 ? wy / length : 1, oy = length > 0 ? -wx / length : 0;
        const double tx = -oy, ty = ox;
        side.outX = static_cast<Real>(ox);
        side.outY = static_cast<Real>(oy);
        side.offset = static_cast<Real>(ox * ax + oy * ay);
        side.middle = static_cast<Real>(tx * (ax + wx / 2) + ty * (ay + wy / 2));
        side.half = static_cast<Real>(length / 2);
    }

    // --- chunks ------------------------------------------------------------------------------

    void begin() {
        firstCorner_ = static_cast<std::uint32_t>(0);
        newCorners_.clear();
        newCentres_.clear();
        corners_.clear();
        newSides_.clear();
    }

    /// Moves what was collected into the pools.
    Chunk& finish(ChunkKind kind) {
        const auto slot = takeChunk();
        Chunk& chunk = shapes_.chunks[slot];
        chunk = {};
        chunk.body = slotOf(record().id);
        chunk.kind = kind;
        chunk.corners = static_cast<std::uint32_t>(newCorners_.size());
        chunk.sides = static_cast<std::uint32_t>(newSides_.size());
        const auto centres = static_cast<std::uint32_t>(newCentres_.size());
        chunk.firstCorner = shapes_.cornerPool.allocate(chunk.corners + centres);
        chunk.firstSide = shapes_.sidePool.allocate(chunk.sides);
        shapes_.corners.resize(shapes_.cornerPool.size());
        shapes_.sides.resize(shapes_.sidePool.size());
        std::copy(newCorners_.begin(), newCorners_.end(),
                  shapes_.corners.begin() + chunk.firstCorner);
        std::copy(newCentres_.begin(), newCentres_.end(),
                  shapes_.corners.begin() + chunk.firstCorner + chunk.corners);
        for (std::uint32_t k = 0; k < chunk.sides; ++k) {
            Side side = newSides_[k];
            placeSide(side, newCorners_[side.a], newCorners_[side.b]);
            if (arcRadius(side) > 0) hulls_[side.joint] += chunk.firstCorner;
            side.a += chunk.firstCorner;
            side.b += chunk.firstCorner;
            shapes_.sides[chunk.firstSide + k] = side;
            chunk.radius = std::max(chunk.radius, side.radius);
            chunk.fineness = k == 0 ? side.radius : std::min(chunk.fineness, side.radius);
        }
        // An end may be thicker than its sides, by a joint to another body.
        for (const Corner& corner : newCorners_)
            chunk.radius = std::max(chunk.radius, corner.radius);
        giveUses(slot);
        auto& first = shapes_.firstChunk[chunk.body];
        shapes_.chunks[slot].nextOfBody = first;
        first = slot;
        return shapes_.chunks[slot];
    }

    std::uint32_t takeChunk() {
        if (shapes_.firstChunk.size() <= slotOf(record().id))
            shapes_.firstChunk.resize(slotOf(record().id) + 1, none);
        if (shapes_.freeChunks.empty()) {
            shapes_.chunks.emplace_back();
            return static_cast<std::uint32_t>(shapes_.chunks.size() - 1);
        }
        const auto slot = shapes_.freeChunks.back();
        shapes_.freeChunks.pop_back();
        return slot;
    }

    /// Enters the chunk with all movers that carry it.
    void giveUses(std::uint32_t slot) {
        Chunk& chunk = shapes_.chunks[slot];
        std::vector<std::uint32_t> movers;
        for (const Corner& corner : newCorners_) movers.push_back(corner.mover);
        std::sort(movers.begin(), movers.end());
        movers.erase(std::unique(movers.begin(), movers.end()), movers.end());
        chunk.uses = static_cast<std::uint32_t>(movers.size());
        chunk.firstUse = shapes_.usePool.allocate(chunk.uses);
        shapes_.uses.resize(shapes_.usePool.size());
        for (std::uint32_t k = 0; k < chunk.uses; ++k) {
            shapes_.uses[chunk.firstUse + k] = {slot, movers[k], movers_.firstUse[movers[k]]};
            movers_.firstUse[movers[k]] = chunk.firstUse + k;
        }
        // A chunk of several movers has an odometer of its own.
        chunk.frame =
            movers.size() == 1 ? movers.front() : newMover(body_, Point(0, 0), Point(1, 0));
    }

    bool hasOneMover(const std::vector<RimEdge>& loop) {
        const auto mover = moverOf(loop.front().from);
        return (state_.particles.cluster[loop.front().from] != none ||
                record().kind == BodyKind::fixed) &&
               std::all_of(loop.begin(), loop.end(),
                           [&](const RimEdge& e) { return moverOf(e.from) == mover; });
    }

    /// Closed, of one mover and one thickness, and nowhere bent inwards.
    bool isConvex(const std::vector<RimEdge>& loop) {
        if (loop.size() < 3 || loop.size() > mostConvexCorners || !hasOneMover(loop)) return false;
        if (std::any_of(loop.begin(), loop.end(),
                        [&](const RimEdge& edge) { return isBent(edge.joint); }))
            return false;
        const auto& rest = state_.particles.rest;
        double turns = 0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const RimEdge &edge = loop[k], &next = loop[(k + 1) % loop.size()];
            if (edge.to != next.from) return false;
            if (state_.joints.radius[edge.joint] != state_.joints.radius[loop[0].joint])
                return false;
            const Point u = (rest[edge.to] - rest[edge.from]).cast<double>();
            const Point v = (rest[next.to] - rest[next.from]).cast<double>();
            const double turn = cross(u, v) / (u.norm() * v.norm());
            if (!(turn > -straight) || u.dot(v) < -0.999999 * u.norm() * v.norm()) return false;
            if (turn < straight &&
                !(surfaceOf(state_, edge.joint, body_) == surfaceOf(state_, next.joint, body_)))
                return false;
            turns += angleOf({u.dot(v), cross(u, v)});
        }
        return turns < 1.5 * fullTurn;  // once round, not twice
    }

    /// Edges that go on in one line make one side.
    void addConvex(const std::vector<RimEdge>& loop) {
        begin();
        std::vector<RimEdge> edges;
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (isCorner(loop[(k + loop.size() - 1) % loop.size()], loop[k]))
                edges.push_back(loop[k]);
        for (const RimEdge& edge : edges) addCorner(edge.from);
        for (std::size_t k = 0; k < edges.size(); ++k) {
            Side side;
            side.a = corners_.at(edges[k].from);
            side.b = corners_.at(edges[(k + 1) % edges.size()].from);
            side.joint = slotOf(state_.joints.id[edges[k].joint]);
            side.radius = state_.joints.radius[edges[k].joint];
            side.outward = 1;
            newSides_.push_back(side);
        }
        finish(ChunkKind::convex);
    }
    bool isCorner(const RimEdge& edge, const RimEdge& next) const {
        const auto& rest = state_.particles.rest;
        const Point u = (rest[edge.to] - rest[edge.from]).cast<double>();
        const Point v = (rest[next.to] - rest[next.from]).cast<double>();
        return cross(u, v) >= straight * u.norm() * v.norm();
    }

    /// What is inside of a convex outline is never touched.
    void dropInside(const std::vector<RimEdge>& loop, std::vector<std::uint32_t>& left) {
        const auto& rest = state_.particles.rest;
        const auto inside = [&](std::uint32_t i) {
            return std::all_of(loop.begin(), loop.end(), [&](const RimEdge& e) {
                const Point u = (rest[e.to] - rest[e.from]).cast<double>();
                const Point v = (rest[i] - rest[e.from]).cast<double>();
                return cross(u, v) >= -1e-6 * u.norm() * u.norm();
            });
        };
        std::erase_if(left, [&](std::uint32_t j) {
            return inside(state_.joints.a[j]) && inside(state_.joints.b[j]) &&
                   moverOf(state_.joints.a[j]) == moverOf(state_.joints.b[j]);
        });
    }

    /// A capsule of one mover that shares no end with another.
    bool isLone(std::uint32_t j) {
        const auto a = state_.joints.a[j], b = state_.joints.b[j];
        if (moverOf(a) != moverOf(b) || isBent(j)) return false;
        return std::none_of(capsules_.begin(), capsules_.end(), [&](std::uint32_t k) {
            return k != j && (state_.joints.a[k] == a || state_.joints.b[k] == a ||
                              state_.joints.a[k] == b || state_.joints.b[k] == b);
        });
    }

    /// Capsules that hang together by their ends, a few to a chunk, one after the other.
    void addLoose(std::vector<std::uint32_t> left) {
        const std::size_t most = record().kind == BodyKind::fixed ? 2 : 6;
        while (!left.empty()) {
            begin();
            std::uint32_t j = left.front();
            const bool lone = isLone(j);
            while (j != none) {
                left.erase(std::find(left.begin(), left.end(), j));
                newSides_.push_back(sideOf(j));
                j = newSides_.size() < most ? nextAfter(left) : none;
            }
            if (lone) {
                Side back = newSides_.front();
                std::swap(back.a, back.b);
                newSides_.push_back(back);
            }
            finish(lone ? ChunkKind::convex : ChunkKind::loose);
        }
    }
    /// One that shares a particle with what was collected.
    std::uint32_t nextAfter(const std::vector<std::uint32_t>& left) const {
        for (const auto j : left)
            if (corners_.contains(state_.joints.a[j]) || corners_.contains(state_.joints.b[j]))
                return j;
        return none;
    }

    void addDiscs() {
        for (std::size_t k = 0; k < record().particles.size(); ++k) {
            const auto i = record().firstParticle + static_cast<std::uint32_t>(k);
            if (!(state_.particles.radius[i] > 0)) continue;
            begin();
            Side side;
            side.a = side.b = addCorner(i);
            side.radius = state_.particles.radius[i];
            newCorners_.front().radius = side.radius;
            newSides_.push_back(side);
            // The way from its centre to where it touches turns with every step beside somebody.
            movers_.fineness[newCorners_.front().mover] = side.radius / 100;
            const bool single =
                state_.particles.cluster[i] != none || record().kind == BodyKind::fixed;
            finish(single ? ChunkKind::convex : ChunkKind::loose);
        }
    }

    State& state_;
    Shapes& shapes_;
    Movers& movers_;
    std::uint32_t body_;
    std::optional<bool> whole_;            // whether all of it stands on one mover
    std::vector<std::uint32_t> capsules_;  // joints
    std::ptrdiff_t own_ = 0;               // of these, the first are no joints between bodies
    std::map<std::uint32_t, std::int32_t> outward_;   // by joint
    std::map<std::uint32_t, std::uint32_t> corners_;  // by particle, of the present chunk
    std::uint32_t firstCorner_ = 0;
    std::vector<Corner> newCorners_;
    std::vector<Corner> newCentres_;                // of arcs
    std::map<std::uint32_t, std::uint32_t> hulls_;  // by joint slot: the first of an arc's hull
    std::vector<Side> newSides_;
};

}  // namespace

void makeShape(State& state, std::uint32_t body) {
    if (state.bodies[body].disabled) return;
    ShapeMaker(state, body).run();
}

void shapeIsStale(State& state, std::uint32_t bodySlot) {
    auto& stale = state.core.staleShapes;
    if (stale.empty() || stale.back() != bodySlot) stale.push_back(bodySlot);
}

}  // namespace sulfur::detail
