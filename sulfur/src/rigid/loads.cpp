#include "rigid/loads.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

#include "particles/motion.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

/// Numbers in memory that somebody lends.
using MappedVector = Eigen::Map<Eigen::VectorXd>;

/// The joints of a cluster as bars of an elastic truss, held where particles are pinned.
class Truss {
public:
    struct Member {
        JointId joint;
        Eigen::Index a, b;  // places in the cluster's list of members
        Point direction;    // from a to b, in the cluster's frame
        double stiffness;   // 1 / length
    };

    Truss(const State& state, const Cluster& cluster) {
        const Eigen::Index size = 2 * static_cast<Eigen::Index>(cluster.last - cluster.first);
        std::vector<Eigen::Triplet<double>> entries;
        double largest = 0;
        const BodyRecord& body = state.bodies[cluster.body];
        for (const JointId id : body.joints) {
            const auto j = state.jointSlots.dense(id);
            const auto a = placeOf(state, cluster, state.joints.a[j]);
            const auto b = placeOf(state, cluster, state.joints.b[j]);
            if (!state.joints.inCluster[j] || a < 0 || b < 0) continue;
            addMember(state, cluster, id, a, b, entries);
            largest = std::max(largest, members_.back().stiffness);
        }
        for (Eigen::Index i = 0; i < size; ++i) {
            const auto k = cluster.first + static_cast<std::uint32_t>(i / 2);
            const bool pinned = state.particles.pinned[state.clusters.members[k]] != 0;
            // The motions of the whole strain nothing; a trace of stiffness holds them, and pins.
            entries.emplace_back(i, i, largest * (pinned ? 1e6 : 1e-10));
        }
        Eigen::SparseMatrix<double> matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        solver_.compute(matrix);
        inversePivots_ = solver_.vectorD().cwiseInverse();
    }

    /// Tensions (N, positive pulls) under forces in balance, in the cluster's frame. `x` lends
    /// memory: the solver's own solve() would take some in every call.
    template <class Function>
    void solve(const MappedVector& forces, MappedVector& x, Function&& tell) const {
        const auto& order = solver_.permutationP().indices();
        for (Eigen::Index i = 0; i < x.size(); ++i) x[order[i]] = forces[i];
        solver_.matrixL().solveInPlace(x);
        x.array() *= inversePivots_.array();
        solver_.matrixU().solveInPlace(x);
        for (const Member& m : members_) {
            Point apart;
            for (Eigen::Index axis = 0; axis < 2; ++axis)
                apart[axis] = x[order[2 * m.b + axis]] - x[order[2 * m.a + axis]];
            tell(m.joint, m.stiffness * m.direction.dot(apart));
        }
    }

private:
    static Eigen::Index placeOf(const State& state, const Cluster& cluster, std::uint32_t p) {
        const auto from = state.clusters.members.begin() + cluster.first;
        const auto to = state.clusters.members.begin() + cluster.last;
        const auto at = std::lower_bound(from, to, p);
        return at != to && *at == p ? static_cast<Eigen::Index>(at - from) : -1;
    }

    void addMember(const State& state, const Cluster& cluster, JointId id, Eigen::Index a,
                   Eigen::Index b, std::vector<Eigen::Triplet<double>>& entries) {
        const auto first = static_cast<Eigen::Index>(cluster.first);
        const Point along = state.clusters.places[static_cast<std::size_t>(first + b)] -
                            state.clusters.places[static_cast<std::size_t>(first + a)];
        const double length = along.norm();
        const Point n = along / length;
        members_.push_back({id, a, b, n, 1 / length});
        for (Eigen::Index row = 0; row < 2; ++row) {
            for (Eigen::Index column = 0; column < 2; ++column) {
                const double value = n[row] * n[column] / length;
                entries.emplace_back(2 * a + row, 2 * a + column, value);
                entries.emplace_back(2 * b + row, 2 * b + column, value);
                entries.emplace_back(2 * a + row, 2 * b + column, -value);
                entries.emplace_back(2 * b + row, 2 * a + column, -value);
            }
        }
    }

    std::vector<Member> members_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
    Eigen::VectorXd inversePivots_;
};

namespace {

bool isWatched(const State& state, std::uint32_t particle) {
    const auto c = state.particles.cluster[particle];
    return c != none && state.clusters.list[c].watched;
}

void load(State& state, std::uint32_t particle, const Vec2& force) {
    if (isWatched(state, particle)) state.loads[particle] += force;
}

void loadByContacts(State& state) {
    const Real rate = newtonsPerMultiplier(state);
    for (const ContactLoad& c : state.contacts) {
        const Vec2 tangent(-c.normal[1], c.normal[0]);
        const Vec2 force = rate * (c.normalLambda * c.normal + c.tangentLambda * tangent);
        load(state, c.particle, force);
        load(state, c.a, -c.weightA * force);
        if (c.b != c.a) load(state, c.b, -c.weightB * force);
    }
}

void loadByJoints(State& state) {
    const Joints& joints = state.joints;
    for (const auto j : state.work.stiffJoints) {
        const auto a = joints.a[j], b = joints.b[j];
        if (!isWatched(state, a) && !isWatched(state, b)) continue;
        const auto& x = state.particles.position;
        const Vec2 direction = (x[b] - x[a]).normalized().cast<Real>();
        const Vec2 pull = -newtonsPerMultiplier(state) * joints.lambda[j] * direction;
        load(state, a, pull);
        load(state, b, -pull);
    }
}

void loadByAngles(State& state) {
    for (const SweptAngle& swept : state.work.sweptAngles.list)
        for (std::size_t k = 0; k < 3; ++k) {
            const double push = static_cast<double>(newtonsPerMultiplier(state)) * swept.lambda;
            load(state, swept.grips[k].particle, (push * swept.start.slopes[k]).cast<Real>());
        }
}

void loadByAttachments(State& state) {
    for (const Attachment& held : state.attachments) {
        load(state, held.particle, held.force);
        for (std::uint32_t k = 0; k < held.count; ++k)
            load(state, held.support[k], -held.weight[k] * held.force);
    }
    for (const Hinge& hinge : state.clusters.hinges) {
        load(state, hinge.particle, -hinge.force);
        const Cluster& c = state.clusters.list[hinge.cluster];
        if (!c.watched) continue;
        // The place of a hinge is no member; its nearest one carries it.
        auto nearest = c.first;
        const auto& places = state.clusters.places;
        for (auto k = c.first; k < c.last; ++k)
            if ((places[k] - hinge.place).squaredNorm() <
                (places[nearest] - hinge.place).squaredNorm())
                nearest = k;
        load(state, state.clusters.members[nearest], hinge.force);
    }
}

void loadByGrabs(State& state) {
    for (const Grab& grab : state.influences.grabs)
        for (std::uint32_t k = 0; k < grab.count; ++k)
            load(state, state.particleSlots.dense(grab.support[k]),
                 grab.weight[k] * newtonsPerMultiplier(state) * grab.impulse);
}

/// 1/(kg m^2), with which a cluster answers a torque, or with which it would if its body turned:
/// what keeps it from turning then acts on all of it.
double inverseInertiaInside(const State& state, const Cluster& c) {
    if (canTurn(c) || !(c.freeInverseMass > 0)) return static_cast<double>(c.inverseInertia);
    double inertia = 0;
    for (auto k = c.first; k < c.last; ++k)
        inertia += static_cast<double>(state.particles.mass[state.clusters.members[k]]) *
                   state.clusters.places[k].squaredNorm();
    return 1 / inertia;
}

/// Applied forces less mass times acceleration, in the frame of the cluster.
void balanceForces(const State& state, const Cluster& c, MappedVector& forces) {
    const auto& members = state.clusters.members;
    const Particles& p = state.particles;
    Point sum(0, 0);
    double torque = 0;
    for (auto k = c.first; k < c.last; ++k) {
        const Point f = state.loads[members[k]].cast<double>();
        sum += f;
        torque += cross(p.arm[members[k]].cast<double>(), f);
    }
    const Point acceleration = static_cast<double>(c.inverseMass) * sum;
    const double turning = inverseInertiaInside(state, c) * torque;
    const Point back(c.heading[0], -c.heading[1]);
    for (auto k = c.first; k < c.last; ++k) {
        const auto i = members[k];
        const Point arm = p.arm[i].cast<double>();
        const Point a = acceleration + turning * Point(-arm[1], arm[0]) - c.spin * c.spin * arm;
        const Point left = state.loads[i].cast<double>() - static_cast<double>(p.mass[i]) * a;
        forces.segment<2>(2 * static_cast<Eigen::Index>(k - c.first)) = turned(back, left);
    }
}

}  // namespace

void noteLoads(State& state) {
    if (state.work.watchedClusters.empty()) return;
    state.loads.assign(state.particles.size(), Vec2(0, 0));
    const Particles& p = state.particles;
    for (const auto index : state.work.watchedClusters) {
        const Cluster& c = state.clusters.list[index];
        for (auto k = c.first; k < c.last; ++k) {
            const auto i = state.clusters.members[k];
            state.loads[i] = p.force[i].cast<Real>() + p.mass[i] * state.settings.gravity;
        }
    }
}

void recoverLoads(State& state) {
    if (state.work.watchedClusters.empty()) return;
    loadByContacts(state);
    loadByJoints(state);
    loadByAngles(state);
    loadByAttachments(state);
    loadByGrabs(state);
    std::pmr::vector<double> memory(&state.arena);
    for (const auto index : state.work.watchedClusters) {
        Cluster& c = state.clusters.list[index];
        if (!c.truss) c.truss = std::make_shared<const Truss>(state, c);
        const std::size_t size = 2 * (c.last - c.first);
        if (memory.size() < 2 * size) memory.resize(2 * size);
        MappedVector forces(memory.data(), static_cast<Eigen::Index>(size));
        MappedVector x(memory.data() + size, static_cast<Eigen::Index>(size));
        balanceForces(state, c, forces);
        c.truss->solve(forces, x, [&](JointId joint, double tension) {
            state.joints.force[state.jointSlots.dense(joint)] = static_cast<Real>(tension);
        });
    }
}

}  // namespace sulfur::detail
