// How each angular joint is solved, derived from stiffness, masses, lengths and the tick.
//
// Its stiffness is a matrix k y y^T of rank one, where y has the slopes of the angle times the
// roots of the inverse masses. As for lengths, the sum of all that are forces is bounded by
// Gershgorin's circles: for each mover p, the sum of h^2 k |y_p| (|y_a| + |y_b| + |y_c|) over its
// joints. What springs at the same particles have of the limit is theirs.
//
// Links of ropes may move in shorter steps than these forces are found in. They are those of the
// middle of a step (solver/angles.cpp), and so stable up to the same load.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/settings.hpp"
#include "joints/classify.hpp"

namespace sulfur::detail {

namespace {

/// What an angular joint turns: a particle or a rigid component, which is known by its first
/// member, and the size of its slope in 1/(m sqrt(kg)).
struct TurnedPart {
    std::uint32_t mover = none;
    double size = 0;
};
using TurnedParts = std::array<TurnedPart, 3>;

std::uint32_t moverOf(const State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    if (cluster == none) return particle;
    return state.clusters.members[state.clusters.list[cluster].first];
}

/// The lengths of both arms in the blueprint: what was bent or stretched by hand is solved as it
/// was meant.
std::array<double, 2> armsOf(const State& state, std::uint32_t i) {
    const Angles& angles = state.angles;
    const auto& rest = state.particles.rest;
    const auto place = [&](std::uint32_t particle) { return rest[particle].cast<double>().eval(); };
    const Point corner = place(angles.b[i]);
    return {(corner - place(angles.a[i])).norm(), (place(angles.c[i]) - corner).norm()};
}

/// Of a rigid component that is pushed by `force` and turned by `turning` for one rad.
double sizeOf(const Cluster& c, double force, double turning) {
    return std::sqrt(c.freeInverseMass * force * force + c.freeInverseInertia * turning * turning);
}

/// Slopes are at most those of a straight or folded angle, levers those of the arms to the members.
TurnedParts partsOf(const State& state, std::uint32_t i) {
    const Angles& angles = state.angles;
    const auto arms = armsOf(state, i);
    const std::array<std::uint32_t, 3> particles{angles.a[i], angles.b[i], angles.c[i]};
    const std::array<double, 3> slope{1 / arms[0], 1 / arms[0] + 1 / arms[1], 1 / arms[1]};
    const auto clusterOf = [&](std::size_t k) { return state.particles.cluster[particles[k]]; };
    const auto lever = [&](std::size_t k) {
        return static_cast<double>(state.particles.arm[particles[k]].norm());
    };
    TurnedParts parts;
    for (std::size_t k = 0; k < 3; ++k) {
        parts[k].mover = moverOf(state, particles[k]);
        const auto cluster = clusterOf(k);
        if (cluster == none) {
            const double w = static_cast<double>(inverseMassAwake(state, particles[k]));
            parts[k].size = slope[k] * std::sqrt(w);
            continue;
        }
        parts[k].size = sizeOf(state.clusters.list[cluster], slope[k], lever(k) * slope[k]);
    }
    // Two of one component push it as the third does the other way, and turn it by what is left.
    const auto unite = [&](std::size_t k, std::size_t l, double turning) {
        if (clusterOf(k) == none || clusterOf(k) != clusterOf(l)) return;
        parts[k].size = sizeOf(state.clusters.list[clusterOf(k)], slope[3 - k - l], turning);
        parts[l] = {};
    };
    unite(1, 0, 1 + lever(1) * slope[2]);
    unite(1, 2, 1 + lever(1) * slope[0]);
    unite(0, 2, lever(0) * slope[0] + lever(2) * slope[2]);
    return parts;
}

struct AngularLoad {
    double stiffness = 0;  // h^2 K
    double damping = 0;    // h B
};

bool isHeld(const State& state, std::uint32_t i) {
    const Angles& angles = state.angles;
    if (state.bodies[angles.body[i]].gone > 0) return true;
    const auto& cluster = state.particles.cluster;
    const auto c = cluster[angles.b[i]];
    return c != none && cluster[angles.a[i]] == c && cluster[angles.c[i]] == c;
}

/// Whether both arms keep their length. Others may shorten, where the angle is steeper.
bool hasRigidArms(const State& state, std::uint32_t i) {
    const Angles& angles = state.angles;
    const auto isRigid = [&](JointId arm, std::uint32_t end) {
        if (state.jointSlots.contains(arm))
            return state.joints.stiffness[state.jointSlots.dense(arm)] == infinite;
        const auto cluster = state.particles.cluster[end];
        return cluster != none && cluster == state.particles.cluster[angles.b[i]];
    };
    return isRigid(angles.before[i], angles.a[i]) && isRigid(angles.after[i], angles.c[i]);
}

class AngleClassifier {
public:
    AngleClassifier(State& state, const Counts& before)
        : state_(state),
          before_(before),
          first_(anglesOf(state, before.bodies).first),
          loads_(state.particles.size() - before.particles),
          taken_(state.particles.size() - before.particles, 0) {}

    void run() {
        addSprings();
        for (auto i = first_; i < state_.angles.size(); ++i) addLoads(i);
        for (auto i = first_; i < state_.angles.size(); ++i) classify(i);
    }

private:
    double step() const { return static_cast<double>(state_.h); }

    /// What springs and dampers that are forces have of the limit.
    void addSprings() {
        const Joints& joints = state_.joints;
        for (auto j = before_.joints; j < joints.size(); ++j) {
            const double w = static_cast<double>(inverseMassAwake(state_, joints.a[j])) +
                             static_cast<double>(inverseMassAwake(state_, joints.b[j]));
            const double load = w * step() *
                                (step() * static_cast<double>(joints.explicitStiffness[j]) +
                                 2 * static_cast<double>(joints.explicitDamping[j]));
            for (const auto p : {joints.a[j], joints.b[j]}) taken_[p - before_.particles] += load;
        }
    }

    void addLoads(std::uint32_t i) {
        if (isHeld(state_, i) || state_.angles.drive[i]) return;
        const TurnedParts parts = partsOf(state_, i);
        const double sum = parts[0].size + parts[1].size + parts[2].size;
        const double steepened = hasRigidArms(state_, i) ? 1 : tuned::mostSteepened;
        for (const TurnedPart& part : parts) {
            if (part.mover == none) continue;
            AngularLoad& load = loads_[part.mover - before_.particles];
            const double each = steepened * step() * part.size * sum;
            load.stiffness += step() * each * static_cast<double>(state_.angles.stiffness[i]);
            load.damping += each * static_cast<double>(state_.angles.damping[i]);
        }
    }

    /// What is left of the limit at a joint's particles.
    double roomAt(std::uint32_t i) const {
        const Angles& angles = state_.angles;
        double most = 0;
        for (const auto p : {angles.a[i], angles.b[i], angles.c[i]})
            most = std::max(most, taken_[p - before_.particles]);
        return tuned::forceLimit - most;
    }

    void classify(std::uint32_t i) {
        Angles& angles = state_.angles;
        angles.explicitStiffness[i] = angles.explicitDamping[i] = 0;
        angles.kind[i] = AngleKind::held;
        if (isHeld(state_, i)) return;
        if (angles.drive[i]) {
            angles.kind[i] = AngleKind::driven;
            return;
        }
        const auto arms = armsOf(state_, i);
        angles.armBefore[i] = static_cast<Real>(arms[0]);
        angles.armAfter[i] = static_cast<Real>(arms[1]);
        shareOut(i);
        const bool whole = angles.explicitStiffness[i] == angles.stiffness[i] &&
                           angles.explicitDamping[i] == angles.damping[i];
        angles.kind[i] = whole ? AngleKind::explicitElastic : AngleKind::implicitElastic;
    }

    /// As at springs of lattices, all limits in the share of the room that is left.
    void shareOut(std::uint32_t i) {
        Angles& angles = state_.angles;
        const double room = roomAt(i), scale = room / tuned::forceLimit;
        if (!(scale > 0)) return;
        double stiffest = 0, most = 0, used = 0;
        for (const TurnedPart& part : partsOf(state_, i)) {
            if (part.mover == none) continue;
            const AngularLoad& load = loads_[part.mover - before_.particles];
            stiffest = std::max(stiffest, load.stiffness);
            most = std::max(most, load.damping);
            used = std::max(used, asForces(load.stiffness, scale));
        }
        used = std::max(used, asForces(stiffest, scale));
        const double left =
            (room - used) / 2 * std::max(0.0, 1 - most / (tuned::stiffLimit * scale));
        angles.explicitStiffness[i] = angles.stiffness[i];
        angles.explicitDamping[i] = angles.damping[i];
        if (stiffest > tuned::softLimit * scale)
            angles.explicitStiffness[i] *= static_cast<Real>(asForces(stiffest, scale) / stiffest);
        if (most > left) angles.explicitDamping[i] *= static_cast<Real>(left / most);
    }

    /// Real holds no load of arms that are next to nothing.
    static double asForces(double load, double scale) {
        const double most = std::min(load / scale, 1e30);
        return scale * static_cast<double>(explicitLoad(static_cast<Real>(most)));
    }

    State& state_;
    Counts before_;
    std::uint32_t first_;
    std::vector<AngularLoad> loads_;  // of each particle that was not there before
    std::vector<double> taken_;
};

}  // namespace

void classifyAngles(State& state, const Counts& before) {
    if (state.angles.size() > 0) AngleClassifier(state, before).run();
}

}  // namespace sulfur::detail
