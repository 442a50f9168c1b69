// What a driver squeezes against something that cannot give way is not pressed ever harder.
//
// Impulses are kept from step to step, because loads change slowly. Between a driver and a wall no
// impulse does: both rows would add to theirs without end, and whoever slips out would be thrown by
// what the one of them has gathered. So bodies on which a driver still closes in when a step has
// been solved begin the next one without impulses, if its load goes through them to something else
// that nothing pushes.
//
// Nor does a blow go on, or what has lost its balance. A light crate between a heavy one and the
// ground is pressed with a thousand times its weight from both sides; when one of these normals
// turns to another side, what is left over would throw it, faster than sweeps can mend. So nobody
// begins a step thrown: of whom forces and rows' beginnings would change wildly, rows keep so much
// less, and so do those of whom that would throw in its turn.
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "contacts/row_pushes.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// What carries so much of the load stands in the way.
constexpr Real loadShare = Real(tuned::loadShare);

class GivingWay {
public:
    explicit GivingWay(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          vain_(slowSpeedsOf(state.settings).vain * state.h),
          wild_(slowSpeedsOf(state.settings).wild * state.h),
          pressed_(&state.arena),
          isPressed_(&state.arena),
          losers_(&state.arena) {}

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

    /// `answer`: trees and networks do, to what has not been given yet. A mover loses only once.
    void forgetWild(void (*answer)(State&)) {
        std::pmr::vector<std::uint8_t> hasLost(movers_.size(), 0, &state_.arena);
        losers_.assign(core_.awakeMovers.begin(), core_.awakeMovers.end());
        std::pmr::vector<Thrown> thrown(&state_.arena);
        while (true) {
            thrown.clear();
            for (const auto m : losers_)
                if (const Real share = keepsOf(m); share < 1 && hasLost[m] == 0)
                    thrown.push_back({m, share});
            losers_.clear();
            if (thrown.empty()) return;
            for (const Thrown& t : thrown) hasLost[t.mover] = 1;
            loseOf(thrown);
            std::sort(losers_.begin(), losers_.end());
            losers_.erase(std::unique(losers_.begin(), losers_.end()), losers_.end());
            answer(state_);
        }
    }

private:
    /// A mover that would be thrown, and which share its rows keep.
    struct Thrown {
        std::uint32_t mover;
        Real share;
    };
    /// A row that keeps the share of one of them.
    struct Kept {
        std::uint32_t place;  // of the mover among the thrown ones
        std::uint32_t order;  // in which it was found
        std::variant<ManifoldBlock*, TouchBlock*> block;
        std::uint32_t lane;
    };

    /// Which share rows keep of their impulses on a mover, so that these change its way since the
    /// last step by no more than is wild. Of rigid components, and of particles that links hold:
    /// what else is soft gives way by itself.
    Real keepsOf(std::uint32_t m) const {
        const SolverBody& body = movers_.bodies[m];
        const Real reach = movers_.reach[m], around = reach * body.spin;
        const Real gives = body.vx * body.vx + (body.vy * body.vy + around * around);
        if (!(gives > wild_ * wild_)) return 1;
        const auto dense = core_.denseOfMover[m];
        if (m >= core_.ways.size() || dense == none) return 1;
        if (core_.moverIsCluster[m] == 0 && state_.trees.ofParticle[dense] == none) return 1;
        const Prediction& p = movers_.predictions[m];
        const BodyWay& before = core_.ways[m];
        const Real turns = reach * (p.spin + body.spin - before.turn);
        const Real changes = body.vx * (p.vx + body.vx - before.x) +
                             (body.vy * (p.vy + body.vy - before.y) + around * turns);
        const Real given = std::sqrt(gives);
        return 1 - std::clamp<Real>((changes / given - wild_) / given, 0, 1);
    }

    /// Movers of one body stand together, and its rows are looked at once for all of them.
    void loseOf(const std::pmr::vector<Thrown>& all) {
        std::pmr::vector<std::uint32_t> placeOf(movers_.body.size(), none, &state_.arena);
        for (std::uint32_t k = 0; k < all.size(); ++k) placeOf[all[k].mover] = k;
        std::pmr::vector<Kept> kept(&state_.arena);
        for (std::uint32_t from = 0, to = 0; from < all.size(); from = to) {
            const auto body = movers_.body[all[from].mover];
            while (to < all.size() && movers_.body[all[to].mover] == body) ++to;
            kept.clear();
            if (body == none) continue;
            forEachRow(core_, body, [&](auto& block, std::uint32_t lane) {
                const auto first = static_cast<std::ptrdiff_t>(kept.size());
                const auto isNoted = [&](std::uint32_t place) {
                    return std::any_of(kept.begin() + first, kept.end(),
                                       [&](const Kept& k) { return k.place == place; });
                };
                forEachPush(block, lane, [&](std::uint32_t who, const Vec2&, Real) {
                    const auto place = placeOf[who];
                    const auto order = static_cast<std::uint32_t>(kept.size());
                    if (place != none && place >= from && place < to && !isNoted(place))
                        kept.push_back({place, order, &block, lane});
                });
            });
            // A stable sort would ask for memory.
            std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
                return std::pair(a.place, a.order) < std::pair(b.place, b.order);
            });
            for (const Kept& k : kept)
                std::visit([&](auto* block) { keep(*block, k.lane, all[k.place].share); }, k.block);
        }
    }

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
            forEachRow(core_, pressed_[k],
                       [&](auto& other, std::uint32_t l) { keep(other, l, 0); });
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

    /// A row begins the next step with a share of what it gives.
    template <class Block>
    void keep(Block& block, std::uint32_t lane, Real share) {
        const Real gone = 1 - share;
        forEachPush(block, lane, [&](std::uint32_t m, const Vec2& push, Real twist) {
            SolverBody& body = movers_.bodies[m];
            body.vx -= gone * push[0] * body.inverseMass;
            body.vy -= gone * push[1] * body.inverseMass;
            body.spin -= gone * twist * body.inverseInertia;
            if (body.inverseMass > 0) losers_.push_back(m);
        });
        keepImpulses(block, lane, share);
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    Real vain_;  // m: a driver that closes in by more in a step has pressed in vain
    Real wild_;  // m: whom a step's begin changes by more is thrown
    std::pmr::vector<std::uint32_t> pressed_;   // bodies, slots
    std::pmr::vector<std::uint8_t> isPressed_;  // by slot of a body
    std::pmr::vector<std::uint32_t> losers_;    // movers whose rows have lost something
};

}  // namespace

void forgetVain(State& state) {
    GivingWay(state).forgetVain();
}

void forgetWild(State& state, void (*answer)(State&)) {
    GivingWay(state).forgetWild(answer);
}

}  // namespace sulfur::detail
