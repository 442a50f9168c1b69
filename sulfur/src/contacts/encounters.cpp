#include "contacts/encounters.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "contacts/stages.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"

namespace sulfur::detail {

namespace {

std::size_t bucketOf(const ContactCore& core, BodyId a, BodyId b) {
    std::uint64_t h = (std::uint64_t{a.index} << 32 | b.index) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
    return static_cast<std::size_t>(h) & (core.buckets.size() - 1);
}

void growBuckets(ContactCore& core) {
    core.buckets.assign(std::max<std::size_t>(64, 2 * core.buckets.size()), none);
    for (std::uint32_t e = 0; e < core.encounters.size(); ++e) {
        Encounter& encounter = core.encounters[e];
        if (!encounter.a) continue;
        auto& bucket = core.buckets[bucketOf(core, encounter.a, encounter.b)];
        encounter.nextInBucket = std::exchange(bucket, e);
    }
}

std::uint32_t findEncounter(ContactCore& core, BodyId a, BodyId b) {
    if (core.encounters.size() >= core.buckets.size()) growBuckets(core);
    auto& bucket = core.buckets[bucketOf(core, a, b)];
    for (auto e = bucket; e != none; e = core.encounters[e].nextInBucket)
        if (core.encounters[e].a == a && core.encounters[e].b == b) return e;
    std::uint32_t slot;
    if (core.freeEncounters.empty()) {
        slot = static_cast<std::uint32_t>(core.encounters.size());
        core.encounters.emplace_back();
    } else {
        slot = core.freeEncounters.back();
        core.freeEncounters.pop_back();
    }
    Encounter& encounter = core.encounters[slot] = {};
    encounter.a = a;
    encounter.b = b;
    encounter.nextInBucket = std::exchange(bucket, slot);
    return slot;
}

void freeEncounter(ContactCore& core, std::uint32_t e) {
    const Encounter& encounter = core.encounters[e];
    auto* link = &core.buckets[bucketOf(core, encounter.a, encounter.b)];
    while (*link != e) link = &core.encounters[*link].nextInBucket;
    *link = encounter.nextInBucket;
    core.encounters[e] = {};
    core.freeEncounters.push_back(e);
}

void noteChange(ContactCore& core, std::uint32_t e) {
    Encounter& encounter = core.encounters[e];
    if (std::exchange(encounter.changed, 1) != 0) return;
    encounter.touched = encounter.touching;
    core.changedEncounters.push_back(e);
}

/// Whether two bodies that come near each other collide.
bool shouldCollide(State& state, const Encounter& encounter) {
    Callbacks& callbacks = state.callbacks;
    if (!callbacks.shouldCollide || encounter.a == encounter.b) return true;
    bool answer = true;
    callbacks.ask([&] { answer = callbacks.shouldCollide(encounter.a, encounter.b); });
    return answer;
}

/// Of two bodies, or null where they are not near each other.
const Encounter* encounterOf(const ContactCore& core, BodyId a, BodyId b) {
    if (core.buckets.empty()) return nullptr;
    const BodyPair pair = BodyPair::of(a, b);
    for (auto e = core.buckets[bucketOf(core, pair.a, pair.b)]; e != none;
         e = core.encounters[e].nextInBucket)
        if (core.encounters[e].a == pair.a && core.encounters[e].b == pair.b)
            return &core.encounters[e];
    return nullptr;
}

}  // namespace

bool areTouching(const ContactCore& core, BodyId a, BodyId b) {
    const Encounter* encounter = encounterOf(core, a, b);
    return encounter && encounter->touching != 0;
}

bool passThrough(const ContactCore& core, BodyId a, BodyId b) {
    const Encounter* encounter = encounterOf(core, a, b);
    return encounter && encounter->rowless == Encounter::letPass;
}

void enterEncounter(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    Pair& pair = core.pairs[index];
    const auto idOf = [&](std::uint32_t chunk) {
        return state.bodies[state.bodySlots.denseOf(core.shapes.chunks[chunk].body)].id;
    };
    const BodyPair bodies = BodyPair::of(idOf(pair.a), idOf(pair.b));
    pair.encounter = findEncounter(core, bodies.a, bodies.b);
    Encounter& encounter = core.encounters[pair.encounter];
    auto& first = encounter.firstPair;
    if (first == none) {
        if (encounter.rowless == Encounter::letPass) encounter.rowless = 0;
        if (!shouldCollide(state, encounter)) encounter.rowless = Encounter::letPass;
    }
    pair.nextOfEncounter = first;
    if (first != none) core.pairs[first].previousOfEncounter = index;
    first = index;
}

void leaveEncounter(ContactCore& core, std::uint32_t index) {
    const Pair pair = core.pairs[index];
    Encounter& encounter = core.encounters[pair.encounter];
    if (pair.previousOfEncounter != none)
        core.pairs[pair.previousOfEncounter].nextOfEncounter = pair.nextOfEncounter;
    else
        encounter.firstPair = pair.nextOfEncounter;
    if (pair.nextOfEncounter != none)
        core.pairs[pair.nextOfEncounter].previousOfEncounter = pair.previousOfEncounter;
    if (encounter.firstPair == none) noteChange(core, pair.encounter);
}

void addPressing(ContactCore& core, std::uint32_t e, int more) {
    core.encounters[e].pressing += static_cast<std::uint32_t>(more);
    noteChange(core, e);
}

void noteStruck(ContactCore& core, std::uint32_t e) {
    if (std::exchange(core.encounters[e].struck, 1) != 0) return;
    core.struckEncounters.push_back(e);
    noteChange(core, e);
}

void forgetStruck(ContactCore& core) {
    for (const auto e : core.struckEncounters) {
        if (core.encounters[e].struck == 0) continue;  // its place is another's now
        core.encounters[e].struck = 0;
        noteChange(core, e);
    }
    core.struckEncounters.clear();
}

namespace {

/// What all rows of an encounter do together.
struct Push {
    Real impulse = 0, most = -1;  // N s: of all, of the strongest
    Real speed = 0;               // m/s
    Vec2 normal{0, 0};            // from b towards a
    BodyId a, b;
    Point point{0, 0};
};

/// What begins and what ends is told of a whole tick, whose steps it follows: who touches before
/// and after has neither begun nor ended, and impulses add up.
class Teller {
public:
    explicit Teller(State& state) : state_(state), core_(state.core), events_(state.events) {}

    void run() {
        notePressing(
            core_.rows.manifolds, rowKernels().pressingManifolds,
            [](const ManifoldShape& shape, std::uint32_t lane) { return shape.pair[lane]; });
        notePressing(core_.rows.touches, rowKernels().pressingTouches,
                     [&](const TouchShape& shape, std::uint32_t lane) {
                         return core_.touches[shape.touch[lane]].pair;
                     });
        for (const auto e : core_.changedEncounters) follow(core_.encounters[e]);
        const bool last = state_.stepsLeft == 1;
        if (state_.settings.tellPersisting) followPersisting(last);
        if (last) endTick();
    }

private:
    template <class Lists, class Kernel, class PairOf>
    void notePressing(Lists& lists, Kernel&& kernel, PairOf&& pairOf) {
        for (const auto c : core_.rows.inUse()) {
            auto& list = lists[c];
            for (std::size_t k = 0; k < list.blocks.size(); ++k) {
                const std::uint32_t now = kernel(list.blocks[k]);
                for (auto set = now ^ list.pressing[k]; set != 0; set &= set - 1) {
                    const auto lane = static_cast<std::uint32_t>(std::countr_zero(set));
                    const bool presses = (now >> lane & 1) != 0;
                    const auto pair = pairOf(list.shapes[k], lane);
                    addPressing(core_, core_.pairs[pair].encounter, presses ? 1 : -1);
                }
                list.pressing[k] = static_cast<std::uint8_t>(now);
            }
        }
    }

    void follow(Encounter& encounter) {
        encounter.touching = encounter.pressing > 0 || encounter.struck != 0 ? 1 : 0;
        if (encounter.touching == 0 || encounter.touched == 1) return;
        const Push p = pushOf(encounter);
        if (encounter.begun != none) {
            events_.contactsBegun[encounter.begun].impulse += p.impulse;
            return;
        }
        encounter.begun = static_cast<std::uint32_t>(events_.contactsBegun.size());
        events_.contactsBegun.push_back(
            {p.a, p.b, p.point, p.normal, std::max<Real>(p.speed, 0), p.impulse});
    }

    void followPersisting(bool last) {
        auto& impulses = core_.impulses;
        impulses.resize(core_.encounters.size(), 0);
        for (std::uint32_t e = 0; e < core_.encounters.size(); ++e) {
            const Encounter& encounter = core_.encounters[e];
            if (encounter.touching == 1 && encounter.begun == none) {
                const Push p = pushOf(encounter);
                impulses[e] += p.impulse;
                if (last && p.most >= 0)  // not of sleepers
                    events_.contactsPersisted.push_back({p.a, p.b, p.point, p.normal, impulses[e]});
            }
            if (last) impulses[e] = 0;
        }
        if (last) sort(events_.contactsPersisted);
    }

    void endTick() {
        const auto isGone = [&](const auto& e) {
            return !state_.bodySlots.contains(e.a) || !state_.bodySlots.contains(e.b);
        };
        for (const auto e : core_.changedEncounters) {
            Encounter& encounter = core_.encounters[e];
            // Who came and is gone has never been told of.
            if (encounter.touching == 0 &&
                (encounter.touched == 1 || (encounter.begun != none && !isGone(encounter))))
                events_.contactsEnded.push_back({encounter.a, encounter.b});
            encounter.changed = 0;
            encounter.begun = none;
            if (encounter.firstPair == none) freeEncounter(core_, e);
        }
        core_.changedEncounters.clear();
        std::erase_if(events_.contactsBegun, isGone);
        sort(events_.contactsBegun);
        sort(events_.contactsEnded);
    }

    template <class Event>
    static void sort(std::vector<Event>& events) {
        std::sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
            return BodyPair::of(x.a, x.b) < BodyPair::of(y.a, y.b);
        });
    }

    Push pushOf(const Encounter& encounter) const {
        Push push;
        for (auto index = encounter.firstPair; index != none;
             index = core_.pairs[index].nextOfEncounter) {
            const Pair& pair = core_.pairs[index];
            if (pair.row) addManifold(pair, push);
            for (auto t = pair.firstTouch; t != none; t = core_.touches[t].next)
                if (core_.touches[t].row) addTouch(core_.touches[t], push);
            push.impulse += pair.blow;
            push.speed = std::max(push.speed, pair.approach);
        }
        return push;
    }
    void addManifold(const Pair& pair, Push& push) const {
        const ManifoldBlock& block = core_.rows.manifold(pair.row);
        const ManifoldShape& shape = core_.rows.manifoldShape(pair.row);
        const auto lane = RowGraph::laneOf(pair.row);
        for (std::size_t k = 0; k < 2; ++k) {
            const ManifoldPoint& p = block.points[k];
            if (pair.features[k][0] == none) continue;
            add(push, p.pressing[lane], p.closing[lane], pair.features[k][0], pair.features[k][1],
                shape.features[k].owner[lane] * Vec2(p.normalX[lane], p.normalY[lane]));
        }
    }
    void addTouch(const Touch& touch, Push& push) const {
        const TouchBlock& t = core_.rows.touch(touch.row);
        const auto lane = RowGraph::laneOf(touch.row);
        add(push, t.pressing[lane], t.closing[lane], core_.shapes.corners[touch.corner].particle,
            core_.shapes.corners[core_.shapes.sides[touch.side].a].particle,
            Vec2(t.normalX[lane], t.normalY[lane]));
    }
    void add(Push& push, Real pressing, Real closing, std::uint32_t corner, std::uint32_t side,
             const Vec2& normal) const {
        const Real impulse = pressing / state_.h;
        push.impulse += impulse;
        if (impulse <= push.most) return;
        const Particles& p = state_.particles;
        const auto i = state_.particleSlots.denseOf(corner), j = state_.particleSlots.denseOf(side);
        if (i == none || j == none) return;  // it broke away in this step
        push.most = impulse;
        push.speed = std::max(push.speed, -closing / state_.h);
        push.normal = normal;
        push.a = state_.bodies[p.body[i]].id;
        push.b = state_.bodies[p.body[j]].id;
        push.point = placeNow(state_, i) - (p.reach[i] * normal).cast<double>();
    }

    State& state_;
    ContactCore& core_;
    Events& events_;
};

}  // namespace

void tellContacts(State& state) {
    Teller(state).run();
}

}  // namespace sulfur::detail
