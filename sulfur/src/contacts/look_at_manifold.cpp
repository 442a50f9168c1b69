// One row of up to two points for two convex chunks.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contacts/encounters.hpp"
#include "contacts/looks.hpp"
#include "contacts/pair_table.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"

namespace sulfur::detail {

namespace {

struct OldPoint {
    std::array<std::uint32_t, 3> particles{none, none, none};
    Real pressing = 0;  // kg m
    bool taken = false;
};

class ManifoldLook {
public:
    ManifoldLook(State& state, std::uint32_t pair)
        : state_(state),
          core_(state.core),
          index_(pair),
          pair_(core_.pairs[pair]),
          a_(core_.shapes.chunks[pair_.a]),
          b_(core_.shapes.chunks[pair_.b]) {}

    void run(const ForeseenManifold& foreseen) {
        const Real thickness = a_.radius + b_.radius;
        const Manifold m = isStill(foreseen) ? foreseen.manifold : manifoldOf(core_, pair_);
        if (m.count == 0) {
            dropRows(state_, index_);
            return watchApart(state_, index_, std::max(m.gap - thickness / 4, thickness / 4));
        }
        const bool isNew = !pair_.row;
        if (isNew) {
            pair_.row = core_.rows.addManifold(core_.movers, index_, a_.frame, b_.frame);
            ++core_.newRows;
            if (std::exchange(pair_.keptPressing, 0))
                core_.rows.setPressing(core_.rows.manifolds, pair_.row);
        }
        setPoints(m, isNew);
        setShape(m);
        core_.rows.markManifold(pair_.row);
        // From now on the refresh tells.
        watchPair(state_, index_, PairWatch::never);
    }

private:
    bool isStill(const ForeseenManifold& foreseen) const {
        const auto same = [](const Motion3& a, const Motion3& b) {
            return a.x == b.x && a.y == b.y && a.turn == b.turn;
        };
        return foreseen.isKnown && same(foreseen.a, motionNow(core_.movers, a_.frame)) &&
               same(foreseen.b, motionNow(core_.movers, b_.frame));
    }

    void setPoints(const Manifold& m, bool isNew) {
        ManifoldBlock& block = core_.rows.manifold(pair_.row);
        const auto lane = RowGraph::laneOf(pair_.row);
        std::array<OldPoint, 2> old;
        Real rubbing = isNew ? pair_.kept[2] : block.rubbing[lane];
        for (std::size_t k = 0; k < 2; ++k)
            old[k] = {pair_.features[k], isNew ? pair_.kept[k] : block.points[k].pressing[lane],
                      false};
        for (int k = 0; k < m.count; ++k)
            wanted_[static_cast<std::size_t>(k)] = keyOf(m.features[static_cast<std::size_t>(k)]);
        if (!isNew && pair_.features == wanted_) return;
        if (isNew)
            block.rubbing[lane] = rubbing;
        else
            for (int k = 0; k < 2; ++k)
                RowGraph::pressManifold(core_.movers, block, lane, k,
                                        -block.points[k].pressing[lane]);
        pair_.kept = {};
        for (int k = 0; k < 2; ++k) setPoint(m, k, old, block, lane);
    }

    static constexpr std::array<std::uint32_t, 3> noFeature{none, none, none};
    std::array<std::uint32_t, 3> keyOf(const Feature& f) const {
        return particlesOf(core_.shapes, f.corner, f.side);
    }

    void setPoint(const Manifold& m, int k, std::array<OldPoint, 2>& old, ManifoldBlock& block,
                  std::uint32_t lane) {
        ManifoldPoint& p = block.points[k];
        ManifoldFeature& f = core_.rows.manifoldShape(pair_.row).features[k];
        const auto index = static_cast<std::size_t>(k);
        // The refresh turns what a point has from no direction at all to the right one.
        p.pressing[lane] = p.normalX[lane] = p.normalY[lane] = 0;
        p.normalArmA[lane] = p.normalArmB[lane] = 0;
        pair_.features[index] = wanted_[index];
        if (k >= m.count) {
            f.owner[lane] = 0;
            return;
        }
        const Feature& feature = m.features[index];
        const Corner& corner = core_.shapes.corners[feature.corner];
        const Side& side = core_.shapes.sides[feature.side];
        f.cornerX[lane] = corner.x;
        f.cornerY[lane] = corner.y;
        f.outX[lane] = side.outX;
        f.outY[lane] = side.outY;
        f.offset[lane] = side.offset;
        f.middle[lane] = side.middle;
        f.owner[lane] = feature.cornerIsB ? Real(1) : Real(-1);
        const Chunk &own = feature.cornerIsB ? b_ : a_, &other = feature.cornerIsB ? a_ : b_;
        f.half[lane] = other.corners == 2 ? -side.half : side.half;
        f.share[lane] = own.radius / (own.radius + other.radius);
        const Surfaces surface =
            surfacesOf(state_, feature.corner, own.body, feature.side, other.body);
        block.staticFriction[lane] = surface.staticFriction;
        block.kineticFriction[lane] = surface.kineticFriction;
        block.slip[lane] = -surface.speed * state_.h;
        core_.rows.manifoldShape(pair_.row).rolling[lane] = static_cast<float>(surface.rolling);
        pair_.drag = surface.drag;
        pair_.restitution = surface.restitution;
        p.pressing[lane] = inherited(wanted_[index], old, block, lane);
    }

    /// The impulse of the same feature, or of one that is no more.
    Real inherited(const std::array<std::uint32_t, 3>& key, std::array<OldPoint, 2>& old,
                   ManifoldBlock& block, std::uint32_t lane) {
        for (OldPoint& o : old)
            if (!o.taken && o.particles == key) {
                o.taken = true;
                return o.pressing;
            }
        if (const Heir* heir = findHeir(core_, key)) {
            block.rubbing[lane] += heir->rubbing;
            return heir->pressing;
        }
        for (OldPoint& o : old)
            if (!o.taken && o.particles != noFeature && o.particles != wanted_[0] &&
                o.particles != wanted_[1]) {
                o.taken = true;
                return o.pressing;
            }
        return 0;
    }

    void setShape(const Manifold& m) {
        ManifoldShape& shape = core_.rows.manifoldShape(pair_.row);
        const auto lane = RowGraph::laneOf(pair_.row);
        shape.thickness[lane] = a_.radius + b_.radius;
        shape.fineness[lane] = a_.fineness + b_.fineness;
        shape.lookX[lane] = m.x;
        shape.lookY[lane] = m.y;
        shape.lookCosine[lane] = m.cosine;
        shape.lookSine[lane] = m.sine;
        shape.reach[lane] = core_.movers.reach[b_.frame];
        shape.margin[lane] = m.margin;
    }

    State& state_;
    ContactCore& core_;
    std::uint32_t index_;
    Pair& pair_;
    const Chunk &a_, &b_;
    std::array<std::array<std::uint32_t, 3>, 2> wanted_{noFeature, noFeature};
};

}  // namespace

Manifold manifoldOf(const ContactCore& core, const Pair& pair) {
    const Movers& movers = core.movers;
    const Chunk &a = core.shapes.chunks[pair.a], &b = core.shapes.chunks[pair.b];
    const Motion3 wayA = motionNow(movers, a.frame), wayB = motionNow(movers, b.frame);
    const Real closing = std::abs(wayA.x - wayB.x) + std::abs(wayA.y - wayB.y) +
                         movers.reach[a.frame] * std::abs(wayA.turn) +
                         movers.reach[b.frame] * std::abs(wayB.turn);
    return findManifold(movers, core.shapes, a, b, closing);
}

void lookAtManifold(State& state, std::uint32_t pair, const ForeseenManifold& foreseen) {
    ManifoldLook(state, pair).run(foreseen);
}

}  // namespace sulfur::detail
