#include "world/validate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/limits.hpp"
#include "solver/coordinates.hpp"

namespace sulfur::detail {

namespace {

std::string problem(const char* what, std::size_t index) {
    return std::string(what) + " (index " + std::to_string(index) + ")";
}

/// Every array of a structure of arrays has one entry for each thing.
template <class Arrays>
bool evenlyLong(const Arrays& arrays) {
    bool even = true;
    // forEachArray only hands out the arrays; nothing is changed.
    const_cast<Arrays&>(arrays).forEachArray(
        [&](const auto& list) { even &= list.size() == arrays.size(); });
    return even;
}

std::string validateArrays(const State& state) {
    if (!evenlyLong(state.particles)) return "arrays of particles of different lengths";
    if (!evenlyLong(state.joints)) return "arrays of joints of different lengths";
    if (!evenlyLong(state.angles)) return "arrays of angular joints of different lengths";
    if (state.bodyIds.size() + state.gone.bodies != state.bodies.size())
        return "a list of bodies of another length";
    if (!state.particleSlots.sound() || !state.jointSlots.sound() || !state.bodySlots.sound() ||
        !state.attachmentSlots.sound() || !state.angleSlots.sound())
        return "handles that fit no list";
    const int rate = state.settings.tickRate;
    if (rate < minTickRate || rate > maxTickRate) return "tick rate out of range";
    if (state.settings.sweeps < 1 || state.settings.sweeps > 100) return "sweeps out of range";
    if (!(state.h > 0) || !(state.lastStep > 0)) return "a tick without duration";
    return {};
}

std::string validateParticles(const State& state) {
    const Particles& p = state.particles;
    const auto clusters = state.clusters.list.size();
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!p.position[i].allFinite()) return problem("particle position is not finite", i);
        if (!p.velocity[i].allFinite()) return problem("particle velocity is not finite", i);
        if (!p.displacement[i].allFinite())
            return problem("particle displacement is not finite", i);
        if (!(p.inverseMass[i] >= 0)) return problem("particle inverse mass is negative", i);
        if (!(p.mass[i] > 0)) return problem("particle mass is not positive", i);
        if (p.body[i] >= state.bodies.size()) return problem("particle without a body", i);
        if (p.cluster[i] != none && p.cluster[i] >= clusters)
            return problem("particle of a rigid component that there is not", i);
        if (state.bodies[p.body[i]].gone > 0) continue;
        if (!state.particleSlots.contains(p.id[i]) || state.particleSlots.dense(p.id[i]) != i)
            return problem("particle handle leads elsewhere", i);
    }
    return {};
}

std::string validateJoints(const State& state) {
    const Joints& j = state.joints;
    for (std::size_t i = 0; i < j.size(); ++i) {
        if (j.a[i] >= state.particles.size() || j.b[i] >= state.particles.size())
            return problem("joint end out of range", i);
        if (j.a[i] == j.b[i]) return problem("joint from a particle to itself", i);
        if (const double bend = std::abs(static_cast<double>(j.bend[i].angle));
            bend != 0 && !(bend >= leastBend && bend <= mostBend && isRigid(j, i)))
            return problem("joint with a bend that there is not", i);
        if (j.body[i] != none && j.body[i] >= state.bodies.size())
            return problem("joint of a body that there is not", i);
        if (state.bodies[state.particles.body[j.a[i]]].gone > 0) continue;
        if (!state.jointSlots.contains(j.id[i]) || state.jointSlots.dense(j.id[i]) != i)
            return problem("joint handle leads elsewhere", i);
    }
    return {};
}

std::string validateAngles(const State& state) {
    const Angles& angles = state.angles;
    if (!std::is_sorted(angles.body.begin(), angles.body.end()))
        return "angular joints out of order";
    for (std::size_t i = 0; i < angles.size(); ++i) {
        for (const auto p : {angles.a[i], angles.b[i], angles.c[i]}) {
            if (p >= state.particles.size()) return problem("angular joint out of range", i);
            if (state.particles.body[p] != angles.body[i])
                return problem("angular joint of another body", i);
        }
        if (angles.a[i] == angles.b[i] || angles.b[i] == angles.c[i] || angles.a[i] == angles.c[i])
            return problem("angular joint that names a particle twice", i);
        if (!std::isfinite(angles.torque[i])) return problem("torque is not finite", i);
        if (!(angles.strength[i] > 0)) return problem("angular joint without strength", i);
        if (state.bodies[angles.body[i]].gone > 0) continue;
        if (!state.angleSlots.contains(angles.id[i]) || state.angleSlots.dense(angles.id[i]) != i)
            return problem("handle of an angular joint leads elsewhere", i);
        const Mechanisms& all = state.mechanisms;
        if (angles.drive[i] && (!all.slots.contains(angles.drive[i]) ||
                                all.slots.dense(angles.drive[i]) >= all.list.size() ||
                                all.list[all.slots.dense(angles.drive[i])].angle != angles.id[i]))
            return problem("angular joint that another mechanism drives", i);
    }
    return {};
}

std::string validateAttachments(const State& state) {
    const auto particles = state.particles.size();
    for (std::size_t i = 0; i < state.attachments.size(); ++i) {
        const Attachment& held = state.attachments[i];
        if (held.particle >= particles || held.count < 1 || held.count > held.support.size())
            return problem("attachment of nothing", i);
        for (std::uint32_t k = 0; k < held.count; ++k)
            if (held.support[k] >= particles) return problem("attachment to nothing", i);
        if (!state.attachmentSlots.contains(held.id) || state.attachmentSlots.dense(held.id) != i)
            return problem("attachment handle leads elsewhere", i);
    }
    return {};
}

std::string validateBodies(const State& state) {
    std::size_t next = 0, listed = 0;
    Counts gone;
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
        const BodyRecord& body = state.bodies[i];
        const std::size_t size = body.gone > 0 ? body.gone : body.particles.size();
        if (body.firstParticle != next) return problem("body does not follow its predecessor", i);
        if (size > state.particles.size() - next)
            return problem("body has more particles than there are", i);
        for (std::size_t k = 0; k < size; ++k)
            if (state.particles.body[next + k] != i) return problem("particle of another body", i);
        next += size;
        if (body.gone > 0) {
            if (body.kind != BodyKind::fixed || body.asleep || !body.particles.empty() ||
                state.bodySlots.contains(body.id))
                return problem("a body that is gone takes part", i);
            ++gone.bodies;
            gone.particles += body.gone;
            continue;
        }
        if (body.disabled && body.asleep) return problem("a body that takes no part sleeps", i);
        if (!body.turn.allFinite() || !body.turnBefore.allFinite() || !body.drift.allFinite() ||
            !std::isfinite(body.spin) || !std::isfinite(body.gravityScale))
            return problem("turn or gravity of a body is not finite", i);
        if (!std::isfinite(body.linearDamping) || !std::isfinite(body.angularDamping))
            return problem("damping of a body is not finite", i);
        for (const JointId id : body.joints)
            if (!state.jointSlots.contains(id)) return problem("body with a joint that is gone", i);
        if (!state.bodySlots.contains(body.id) || state.bodySlots.dense(body.id) != i)
            return problem("body handle leads elsewhere", i);
        if (listed == state.bodyIds.size() || state.bodyIds[listed++] != body.id)
            return problem("body under another handle", i);
    }
    if (gone.bodies != state.gone.bodies || gone.particles != state.gone.particles)
        return "gaps that are not counted";
    return next == state.particles.size() ? std::string() : "particles outside of bodies";
}

std::string validateVisits(const State& state) {
    const auto& visits = state.sensing.visits;
    const bool sorted =
        std::adjacent_find(visits.begin(), visits.end(),
                           [](const Visit& a, const Visit& b) { return !(a < b); }) == visits.end();
    return sorted ? "" : "visits of sensors out of order";
}

std::string validateDiscTurns(const State& state) {
    for (std::size_t i = 0; i < state.discTurns.size(); ++i) {
        const DiscTurn& turn = state.discTurns[i];
        if (!std::isfinite(turn.spin) || !std::isfinite(turn.torque))
            return problem("turn of a disc is not finite", i);
        if (i > 0 && !(state.discTurns[i - 1].disc < turn.disc))
            return "turns of discs out of order";
    }
    return {};
}

std::string validateClusters(const State& state) {
    const Clusters& clusters = state.clusters;
    const auto members = clusters.members.size();
    if (clusters.places.size() != members) return "places of members of another length";
    for (const auto i : clusters.members)
        if (i >= state.particles.size()) return "a rigid component of nothing";
    for (std::size_t i = 0; i < clusters.list.size(); ++i) {
        const Cluster& c = clusters.list[i];
        if (c.body >= state.bodies.size()) return problem("rigid component without a body", i);
        if (c.first >= c.last || c.last > members)
            return problem("rigid component without members", i);
        if (!c.centre.allFinite() || !c.velocity.allFinite() || !std::isfinite(c.spin))
            return problem("motion of a rigid component is not finite", i);
        if (!(std::abs(c.heading.norm() - 1) < 1e-6))
            return problem("rigid component whose heading is no direction", i);
    }
    for (std::size_t i = 0; i < clusters.hinges.size(); ++i)
        if (clusters.hinges[i].cluster >= clusters.list.size() ||
            clusters.hinges[i].particle >= state.particles.size())
            return problem("hinge of nothing", i);
    return {};
}

bool linkExists(const State& state, LinkKind kind, std::uint32_t link) {
    switch (kind) {
        case LinkKind::joint:
            return link < state.joints.size();
        case LinkKind::attachment:
            return link < state.attachments.size();
        case LinkKind::hinge:
            return link < state.clusters.hinges.size();
    }
    return false;
}

std::string validateNetwork(const State& state, const Tree& tree) {
    const Trees& trees = state.trees;
    if (tree.firstLink > tree.lastLink || tree.lastLink > trees.links.size() ||
        trees.rows.size() != trees.links.size())
        return "network without links";
    const std::uint32_t nodes = tree.last - tree.first;
    for (auto l = tree.firstLink; l < tree.lastLink; ++l) {
        const NetworkLink& n = trees.links[l];
        if (n.here >= nodes || n.there >= nodes || n.here == n.there ||
            !linkExists(state, n.kind, n.link))
            return problem("network link of nothing", l);
    }
    return {};
}

std::string validateTrees(const State& state) {
    const Trees& trees = state.trees;
    const auto exists = [](std::uint32_t i, std::size_t count) { return i == none || i < count; };
    std::uint32_t networks = 0;
    for (std::size_t t = 0; t < trees.list.size(); ++t) {
        const Tree& tree = trees.list[t];
        if (tree.network != none && tree.network != networks++)
            return problem("network under another number", t);
        if (tree.first >= tree.last || tree.last > trees.nodes.size() || tree.steps < 1)
            return problem("tree without nodes", t);
        if (tree.network != none)
            if (const std::string broken = validateNetwork(state, tree); !broken.empty())
                return broken;
        for (auto k = tree.first; k < tree.last; ++k) {
            const TreeNode& n = trees.nodes[k];
            if (!exists(n.particle, state.particles.size()) ||
                !exists(n.cluster, state.clusters.list.size()))
                return problem("tree node of nothing", k);
            const bool root = k == tree.first || tree.network != none;
            if (!root && (n.parent >= k - tree.first || !linkExists(state, n.kind, n.link)))
                return problem("tree node without a parent", k);
            const bool support = n.particle == none && n.cluster == none;
            if (support && n.link >= state.attachments.size())
                return problem("tree node at no attachment", k);
        }
    }
    if (state.structure.stale) return {};
    if (trees.ofParticle.size() != state.particles.size() ||
        trees.ofCluster.size() != state.clusters.list.size())
        return "trees of other particles";
    for (const auto* list : {&trees.ofParticle, &trees.ofCluster})
        for (const auto t : *list)
            if (!exists(t, trees.list.size())) return "a tree that there is not";
    return {};
}

/// Sleepers that must wake together form rings.
std::string validateSleepers(const State& state) {
    std::vector<bool> followed(state.bodies.size(), false);
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
        const BodyRecord& body = state.bodies[i];
        if (!body.asleep) continue;
        if (!state.bodySlots.contains(body.nextAsleep)) return problem("sleeper before nobody", i);
        const auto next = state.bodySlots.dense(body.nextAsleep);
        if (next >= state.bodies.size() || !state.bodies[next].asleep || followed[next])
            return problem("sleeper outside of any ring", i);
        followed[next] = true;
    }
    return {};
}

using SlotPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

bool within(const std::vector<std::uint32_t>& list, std::size_t count) {
    return std::all_of(list.begin(), list.end(), [&](std::uint32_t i) { return i < count; });
}
bool within(const SlotPairs& list, std::size_t firsts, std::size_t seconds) {
    return std::all_of(list.begin(), list.end(), [&](const auto& pair) {
        return pair.first < firsts && pair.second < seconds;
    });
}

std::string validateVetoes(const State& state) {
    return std::is_sorted(state.vetoes.begin(), state.vetoes.end()) ? "" : "vetoes out of order";
}

/// Lists that name bodies and particles by their slots.
std::string validateSlotLists(const State& state) {
    const ContactCore& core = state.core;
    const std::size_t bodies = state.bodySlots.slots(), particles = state.particleSlots.slots();
    if (!within(core.passedBy, bodies, bodies) || !within(core.linkedBodies, bodies, bodies) ||
        !within(core.linked, particles, bodies) || !within(core.staleShapes, bodies) ||
        !within(state.placed, bodies) || !within(state.turned, bodies))
        return "a list of bodies that there are not";
    for (const TiedCapsule& tied : core.tiedCapsules)
        if (tied.joint.index - 1 >= state.jointSlots.slots() || tied.a >= bodies ||
            tied.b >= bodies)
            return "a list of joints that there are not";
    const Movers& movers = core.movers;
    if (!evenlyLong(movers) || !within(movers.free, movers.size()))
        return "arrays of movers of different lengths";
    for (std::size_t m = 0; m < movers.size(); ++m)
        if ((movers.body[m] != none && movers.body[m] >= bodies) ||
            (movers.particle[m] != none && movers.particle[m] >= particles))
            return problem("mover of a body that there is not", m);
    for (std::size_t c = 0; c < core.shapes.chunks.size(); ++c) {
        const Chunk& chunk = core.shapes.chunks[c];
        if (chunk.body != none && (chunk.body >= bodies || chunk.frame >= movers.size()))
            return problem("shape of a body that there is not", c);
    }
    return {};
}

/// Lists that name pairs and what belongs to them.
std::string validatePairLists(const State& state) {
    const ContactCore& core = state.core;
    const std::size_t pairs = core.pairs.size(), encounters = core.encounters.size();
    if (!within(core.freePairs, pairs) || !within(core.struck, pairs) ||
        !within(core.freeTouches, core.touches.size()) ||
        !within(core.freeEncounters, encounters) || !within(core.changedEncounters, encounters) ||
        !within(core.struckEncounters, encounters) || !within(core.leading, encounters))
        return "a list of contacts that there are not";
    if (core.rooms.size() != core.watches.size()) return "rooms of other pairs";
    const std::size_t movers = core.movers.size(), chunks = core.shapes.chunks.size();
    for (std::size_t w = 0; w < core.watches.size(); ++w) {
        const PairWatch& watch = core.watches[w];
        if (watch.pair >= pairs || watch.a >= movers || watch.b >= movers)
            return problem("watch over a pair that there is not", w);
    }
    for (std::size_t i = 0; i < pairs; ++i) {
        const Pair& pair = core.pairs[i];
        if (pair.a != none &&
            (pair.a >= chunks || pair.b >= chunks || pair.encounter >= encounters))
            return problem("pair of shapes that there are not", i);
    }
    return {};
}

/// What was there before bodies were added keeps what was derived for it.
std::string validateAdded(const State& state) {
    const Structure& s = state.structure;
    if (!s.onlyAdded) return {};
    const Counts& before = s.before;
    if (!s.stale || before.bodies >= state.bodies.size() || before.joints > state.joints.size() ||
        before.particles != state.bodies[before.bodies].firstParticle)
        return "bodies added to others than there are";
    const auto& body = state.particles.body;
    for (std::uint32_t j = 0; j < state.joints.size(); ++j)
        for (const auto p : {state.joints.a[j], state.joints.b[j]})
            if ((body[p] < before.bodies) != (j < before.joints))
                return problem("joint that was added with no body", j);
    for (std::size_t i = 0; i < state.clusters.list.size(); ++i)
        if (state.clusters.list[i].body >= before.bodies)
            return problem("rigid component of a body that was added", i);
    return {};
}

std::string validateStructure(const State& state) {
    const Structure& s = state.structure;
    if (!within(state.fresh, state.particles.size())) return "a fresh particle that there is not";
    if (s.stale) return {};  // it is derived again before anybody looks
    if (!within(s.sweptJoints, state.joints.size()) ||
        !within(s.sweptAttachments, state.attachments.size()) ||
        !within(s.sweptHinges, state.clusters.hinges.size()))
        return "a list that names what there is not";
    return s.colours.size() == state.joints.size() ? "" : "colours of other joints";
}

/// Whether the line of a slider is the link of its rail that it is on.
bool isOnItsRail(const State& state, const Mechanism& m) {
    const Rail& rail = m.rail;
    if (m.kind != MechanismKind::slider || rail.closed > 1 || rail.link >= rail.links.size() ||
        !std::isfinite(rail.begin) || !state.jointSlots.contains(rail.links[rail.link]))
        return false;
    const auto j = state.jointSlots.dense(rail.links[rail.link]);
    if (j >= state.joints.size()) return false;
    const auto isEnd = [&](const MechanismPoint& point, std::uint32_t particle) {
        return point.count == 1 && point.support[0] == state.particles.id[particle];
    };
    const auto a = state.joints.a[j], b = state.joints.b[j];
    return (isEnd(m.points[1], a) && isEnd(m.points[2], b)) ||
           (isEnd(m.points[1], b) && isEnd(m.points[2], a));
}

bool isWhole(const State& state, const Mechanism& m) {
    const auto among = [](auto value, auto most) { return !(value > most); };
    if (!among(m.kind, MechanismKind::weld) || !std::isfinite(m.zero) ||
        !std::isfinite(m.zeroAngle) || !std::isfinite(m.ratio))
        return false;
    const Drive& d = m.drive;
    for (const Real number : {d.damping, d.rest, d.motorSpeed, d.motorTarget.value_or(0)})
        if (!std::isfinite(number)) return false;
    for (const Real number : {d.stiffness, d.motorMax, d.strength, m.pinStrength})
        if (!(number >= 0)) return false;
    if (!(d.lower <= d.upper)) return false;
    for (const RowForces& forces : m.forces)
        if (!std::isfinite(forces.spring) || !std::isfinite(forces.motor) ||
            !std::isfinite(forces.lower) || !std::isfinite(forces.upper))
            return false;
    const bool isGear = m.kind == MechanismKind::gear, ofOneBody = m.a == m.b;
    if (m.angle ? !ofOneBody || m.kind != MechanismKind::hinge : ofOneBody && !isGear) return false;
    const auto points = m.kind == MechanismKind::slider     ? 3u
                        : m.kind == MechanismKind::distance ? 2u
                        : m.kind == MechanismKind::pulley   ? 4u
                                                            : 0u;
    for (std::size_t k = 0; k < m.points.size(); ++k) {
        const MechanismPoint& point = m.points[k];
        if (point.count > point.support.size() || (point.count > 0) != (k < points)) return false;
        for (std::uint32_t i = 0; i < point.count; ++i)
            if (!point.support[i] || !std::isfinite(point.weight[i])) return false;
    }
    if (!m.rail.isNothing() && !isOnItsRail(state, m)) return false;
    const bool turns = m.kind == MechanismKind::hinge || m.kind == MechanismKind::weld ||
                       (m.kind == MechanismKind::slider && m.turns == 0);
    for (const MechanismArm& arm : m.arms)
        if (!std::isfinite(arm.angle) || bool(arm.from) != turns || bool(arm.to) != turns)
            return false;
    for (const MechanismId part : m.parts) {
        if (bool(part) != isGear) return false;
        const Mechanisms& all = state.mechanisms;
        if (isGear && (!all.slots.contains(part) || all.slots.dense(part) >= all.list.size() ||
                       all.list[all.slots.dense(part)].kind == MechanismKind::gear))
            return false;
    }
    return true;
}

std::string validateMechanisms(const State& state) {
    const Mechanisms& all = state.mechanisms;
    if (!all.slots.sound()) return "handles of mechanisms do not fit each other";
    for (std::size_t i = 0; i < all.list.size(); ++i) {
        const Mechanism& m = all.list[i];
        if (!all.slots.contains(m.id) || all.slots.dense(m.id) != i)
            return problem("mechanism handle leads elsewhere", i);
        if (!isWhole(state, m) || !holds(state, m)) return problem("mechanism of nothing", i);
    }
    return {};
}

}  // namespace

std::string findBroken(const State& state) {
    for (const auto check :
         {validateArrays, validateParticles, validateJoints, validateAngles, validateAttachments,
          validateBodies, validateSleepers, validateVisits, validateVetoes, validateSlotLists,
          validatePairLists, validateDiscTurns, validateClusters, validateTrees, validateStructure,
          validateAdded, validateMechanisms})
        if (std::string broken = check(state); !broken.empty()) return broken;
    return state.influences.validate();
}

}  // namespace sulfur::detail
