// What the caller says about contacts before they are solved: see World::setPreSolve.
//
// A row that does not act in a step is taken away, and its pair looked at again in the next one: so
// no stage knows of it. A changed surface is one of the step: between steps rows are as if nobody
// had been asked, so that neither snapshots nor later callbacks find answers of others.
#include "contacts/ask.hpp"

#include <algorithm>
#include <array>

#include "contacts/looks.hpp"
#include "contacts/pair_table.hpp"
#include "core/error_checks.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// m, by which motions of movers open a point; `motionOf` tells that of each.
template <class Function>
Real openingOf(const ManifoldBlock& r, const ManifoldPoint& p, std::uint32_t l,
               Function&& motionOf) {
    const Motion3 a = motionOf(r.a[l]), b = motionOf(r.b[l]);
    return p.normalX[l] * (b.x - a.x) + p.normalY[l] * (b.y - a.y) + p.normalArmB[l] * b.turn -
           p.normalArmA[l] * a.turn;
}
template <class Function>
Real openingOf(const TouchBlock& t, std::uint32_t l, Function&& motionOf) {
    const Motion3 p = motionOf(t.p[l]), a = motionOf(t.a[l]), b = motionOf(t.b[l]);
    const Vec2 normal(t.normalX[l], t.normalY[l]);
    const Vec2 lean = t.lean[l] * Vec2(t.sideX[l], t.sideY[l]);
    return normal.dot(Vec2(p.x, p.y)) + t.normalArmP[l] * p.turn -
           Vec2(t.weightA[l] * normal - lean).dot(Vec2(a.x, a.y)) - t.normalArmA[l] * a.turn -
           Vec2(t.weightB[l] * normal + lean).dot(Vec2(b.x, b.y)) - t.normalArmB[l] * b.turn;
}

class Asker {
public:
    explicit Asker(State& state)
        : state_(state), core_(state.core), movers_(core_.movers), callbacks_(state.callbacks) {}

    void askAboutRows() {
        core_.passedBy.clear();
        for (std::uint32_t index = 0; index < core_.pairs.size(); ++index) {
            Pair& pair = core_.pairs[index];
            if (pair.a == none || isOfOneBody(pair)) continue;
            if (pair.row)
                askAboutManifold(index, pair);
            else if (pair.firstTouch != none)
                askAboutTouches(index, pair);
        }
    }

    void askAboutPassings(const Pair& pair, std::vector<Passing>& passings) {
        if (isOfOneBody(pair)) return;
        std::erase_if(passings, [&](const Passing& p) {
            const bool oneIsA = movers_.body[p.one] == encounterOf(pair).a.index - 1;
            const auto along = [&](std::uint32_t m) {
                return p.normal.dot(Vec2(core_.ways[m].x, core_.ways[m].y));
            };
            const Real opens =
                along(p.one) - (1 - p.share) * along(p.others[0]) - p.share * along(p.others[1]);
            PreSolveContact contact = contactOf(pair, oneIsA, p.normal);
            contact.point = p.at;
            contact.speed = -opens / state_.h;
            contact.gap = p.gap;
            Material unused;
            return !acts(contact, unused);
        });
    }

private:
    const Encounter& encounterOf(const Pair& pair) const {
        return core_.encounters[pair.encounter];
    }
    bool isOfOneBody(const Pair& pair) const { return encounterOf(pair).a == encounterOf(pair).b; }
    bool isFirst(const Pair& pair, std::uint32_t chunk) const {
        return core_.shapes.chunks[chunk].body == encounterOf(pair).a.index - 1;
    }

    /// `normal`: towards the first body of an encounter, or away from it.
    PreSolveContact contactOf(const Pair& pair, bool towards, const Vec2& normal) const {
        PreSolveContact contact;
        contact.a = encounterOf(pair).a;
        contact.b = encounterOf(pair).b;
        contact.normal = towards ? normal : Vec2(-normal);
        return contact;
    }

    Motion3 placed(std::uint32_t m) const {
        const SolverBody& body = movers_.bodies[m];
        return {body.x, body.y, body.turn};
    }

    /// What the caller answers, and makes of a surface.
    bool acts(const PreSolveContact& contact, Material& surface) {
        const Material own = surface;
        bool answer = true;
        const bool isAnswered = callbacks_.ask([&] {
            answer = callbacks_.preSolve(contact, surface);
            if (!(surface == own)) validate(surface);
        });
        if (isAnswered) return answer;
        surface = own;
        return true;
    }

    template <class Block>
    Material surfaceOf(const Pair& pair, const Block& block, std::uint32_t l) const {
        Material surface;
        const bool slides = state_.settings.friction == Friction::sliding;
        surface.staticFriction = slides ? pair.drag : block.staticFriction[l];
        surface.kineticFriction = slides ? pair.drag : block.kineticFriction[l];
        surface.restitution = pair.restitution;
        surface.surfaceSpeed = -block.slip[l] / state_.h;
        return surface;
    }

    /// Changes the surface of a row; that of its pair is left to others.
    template <class Block>
    void setSurface(const Resurfaced& before, Block& block, std::uint32_t l, const Material& own,
                    const Material& surface) {
        core_.resurfaced.push_back(before);
        if (state_.settings.friction == Friction::coulomb) {
            block.staticFriction[l] = surface.staticFriction;
            block.kineticFriction[l] = surface.kineticFriction;
        }
        if (surface.surfaceSpeed != own.surfaceSpeed)
            block.slip[l] = -surface.surfaceSpeed * state_.h;
    }
    void setPairSurface(Pair& pair, Real restitution, Real kineticFriction) {
        pair.restitution = restitution;
        if (state_.settings.friction == Friction::sliding) pair.drag = kineticFriction;
        core_.answersBounce = core_.answersBounce || restitution > 0;
    }

    void askAboutManifold(std::uint32_t index, Pair& pair) {
        ManifoldBlock& block = core_.rows.manifold(pair.row);
        const auto l = RowGraph::laneOf(pair.row);
        const Material own = surfaceOf(pair, block, l);
        Material surface = own;
        if (!acts(contactOfManifold(pair, block, l), surface)) {
            dropRows(state_, index);
            return noteInactive(index, pair);
        }
        if (surface == own) return;
        setSurface(beforeOf(index, none, block, l), block, l, own, surface);
        setPairSurface(pair, surface.restitution, surface.kineticFriction);
    }

    /// Both points are one contact, because they rub as one.
    PreSolveContact contactOfManifold(const Pair& pair, const ManifoldBlock& block,
                                      std::uint32_t l) const {
        const ManifoldShape& shape = core_.rows.manifoldShape(pair.row);
        // From chunk a to chunk b: the tangent is that turned by a right angle.
        const Vec2 normal(block.tangentY[l], -block.tangentX[l]);
        PreSolveContact contact = contactOf(pair, !isFirst(pair, pair.a), normal);
        Point sum(0, 0);
        Real opens = Real(1e30), points = 0;
        contact.gap = Real(1e30);
        for (std::size_t k = 0; k < 2; ++k) {
            const ManifoldPoint& p = block.points[k];
            const ManifoldFeature& f = shape.features[k];
            const Real owner = f.owner[l];
            if (owner == 0) continue;
            const auto mover = owner > 0 ? block.b[l] : block.a[l];
            const Real radius = owner * f.share[l] * shape.thickness[l];
            const Vec2 back = radius * Vec2(p.normalX[l], p.normalY[l]);
            sum += placeOnMover(movers_, mover, f.cornerX[l], f.cornerY[l]) - back.cast<double>();
            const Real placedOpening =
                openingOf(block, p, l, [&](std::uint32_t m) { return placed(m); });
            contact.gap = std::min(contact.gap, p.gap[l] + placedOpening);
            opens = std::min(opens, openingOf(block, p, l, [&](std::uint32_t m) {
                                 return motionNow(movers_, m);
                             }));
            ++points;
        }
        contact.point = sum / static_cast<double>(points);
        contact.speed = -opens / state_.h;
        return contact;
    }

    void askAboutTouches(std::uint32_t index, Pair& pair) {
        Real restitution = 0, kineticFriction = 0;  // the largest
        bool anyChanges = false, anyGoes = false;
        for (auto* link = &pair.firstTouch; *link != none;) {
            const auto t = *link;
            Touch& touch = core_.touches[t];
            if (!touch.row) return;  // it sleeps, as all others
            TouchBlock& block = core_.rows.touch(touch.row);
            const auto l = RowGraph::laneOf(touch.row);
            const Material own = surfaceOf(pair, block, l);
            Material surface = own;
            if (!acts(contactOfTouch(pair, touch, block, l), surface)) {
                *link = touch.next;
                dropTouch(core_, t);
                anyGoes = true;
                continue;
            }
            link = &touch.next;
            restitution = std::max(restitution, surface.restitution);
            kineticFriction = std::max(kineticFriction, surface.kineticFriction);
            if (surface == own) continue;
            setSurface(beforeOf(index, t, block, l), block, l, own, surface);
            anyChanges = true;
        }
        if (anyChanges) setPairSurface(pair, restitution, kineticFriction);
        if (anyGoes) noteInactive(index, pair);
    }

    /// It is looked at again in the next step.
    void noteInactive(std::uint32_t index, const Pair& pair) {
        const auto& chunks = core_.shapes.chunks;
        core_.passedBy.emplace_back(chunks[pair.a].body, chunks[pair.b].body);
        watchPair(state_, index, -1);
    }

    PreSolveContact contactOfTouch(const Pair& pair, const Touch& touch, const TouchBlock& block,
                                   std::uint32_t l) const {
        const TouchShape& shape = core_.rows.touchShape(touch.row);
        // By the side, because the corner may be the centre of an arc.
        const Chunk& b = core_.shapes.chunks[pair.b];
        const bool ofA = touch.side - b.firstSide < b.sides;
        const Vec2 normal(block.normalX[l], block.normalY[l]);
        PreSolveContact contact = contactOf(pair, isFirst(pair, ofA ? pair.a : pair.b), normal);
        const Vec2 back = shape.share[l] * shape.thickness[l] * normal;
        contact.point = placeOnMover(movers_, block.p[l], shape.cornerX[l], shape.cornerY[l]) -
                        back.cast<double>();
        contact.gap =
            block.gap[l] + openingOf(block, l, [&](std::uint32_t m) { return placed(m); });
        contact.speed =
            -openingOf(block, l, [&](std::uint32_t m) { return motionNow(movers_, m); }) / state_.h;
        return contact;
    }

    template <class Block>
    Resurfaced beforeOf(std::uint32_t index, std::uint32_t touch, const Block& block,
                        std::uint32_t l) const {
        const Pair& pair = core_.pairs[index];
        return {index,
                touch,
                block.staticFriction[l],
                block.kineticFriction[l],
                block.slip[l],
                pair.restitution,
                pair.drag};
    }

    State& state_;
    ContactCore& core_;
    const Movers& movers_;
    Callbacks& callbacks_;
};

}  // namespace

void askAboutRows(State& state) {
    Asker(state).askAboutRows();
}

void forgetAnswers(State& state) {
    ContactCore& core = state.core;
    const auto restore = [](auto& block, std::uint32_t l, const Resurfaced& before) {
        block.staticFriction[l] = before.staticFriction;
        block.kineticFriction[l] = before.kineticFriction;
        block.slip[l] = before.slip;
    };
    for (const Resurfaced& before : core.resurfaced) {
        Pair& pair = core.pairs[before.pair];
        const RowPlace row = before.touch == none ? pair.row : core.touches[before.touch].row;
        if (before.touch == none)
            restore(core.rows.manifold(row), RowGraph::laneOf(row), before);
        else
            restore(core.rows.touch(row), RowGraph::laneOf(row), before);
        pair.restitution = before.restitution;
        pair.drag = before.drag;
    }
    core.resurfaced.clear();
    core.answersBounce = false;
}

void askAboutPassings(State& state, const Pair& pair, std::vector<Passing>& passings) {
    Asker(state).askAboutPassings(pair, passings);
}

}  // namespace sulfur::detail
