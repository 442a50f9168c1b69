// How each joint is solved, derived from stiffness, masses and the tick.
#include <algorithm>

#include "core/settings.hpp"
#include "joints/classify.hpp"

namespace sulfur::detail {

namespace {

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
Shares explicitShares(const JointLoad& a, const JointLoad& b, bool braced) {
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

}  // namespace

Real mobility(const State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    if (cluster == none) return inverseMassAwake(state, particle);
    const Cluster& c = state.clusters.list[cluster];
    return static_cast<Real>(c.freeInverseMass +
                             c.freeInverseInertia *
                                 static_cast<double>(state.particles.arm[particle].squaredNorm()));
}

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

}  // namespace

Real weightOfSprings(const State& state, std::uint32_t particle, bool isLink) {
    return isLink && state.particles.cluster[particle] == none ? weightOfLinks : 1;
}

void addLoad(JointLoad& load, const Spring& spring, Real weight, Real mobilities, Real h) {
    load.stiffness += weight * h * h * spring.stiffness * mobilities;
    load.damping += h * spring.damping * mobilities;
}

HowSolved howSolved(const State& state, std::uint32_t j, const Spring& spring, const JointLoad& a,
                    const JointLoad& b) {
    if (isRigid(state.joints, j)) return {0, 0, JointKind::rigid};
    const Shares share = explicitShares(a, b, state.joints.braced[j] != 0);
    HowSolved how{share.stiffness * spring.stiffness, share.damping * spring.damping};
    const bool whole = how.stiffness == spring.stiffness && how.damping == spring.damping;
    how.kind = whole ? JointKind::explicitElastic : JointKind::implicitElastic;
    return how;
}

namespace {

/// Of each particle that was not there `before`, as all that follows.
std::vector<Real> weightsOf(const State& state, const Counts& before) {
    const Joints& joints = state.joints;
    std::vector<Real> weights(state.particles.size() - before.particles, 1);
    for (auto j = before.joints; j < joints.size(); ++j)
        if (isRigid(joints, j))
            for (const auto p : {joints.a[j], joints.b[j]})
                weights[p - before.particles] = weightOfSprings(state, p, true);
    return weights;
}

std::vector<JointLoad> loadsOf(const State& state, const Counts& before) {
    const Joints& joints = state.joints;
    const std::vector<Real> weight = weightsOf(state, before);
    std::vector<Real> w(weight.size());
    for (std::uint32_t i = 0; i < w.size(); ++i) w[i] = mobility(state, before.particles + i);
    std::vector<JointLoad> load(weight.size());
    for (auto j = before.joints; j < joints.size(); ++j) {
        if (isRigid(joints, j)) continue;
        const auto a = joints.a[j] - before.particles, b = joints.b[j] - before.particles;
        for (const auto p : {a, b})
            addLoad(load[p], springOf(joints, j), weight[p], w[a] + w[b], state.h);
    }
    return load;
}

}  // namespace

void classifyJoints(State& state, const Counts& before) {
    Joints& joints = state.joints;
    const std::vector<JointLoad> load = loadsOf(state, before);
    for (auto j = before.joints; j < joints.size(); ++j) {
        const HowSolved how =
            howSolved(state, j, springOf(joints, j), load[joints.a[j] - before.particles],
                      load[joints.b[j] - before.particles]);
        joints.explicitStiffness[j] = how.stiffness;
        joints.explicitDamping[j] = how.damping;
        joints.kind[j] = how.kind;
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
