// What a driver squeezes against something that cannot give way is not pressed ever harder.
//
// Impulses are kept from step to step, because loads change slowly. Between a driver and a wall no
// impulse does: both rows would add to theirs without end, and whoever slips out would be thrown by
// what the one of them has gathered. So bodies on which a driver still closes in when a step has
// been solved begin the next one without impulses, if its load goes through them to something else
// that nothing pushes. So do bodies that rows have driven beyond the limit of speed: they do not go
// on like that, and impulses that found no balance would double in every step.
#include <cmath>
#include <utility>

#include "contacts/row_pushes.hpp"
#include "contacts/stages.hpp"
#include "core/limits.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// A driver that closes in more slowly has not pressed in vain.
/// What carries so much of the load stands in the way.
constexpr Real loadShare = Real(tuned::loadShare);

class GivingWay {
public:
    explicit GivingWay(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          vain_(slowSpeedsOf(state.settings).vain * state.h),
          pressed_(&state.arena),
          isPressed_(&state.arena) {}

    void forgetVain() {
        if (state_.work.kinematic.empty()) return;
        isPressed_.assign(core_.shapes.firstChunk.size(), 0);
        for (const auto body : state_.work.kinematic) {
            const auto driver = state_.bodies[body].id.index - 1;
            forEachRow(core_, driver, [&](auto& block, std::uint32_t lane) {
                if (isVain(block, lane)) follow(block, lane, driver);
            });
        }
    }

    void forgetLimited() {
        const Real most = static_cast<Real>(maxSpeed) * state_.h;
        std::uint32_t done = none;  // movers of one body stand together
        for (const auto m : core_.awakeMovers) {
            if (core_.lengths[m] <= most || movers_.body[m] == done) continue;
            const BodyWay& way = core_.ways[m];
            if (std::abs(way.x) <= most && std::abs(way.y) <= most &&
                movers_.reach[m] * std::abs(way.turn) <= most)
                continue;
            done = movers_.body[m];
            forEachRow(core_, done, [&](auto& block, std::uint32_t lane) { forget(block, lane); });
        }
    }

private:
    bool isDriver(std::uint32_t m) const {
        return movers_.bodies[m].inverseMass == 0 && movers_.bodies[m].inverseInertia == 0;
    }

    /// Whether a driver's row still closes, by the power of its impulses.
    template <class Block>
    bool isVain(const Block& block, std::uint32_t lane) const {
        Real closing = 0;
        forEachPush(block, lane, [&](std::uint32_t m, const Vec2& push, Real twist) {
            const SolverBody& v = movers_.bodies[m];
            const Prediction& p = movers_.predictions[m];
            closing -=
                push[0] * (p.vx + v.vx) + push[1] * (p.vy + v.vy) + twist * (p.spin + v.spin);
        });
        return closing > vain_ * pressingOf(block, lane);
    }

    /// Through whom the load of a driver's row goes. If it ends at something that stands fast, or
    /// at another driver, all of them forget what presses them.
    template <class Block>
    void follow(const Block& block, std::uint32_t lane, std::uint32_t driver) {
        const Real load = pressingOf(block, lane);
        const std::size_t first = pressed_.size();
        bool ends = press(block, lane, driver);
        for (std::size_t k = first; k < pressed_.size(); ++k)
            forEachRow(core_, pressed_[k], [&](auto& other, std::uint32_t l) {
                if (pressingOf(other, l) >= loadShare * load) ends |= press(other, l, driver);
            });
        for (std::size_t k = first; ends && k < pressed_.size(); ++k)
            forEachRow(core_, pressed_[k], [&](auto& other, std::uint32_t l) { forget(other, l); });
    }

    /// Notes whom a row presses. Returns whether that is something else that nothing pushes.
    template <class Block>
    bool press(const Block& block, std::uint32_t lane, std::uint32_t driver) {
        bool ends = false;
        forEachPush(block, lane, [&](std::uint32_t m, const Vec2& push, Real) {
            const auto body = movers_.body[m];
            if (isDriver(m))
                ends |= !push.isZero(0) && body != driver;
            else if (std::exchange(isPressed_[body], 1) == 0)
                pressed_.push_back(body);
        });
        return ends;
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

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    Real vain_;  // m: a driver that closes in by more in a step has pressed in vain
    std::pmr::vector<std::uint32_t> pressed_;   // bodies, slots
    std::pmr::vector<std::uint8_t> isPressed_;  // by slot of a body
};

}  // namespace

void giveWay(State& state) {
    GivingWay way(state);
    way.forgetVain();
    way.forgetLimited();
}

}  // namespace sulfur::detail
