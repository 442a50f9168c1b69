// Points that push, as those see them who ask about contacts one by one.
#include <algorithm>
#include <tuple>
#include <utility>

#include "contacts/stages.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

class Exporter {
public:
    Exporter(const State& state, std::vector<ContactLoad>& contacts)
        : state_(state), core_(state.core), contacts_(contacts) {}

    void run(bool sleepers) {
        contacts_.clear();
        for (const Pair& pair : core_.pairs)
            if (pair.a != none) addPair(pair, sleepers);
    }
    /// Of one body, by slot, with sleepers.
    void runOf(std::uint32_t slot) {
        contacts_.clear();
        const auto& chunks = core_.shapes.chunks;
        const auto& first = core_.shapes.firstChunk;
        for (auto c = slot < first.size() ? first[slot] : none; c != none; c = chunks[c].nextOfBody)
            for (auto at = chunks[c].firstPair; at != none;) {
                const Pair& pair = core_.pairs[at / 2];
                // Of its own parts, once.
                if (at % 2 == 0 || chunks[pair.a].body != chunks[pair.b].body) addPair(pair, true);
                at = pair.next[at % 2];
            }
    }
    /// Impacts of the last step, of one body (dense index) or of all; where a row presses at the
    /// same point, both are one.
    void addKnocks(std::uint32_t body = none) {
        const std::size_t rows = contacts_.size();
        for (const Knock& knock : core_.knocks) {
            ContactLoad c;
            c.normal = knock.normal;
            c.normalLambda = knock.pressing;
            c.tangentLambda = knock.rubbing;
            if (body == none || isOf(knock, body)) add(c, knock.particles);
        }
        const auto first = contacts_.begin() + static_cast<std::ptrdiff_t>(rows);
        std::sort(first, contacts_.end(), [](const ContactLoad& x, const ContactLoad& y) {
            return std::tuple(placeOf(x), x.normalLambda, x.tangentLambda) <
                   std::tuple(placeOf(y), y.normalLambda, y.tangentLambda);
        });
        auto last = first;  // of those at different places
        for (auto k = first; k != contacts_.end(); ++k) {
            if (last != first && placeOf(*(last - 1)) == placeOf(*k))
                addTo(*(last - 1), *k);
            else
                *last++ = *k;
        }
        contacts_.erase(last, contacts_.end());
        for (std::size_t k = 0; k < rows; ++k) {
            const auto same = std::lower_bound(
                first, contacts_.end(), contacts_[k],
                [](const auto& x, const auto& y) { return placeOf(x) < placeOf(y); });
            if (same == contacts_.end() || placeOf(*same) != placeOf(contacts_[k])) continue;
            addTo(contacts_[k], *same);
            same->normalLambda = same->tangentLambda = 0;
        }
        contacts_.erase(std::remove_if(first, contacts_.end(),
                                       [](const ContactLoad& c) { return c.normalLambda == 0; }),
                        contacts_.end());
    }

private:
    static std::tuple<std::uint32_t, std::uint32_t, std::uint32_t> placeOf(const ContactLoad& c) {
        return {c.particle, c.a, c.b};
    }
    static void addTo(ContactLoad& c, const ContactLoad& more) {
        c.normalLambda += more.normalLambda;
        c.tangentLambda += more.tangentLambda;
    }

    /// As add() names both of its bodies.
    bool isOf(const Knock& knock, std::uint32_t body) const {
        const auto isOurs = [&](std::uint32_t slot) {
            const auto i = state_.particleSlots.denseOf(slot);
            return i != none && state_.particles.body[i] == body;
        };
        return isOurs(knock.particles[0]) || isOurs(knock.particles[1]);
    }

    void addPair(const Pair& pair, bool sleepers) {
        if (pair.row)
            addManifold(pair);
        else if (sleepers && pair.keptPressing)
            addSleeping(pair);
        for (auto t = pair.firstTouch; t != none; t = core_.touches[t].next)
            addTouch(core_.touches[t], sleepers);
    }
    void addManifold(const Pair& pair) {
        const ManifoldBlock& block = core_.rows.manifold(pair.row);
        const ManifoldShape& shape = core_.rows.manifoldShape(pair.row);
        const auto lane = RowGraph::laneOf(pair.row);
        bool first = true;  // the friction of both is told with the first
        for (std::size_t k = 0; k < 2; ++k) {
            const ManifoldPoint& p = block.points[k];
            if (!(p.pressing[lane] > 0)) continue;
            ContactLoad c;
            c.normal = shape.features[k].owner[lane] * Vec2(p.normalX[lane], p.normalY[lane]);
            c.normalLambda = p.pressing[lane];
            c.tangentLambda = std::exchange(first, false) ? block.rubbing[lane] : Real(0);
            add(c, pair.features[k]);
        }
    }
    void addSleeping(const Pair& pair) {
        for (std::size_t k = 0; k < 2; ++k) {
            if (!(pair.kept[k] > 0)) continue;
            ContactLoad c;
            c.normal = Vec2(pair.keptNormal[2 * k], pair.keptNormal[2 * k + 1]);
            c.normalLambda = pair.kept[k];
            c.tangentLambda = k == 0 ? pair.kept[2] : Real(0);
            add(c, pair.features[k]);
        }
    }
    void addTouch(const Touch& touch, bool sleepers) {
        const Shapes& shapes = core_.shapes;
        const Side& side = shapes.sides[touch.side];
        ContactLoad c;
        if (touch.row) {
            const TouchBlock& block = core_.rows.touch(touch.row);
            const auto lane = RowGraph::laneOf(touch.row);
            c.normal = Vec2(block.normalX[lane], block.normalY[lane]);
            c.normalLambda = block.pressing[lane];
            c.tangentLambda = block.rubbing[lane];
        } else if (sleepers) {
            c.normal = Vec2(touch.normalX, touch.normalY);
            c.normalLambda = touch.pressing;
            c.tangentLambda = touch.rubbing;
        }
        if (!(c.normalLambda > 0)) return;
        add(c, {shapes.corners[touch.corner].particle, shapes.corners[side.a].particle,
                shapes.corners[side.b].particle});
    }

    void add(ContactLoad& c, const std::array<std::uint32_t, 3>& particles) {
        const Particles& p = state_.particles;
        c.particle = state_.particleSlots.denseOf(particles[0]);
        c.a = state_.particleSlots.denseOf(particles[1]);
        c.b = state_.particleSlots.denseOf(particles[2]);
        if (c.particle == none || c.a == none || c.b == none) return;  // it broke away
        c.bodyA = p.body[c.particle];
        c.bodyB = p.body[c.a];
        const Point way = p.position[c.b] - p.position[c.a];
        const double length2 = way.squaredNorm();
        const double along = way.dot(p.position[c.particle] - p.position[c.a]);
        const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
        c.weightB = static_cast<Real>(t);
        c.weightA = 1 - c.weightB;
        contacts_.push_back(c);
    }

    const State& state_;
    const ContactCore& core_;
    std::vector<ContactLoad>& contacts_;
};

}  // namespace

void exportContacts(const State& state, std::vector<ContactLoad>& contacts, bool sleepers) {
    Exporter exporter(state, contacts);
    exporter.run(sleepers);
    exporter.addKnocks();
}

void exportContactsOf(const State& state, std::uint32_t body, std::vector<ContactLoad>& contacts) {
    const auto slot = state.bodies[body].id.index - 1;
    Exporter exporter(state, contacts);
    // Capsules between bodies are chunks of one of them, with corners of both.
    if (!state.core.tiedCapsules.empty() && hasLinks(state.core, slot))
        exporter.run(true);
    else
        exporter.runOf(slot);
    std::erase_if(contacts,
                  [&](const ContactLoad& c) { return c.bodyA != body && c.bodyB != body; });
    exporter.addKnocks(body);
}

}  // namespace sulfur::detail
