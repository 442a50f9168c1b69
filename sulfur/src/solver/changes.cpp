// Stage 1: what is derived from bodies and joints follows their changes.
#include <algorithm>

#include "joints/batches.hpp"
#include "joints/classify.hpp"
#include "joints/triangles.hpp"
#include "rigid/find_clusters.hpp"
#include "solver/constraint_kinds.hpp"
#include "solver/stages.hpp"
#include "solver/work_lists.hpp"
#include "trees/chain_batches.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// So many bodies, or a sixteenth of all if that is more, may turn before all lists are made anew.
constexpr std::size_t leastFew = 8;

bool anyAwake(const State& state, std::uint32_t a, std::uint32_t b) {
    const auto& body = state.particles.body;
    return state.awake(body[a]) || state.awake(body[b]);
}

void append(std::vector<Range>& ranges, std::uint32_t i) {
    if (!ranges.empty() && ranges.back().last == i)
        ++ranges.back().last;
    else
        ranges.push_back({i, i + 1});
}

/// The first cluster of a body, or of the next one that has any.
std::uint32_t firstCluster(const State& state, std::uint32_t body) {
    const auto& list = state.clusters.list;
    return static_cast<std::uint32_t>(
        std::partition_point(list.begin(), list.end(),
                             [&](const Cluster& c) { return c.body < body; }) -
        list.begin());
}

/// This and other lists go on from what was listed `before`.
void listClusters(State& state, const Counts& before) {
    WorkLists& work = state.work;
    if (before.bodies == 0)
        for (auto* list : {&work.awakeClusters, &work.clusters, &work.watchedClusters})
            list->clear();
    for (auto c = firstCluster(state, before.bodies); c < state.clusters.list.size(); ++c) {
        if (!state.awake(state.clusters.list[c].body)) continue;
        work.awakeClusters.push_back(c);
        if (state.clusters.list[c].watched) work.watchedClusters.push_back(c);
        if (state.trees.ofCluster[c] == none) work.clusters.push_back(c);
    }
}

bool isAwake(const State& state, const TreeNode& node) {
    if (node.cluster != none) {
        const Cluster& c = state.clusters.list[node.cluster];
        return c.inverseMass > 0 || c.inverseInertia > 0;
    }
    return node.particle != none && state.particles.inverseMass[node.particle] > 0;
}

void listTrees(State& state) {
    WorkLists& work = state.work;
    work.lonelyTrees.clear();
    work.tiedTrees.clear();
    work.lines.clear();
    for (std::uint32_t t = 0; t < state.trees.list.size(); ++t) {
        const Tree& tree = state.trees.list[t];
        const auto first = state.trees.nodes.begin() + tree.first;
        const auto last = state.trees.nodes.begin() + tree.last;
        if (std::any_of(first, last, [&](const TreeNode& n) { return isAwake(state, n); }))
            (tree.alone ? work.lonelyTrees : work.lines).push_back(t);
    }
    for (const auto t : work.lonelyTrees)
        if (state.trees.list[t].tied) work.tiedTrees.push_back(t);
    listChainBatches(state);
}

/// Pins of ropes and pendulums: the trees forget their forces, so that nothing is left to predict.
std::pmr::vector<bool> heldByTrees(State& state) {
    std::pmr::vector<bool> held(state.particles.size(), false, &state.arena);
    for (const auto t : state.work.lonelyTrees) {
        const Tree& tree = state.trees.list[t];
        for (auto k = tree.first; k < tree.last; ++k)
            if (const auto p = state.trees.nodes[k].particle;
                p != none && state.particles.inverseMass[p] == 0)
                held[p] = true;
    }
    return held;
}

void clearAwake(const State& state, WorkLists& work) {
    work.bodies.clear();
    work.kinematic.clear();
    work.sleepers = 0;
    work.bodies.reserve(state.bodies.size());
    for (auto* list : {&work.awake, &work.points, &work.free}) {
        list->clear();
        // When some fall asleep, the ranges of the others fall apart.
        list->reserve(state.bodies.size());
    }
    work.awakeParticles = work.awakeSurfaces = 0;
    work.heldNodes.clear();
}

void listAwakeParticles(State& state, const Counts& before) {
    WorkLists& work = state.work;
    if (before.bodies == 0) clearAwake(state, work);
    const auto held = before.bodies == 0 ? heldByTrees(state) : std::pmr::vector<bool>();
    for (std::uint32_t b = before.bodies; b < state.bodies.size(); ++b) {
        const BodyRecord& body = state.bodies[b];
        if (body.asleep) ++work.sleepers;
        if (!state.awake(b)) continue;
        work.bodies.push_back(b);
        if (body.kind == BodyKind::kinematic) work.kinematic.push_back(b);
        const auto size = static_cast<std::uint32_t>(body.particles.size());
        work.awakeParticles += size;
        const auto surfaces = countSurfaces(state, body);
        work.awakeSurfaces += surfaces;
        for (auto i = body.firstParticle; i < body.firstParticle + size; ++i) {
            if (surfaces > 0) append(work.awake, i);
            if (state.particles.cluster[i] != none) continue;
            append(work.points, i);
            if (state.trees.ofParticle[i] != none) continue;
            if (!held.empty() && held[i] && body.kind == BodyKind::dynamic)
                work.heldNodes.push_back(i);
            else
                append(work.free, i);
        }
    }
}

bool takesPart(const State& state, std::uint32_t j) {
    const Joints& joints = state.joints;
    const auto moves = [&](std::uint32_t p) {
        return state.awake(state.particles.body[p]) && inverseMassAwake(state, p) > 0;
    };
    return !joints.inCluster[j] && (moves(joints.a[j]) || moves(joints.b[j])) && !isCut(state, j);
}

void listStiffRuns(State& state) {
    const Joints& joints = state.joints;
    auto& runs = state.work.stiffRuns;
    runs.clear();
    for (const auto j : state.work.stiffJoints) {
        const bool forces = joints.explicitStiffness[j] > 0 || joints.explicitDamping[j] > 0;
        if (!runs.empty() && runs.back().last == j && runs.back().forces == forces)
            ++runs.back().last;
        else
            runs.push_back({j, j + 1, forces});
    }
}

void listBreakable(State& state, const Counts& before) {
    const Joints& joints = state.joints;
    for (auto j = before.joints; j < joints.size(); ++j)
        if (joints.strength[j] != infinite && anyAwake(state, joints.a[j], joints.b[j]) &&
            !isCut(state, j))
            state.work.breakableJoints.push_back(j);
}

void listJoints(State& state) {
    WorkLists& work = state.work;
    const Joints& joints = state.joints;
    for (auto* list : {&work.explicitJoints, &work.implicitJoints, &work.rigidJoints,
                       &work.stiffJoints, &work.breakableJoints, &work.tiedJoints})
        list->clear();
    listBreakable(state, {});
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        if (joints.body[j] == none) work.tiedJoints.push_back(j);
        if (!takesPart(state, j)) continue;
        if (joints.kind[j] != JointKind::rigid &&
            (joints.explicitStiffness[j] > 0 || joints.explicitDamping[j] > 0))
            work.explicitJoints.push_back(j);
        if (joints.kind[j] != JointKind::explicitElastic) work.stiffJoints.push_back(j);
    }
    batchExplicitJoints(state);
    listStiffRuns(state);
    for (const auto j : state.structure.sweptJoints) {
        if (!takesPart(state, j)) continue;
        (joints.kind[j] == JointKind::rigid ? work.rigidJoints : work.implicitJoints).push_back(j);
    }
    batchSweptJoints(state);
}

void listAngles(State& state) {
    WorkLists& work = state.work;
    const Angles& angles = state.angles;
    work.explicitAngles.clear();
    work.implicitAngles.clear();
    work.breakableAngles.clear();
    for (std::uint32_t i = 0; i < angles.size(); ++i) {
        if (angles.kind[i] == AngleKind::held || angles.kind[i] == AngleKind::driven ||
            !state.awake(angles.body[i]))
            continue;
        const auto moves = [&](std::uint32_t p) { return inverseMassAwake(state, p) > 0; };
        if (!moves(angles.a[i]) && !moves(angles.b[i]) && !moves(angles.c[i])) continue;
        if (angles.explicitStiffness[i] > 0 || angles.explicitDamping[i] > 0)
            work.explicitAngles.push_back(i);
        if (angles.kind[i] == AngleKind::implicitElastic) work.implicitAngles.push_back(i);
        if (angles.strength[i] != infinite) work.breakableAngles.push_back(i);
    }
    groupAngles(state);
}

/// A rigid component may have a surface elsewhere.
void listSweptParticles(State& state) {
    WorkLists& work = state.work;
    work.sweptParticles.clear();
    std::pmr::vector<bool> listed(state.particles.size(), false, &state.arena);
    const auto add = [&](std::uint32_t i) {
        if (listed[i]) return;
        listed[i] = true;
        if (state.particles.reach[i] > 0 || state.particles.cluster[i] != none)
            work.sweptParticles.push_back(i);
    };
    for (const auto* list : {&work.implicitJoints, &work.rigidJoints})
        for (const auto j : *list)
            for (const auto i : {state.joints.a[j], state.joints.b[j]}) add(i);
    const Angles& angles = state.angles;
    for (const auto j : work.implicitAngles)
        for (const auto i : {angles.a[j], angles.b[j], angles.c[j]}) add(i);
}

/// Whether a joint or tree that takes part holds a rigid component.
bool holdsClusters(const State& state) {
    const WorkLists& work = state.work;
    const auto isHeld = [&](std::uint32_t particle) {
        return state.particles.cluster[particle] != none;
    };
    for (const auto* list : {&work.explicitJoints, &work.implicitJoints, &work.rigidJoints})
        for (const auto j : *list)
            if (isHeld(state.joints.a[j]) || isHeld(state.joints.b[j])) return true;
    for (const auto* list : {&work.explicitAngles, &work.implicitAngles})
        for (const auto j : *list)
            for (const auto i : {state.angles.a[j], state.angles.b[j], state.angles.c[j]})
                if (isHeld(i)) return true;
    const auto hasClusters = [&](std::uint32_t tree) { return state.trees.list[tree].points == 0; };
    return std::any_of(work.lonelyTrees.begin(), work.lonelyTrees.end(), hasClusters) ||
           std::any_of(work.lines.begin(), work.lines.end(), hasClusters);
}

void listSprings(State& state, const Counts& before) {
    auto& springs = state.work.springs;
    auto& start = state.work.springStart;
    if (before.bodies == 0) {
        springs.clear();
        start.assign(1, 0);
    }
    for (auto b = before.bodies; b < state.bodies.size(); ++b) {
        for (const JointId id : state.bodies[b].joints)
            if (const auto j = state.jointSlots.dense(id); !isRigid(state.joints, j))
                springs.push_back(j);
        start.push_back(static_cast<std::uint32_t>(springs.size()));
    }
}

void listAttachments(State& state) {
    WorkLists& work = state.work;
    work.attachments.clear();
    work.hinges.clear();
    for (const auto i : state.structure.sweptAttachments) {
        const Attachment& held = state.attachments[i];
        if (anyAwake(state, held.particle, held.support[0]) && !isCut(state, held))
            work.attachments.push_back(i);
    }
    for (const auto i : state.structure.sweptHinges) {
        const Hinge& hinge = state.clusters.hinges[i];
        if (state.awake(state.clusters.list[hinge.cluster].body)) work.hinges.push_back(i);
    }
}

/// Bodies that the caller bent are whole again when the sweeps have straightened them.
void watchStrain(State& state) {
    const auto watch = [&](std::uint32_t i) {
        if (!state.bodies[i].strained || !strainIsGone(state, i)) return;
        state.bodies[i].clustersStale = true;
        state.structure.changed();
    };
    if (state.work.onlyAdded || (!state.work.stale && !state.structure.stale)) {
        state.looked(Stage::changes, state.work.strained.size());
        for (const auto i : state.work.strained) watch(i);
        return;
    }
    state.looked(Stage::changes, state.bodies.size());
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) watch(i);
}

void listStrained(State& state) {
    auto& strained = state.work.strained;
    strained.clear();
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i)
        if (state.bodies[i].strained) strained.push_back(i);
}

/// Whether all that was added is single particles and whole rigid components, so that no joint of
/// it has to be solved. Trees stay as they are then.
bool addedAreRigid(const State& state, const Counts& before) {
    const auto& hinges = state.clusters.hinges;
    const bool hinged =
        !hinges.empty() && hinges.back().cluster >= firstCluster(state, before.bodies);
    return !hinged &&
           std::all_of(state.joints.inCluster.begin() + before.joints, state.joints.inCluster.end(),
                       [](auto in) { return in != 0; }) &&
           std::all_of(state.angles.kind.begin() + anglesOf(state, before.bodies).first,
                       state.angles.kind.end(),
                       [](AngleKind kind) { return kind == AngleKind::held; });
}

/// Ties between bodies come and go without that.
bool anyShapeChanged(const State& state) {
    return std::any_of(state.bodies.begin(), state.bodies.end(),
                       [](const BodyRecord& body) { return body.clustersStale; });
}

/// Bodies that were added are tied to nothing, so that all but the trees, whose order is that of
/// all particles, stays for the others.
void deriveStructure(State& state) {
    const bool onlyAdded = state.structure.onlyAdded;
    const Counts before = onlyAdded ? state.structure.before : Counts{};
    if (!onlyAdded) {
        dissolveTrees(state);
        if (state.triangles.bodies == 0 || anyShapeChanged(state)) forgetTriangles(state);
    }
    updateClusters(state, before);
    findTriangles(state);
    classifyJoints(state, before);
    classifyAngles(state, before);
    if (onlyAdded && addedAreRigid(state, before)) {
        state.trees.ofParticle.resize(state.particles.size(), none);
        state.trees.ofCluster.resize(state.clusters.list.size(), none);
        state.structure.colours.resize(state.joints.size(), 0);
        state.structure.stale = state.structure.onlyAdded = false;
        return;
    }
    if (onlyAdded) dissolveTrees(state);
    buildTrees(state);
    if (!onlyAdded) state.structureChanged = true;
    state.structure.stale = state.structure.onlyAdded = false;
    state.work.changed();
}

std::uint32_t sizeOf(const auto& list) {
    return static_cast<std::uint32_t>(list.size());
}

void count(State& state) {
    Statistics& statistics = state.statistics;
    const WorkLists& work = state.work;
    statistics.particles = sizeOf(state.particles) - state.gone.particles;
    statistics.joints = sizeOf(state.joints) - state.gone.joints;
    statistics.bodies = sizeOf(state.bodies) - state.gone.bodies;
    statistics.awakeParticles = work.awakeParticles;
    statistics.clusters = sizeOf(work.awakeClusters);
    statistics.breakableJoints = sizeOf(work.breakableJoints);
}

void countTrees(State& state) {
    Statistics& statistics = state.statistics;
    const WorkLists& work = state.work;
    statistics.trees = sizeOf(work.lonelyTrees);
    const auto isNetwork = [&](std::uint32_t t) { return state.trees.list[t].network != none; };
    statistics.networks = static_cast<std::uint32_t>(
        std::count_if(work.lonelyTrees.begin(), work.lonelyTrees.end(), isNetwork));
    statistics.triangles = static_cast<std::uint32_t>(state.triangles.awake.count);
    statistics.sweptJoints = sizeOf(work.implicitJoints) + sizeOf(work.rigidJoints);
    statistics.explicitJoints = statistics.dampedJoints = 0;
    statistics.rigidJoints = statistics.implicitJoints = 0;
    for (const auto j : work.explicitJoints) {
        if (state.joints.kind[j] == JointKind::explicitElastic) ++statistics.explicitJoints;
        if (state.joints.explicitDamping[j] > 0) ++statistics.dampedJoints;
    }
    statistics.explicitAngles = statistics.implicitAngles = 0;
    for (const auto i : work.explicitAngles)
        if (state.angles.kind[i] == AngleKind::explicitElastic) ++statistics.explicitAngles;
    statistics.implicitAngles = sizeOf(work.implicitAngles);
    for (const auto j : work.stiffJoints)
        ++(state.joints.kind[j] == JointKind::rigid ? statistics.rigidJoints
                                                    : statistics.implicitJoints);
}

/// Bodies that woke or fell asleep since the lists were made enter and leave them one by one, if
/// they are few and plain.
void followTurned(State& state) {
    WorkLists& work = state.work;
    work.turned.clear();
    std::swap(work.turned, state.turned);
    if (work.stale && !work.onlyAdded) return;
    const std::size_t few = leastFew + state.bodies.size() / 16;
    if (work.turned.size() > few) return work.changed();
    state.looked(Stage::changes, work.turned.size());
    for (const auto slot : work.turned) {
        const auto body = state.bodySlots.denseOf(slot);
        if (body == none || body >= work.listed.bodies) continue;
        if (!isPlain(state, body)) return work.changed();
        unlist(state, body);
        enlist(state, body);
        state.anyForced = state.anyStirred = true;
    }
}

/// The lists of all bodies, or of those that were added if nothing else has changed.
void listAnew(State& state) {
    WorkLists& work = state.work;
    const Counts before = work.onlyAdded ? work.listed : Counts{};
    updateReach(state, before);
    if (!work.onlyAdded) listTrees(state);
    listAwakeParticles(state, before);
    listClusters(state, before);
    listSprings(state, before);
    if (work.onlyAdded) {
        listBreakable(state, before);
    } else {
        listJoints(state);
        listAngles(state);
        listSweptParticles(state);
        work.holdsClusters = holdsClusters(state);
        listAttachments(state);
        listStrained(state);
        listTriangles(state);
        state.core.listsStale = true;
        countTrees(state);
        state.anyForced = true;  // of who woke, too
    }
    state.anyStirred = true;  // of who woke, too
    work.listed = countsOf(state);
    for (auto* list : {&work.turned, &state.turned}) list->reserve(state.bodies.size());
    work.stale = work.onlyAdded = work.retuned = false;
}

/// Batches of joints of which only numbers have changed.
void refillBatches(State& state) {
    fillExplicitBatches(state);
    fillSweptBatches(state);
    listChainBatches(state);
    state.work.retuned = false;
}

}  // namespace

void updateStructure(State& state) {
    watchStrain(state);
    if (state.structure.stale) deriveStructure(state);
}

void applyChanges(State& state) {
    closeListGaps(state);
    updateStructure(state);
    followTurned(state);
    WorkLists& work = state.work;
    if (work.stale)
        listAnew(state);
    else if (work.retuned)
        refillBatches(state);
    count(state);
}

}  // namespace sulfur::detail
