// What a driver squeezes against something that cannot give way is not pressed ever harder.
//
// Impulses are kept from step to step, because loads change slowly. Between a driver and a wall no
// impulse does: both rows would add to theirs without end, and whoever slips out would be thrown by
// what the one of them has gathered. So bodies on which a driver still closes in when a step has
// been solved begin the next one without impulses, with all that stands in their way.
#include <utility>

#include "contacts/row_pushes.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// A driver that closes in more slowly, or at less than half of its own speed, has not pressed in
/// vain: the sweeps have not ended it yet.
constexpr Real vainSpeed = Real(tuned::vainSpeed);
/// What carries so much of the load that is pressed in vain stands in the way.
constexpr Real loadShare = Real(tuned::loadShare);

class GivingWay {
public:
    explicit GivingWay(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          pressed_(&state.arena),
          isPressed_(movers_.size(), 0, &state.arena) {}

    void run() {
        for (const auto body : state_.work.kinematic) {
            const auto slot = state_.bodies[body].id.index - 1;
            for (auto c = core_.shapes.firstChunk[slot]; c != none;
                 c = core_.shapes.chunks[c].nextOfBody)
                forEachRow(c, [&](auto& block, std::uint32_t lane) {
                    if (isVain(block, lane)) press(block, lane, pressingOf(block, lane));
                });
        }
        for (std::size_t k = 0; k < pressed_.size(); ++k) {
            const auto [mover, load] = pressed_[k];
            for (auto u = movers_.firstUse[mover]; u != none; u = core_.shapes.uses[u].next)
                forEachRow(core_.shapes.uses[u].chunk,
                           [&, pressed = load](auto& block, std::uint32_t lane) {
                               if (pressingOf(block, lane) >= loadShare * pressed)
                                   press(block, lane, pressed);
                               forget(block, lane);
                           });
        }
    }

private:
    bool isDriver(std::uint32_t m) const {
        return movers_.bodies[m].inverseMass == 0 && movers_.bodies[m].inverseInertia == 0;
    }

    /// Whether a driver's row still closes, by the power of its impulses.
    template <class Block>
    bool isVain(const Block& block, std::uint32_t lane) const {
        Real closing = 0, driven = 0;
        forEachPush(block, lane, [&](std::uint32_t m, const Vec2& push, Real twist) {
            const SolverBody& v = movers_.bodies[m];
            const Prediction& p = movers_.predictions[m];
            const Real power =
                push[0] * (p.vx + v.vx) + push[1] * (p.vy + v.vy) + twist * (p.spin + v.spin);
            closing -= power;
            if (isDriver(m)) driven -= power;
        });
        return closing > vainSpeed * state_.h * pressingOf(block, lane) && 2 * closing > driven;
    }

    template <class Block>
    void press(const Block& block, std::uint32_t lane, Real load) {
        forEachPush(block, lane, [&](std::uint32_t m, const Vec2&, Real) {
            if (isDriver(m) || std::exchange(isPressed_[m], 1) != 0) return;
            pressed_.emplace_back(m, load);
        });
    }

    template <class Block>
    void forget(Block& block, std::uint32_t lane) {
        forEachPush(block, lane, [&](std::uint32_t m, const Vec2& push, Real twist) {
            SolverBody& body = movers_.bodies[m];
            body.vx -= push[0] * body.inverseMass;
            body.vy -= push[1] * body.inverseMass;
            body.spin -= twist * body.inverseInertia;
        });
        forgetImpulses(block, lane);
    }

    template <class Function>
    void forEachRow(std::uint32_t chunk, Function&& f) {
        for (auto at = core_.shapes.chunks[chunk].firstPair; at != none;) {
            const Pair& pair = core_.pairs[at / 2];
            at = pair.next[at % 2];
            if (pair.row) f(core_.rows.manifold(pair.row), RowGraph::laneOf(pair.row));
            for (auto i = pair.firstTouch; i != none; i = core_.touches[i].next)
                if (const RowPlace row = core_.touches[i].row)
                    f(core_.rows.touch(row), RowGraph::laneOf(row));
        }
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    std::pmr::vector<std::pair<std::uint32_t, Real>> pressed_;  // movers, and how hard; kg m
    std::pmr::vector<std::uint8_t> isPressed_;                  // by mover
};

}  // namespace

void giveWay(State& state) {
    if (!state.work.kinematic.empty()) GivingWay(state).run();
}

}  // namespace sulfur::detail
