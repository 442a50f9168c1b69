#include "rigid/find_clusters.hpp"

#include <algorithm>
#include <cmath>

#include "core/settings.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/rigidity.hpp"
#include "shape/make_shapes.hpp"

namespace sulfur::detail {

namespace {

/// More than this share of its length makes a rigid joint strained: its body was bent by the
/// caller, and the sweeps bring it into shape before it may move as one piece.
using tuned::strainLimit;

/// kg m^2: less than that has an inverse that Real does not hold, or no product with it.
constexpr double leastInertia = 1e-30;

bool isStrained(const State& state, std::uint32_t j) {
    const Joints& joints = state.joints;
    const auto& x = state.particles.position;
    const double rest = static_cast<double>(joints.restLength[j]);
    return std::abs((x[joints.b[j]] - x[joints.a[j]]).norm() - rest) > strainLimit * rest;
}

/// The rigid joints of a body, with particles numbered from its first one.
struct Framework {
    Framework(const State& state, std::uint32_t index) {
        const BodyRecord& body = state.bodies[index];
        first = body.firstParticle;
        for (std::uint32_t k = 0; k < body.particles.size(); ++k)
            positions.push_back(state.particles.position[first + k]);
        for (const JointId id : body.joints) {
            const auto j = state.jointSlots.dense(id);
            if (!isRigid(state.joints, j)) continue;
            joints.push_back(j);
            bars.push_back({state.joints.a[j] - first, state.joints.b[j] - first});
        }
    }
    std::uint32_t first = 0;
    std::vector<Point> positions;
    std::vector<std::uint32_t> joints;
    std::vector<Bar> bars;
};

std::uint32_t pinnedAmong(const State& state, const std::vector<std::uint32_t>& particles) {
    return static_cast<std::uint32_t>(
        std::count_if(particles.begin(), particles.end(),
                      [&](std::uint32_t i) { return state.particles.pinned[i] != 0; }));
}

/// One rigid joint between two particles that nobody pins, and nothing else of the body.
bool isLoneRod(const State& state, const BodyRecord& body, const Framework& frame) {
    return body.joints.size() == 1 && frame.bars.size() == 1 && frame.positions.size() == 2 &&
           !state.particles.pinned[frame.first] && !state.particles.pinned[frame.first + 1];
}

/// A particle with a radius, which is a component by itself where it is in no other: it turns. The
/// particles of the paper do not.
bool isDisc(const State& state, std::uint32_t particle) {
    return state.particles.radius[particle] > 0 && !state.particles.pinned[particle] &&
           state.settings.friction == Friction::coulomb;
}

/// By rigid joint of a body, to which rigid component it belongs, or none. Nothing where there can
/// be none, or where the body is strained.
std::vector<std::uint32_t> labelsOf(const State& state, const BodyRecord& body,
                                    const Framework& frame, bool& strained) {
    const bool isRod = isLoneRod(state, body, frame);
    if (!isRod && frame.bars.size() < 3) return {};
    strained = std::any_of(frame.joints.begin(), frame.joints.end(),
                           [&](std::uint32_t j) { return isStrained(state, j); });
    if (strained) return {};
    return isRod ? std::vector<std::uint32_t>{0} : findRigidSets(frame.positions, frame.bars);
}

/// What a cluster of these particles turns about, and how heavy it is.
struct Measures {
    Point centre{0, 0}, massCentre{0, 0};  // m, in the world
    double mass = 0, inertia = 0;          // inertia about `centre`
};

Measures measure(const State& state, const std::vector<std::uint32_t>& particles) {
    const Particles& p = state.particles;
    const Point origin = p.position[particles.front()];
    Measures m;
    Point weighted(0, 0);
    for (const auto i : particles) {
        m.mass += static_cast<double>(p.mass[i]);
        weighted += static_cast<double>(p.mass[i]) * (p.position[i] - origin);
    }
    m.massCentre = m.centre = origin + weighted / m.mass;
    for (const auto i : particles)
        if (p.pinned[i]) m.centre = p.position[i];
    for (const auto i : particles)
        m.inertia += static_cast<double>(p.mass[i]) * (p.position[i] - m.centre).squaredNorm();
    if (particles.size() == 1)
        m.inertia = discInertia(static_cast<double>(p.mass[particles[0]]),
                                static_cast<double>(p.radius[particles[0]]));
    return m;
}

class Finder {
public:
    explicit Finder(State& state) : state_(state), next_() {}

    void run(const Counts& before) {
        const std::size_t had = before.bodies > 0 ? state_.clusters.list.size() : 0;
        if (before.bodies > 0) {
            next_ = std::move(state_.clusters);
            for (auto body = before.bodies; body < state_.bodies.size(); ++body) findAnew(body);
        } else {
            findAll();
        }
        state_.clusters = std::move(next_);
        pointParticlesAtClusters(had, before.particles);
    }

private:
    void findAll() {
        std::size_t old = 0, oldHinge = 0;
        const Clusters& before = state_.clusters;
        for (std::uint32_t body = 0; body < state_.bodies.size(); ++body) {
            const std::size_t from = old, fromHinge = oldHinge;
            while (old < before.list.size() && before.list[old].body == body) ++old;
            while (oldHinge < before.hinges.size() && before.hinges[oldHinge].cluster < old)
                ++oldHinge;
            if (state_.bodies[body].clustersStale)
                findAnew(body);
            else
                keep(from, old, fromHinge, oldHinge);
        }
    }

    void keep(std::size_t from, std::size_t to, std::size_t fromHinge, std::size_t toHinge) {
        const Clusters& before = state_.clusters;
        const auto shiftOfClusters = next_.list.size() - from;  // wraps, and wraps back
        for (std::size_t i = from; i < to; ++i) {
            Cluster c = before.list[i];
            const auto first = static_cast<std::uint32_t>(next_.members.size());
            next_.members.insert(next_.members.end(), before.members.begin() + c.first,
                                 before.members.begin() + c.last);
            next_.places.insert(next_.places.end(), before.places.begin() + c.first,
                                before.places.begin() + c.last);
            c.last = first + (c.last - c.first);
            c.first = first;
            next_.list.push_back(c);
        }
        for (std::size_t i = fromHinge; i < toHinge; ++i) {
            Hinge hinge = before.hinges[i];
            hinge.cluster = static_cast<std::uint32_t>(hinge.cluster + shiftOfClusters);
            next_.hinges.push_back(hinge);
        }
    }

    void findAnew(std::uint32_t index) {
        BodyRecord& body = state_.bodies[index];
        body.clustersStale = false;
        body.strained = false;
        shapeIsStale(state_, body.id.index - 1);
        for (const JointId id : body.joints)
            state_.joints.inCluster[state_.jointSlots.dense(id)] = 0;
        if (body.kind != BodyKind::dynamic) return;
        const Framework frame(state_, index);
        std::vector<std::uint8_t> taken(frame.positions.size(), 0);
        addSets(index, frame, labelsOf(state_, body, frame, body.strained), taken);
        for (std::uint32_t k = 0; k < taken.size(); ++k) {
            const auto i = frame.first + k, old = state_.particles.cluster[i];
            if (!taken[k] && isDisc(state_, i))
                addDisc(index, i);
            else if (old != none)
                keepTurn(body, state_.clusters.list[old]);
        }
    }

    /// One that has been a disc before keeps how it turns.
    void addDisc(std::uint32_t body, std::uint32_t particle) {
        const auto old = state_.particles.cluster[particle];
        if (!addCluster(body, {particle}, {}) || old == none) return;
        const Cluster& before = state_.clusters.list[old];
        if (!isDisc(before)) return;
        if (canTurn(next_.list.back())) next_.list.back().spin = before.spin;
        next_.list.back().heading = before.heading;
        next_.list.back().headingBefore = before.headingBefore;
    }

    void addSets(std::uint32_t body, const Framework& frame,
                 const std::vector<std::uint32_t>& label, std::vector<std::uint8_t>& taken) {
        std::uint32_t sets = 0;
        for (const auto l : label)
            if (l != none) sets = std::max(sets, l + 1);
        std::vector<std::vector<std::uint32_t>> particles(sets), shared(sets);
        std::vector<std::uint32_t> owner(frame.positions.size(), none);
        for (std::size_t i = 0; i < label.size(); ++i) {
            if (label[i] == none) continue;
            for (const auto p : {frame.bars[i].a, frame.bars[i].b}) {
                if (owner[p] == none) owner[p] = label[i];
                auto& list = owner[p] == label[i] ? particles[label[i]] : shared[label[i]];
                list.push_back(frame.first + p);
            }
        }
        for (std::uint32_t set = 0; set < sets; ++set) {
            for (auto* list : {&particles[set], &shared[set]}) {
                std::sort(list->begin(), list->end());
                list->erase(std::unique(list->begin(), list->end()), list->end());
            }
            if (particles[set].size() < 2 || !addCluster(body, particles[set], shared[set]))
                continue;
            for (const auto i : particles[set]) taken[i - frame.first] = 1;
            for (std::size_t i = 0; i < label.size(); ++i) {
                if (label[i] != set) continue;
                const auto j = frame.joints[i];
                state_.joints.inCluster[j] = 1;
                state_.joints.force[j] = 0;
                if (state_.joints.strength[j] != infinite) next_.list.back().watched = 1;
            }
        }
    }

    /// False if all of its particles are as good as in one place: then its joints are solved.
    bool addCluster(std::uint32_t body, const std::vector<std::uint32_t>& particles,
                    const std::vector<std::uint32_t>& shared) {
        const Measures m = measure(state_, particles);
        const auto pins = pinnedAmong(state_, particles);
        if (!(m.inertia > leastInertia)) return false;
        Cluster c;
        c.body = body;
        c.first = static_cast<std::uint32_t>(next_.members.size());
        c.last = c.first + static_cast<std::uint32_t>(particles.size());
        c.centre = m.centre;
        c.massCentre = m.massCentre - m.centre;
        c.mass = m.mass;
        c.freeInverseMass = pins == 0 ? 1 / m.mass : 0;
        const bool turns = pins < 2 && !state_.bodies[body].fixedRotation;
        c.freeInverseInertia = turns ? 1 / m.inertia : 0;
        for (const auto i : particles) {
            c.reach = std::max(c.reach, (state_.particles.position[i] - m.centre).norm());
            next_.members.push_back(i);
            next_.places.push_back(state_.particles.position[i] - m.centre);
        }
        const auto index = static_cast<std::uint32_t>(next_.list.size());
        for (const auto i : shared)
            next_.hinges.push_back({index, i, state_.particles.position[i] - m.centre});
        next_.list.push_back(c);
        return true;
    }

    /// Of the clusters and particles from these numbers on.
    void pointParticlesAtClusters(std::size_t firstCluster, std::uint32_t firstParticle) {
        Particles& p = state_.particles;
        std::fill(p.cluster.begin() + firstParticle, p.cluster.end(), none);
        for (auto c = static_cast<std::uint32_t>(firstCluster); c < state_.clusters.list.size();
             ++c) {
            const Cluster& cluster = state_.clusters.list[c];
            for (std::uint32_t k = cluster.first; k < cluster.last; ++k) {
                const auto i = state_.clusters.members[k];
                p.cluster[i] = c;
                p.arm[i] = turned(cluster.heading, state_.clusters.places[k]).cast<Real>();
            }
        }
        for (auto i = firstParticle; i < p.size(); ++i)
            if (p.cluster[i] == none) p.arm[i] = Vec2(0, 0);
    }

    State& state_;
    Clusters next_;
};

}  // namespace

void updateClusters(State& state, const Counts& before) {
    Finder(state).run(before);
    state.anyStirred = true;  // new ones are
    for (auto i = before.bodies; i < state.bodies.size(); ++i) restoreClusterMasses(state, i);
}

void keepTurn(BodyRecord& body, const Cluster& cluster) {
    if (!isDisc(cluster) || body.particles.size() != 1) return;
    body.turn = turned(body.turn, cluster.heading);
    body.turnBefore = turned(body.turnBefore, cluster.headingBefore);
}

std::vector<std::uint32_t> discsOf(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    const Particles& p = state.particles;
    const auto first = body.firstParticle;
    std::vector<std::uint32_t> discs;
    for (auto i = first; i < first + body.particles.size(); ++i)
        if (body.kind == BodyKind::dynamic && isDisc(state, i)) discs.push_back(i);
    if (discs.empty()) return discs;
    if (!body.clustersStale) {
        std::erase_if(discs, [&](std::uint32_t i) {
            return p.cluster[i] == none || !isDisc(state.clusters.list[p.cluster[i]]);
        });
        return discs;
    }
    const Framework frame(state, index);
    bool strained = false;
    const auto label = labelsOf(state, body, frame, strained);
    for (std::size_t k = 0; k < label.size(); ++k)
        if (label[k] != none)
            for (const auto i : {first + frame.bars[k].a, first + frame.bars[k].b})
                std::erase(discs, i);
    return discs;
}

bool strainIsGone(const State& state, std::uint32_t body) {
    const BodyRecord& record = state.bodies[body];
    return std::none_of(record.joints.begin(), record.joints.end(), [&](JointId id) {
        const auto j = state.jointSlots.dense(id);
        return isRigid(state.joints, j) && isStrained(state, j);
    });
}

void restoreClusterMasses(State& state, std::uint32_t body) {
    const bool moves = state.bodies[body].kind == BodyKind::dynamic && state.awake(body);
    auto& list = state.clusters.list;
    auto at = std::lower_bound(list.begin(), list.end(), body,
                               [](const Cluster& c, std::uint32_t b) { return c.body < b; });
    for (; at != list.end() && at->body == body; ++at) {
        at->inverseMass = moves ? static_cast<Real>(at->freeInverseMass) : 0;
        at->inverseInertia = moves ? static_cast<Real>(at->freeInverseInertia) : 0;
        if (moves || state.bodies[body].disabled) continue;
        at->velocity = Point(0, 0);
        at->spin = 0;
        at->headingBefore = at->heading;
    }
}

void stirClusters(State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    if (cluster == none) return;
    state.clusters.list[cluster].stirred = 1;
    state.anyStirred = true;
}

}  // namespace sulfur::detail
