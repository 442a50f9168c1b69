// Impacts with restitution, before the rows are swept.
//
// Pairs that close in this step faster than what lies strike one after the other until none does:
// so a row of balls passes a blow on, as Newton's cradle shows. Each impact is that of two bodies:
// the impulses of its points are those of a plastic impact times 1 + e, which by Newton's law loses
// the share 1 - e^2 of the energy that the plastic one would, and so never gains any. A blow acts
// from its moment within the step on: what the bodies would have gone before is taken off their
// places.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory_resource>
#include <optional>
#include <utility>

#include "contacts/blows.hpp"
#include "contacts/encounters.hpp"
#include "contacts/looks.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

constexpr int mostRounds = tuned::impactRounds, plasticSweeps = tuned::plasticSweeps;

/// What one direction of a contact has to do with up to three bodies.
struct Strike {
    std::array<std::uint32_t, 3> body{0, 0, 0};
    std::array<Vec2, 3> linear{Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)};
    std::array<Real, 3> angular{0, 0, 0};
    Real mass = 0;   // kg, effective
    Real gap = 0;    // m, at the start of the step
    Real falls = 0;  // m per step and step, by which gravity makes the gap grow faster
};

/// The points of one pair, with their tangents.
struct Meeting {
    std::array<Strike, 2> normal, tangent;
    std::array<Knock, 2> knock;             // what it is about, without impulses
    std::array<std::size_t, 2> side{1, 1};  // of each point: whose surface it is, of its bodies
    int points = 0;
    std::uint32_t asked = 0;  // how many blows there had been when it was last asked
    Real restitution = 0, staticFriction = 0, kineticFriction = 0;
    std::uint32_t pair = none;
};

class Striker {
public:
    explicit Striker(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          h_(state.h),
          slow_(slowSpeedsOf(state.settings).rebound * h_),
          meetings_(&state.arena),
          due_(&state.arena),
          struck_(&state.arena),
          squashed_(&state.arena) {}

    void run() {
        collect();
        if (meetings_.empty()) return;
        struck_.assign(movers_.size(), {});
        bool any = true;
        std::size_t asked = 0;
        const std::size_t most =
            tuned::askedMeetings * (core_.awakeMovers.size() + tuned::fewMovers);
        for (int round = 0; round < mostRounds && any && asked < most; ++round) {
            any = false;
            orderByMoment();
            asked += due_.size();
            for (const Due& due : due_) any |= strike(meetings_[due.meeting]);
        }
        std::sort(core_.blows.begin(), core_.blows.end(),
                  [](const Blow& a, const Blow& b) { return a.mover < b.mover; });
    }

private:
    /// Whether one of its bodies was struck since it was last asked.
    bool isToAsk(Meeting& m) const {
        const auto asked = std::exchange(m.asked, blows_);
        return std::any_of(m.normal[0].body.begin(), m.normal[0].body.end(),
                           [&](std::uint32_t body) { return struck_[body].last > asked; });
    }

    /// Lists who is to be asked, and first who comes to touch first.
    void orderByMoment() {
        due_.clear();
        for (std::uint32_t i = 0; i < meetings_.size(); ++i)
            if (isToAsk(meetings_[i])) due_.push_back({momentOf(meetings_[i]), i});
        std::sort(due_.begin(), due_.end(), [](const Due& a, const Due& b) {
            return std::pair(a.moment, a.meeting) < std::pair(b.moment, b.meeting);
        });
    }
    /// Share of the step after which the first point of a meeting touches; 1 if none does.
    Real momentOf(const Meeting& m) const {
        Real first = 1;
        for (int k = 0; k < m.points; ++k) {
            const Strike& normal = m.normal[static_cast<std::size_t>(k)];
            if (const Real closing = motion(normal); closing < 0)
                first = std::min(first, momentOf(normal, closing));
        }
        return first;
    }
    /// The velocity of a step stands in its middle; the blow comes when the gap is closed.
    static Real momentOf(const Strike& normal, Real closing) {
        return std::clamp<Real>(std::max<Real>(normal.gap, 0) / -closing, 0, 1);
    }

    /// All rows that rebound, because a blow may go through them, and those of others that come to
    /// touch in this step.
    void collect() {
        const RowKernels& kernels = rowKernels();
        const bool anyBounces = core_.bouncingPairs > 0 || core_.answersBounce;
        if (anyBounces) noteSquashed();
        const Real fall = largestGravityScale() * state_.settings.gravity.norm();
        const Real slow = slow_ + h_ * h_ * fall;
        if (!anyBounces && 2 * core_.farthest < slow) return;
        const auto look = [&](auto& list, std::uint32_t c, auto&& kernel, auto&& pairOf,
                              auto&& add) {
            for (std::size_t k = 0; k < list.blocks.size(); ++k) {
                std::uint32_t lanes =
                    kernel(movers_.bodies.data(), movers_.predictions.data(), list.blocks[k], slow);
                const auto rows = std::min(RowGraph::rowsIn(list, c, k), std::uint32_t{rowLanes});
                for (std::uint32_t lane = 0; anyBounces && lane < rows; ++lane)
                    if (core_.pairs[pairOf(list.shapes[k], lane)].restitution > 0)
                        lanes |= 1u << lane;
                for (; lanes != 0; lanes &= lanes - 1) {
                    const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
                    const auto first = static_cast<std::uint32_t>(k);
                    const RowPlace place{c, c == RowGraph::overflow ? first
                                                                    : static_cast<std::uint32_t>(
                                                                          first * rowLanes + lane)};
                    add(place, pairOf(list.shapes[k], lane));
                }
            }
        };
        for (const auto c : core_.rows.inUse()) {
            look(
                core_.rows.manifolds[c], c, kernels.meetingManifolds,
                [](const ManifoldShape& s, std::uint32_t lane) { return s.pair[lane]; },
                [&](RowPlace place, std::uint32_t pair) { addManifold(place, pair); });
            look(
                core_.rows.touches[c], c, kernels.meetingTouches,
                [&](const TouchShape& s, std::uint32_t lane) {
                    return core_.touches[s.touch[lane]].pair;
                },
                [&](RowPlace place, std::uint32_t pair) { addTouch(place, pair); });
        }
    }

    /// What is pressed flat does not bounce: its triangles push with what sweeps leave of an error,
    /// and a rebound from that would be energy from nothing.
    void noteSquashed() {
        if (state_.triangles.pressed.empty()) return;
        squashed_.assign(state_.particles.size(), 0);
        for (const PressedTriangle& t : state_.triangles.pressed)
            for (const Grip& corner : t.corners) squashed_[corner.particle] = 1;
    }
    bool isSquashed(std::uint32_t corner) const {
        if (squashed_.empty()) return false;
        return squashed_[state_.particleSlots.denseOf(core_.shapes.corners[corner].particle)] != 0;
    }

    void addManifold(RowPlace place, std::uint32_t pair) {
        const ManifoldBlock& block = core_.rows.manifold(place);
        const auto l = RowGraph::laneOf(place);
        Meeting m;
        m.pair = pair;
        m.restitution = core_.pairs[pair].restitution;
        m.staticFriction = block.staticFriction[l];
        m.kineticFriction = block.kineticFriction[l];
        const auto strikeOf = [&](Real x, Real y, Real armA, Real armB) {
            Strike s;
            s.body = {block.b[l], block.a[l], 0};
            s.linear = {Vec2(x, y), Vec2(-x, -y), Vec2(0, 0)};
            s.angular = {armB, -armA, 0};
            return weighed(s);
        };
        for (const ManifoldPoint& p : block.points) {
            if (!(p.normalMass[l] > 0)) continue;
            Strike s = strikeOf(p.normalX[l], p.normalY[l], p.normalArmA[l], p.normalArmB[l]);
            s.gap = gapNow(s, p.gap[l]);
            const auto k = static_cast<std::size_t>(&p - block.points);
            const Real owner = core_.rows.manifoldShape(place).features[k].owner[l];
            m.knock[static_cast<std::size_t>(m.points)] = {
                core_.pairs[pair].features[k], owner * Vec2(p.normalX[l], p.normalY[l]), 0, 0};
            m.side[static_cast<std::size_t>(m.points)] = owner > 0 ? 1 : 0;
            m.normal[static_cast<std::size_t>(m.points)] = s;
            m.tangent[static_cast<std::size_t>(m.points)] = strikeOf(
                block.tangentX[l], block.tangentY[l], block.tangentArmA[l], block.tangentArmB[l]);
            ++m.points;
        }
        if (m.points > 0) meetings_.push_back(m);
    }

    void addTouch(RowPlace place, std::uint32_t pair) {
        const TouchBlock& t = core_.rows.touch(place);
        const auto l = RowGraph::laneOf(place);
        const Touch& touch = core_.touches[core_.rows.touchShape(place).touch[l]];
        if (!(t.normalMass[l] > 0)) return;
        Meeting m;
        m.pair = pair;
        m.points = 1;
        const Side& side = core_.shapes.sides[touch.side];
        if (!isSquashed(touch.corner) && !isSquashed(side.a) && !isSquashed(side.b))
            m.restitution = core_.pairs[pair].restitution;
        m.staticFriction = t.staticFriction[l];
        m.kineticFriction = t.kineticFriction[l];
        const Vec2 n(t.normalX[l], t.normalY[l]), tangent(-n[1], n[0]);
        m.knock[0] = {particlesOf(core_.shapes, touch.corner, touch.side), n, 0, 0};
        const Vec2 along(t.sideX[l], t.sideY[l]), rod = t.rod[l] * along, lean = t.lean[l] * along;
        Strike& s = m.normal[0];
        s.body = {t.p[l], t.a[l], t.b[l]};
        s.linear = {n, -t.weightA[l] * n + lean, -t.weightB[l] * n - lean};
        s.angular = {t.normalArmP[l], -t.normalArmA[l], -t.normalArmB[l]};
        s = weighed(s);
        s.gap = gapNow(s, t.gap[l]);
        Strike& r = m.tangent[0];
        r.body = s.body;
        r.linear = {tangent, -t.weightA[l] * tangent + rod, -t.weightB[l] * tangent - rod};
        r.angular = {t.tangentArmP[l], -t.tangentArmA[l], -t.tangentArmB[l]};
        r = weighed(r);
        if (movers_.bodies[t.a[l]].inverseInertia == 0) m.side[0] = 0;
        meetings_.push_back(m);
    }

    Strike weighed(Strike s) const {
        Real mobility = 0;
        for (std::size_t k = 0; k < 3; ++k)
            mobility += movers_.bodies[s.body[k]].inverseMass * s.linear[k].squaredNorm() +
                        movers_.bodies[s.body[k]].inverseInertia * s.angular[k] * s.angular[k];
        s.mass = mobility > 0 ? 1 / mobility : 0;
        s.falls = 0;
        const Vec2 fall = h_ * h_ * state_.settings.gravity;
        for (std::size_t k = 0; k < 3; ++k)
            if (movers_.bodies[s.body[k]].inverseMass > 0)
                s.falls += gravityScaleOf(state_, s.body[k]) * s.linear[k].dot(fall);
        return s;
    }
    /// Weight alone is no blow to anybody.
    Real largestGravityScale() const {
        Real most = 1;
        if (!state_.gravityScaled) return most;
        for (const auto body : state_.work.bodies)
            most = std::max(most, std::abs(state_.bodies[body].gravityScale));
        return most;
    }
    Real gapNow(const Strike& s, Real gap) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const SolverBody& b = movers_.bodies[s.body[k]];
            gap += s.linear[k].dot(Vec2(b.x, b.y)) + s.angular[k] * b.turn;
        }
        return gap;
    }
    /// m, along the direction in this step, with what rows begin with.
    Real motion(const Strike& s) const {
        Real sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const SolverBody& b = movers_.bodies[s.body[k]];
            const Prediction& p = movers_.predictions[s.body[k]];
            sum +=
                s.linear[k].dot(Vec2(p.vx + b.vx, p.vy + b.vy)) + s.angular[k] * (p.spin + b.spin);
        }
        return sum;
    }

    bool isAlone(std::uint32_t m) {
        auto& alone = struck_[m].alone;
        if (!alone) alone = movesAlone(state_, m);
        return *alone;
    }

    /// Rows turn as from the start of the step. Who goes on freely until the blow is struck where
    /// he is then.
    Strike atMoment(Strike s, std::size_t side, Real when) {
        for (std::size_t k = 0; k < 2; ++k)
            if (movers_.bodies[s.body[k]].inverseMass == 0) return s;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto m = s.body[k];
            if (movers_.bodies[m].inverseMass == 0 || !isAlone(m)) continue;
            const Motion3 way = motionNow(movers_, m);
            const auto blow = struck_[m].blow;
            const Motion3 late = blow != none ? core_.blows[blow].late : Motion3{};
            const Vec2 gone(when * way.x - late.x, when * way.y - late.y);
            s.angular[side] -= cross(gone, s.linear[k]);
        }
        return weighed(s);
    }

    void push(const Strike& s, Real impulse, Real before) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto m = s.body[k];
            const SolverBody& b = movers_.bodies[m];
            if (b.inverseMass == 0 && b.inverseInertia == 0) continue;
            const Vec2 v = b.inverseMass * impulse * s.linear[k];
            const Real w = b.inverseInertia * impulse * s.angular[k];
            Prediction& p = movers_.predictions[m];
            p.vx += v[0];
            p.vy += v[1];
            p.spin += w;
            const Motion3 late{before * v[0], before * v[1], before * w};
            Blow& blow = blowOf(m);
            blow.velocity += v;
            blow.spin += w;
            blow.late = sumOf(blow.late, late);
            struck_[m].moment = std::max(struck_[m].moment, before);
            struck_[m].last = blows_;
        }
    }

    /// What strikes one mover in a step is one blow.
    Blow& blowOf(std::uint32_t m) {
        auto& blow = struck_[m].blow;
        if (blow == none) {
            blow = static_cast<std::uint32_t>(core_.blows.size());
            core_.blows.emplace_back().mover = m;
        }
        return core_.blows[blow];
    }

    static Motion3 sumOf(const Motion3& a, const Motion3& b) {
        return {a.x + b.x, a.y + b.y, a.turn + b.turn};
    }

    /// Strikes if it closes. Returns whether it did.
    bool strike(const Meeting& m) {
        std::array<Real, 2> closing{0, 0}, when{0, 0};
        std::array<Strike, 2> normal = m.normal, tangent = m.tangent;
        bool any = false;
        for (int k = 0; k < m.points; ++k) {
            const auto i = static_cast<std::size_t>(k);
            closing[i] = motion(m.normal[i]);
            any |= closing[i] < -slow_ && m.normal[i].gap + closing[i] < 0;
        }
        if (!any) return false;
        ++blows_;
        for (int k = 0; k < m.points; ++k) {
            const auto i = static_cast<std::size_t>(k);
            if (!(closing[i] < 0)) continue;
            when[i] = momentOf(m.normal[i], closing[i]);
            // A blow that goes on through somebody does so when it has come to him.
            for (const auto body : m.normal[i].body)
                when[i] = std::max(when[i], struck_[body].moment);
            normal[i] = atMoment(normal[i], m.side[i], when[i]);
            tangent[i] = atMoment(tangent[i], m.side[i], when[i]);
            closing[i] = motion(normal[i]) + normal[i].falls * (when[i] - Real(0.5));
        }
        // Both points rub as one, from when the last of them strikes.
        const auto closes = [&](std::size_t i) { return normal[i].gap + closing[i] < 0; };
        const std::size_t last =
            m.points == 2 && closes(1) && (!closes(0) || when[1] > when[0]) ? 1 : 0;
        const Strike& rubs = tangent[last];
        const Plastic plastic = plasticImpact(m, normal, closing, rubs, slideAt(rubs, when[last]));
        std::array<Real, 2> impulse{0, 0};
        for (int k = 0; k < m.points; ++k) {
            const auto i = static_cast<std::size_t>(k);
            impulse[i] = (1 + m.restitution) * plastic.normal[i];
            if (impulse[i] > 0) push(normal[i], impulse[i], when[i]);
        }
        const Real pressing = impulse[0] + impulse[1];
        if (!(pressing > 0)) return true;
        push(rubs, plastic.rubbing, when[last]);
        const Real wanted = plastic.rubbing - rubs.mass * slideAt(rubs, when[last]);
        const Real rubbing = rub(m, wanted, pressing);
        push(rubs, rubbing - plastic.rubbing, when[last]);
        for (int k = 0; k < m.points; ++k) {
            const auto i = static_cast<std::size_t>(k);
            if (!(impulse[i] > 0)) continue;
            core_.knocks.push_back(m.knock[i]);
            core_.knocks.back().pressing = impulse[i];
            core_.knocks.back().rubbing = rubbing * impulse[i] / pressing;
            core_.struck.push_back(m.pair);
            noteStruck(core_, core_.pairs[m.pair].encounter);
            core_.pairs[m.pair].blow += impulse[i] / h_;
            auto& approach = core_.pairs[m.pair].approach;
            approach = std::max(approach, -closing[i] / h_);
        }
        return true;
    }

    /// Impulses, kg m.
    struct Plastic {
        std::array<Real, 2> normal{0, 0};
        Real rubbing = 0;
    };

    /// What stops the points that close, and their slide as far as Coulomb's law lets it. Two
    /// points hold a face, which friction cannot turn; where one strikes alone, friction comes
    /// after it.
    Plastic plasticImpact(const Meeting& m, const std::array<Strike, 2>& normal,
                          const std::array<Real, 2>& closing, const Strike& rubs,
                          Real slide) const {
        Plastic found;
        const Real coupling = m.points == 2 ? response(normal[0], normal[1]) : 0;
        std::array<Real, 2> turns{0, 0};
        if (m.points == 2) turns = {response(normal[0], rubs), response(normal[1], rubs)};
        for (int sweep = 0; sweep < plasticSweeps; ++sweep) {
            const Plastic before = found;
            for (int k = 0; k < m.points; ++k) {
                const auto i = static_cast<std::size_t>(k);
                if (!(normal[i].gap + closing[i] < 0)) continue;
                const Real now =
                    closing[i] + coupling * found.normal[1 - i] + turns[i] * found.rubbing;
                found.normal[i] = std::max<Real>(-normal[i].mass * now, 0);
            }
            const Real now = slide + turns[0] * found.normal[0] + turns[1] * found.normal[1];
            found.rubbing = rub(m, -rubs.mass * now, found.normal[0] + found.normal[1]);
            if (found.normal == before.normal && found.rubbing == before.rubbing) break;
        }
        return found;
    }
    /// Coulomb's law.
    static Real rub(const Meeting& m, Real wanted, Real pressing) {
        const bool sticks = std::abs(wanted) <= m.staticFriction * pressing;
        const Real most = (sticks ? m.staticFriction : m.kineticFriction) * pressing;
        return std::clamp(wanted, -most, most);
    }
    /// m, by which the surfaces slide in a step, at a moment within it.
    Real slideAt(const Strike& tangent, Real when) const {
        return motion(tangent) + tangent.falls * (when - Real(0.5));
    }

    /// What an impulse along one direction does along the other.
    Real response(const Strike& one, const Strike& other) const {
        Real sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const SolverBody& b = movers_.bodies[one.body[k]];
            sum += b.inverseMass * one.linear[k].dot(other.linear[k]) +
                   b.inverseInertia * one.angular[k] * other.angular[k];
        }
        return sum;
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    Real h_;
    Real slow_;  // m: what closes by less in a step is no blow
    std::pmr::vector<Meeting> meetings_;
    struct Due {
        Real moment = 0;
        std::uint32_t meeting = 0;
    };
    std::pmr::vector<Due> due_;  // in this round
    std::uint32_t blows_ = 1;
    struct Struck {
        std::uint32_t blow = none;  // what has struck it so far, among core.blows
        std::uint32_t last = 1;     // the number of the last blow, or 1
        Real moment = 0;            // the latest of all, as a share of the step
        std::optional<bool> alone;  // whether it moves alone, once somebody has asked
    };
    std::pmr::vector<Struck> struck_;          // by mover
    std::pmr::vector<std::uint8_t> squashed_;  // by particle, dense; none where nothing is
};

}  // namespace

void strikeRows(State& state) {
    state.core.blows.clear();
    for (const auto pair : state.core.struck)
        state.core.pairs[pair].blow = state.core.pairs[pair].approach = 0;
    state.core.struck.clear();
    state.core.knocks.clear();
    forgetStruck(state.core);
    Striker(state).run();
    // Whoever was struck has it in the predicted motion; places follow when the step ends.
    for (Blow& blow : state.core.blows) {
        const Motion3 now = motionNow(state.core.movers, blow.mover);
        blow.before = {now.x - blow.velocity[0], now.y - blow.velocity[1], now.turn - blow.spin};
        const auto i = state.core.denseOfMover[blow.mover];
        if (state.core.moverIsCluster[blow.mover]) {
            Cluster& c = state.clusters.list[i];
            c.displacement += blow.velocity;
            c.angle += static_cast<double>(blow.spin);
            updateTurn(c);
        } else {
            state.particles.displacement[i] += blow.velocity;
        }
    }
}

}  // namespace sulfur::detail
