#include "solver/impacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

constexpr int bisections = 10;

double square(double x) {
    return x * x;
}

enum Trait : std::uint8_t { fast = 1, anchored = 2, driven = 4 };

enum class Role : std::uint8_t { still, moved, kinematic };

Role roleOf(const BodyRecord& body) {
    if (body.kind == BodyKind::kinematic) return Role::kinematic;
    const bool moves = body.kind == BodyKind::dynamic && !body.asleep;
    return moves ? Role::moved : Role::still;
}

/// Where chains that move by themselves were led without contacts.
Vec2 predictedDisplacement(const State& state, std::uint32_t i) {
    const auto tree = state.trees.ofParticle[i];
    if (tree != none && state.trees.list[tree].alone && state.trees.touched[tree] != 0)
        return state.trees.predicted[state.trees.nodeOfParticle[i]];
    return (static_cast<double>(state.h) * state.particles.velocity[i]).cast<Real>();
}

/// Holds scratch memory only.
class Impacts {
public:
    /// After the displacements are found: finds the groups and limits displacements.
    void limitDisplacements(State& state);
    /// After rebounds: limits velocities in the groups that were found.
    void limitVelocities(State& state) const;

private:
    /// A rigid component or a particle that moves by itself.
    struct Part {
        std::uint32_t cluster = none, particle = none;
        double mass = 0, inertia = 0;
        Point centre{0, 0};        // m, at the start of the tick
        Point displacement{0, 0};  // m, as the constraints left it
        double angle = 0;          // rad, the same
        // The velocity after the tick is that of the displacement and this.
        Point offset{0, 0};  // m/s
        double spinOffset = 0;
    };
    struct Group {
        std::uint32_t firstPart = 0, lastPart = 0;
        std::uint32_t firstBody = 0, lastBody = 0;  // of bodies_
        bool anchored = false;                      // it leans on something that does not move
        double allowed = 0;                         // J
    };
    /// Velocities or displacements of a part or, as one rigid body, of a group.
    struct Motion {
        Point centre{0, 0};
        Point linear{0, 0};
        double angular = 0;

        Point at(const Point& place) const {
            const Point r = place - centre;
            return linear + angular * Point(-r[1], r[0]);
        }
    };

    bool findGroups(const State& state);
    void unite(const State& state);
    void gatherBodies();
    template <class Visit>
    void forEachHit(Visit&& visit);
    void addParts(const State& state, Group& group);
    template <class MotionOf>
    Motion rigidMotion(const Group& group, MotionOf&& motionOf) const;
    void scale(State& state, const Group& group, const Motion& common, double share) const;
    double energyOfDisplacements(const State& state, const Group& group) const;
    double energyBefore(const State& state, const Group& group);
    void takeBackForces(const State& state, const Group& group);
    template <class Visit>
    void forEachSpring(const State& state, const Group& group, Visit&& visit) const;
    template <class PlaceOf, class VelocityOf>
    double elasticEnergy(const State& state, const Group& group, PlaceOf&& placeOf,
                         VelocityOf&& velocityOf) const;

    std::vector<Group> groups_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> bodies_;
    std::vector<std::uint32_t> groupOf_;  // of the first body of each set
    std::vector<Point> before_;           // m/s, by particle; of those that were asked for
    std::vector<Role> roles_;             // of bodies
    std::vector<std::uint8_t> traits_;    // of bodies; of the first of each set, those of all
    DisjointSets sets_;
    std::vector<std::uint32_t> leader_;  // of bodies, the first of their sets
};

void Impacts::unite(const State& state) {
    sets_.reset(state.bodies.size());
    traits_.assign(state.bodies.size(), 0);
    roles_.resize(state.bodies.size());
    std::transform(state.bodies.begin(), state.bodies.end(), roles_.begin(), roleOf);
    const auto lean = [&](std::uint32_t body, std::uint32_t other) {
        if (roles_[other] != Role::moved)
            traits_[body] |= roles_[other] == Role::kinematic ? driven : anchored;
    };
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        if (roles_[a] == Role::moved && roles_[b] == Role::moved) {
            sets_.unite(a, b);
            return;
        }
        lean(a, b);
        lean(b, a);
    };
    std::uint32_t lastA = none, lastB = none;  // bodies mostly touch at more than one point
    for (const Contact& c : state.contacts) {
        if (c.normalLambda <= 0) continue;
        std::uint8_t trait = c.fast ? fast : 0;
        if (c.conveyed != 0) trait |= driven;
        traits_[c.bodyA] |= trait;
        traits_[c.bodyB] |= trait;
        if (c.bodyA == lastA && c.bodyB == lastB) continue;
        join(lastA = c.bodyA, lastB = c.bodyB);
    }
    const auto& bodyOf = state.particles.body;
    for (const Attachment& a : state.attachments)
        for (std::uint32_t k = 0; k < a.count; ++k) join(bodyOf[a.particle], bodyOf[a.support[k]]);
    for (const Grab& grab : state.influences.grabs)
        for (std::uint32_t k = 0; k < grab.count; ++k)
            traits_[bodyOf[state.particleSlots.dense(grab.support[k])]] |= driven;
    leader_.resize(state.bodies.size());
    for (std::uint32_t i = 0; i < leader_.size(); ++i) {
        leader_[i] = sets_.find(i);
        traits_[leader_[i]] |= traits_[i];
    }
}

/// Calls visit(body, the first of its set) for all in sets that something fast has hit and nothing
/// drives.
template <class Visit>
void Impacts::forEachHit(Visit&& visit) {
    for (std::uint32_t i = 0; i < roles_.size(); ++i) {
        if (roles_[i] != Role::moved) continue;
        const auto first = leader_[i];
        if ((traits_[first] & fast) != 0 && (traits_[first] & driven) == 0) visit(i, first);
    }
}

/// The bodies of each group one after the other: groups in the order of their first bodies. (Those
/// are the smallest of their sets, so that they come first here too.)
void Impacts::gatherBodies() {
    groupOf_.resize(roles_.size());
    forEachHit([&](std::uint32_t body, std::uint32_t first) {
        if (body == first) {
            groupOf_[body] = static_cast<std::uint32_t>(groups_.size());
            groups_.emplace_back();
            groups_.back().anchored = (traits_[body] & anchored) != 0;
        }
        ++groups_[groupOf_[first]].lastBody;  // only counted so far
    });
    std::uint32_t next = 0;
    for (Group& group : groups_) {
        group.firstBody = next;
        next += std::exchange(group.lastBody, next);
    }
    bodies_.resize(next);
    forEachHit([&](std::uint32_t body, std::uint32_t first) {
        bodies_[groups_[groupOf_[first]].lastBody++] = body;
    });
}

bool Impacts::findGroups(const State& state) {
    groups_.clear();
    parts_.clear();
    const auto isFast = [](const Contact& c) { return c.fast && c.normalLambda > 0; };
    if (std::none_of(state.contacts.begin(), state.contacts.end(), isFast)) return false;
    unite(state);
    gatherBodies();
    for (Group& group : groups_) addParts(state, group);
    return true;
}

void Impacts::addParts(const State& state, Group& group) {
    const Particles& p = state.particles;
    const double h = static_cast<double>(state.h);
    group.firstPart = static_cast<std::uint32_t>(parts_.size());
    for (auto k = group.firstBody; k < group.lastBody; ++k) {
        const BodyRecord& body = state.bodies[bodies_[k]];
        for (auto i = body.firstParticle; i < body.firstParticle + body.particles.size(); ++i) {
            Part part;
            if (p.inverseMass[i] == 0 && p.cluster[i] == none) {
                group.anchored = true;
                continue;
            }
            if (p.cluster[i] == none) {
                part.particle = i;
                part.mass = static_cast<double>(p.mass[i]);
                part.centre = p.position[i];
                part.displacement = p.displacement[i].cast<double>();
                part.offset = p.velocity[i] - predictedDisplacement(state, i).cast<double>() / h;
            } else {
                const Cluster& c = state.clusters.list[p.cluster[i]];
                if (state.clusters.members[c.first] != i) continue;
                if (c.inverseMass == 0) group.anchored = true;
                part.cluster = p.cluster[i];
                part.mass = c.inverseMass > 0 ? c.mass : 0;
                part.inertia = c.inverseInertia > 0 ? 1 / static_cast<double>(c.inverseInertia) : 0;
                part.centre = c.centre;
                part.displacement = c.displacement.cast<double>();
                part.angle = c.angle;
                part.offset = c.velocity - c.predicted.cast<double>() / h;
                part.spinOffset = c.spin - c.predictedAngle / h;
                // Members stand in their order: past all of them, if they are neighbours.
                const auto others = c.last - c.first - 1;
                if (state.clusters.members[c.last - 1] == i + others) i += others;
            }
            parts_.push_back(part);
        }
    }
    group.lastPart = static_cast<std::uint32_t>(parts_.size());
}

/// What momentum and angular momentum demand; nothing where something that does not move takes up
/// both.
template <class MotionOf>
Impacts::Motion Impacts::rigidMotion(const Group& group, MotionOf&& motionOf) const {
    Motion common;
    if (group.anchored) return common;
    double mass = 0, inertia = 0, angular = 0;
    Point momentum(0, 0), moment(0, 0);
    const Point origin = parts_[group.firstPart].centre;
    for (auto i = group.firstPart; i < group.lastPart; ++i) {
        const Part& part = parts_[i];
        mass += part.mass;
        moment += part.mass * (part.centre - origin);
        momentum += part.mass * motionOf(part).linear;
    }
    common.centre = origin + moment / mass;
    common.linear = momentum / mass;
    for (auto i = group.firstPart; i < group.lastPart; ++i) {
        const Part& part = parts_[i];
        const Motion m = motionOf(part);
        const Point r = part.centre - common.centre;
        inertia += part.mass * r.squaredNorm() + part.inertia;
        angular += part.mass * cross(r, m.linear) + part.inertia * m.angular;
    }
    if (inertia > 0) common.angular = angular / inertia;
    return common;
}

/// Gives the group its common displacement and this share of the rest.
void Impacts::scale(State& state, const Group& group, const Motion& common, double share) const {
    for (auto i = group.firstPart; i < group.lastPart; ++i) {
        const Part& part = parts_[i];
        const Point rigid = common.at(part.centre);
        const Vec2 displacement = (rigid + share * (part.displacement - rigid)).cast<Real>();
        if (part.cluster == none) {
            state.particles.displacement[part.particle] = displacement;
            continue;
        }
        Cluster& c = state.clusters.list[part.cluster];
        c.displacement = displacement;
        c.angle = common.angular + share * (part.angle - common.angular);
        updateTurn(c);
    }
}

/// Calls visit(joint) for all joints of the group that are not rigid.
template <class Visit>
void Impacts::forEachSpring(const State& state, const Group& group, Visit&& visit) const {
    const auto& start = state.work.springStart;
    for (auto k = group.firstBody; k < group.lastBody; ++k)
        for (auto s = start[bodies_[k]]; s < start[bodies_[k] + 1]; ++s)
            visit(state.work.springs[s]);
}

/// What the springs hold in a tick: the part that acts as a force in the tick's middle, where the
/// velocities stand and where leapfrog keeps energy; the rest at most in the middle or at the end.
template <class PlaceOf, class VelocityOf>
double Impacts::elasticEnergy(const State& state, const Group& group, PlaceOf&& placeOf,
                              VelocityOf&& velocityOf) const {
    const Joints& joints = state.joints;
    const double half = static_cast<double>(state.h) / 2;
    double sum = 0;
    forEachSpring(state, group, [&](std::uint32_t j) {
        const auto a = joints.a[j], b = joints.b[j];
        const Point end = placeOf(b) - placeOf(a);
        const Point middle = end - half * (velocityOf(b) - velocityOf(a));
        const double rest = static_cast<double>(joints.restLength[j]);
        const double whole = static_cast<double>(joints.stiffness[j]);
        const double force = static_cast<double>(joints.explicitStiffness[j]);
        const double inMiddle = square(middle.norm() - rest);
        const double most = std::max(inMiddle, square(end.norm() - rest));
        sum += (force * inMiddle + (whole - force) * most) / 2;
    });
    return sum;
}

double Impacts::energyOfDisplacements(const State& state, const Group& group) const {
    const double h = static_cast<double>(state.h);
    double sum = 0;
    for (auto i = group.firstPart; i < group.lastPart; ++i) {
        const Part& part = parts_[i];
        Point moved;
        double angle = 0;
        if (part.cluster == none) {
            moved = state.particles.displacement[part.particle].cast<double>();
        } else {
            moved = state.clusters.list[part.cluster].displacement.cast<double>();
            angle = state.clusters.list[part.cluster].angle;
        }
        const double spin = part.spinOffset + angle / h;
        sum += part.mass * (part.offset + moved / h).squaredNorm() / 2 +
               part.inertia * spin * spin / 2;
    }
    const auto moved = [&](std::uint32_t i) {
        return Point(displacementOf(state, gripOf(state, i)).cast<double>());
    };
    return sum + elasticEnergy(
                     state, group,
                     [&](std::uint32_t i) { return Point(state.particles.position[i] + moved(i)); },
                     [&](std::uint32_t i) { return Point(moved(i) / h); });
}

/// Leaves in before_ the velocities in the middle of the tick before, of the group's particles that
/// move by themselves or hang on springs: the predicted ones without what explicit springs have
/// added to them.
void Impacts::takeBackForces(const State& state, const Group& group) {
    const Particles& p = state.particles;
    const Joints& joints = state.joints;
    before_.resize(p.size());
    for (auto i = group.firstPart; i < group.lastPart; ++i)
        if (const auto particle = parts_[i].particle; particle != none)
            before_[particle] = p.velocity[particle];
    forEachSpring(state, group, [&](std::uint32_t j) {
        for (const auto end : {joints.a[j], joints.b[j]}) before_[end] = p.velocity[end];
    });
    forEachSpring(state, group, [&](std::uint32_t j) {
        const auto a = joints.a[j], b = joints.b[j];
        const Point apart = p.position[b] - p.position[a];
        const double length = apart.norm();
        if (joints.explicitStiffness[j] == 0 || length == 0) return;
        const double stretch = length - static_cast<double>(joints.restLength[j]);
        const Point impulse =
            static_cast<double>(state.h * joints.explicitStiffness[j]) * stretch / length * apart;
        if (p.cluster[a] == none) before_[a] -= static_cast<double>(p.inverseMass[a]) * impulse;
        if (p.cluster[b] == none) before_[b] += static_cast<double>(p.inverseMass[b]) * impulse;
    });
}

/// The energy in the middle of the tick before, where its velocities stood, but for the work of
/// gravity and fields since then.
double Impacts::energyBefore(const State& state, const Group& group) {
    takeBackForces(state, group);
    double sum = 0;
    for (auto i = group.firstPart; i < group.lastPart; ++i) {
        const Part& part = parts_[i];
        if (part.cluster == none) {
            sum += part.mass * before_[part.particle].squaredNorm() / 2;
            continue;
        }
        const Cluster& c = state.clusters.list[part.cluster];
        sum += part.mass * c.velocity.squaredNorm() / 2 + part.inertia * c.spin * c.spin / 2;
    }
    return sum + elasticEnergy(
                     state, group, [&](std::uint32_t i) { return state.particles.position[i]; },
                     [&](std::uint32_t i) { return before_[i]; });
}

void Impacts::limitDisplacements(State& state) {
    if (!findGroups(state)) return;
    for (Group& group : groups_) {
        group.allowed = energyBefore(state, group);
        if (!(energyOfDisplacements(state, group) > group.allowed)) continue;
        const Motion common = rigidMotion(group, [](const Part& part) {
            return Motion{{}, part.displacement, part.angle};
        });
        double low = 0, high = 1;
        for (int i = 0; i < bisections; ++i) {
            const double share = (low + high) / 2;
            scale(state, group, common, share);
            (energyOfDisplacements(state, group) > group.allowed ? high : low) = share;
        }
        scale(state, group, common, low);
    }
}

void Impacts::limitVelocities(State& state) const {
    const auto velocityOf = [&](const Part& part) {
        if (part.cluster == none) return Motion{{}, state.particles.velocity[part.particle], 0};
        const Cluster& c = state.clusters.list[part.cluster];
        return Motion{{}, c.velocity, c.spin};
    };
    for (const Group& group : groups_) {
        const Motion common = rigidMotion(group, velocityOf);
        double rigid = 0, rest = 0;
        for (auto i = group.firstPart; i < group.lastPart; ++i) {
            const Part& part = parts_[i];
            const Motion m = velocityOf(part);
            const Point together = common.at(part.centre);
            rigid += part.mass * together.squaredNorm() / 2 +
                     part.inertia * common.angular * common.angular / 2;
            const double spin = m.angular - common.angular;
            rest += part.mass * (m.linear - together).squaredNorm() / 2 +
                    part.inertia * spin * spin / 2;
        }
        const double elastic = elasticEnergy(
            state, group,
            [&](std::uint32_t i) {
                const Vec2 moved = displacementOf(state, gripOf(state, i));
                return Point(state.particles.position[i] + moved.cast<double>());
            },
            [&](std::uint32_t i) {
                return Point(detail::velocityOf(state, gripOf(state, i)).cast<double>());
            });
        const double left = group.allowed - elastic - rigid;
        if (!(rest > left) || rest <= 0) continue;
        const double share = std::sqrt(std::max(left, 0.0) / rest);
        for (auto i = group.firstPart; i < group.lastPart; ++i) {
            const Part& part = parts_[i];
            const Point together = common.at(part.centre);
            if (part.cluster == none) {
                Point& v = state.particles.velocity[part.particle];
                v = together + share * (v - together);
                continue;
            }
            Cluster& c = state.clusters.list[part.cluster];
            c.velocity = together + share * (c.velocity - together);
            c.spin = common.angular + share * (c.spin - common.angular);
        }
    }
}

Impacts& impacts() {
    thread_local Impacts scratch;
    return scratch;
}

}  // namespace

void limitImpacts(State& state) {
    impacts().limitDisplacements(state);
}

void limitRebounds(State& state) {
    impacts().limitVelocities(state);
}

}  // namespace sulfur::detail
