// Points that push, as those see them who ask about contacts one by one.
#include <algorithm>

#include "contacts/contact_core.hpp"
#include "contacts/stages.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

class Exporter {
public:
    explicit Exporter(State& state) : state_(state), core_(state.core) {}

    void run() {
        state_.contacts.clear();
        for (std::uint32_t c = 0; c < RowGraph::colours; ++c) {
            const ManifoldList& manifolds = core_.rows.manifolds[c];
            for (std::uint32_t i = 0; i < manifolds.rows; ++i) addManifold({c, i});
            const TouchList& touches = core_.rows.touches[c];
            for (std::uint32_t i = 0; i < touches.rows; ++i) addTouch({c, i});
        }
    }

private:
    void addManifold(RowPlace place) {
        const ManifoldBlock& block = core_.rows.manifold(place);
        const ManifoldShape& shape = core_.rows.manifoldShape(place);
        const auto lane = RowGraph::laneOf(place);
        for (std::size_t k = 0; k < 2; ++k) {
            const ManifoldPoint& p = block.points[k];
            if (!(p.pressing[lane] > 0)) continue;
            const Real owner = shape.features[k].owner[lane];
            Contact c;
            c.normal = owner * Vec2(p.normalX[lane], p.normalY[lane]);
            c.normalLambda = p.pressing[lane];
            c.tangentLambda = k == 0 ? block.rubbing[lane] : Real(0);
            c.staticFriction = block.staticFriction[lane];
            add(c, core_.pairs[shape.pair[lane]].features[k]);
        }
    }
    void addTouch(RowPlace place) {
        const TouchBlock& block = core_.rows.touch(place);
        const auto lane = RowGraph::laneOf(place);
        if (!(block.pressing[lane] > 0)) return;
        const Touch& touch = core_.touches[core_.rows.touchShape(place).touch[lane]];
        const Shapes& shapes = core_.shapes;
        const Side& side = shapes.sides[touch.side];
        Contact c;
        c.normal = Vec2(block.normalX[lane], block.normalY[lane]);
        c.normalLambda = block.pressing[lane];
        c.tangentLambda = block.rubbing[lane];
        c.staticFriction = block.staticFriction[lane];
        add(c, {shapes.corners[touch.corner].particle, shapes.corners[side.a].particle,
                shapes.corners[side.b].particle});
    }

    void add(Contact& c, const std::array<std::uint32_t, 3>& particles) {
        const Particles& p = state_.particles;
        c.particle = state_.particleSlots.denseOf(particles[0]);
        c.a = state_.particleSlots.denseOf(particles[1]);
        c.b = state_.particleSlots.denseOf(particles[2]);
        c.bodyA = p.body[c.particle];
        c.bodyB = p.body[c.a];
        const Point way = p.position[c.b] - p.position[c.a];
        const double length2 = way.squaredNorm();
        const double along = way.dot(p.position[c.particle] - p.position[c.a]);
        const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
        c.weightB = static_cast<Real>(t);
        c.weightA = 1 - c.weightB;
        c.thickness = p.reach[c.particle] + p.reach[c.a];
        state_.contacts.push_back(c);
    }

    State& state_;
    ContactCore& core_;
};

}  // namespace

void exportContacts(State& state) {
    Exporter(state).run();
}

}  // namespace sulfur::detail
