#include "solver/contact_rows.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "core/pieces.hpp"
#include "rigid/grip.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/contact_motion.hpp"
#include "solver/contact_recovery.hpp"

namespace sulfur::detail {

namespace {

/// What sweeps may leave. It does not add up: gaps and drifts are those of the places, and the next
/// tick takes back what this one has left.
constexpr Real mostErrorSpeed = Real(2e-5);  // m/s

/// What one sweep is not likely to make an end of: more than what recoveries disturb in a heap that
/// lies.
constexpr Real largeErrorSpeed = Real(5e-4);  // m/s

/// As a share of the thinnest contact.
constexpr Real deepError = Real(0.02);

constexpr unsigned mostColours = 64;
constexpr std::uint8_t noColourLeft = 0xff;

/// In a microsecond: blocks that are filled, solved or looked at; motions and multipliers that are
/// fetched or put back.
constexpr std::size_t filledInMicrosecond = 10, solvedInMicrosecond = 20, seenInMicrosecond = 64;
constexpr std::size_t motionsInMicrosecond = 200, multipliersInMicrosecond = 400;

/// rad: after a larger turn the series of the kernels is replaced by the exact sine.
constexpr Real exactBeyond = Real(0.05);

bool canBePushed(const Mover& m) {
    return m.mass != 0 || m.inertia != 0;
}

Real reciprocal(Real value) {
    return value > 0 ? 1 / value : 0;
}

/// Whether a mover is on both sides, so that a kernel would push two copies of it.
bool holdsTwice(const std::array<std::uint32_t, 3>& movers) {
    const auto [p, a, b] = movers;
    return (p != 0 && (p == a || p == b)) || (a != 0 && a == b);
}

Vec2 armOf(const Grip& grip) {
    return grip.cluster == none ? Vec2(0, 0) : grip.arm;
}

/// 1/kg: how a push along the normal moves along the tangent what is held `arm` away.
Real couplingOf(const Mover& mover, const Vec2& arm, const Vec2& normal) {
    return mover.inertia * cross(arm, normal) * cross(arm, perpendicular(normal));
}

/// Whether a part of a tree takes part: that is solved singly.
bool isOnTree(const State& state, const Contact& c) {
    const auto isIn = [&](const Grip& grip) {
        return state.trees.ofParticle[grip.particle] != none;
    };
    return isIn(c.gripOfParticle) || isIn(c.gripOfA) || (c.shareB != 0 && isIn(c.gripOfB));
}

/// Whether one more sweep would push by more than `most` m.
bool leavesError(const State& state, const Contact& c, Real most) {
    const Real w = c.inverseEffectiveMass, wt = c.tangentInverseMass;
    const Real along = std::max<Real>(c.normalLambda - gapLeft(state, c) / w, 0) - c.normalLambda;
    if (std::abs(along) * w > most) return true;
    if (wt == 0 || !c.rough) return false;
    const Real limit = frictionOf(c) * c.normalLambda;
    const Real across =
        std::clamp(c.tangentLambda - slipOf(state, c) / wt, -limit, limit) - c.tangentLambda;
    return std::abs(across) * wt > most;
}

}  // namespace

/// Of what the grip holds; the one that never moves for what does not.
std::uint32_t ContactRows::moverOf(const State& state, const Grip& grip) {
    const auto index = grip.cluster != none ? ofCluster_[grip.cluster] : ofParticle_[grip.particle];
    return index != none ? index : addMover(state, grip);
}

std::uint32_t ContactRows::addMover(const State& state, const Grip& grip) {
    const bool rigid = grip.cluster != none;
    auto& index = rigid ? ofCluster_[grip.cluster] : ofParticle_[grip.particle];
    Mover m;
    Vec2 displacement;
    if (rigid) {
        const Cluster& c = state.clusters.list[grip.cluster];
        m.mass = c.inverseMass;
        m.inertia = c.inverseInertia;
        m.sine = c.sine;
        displacement = c.displacement;
    } else {
        m.mass = state.particles.inverseMass[grip.particle];
        displacement = state.particles.displacement[grip.particle];
    }
    if (!canBePushed(m) && displacement.isZero(0) && m.sine == 0) return index = 0;
    index = static_cast<std::uint32_t>(movers_.size());
    movers_.push_back(m);
    owners_.push_back({grip.cluster, grip.particle});
    taken_.push_back(0);
    return index;
}

/// The first colour that none of the contact's movers has yet, if any is left.
void ContactRows::colourContact(const State& state, const Contact& c, Mark& mark) {
    mark.movers[0] = moverOf(state, c.gripOfParticle);
    mark.movers[1] = moverOf(state, c.gripOfA);
    if (mark.three) mark.movers[2] = moverOf(state, c.gripOfB);
    std::uint64_t taken = 0;
    for (const auto m : mark.movers) taken |= taken_[m];
    const auto colour = static_cast<unsigned>(std::countr_one(taken));
    if (colour >= mostColours || holdsTwice(mark.movers)) return;
    mark.colour = static_cast<std::uint8_t>(colour);
    for (const auto m : mark.movers)
        if (canBePushed(movers_[m])) taken_[m] |= std::uint64_t{1} << colour;
}

void ContactRows::colourContacts(const State& state) {
    single_.clear();
    marks_.clear();
    const bool allSingly = state.settings.friction != Friction::coulomb;
    const bool anyTrees = !state.trees.list.empty();
    for (std::uint32_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        Mark& mark = marks_.emplace_back(noColourLeft, c.shareB != 0);
        if (!allSingly && !(anyTrees && isOnTree(state, c))) colourContact(state, c, mark);
        if (mark.colour == noColourLeft) single_.push_back(i);
    }
}

Real ContactRows::couplingOf(const Contact& c, const Mark& mark) const {
    const auto of = [&](std::size_t k, const Grip& grip) {
        return detail::couplingOf(movers_[mark.movers[k]], armOf(grip), c.normal);
    };
    Real sum = of(0, c.gripOfParticle) + c.shareA * c.shareA * of(1, c.gripOfA);
    if (mark.three) sum += c.shareB * c.shareB * of(2, c.gripOfB);
    return sum;
}

void ContactRows::fill(const State& state, std::uint32_t contact, ContactBlock& block,
                       std::size_t lane) const {
    const Contact& c = state.contacts[contact];
    const Mark& mark = marks_[contact];
    const auto set = [lane](auto& list, auto value) { list[lane] = value; };
    set(block.particle, mark.movers[0]);
    set(block.a, mark.movers[1]);
    const Vec2 arm = armOf(c.gripOfParticle), armA = armOf(c.gripOfA);
    set(block.armX, arm[0]);
    set(block.armY, arm[1]);
    set(block.armAX, armA[0]);
    set(block.armAY, armA[1]);
    set(block.shareA, c.shareA);
    if (mark.three) {
        const Vec2 armB = armOf(c.gripOfB);
        set(block.b, mark.movers[2]);
        set(block.armBX, armB[0]);
        set(block.armBY, armB[1]);
        set(block.shareB, c.shareB);
    }
    set(block.normalX, c.normal[0]);
    set(block.normalY, c.normal[1]);
    set(block.start, std::max<Real>(c.gap - c.slack, 0) - c.rise);
    set(block.deepest, deepestOf(c));
    set(block.conveyed, c.conveyed);
    set(block.normalMass, reciprocal(c.inverseEffectiveMass));
    set(block.normalLambda, c.normalLambda);
    set(block.tangentLambda, c.tangentLambda);
    if (c.gap < 0 || standsOpen(c)) {
        set(block.wanted, recoveryOf(state, c));
        block.recovers = 1;
    }
    if (c.drift != 0 && c.tangentInverseMass > 0) {
        set(block.driftLambda, -driftRecovered(state, c) / c.tangentInverseMass);
        block.drifts = 1;
    }
    if (c.staticFriction <= 0) return;
    set(block.tangentMass, reciprocal(c.tangentInverseMass));
    set(block.coupling, couplingOf(c, mark));
    set(block.friction, frictionOf(c));
}

void ContactRows::placeContacts(const State& state) {
    std::array<std::array<std::uint32_t, mostColours>, 2> next{};
    unsigned colours = 0;
    for (const Mark& mark : marks_) {
        if (mark.colour == noColourLeft) continue;
        ++next[mark.three][mark.colour];
        colours = std::max<unsigned>(colours, mark.colour + 1u);
    }
    colours_.assign(colours, {});
    std::uint32_t blocksOfTwo = 0, blocksOfThree = 0;
    const auto reserve = [](std::uint32_t& blocks, std::uint32_t& contacts) {
        const std::uint32_t first = blocks;
        blocks += (contacts + contactLanes - 1) / contactLanes;
        contacts = first * contactLanes;
        return first;
    };
    for (unsigned k = 0; k < colours; ++k) {
        colours_[k].firstTwo = reserve(blocksOfTwo, next[0][k]);
        colours_[k].lastTwo = blocksOfTwo;
        colours_[k].firstThree = reserve(blocksOfThree, next[1][k]);
        colours_[k].lastThree = blocksOfThree;
    }
    two_.resize(blocksOfTwo);
    three_.resize(blocksOfThree);
    contactsOfTwo_.assign(blocksOfTwo * contactLanes, none);
    contactsOfThree_.assign(blocksOfThree * contactLanes, none);
    for (std::uint32_t i = 0; i < marks_.size(); ++i) {
        const Mark& mark = marks_[i];
        if (mark.colour == noColourLeft) continue;
        (mark.three ? contactsOfThree_ : contactsOfTwo_)[next[mark.three][mark.colour]++] = i;
    }
    fillAll(state, contactsOfTwo_, two_);
    fillAll(state, contactsOfThree_, three_);
}

void ContactRows::fillAll(const State& state, const std::vector<std::uint32_t>& contacts,
                          Blocks& blocks) const {
    inPieces(state.tasks, blocks.size(), filledInMicrosecond,
             [&](std::size_t first, std::size_t last) {
                 for (auto k = first; k < last; ++k) {
                     blocks[k] = {};
                     for (std::size_t lane = 0; lane < contactLanes; ++lane) {
                         const auto i = contacts[k * contactLanes + lane];
                         if (i != none) fill(state, i, blocks[k], lane);
                     }
                 }
             });
}

void ContactRows::colour(const State& state) {
    tasks_ = state.tasks;
    movers_.assign(1, Mover{});
    owners_.assign(1, Owner{});
    taken_.assign(1, 0);
    if (!state.contacts.empty()) {
        ofCluster_.assign(state.clusters.list.size(), none);
        ofParticle_.assign(state.particles.size(), none);
    }
    colourContacts(state);
}

void ContactRows::collect(const State& state) {
    placeContacts(state);
}

/// Calls f(mover, its owner) for all that have one, in pieces.
template <class Function>
void ContactRows::forEachMover(Function&& f) {
    inPieces(tasks_, movers_.size(), motionsInMicrosecond,
             [&](std::size_t first, std::size_t last) {
                 for (auto i = std::max<std::size_t>(first, 1); i < last; ++i)
                     f(movers_[i], owners_[i]);
             });
}

void ContactRows::takeMotions(const State& state) {
    forEachMover([&](Mover& m, const Owner& owner) {
        m.turn = 0;
        if (owner.cluster == none) {
            const Vec2& d = state.particles.displacement[owner.particle];
            m.x = d[0];
            m.y = d[1];
            return;
        }
        const Cluster& c = state.clusters.list[owner.cluster];
        m.x = c.displacement[0];
        m.y = c.displacement[1];
        m.sine = c.sine;
        m.versine = c.versine;
    });
}

void ContactRows::giveMotions(State& state) {
    constexpr double most = 1e5;  // rad in a tick: as good as any larger one
    forEachMover([&](Mover& m, const Owner& owner) {
        if (!canBePushed(m)) return;
        if (owner.cluster == none) {
            state.particles.displacement[owner.particle] = Vec2(m.x, m.y);
            return;
        }
        Cluster& c = state.clusters.list[owner.cluster];
        c.displacement = Vec2(m.x, m.y);
        c.angle = std::clamp(c.angle + static_cast<double>(m.turn), -most, most);
        c.sine = m.sine;
        c.versine = m.versine;
        if (std::abs(m.turn) > exactBeyond) updateTurn(c);
        m.sine = c.sine;
        m.versine = c.versine;
        m.turn = 0;
    });
}

namespace {

/// Calls f(contact, its block, its lane there) for all contacts in blocks of a kind, in pieces.
template <class Contacts, class Blocks, class Function>
void forEachLane(Tasks* tasks, Contacts& contacts, const std::vector<std::uint32_t>& places,
                 Blocks& blocks, Function&& f) {
    inPieces(
        tasks, places.size(), multipliersInMicrosecond, [&](std::size_t first, std::size_t last) {
            for (auto lane = first; lane < last; ++lane)
                if (places[lane] != none)
                    f(contacts[places[lane]], blocks[lane / contactLanes], lane % contactLanes);
        });
}

}  // namespace

void ContactRows::takeMultipliers(const State& state) {
    const auto take = [](const Contact& c, ContactBlock& block, std::size_t lane) {
        block.normalLambda[lane] = c.normalLambda;
        block.tangentLambda[lane] = c.tangentLambda;
    };
    forEachLane(tasks_, state.contacts, contactsOfTwo_, two_, take);
    forEachLane(tasks_, state.contacts, contactsOfThree_, three_, take);
}

void ContactRows::giveMultipliers(State& state) const {
    const auto give = [](Contact& c, const ContactBlock& block, std::size_t lane) {
        c.normalLambda = block.normalLambda[lane];
        c.tangentLambda = block.tangentLambda[lane];
    };
    forEachLane(tasks_, state.contacts, contactsOfTwo_, two_, give);
    forEachLane(tasks_, state.contacts, contactsOfThree_, three_, give);
}

void ContactRows::sweepBlocks(ContactKernels::Sweep two, ContactKernels::Sweep three,
                              bool backwards) {
    const auto run = [&](ContactKernels::Sweep kernel, Blocks& blocks, std::size_t from,
                         std::size_t to) {
        inPieces(tasks_, to - from, solvedInMicrosecond, [&](std::size_t first, std::size_t last) {
            kernel(movers_.data(), blocks.data() + from + first, last - first);
        });
    };
    const auto solve = [&](const Colour& colour) {
        run(two, two_, colour.firstTwo, colour.lastTwo);
        run(three, three_, colour.firstThree, colour.lastThree);
    };
    if (backwards)
        std::for_each(colours_.rbegin(), colours_.rend(), solve);
    else
        std::for_each(colours_.begin(), colours_.end(), solve);
}

void ContactRows::sweep(bool backwards) {
    const ContactKernels& kernels = contactKernels();
    sweepBlocks(kernels.solveTwo, kernels.solveThree, !backwards);
    sweepBlocks(kernels.solveTwo, kernels.solveThree, backwards);
}

void ContactRows::warmStart(State& state) {
    const ContactKernels& kernels = contactKernels();
    takeMotions(state);
    sweepBlocks(kernels.warmTwo, kernels.warmThree, false);
    giveMotions(state);
    for (const auto i : single_) pushWithMultipliers(state, state.contacts[i]);
    if (!single_.empty()) takeMotions(state);
}

void ContactRows::takeShifts(const State& state) {
    forEachMover([&](Mover& m, const Owner& owner) {
        const bool rigid = owner.cluster != none;
        const Vec2& shift = rigid ? state.clusters.list[owner.cluster].shift
                                  : state.particles.shift[owner.particle];
        m.x = shift[0];
        m.y = shift[1];
        m.turn = rigid ? static_cast<Real>(state.clusters.list[owner.cluster].twist) : 0;
    });
}

void ContactRows::giveShifts(State& state) {
    forEachMover([&](const Mover& m, const Owner& owner) {
        if (!canBePushed(m)) return;
        if (owner.cluster == none) {
            state.particles.shift[owner.particle] = Vec2(m.x, m.y);
            return;
        }
        Cluster& c = state.clusters.list[owner.cluster];
        c.shift = Vec2(m.x, m.y);
        c.twist = static_cast<double>(m.turn);
    });
}

void ContactRows::applyShifts(State& state) {
    forEachMover([&](const Mover&, const Owner& owner) {
        applyRecovery(state, {owner.particle, owner.cluster, Vec2(0, 0)});
    });
    for (const auto i : single_) {
        const Contact& c = state.contacts[i];
        for (const Grip& grip : {c.gripOfParticle, c.gripOfA, c.gripOfB})
            applyRecovery(state, grip);
    }
}

void ContactRows::recover(State& state) {
    const ContactKernels& kernels = contactKernels();
    takeShifts(state);
    sweepBlocks(kernels.driftTwo, kernels.driftThree, false);
    for (int sweep = 0; sweep < state.settings.sweeps; ++sweep) {
        // There and back: always from the same end, crates of a heap tilted a little in every tick.
        sweepBlocks(kernels.recoverTwo, kernels.recoverThree, sweep % 2 != 0);
        if (single_.empty()) continue;
        giveShifts(state);
        if (sweep == 0) recoverDrifts(state, single_);
        solveRecovery(state, single_);
        takeShifts(state);
    }
    giveShifts(state);
    applyShifts(state);
}

void ContactRows::sweep(State& state, bool backwards) {
    const auto inBlocks = [&] {
        if (colours_.empty()) return;
        takeMotions(state);
        sweep(backwards);
        giveMotions(state);
    };
    if (!backwards) inBlocks();
    solveContacts(state, single_, backwards);
    if (backwards) inBlocks();
}

bool ContactRows::anyTooDeep(const State& state) const {
    const ContactKernels& kernels = contactKernels();
    const auto any = [&](auto kernel, const Blocks& blocks) {
        return anyInPieces(tasks_, blocks.size(), seenInMicrosecond,
                           [&](std::size_t first, std::size_t last) {
                               return kernel(movers_.data(), blocks.data() + first, last - first);
                           });
    };
    return any(kernels.anyDeepTwo, two_) || any(kernels.anyDeepThree, three_) ||
           std::any_of(single_.begin(), single_.end(), [&](std::uint32_t i) {
               return gapLeft(state, state.contacts[i]) < deepestOf(state.contacts[i]);
           });
}

bool ContactRows::anyErrorBeyond(Real most) const {
    const ContactKernels& kernels = contactKernels();
    const auto any = [&](auto kernel, const Blocks& blocks) {
        return anyInPieces(
            tasks_, blocks.size(), seenInMicrosecond, [&](std::size_t first, std::size_t last) {
                return kernel(movers_.data(), blocks.data() + first, last - first, most);
            });
    };
    return any(kernels.anyErrorTwo, two_) || any(kernels.anyErrorThree, three_);
}

bool ContactRows::anySingleBeyond(const State& state, Real most) const {
    return std::any_of(single_.begin(), single_.end(), [&](std::uint32_t i) {
        return leavesError(state, state.contacts[i], most);
    });
}

namespace {

/// m
Real deepErrorIn(const State& state) {
    Real thinnest = std::numeric_limits<Real>::max();
    for (const Contact& c : state.contacts) thinnest = std::min(thinnest, c.thickness);
    return deepError * thinnest;
}

}  // namespace

bool ContactRows::anyDeepError(const State& state) const {
    return anyErrorBeyond(deepErrorIn(state));
}

bool ContactRows::anyDeepErrorSingly(const State& state) const {
    return anySingleBeyond(state, deepErrorIn(state));
}

bool ContactRows::anyLargeError(const State& state) const {
    return anyErrorBeyond(largeErrorSpeed * state.h);
}

bool ContactRows::anyError(const State& state) const {
    const Real most = mostErrorSpeed * state.h;
    return anyErrorBeyond(most) || anySingleBeyond(state, most);
}

}  // namespace sulfur::detail
