// How each joint is solved, derived from stiffness, masses and the tick.
#include <algorithm>

#include "core/settings.hpp"
#include "joints/classify.hpp"

namespace sulfur::detail {

namespace {

/// A network of springs and dampers that are forces is stable with NSV while
/// h^2 K + 2 h B < 4, where the highest eigenvalue is bounded by Gershgorin's circles: for each
/// particle, the sums over its joints of k (w_i + w_j) and b (w_i + w_j). The explicit parts below
/// never go beyond 3, of which springs have up to 2.
struct Load {
    Real stiffness = 0;  // h^2 K
    Real damping = 0;    // h B
};

/// Where the explicit part of a spring begins to lag behind the whole, and the most that springs
/// and dampers are as forces together.
constexpr Real softLimit = Real(tuned::softLimit), forceLimit = Real(tuned::forceLimit);
/// Beyond, a joint is no force at all any more.
constexpr Real stiffLimit = Real(tuned::stiffLimit);

}  // namespace

Real explicitLoad(Real x) {
    if (x <= softLimit) return x;
    const Real beyond = (x - softLimit) / softLimit;
    return softLimit * (1 + beyond / (1 + beyond)) *
           std::max<Real>(0, 1 - x / (stiffLimit * softLimit));
}

namespace {

/// Of a joint between particles of such loads, the shares that are forces.
struct Shares {
    Real stiffness = 1, damping = 1;
};
Shares explicitShares(const Load& a, const Load& b, bool braced) {
    const Real stiffest = std::max(a.stiffness, b.stiffness);
    const Real most = std::max(a.damping, b.damping);
    const Real used =
        std::max({explicitLoad(stiffest), explicitLoad(a.stiffness), explicitLoad(b.stiffness)});
    const Real limit = braced ? (forceLimit - used) / 2 : Real(tuned::dampedLimit);
    const Real room = limit * std::max<Real>(0, 1 - most / stiffLimit);
    Shares s;
    if (stiffest > softLimit) s.stiffness = explicitLoad(stiffest) / stiffest;
    if (most > room) s.damping = room / most;
    return s;
}

/// What a push on a particle moves: a rigid component answers with its effective mass there, in
/// the direction in which it is least.
Real mobility(const State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    if (cluster == none) return inverseMassAwake(state, particle);
    const Cluster& c = state.clusters.list[cluster];
    return static_cast<Real>(c.freeInverseMass +
                             c.freeInverseInertia *
                                 static_cast<double>(state.particles.arm[particle].squaredNorm()));
}

}  // namespace

Real inverseMassAwake(const State& state, std::uint32_t particle) {
    const bool moves = state.bodies[state.particles.body[particle]].kind == BodyKind::dynamic &&
                       state.particles.pinned[particle] == 0;
    return moves ? 1 / state.particles.mass[particle] : 0;
}

namespace {

/// Links of ropes and trees may move in shorter steps than the forces of the springs that pull on
/// them are found in. A force that is held for steps of its own feeds the spring: a light link
/// between a rope and a weight on a spring would swing ever faster. So such springs are forces only
/// while they are much softer.
constexpr Real weightOfLinks = Real(tuned::weightOfLinks);

/// Of each particle that was not there `before`, as all that follows.
std::vector<Real> weightsOf(const State& state, const Counts& before) {
    const Joints& joints = state.joints;
    std::vector<Real> weights(state.particles.size() - before.particles, 1);
    for (auto j = before.joints; j < joints.size(); ++j)
        if (isRigid(joints, j))
            for (const auto p : {joints.a[j], joints.b[j]})
                if (state.particles.cluster[p] == none)
                    weights[p - before.particles] = weightOfLinks;
    return weights;
}

std::vector<Load> loadsOf(const State& state, const Counts& before) {
    const Joints& joints = state.joints;
    const Real h = state.h;
    const std::vector<Real> weight = weightsOf(state, before);
    std::vector<Real> w(weight.size());
    for (std::uint32_t i = 0; i < w.size(); ++i) w[i] = mobility(state, before.particles + i);
    std::vector<Load> load(weight.size());
    for (auto j = before.joints; j < joints.size(); ++j) {
        if (isRigid(joints, j)) continue;
        const auto a = joints.a[j] - before.particles, b = joints.b[j] - before.particles;
        const Real sum = w[a] + w[b];
        for (const auto p : {a, b}) {
            load[p].stiffness += weight[p] * h * h * joints.stiffness[j] * sum;
            load[p].damping += h * joints.damping[j] * sum;
        }
    }
    return load;
}

}  // namespace

void classifyJoints(State& state, const Counts& before) {
    Joints& joints = state.joints;
    const std::vector<Load> load = loadsOf(state, before);
    for (auto j = before.joints; j < joints.size(); ++j) {
        const Load &a = load[joints.a[j] - before.particles],
                   &b = load[joints.b[j] - before.particles];
        const Shares share = explicitShares(a, b, joints.braced[j] != 0);
        joints.explicitStiffness[j] =
            isRigid(joints, j) ? 0 : share.stiffness * joints.stiffness[j];
        joints.explicitDamping[j] = isRigid(joints, j) ? 0 : share.damping * joints.damping[j];
        if (isRigid(joints, j))
            joints.kind[j] = JointKind::rigid;
        else if (joints.explicitStiffness[j] == joints.stiffness[j] &&
                 joints.explicitDamping[j] == joints.damping[j])
            joints.kind[j] = JointKind::explicitElastic;
        else
            joints.kind[j] = JointKind::implicitElastic;
    }
}

void updateReach(State& state, const Counts& before) {
    Particles& particles = state.particles;
    std::copy(particles.radius.begin() + before.particles, particles.radius.end(),
              particles.reach.begin() + before.particles);
    auto& surface = state.surface;
    surface.resize(before.particles);
    surface.resize(particles.size(), none);
    const Joints& joints = state.joints;
    for (auto j = before.joints; j < joints.size(); ++j)
        for (const auto p : {joints.a[j], joints.b[j]}) {
            if (joints.radius[j] <= particles.reach[p]) continue;
            particles.reach[p] = joints.radius[j];
            surface[p] = j;
        }
}

}  // namespace sulfur::detail
