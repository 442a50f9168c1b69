#include "solver/coordinates.hpp"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.hpp"
#include "rigid/grip.hpp"
#include "solver/rails.hpp"

namespace sulfur::detail {

namespace {

constexpr double nothing = 1e-12;  // m: what has no direction

/// Adds a slope (per metre) of a place of one particle.
void add(const State& state, std::uint32_t particle, const Point& slope, CoordinateSlopes& to) {
    const Grip grip = gripOf(state, particle);
    const auto isSame = [&](const TurnedMover& m) {
        return grip.cluster != none ? m.cluster == grip.cluster : m.particle == particle;
    };
    auto* mover = std::find_if(to.begin(), to.end(), isSame);
    if (mover == to.end()) {
        ++to.count;
        *mover = {};
        if (grip.cluster == none) {
            mover->particle = particle;
            mover->inverseMass = static_cast<double>(state.particles.inverseMass[particle]);
        } else {
            const Cluster& c = state.clusters.list[grip.cluster];
            mover->cluster = grip.cluster;
            mover->inverseMass = static_cast<double>(c.inverseMass);
            mover->inverseInertia = static_cast<double>(c.inverseInertia);
        }
    }
    mover->force += slope;
    if (grip.cluster != none) mover->turning += cross(grip.arm.cast<double>(), slope);
}

/// Adds a slope of an angle of a whole rigid component.
void addTurning(const State& state, std::uint32_t particle, double slope, CoordinateSlopes& to) {
    add(state, particle, Point(0, 0), to);
    const auto cluster = state.particles.cluster[particle];
    auto* mover = std::find_if(to.begin(), to.end(),
                               [&](const TurnedMover& m) { return m.cluster == cluster; });
    mover->turning += slope;
}

void add(const State& state, const MechanismPoint& point, const Point& slope,
         CoordinateSlopes& to) {
    for (std::uint32_t k = 0; k < point.count; ++k)
        add(state, state.particleSlots.dense(point.support[k]),
            static_cast<double>(point.weight[k]) * slope, to);
}

bool isAngular(MechanismKind kind) {
    return kind == MechanismKind::hinge || kind == MechanismKind::weld;
}

struct ArmEnds {
    std::uint32_t from, to;
    bool isComponent;
};

ArmEnds endsOf(const State& state, const MechanismArm& arm) {
    const auto from = state.particleSlots.dense(arm.from), to = state.particleSlots.dense(arm.to);
    const auto cluster = state.particles.cluster[from];
    return {from, to, cluster != none && cluster == state.particles.cluster[to]};
}

/// Of a particle that is a rigid component by itself. What a lone one was turned by before it
/// became one, its body keeps.
Point discHeading(const State& state, std::uint32_t particle) {
    const BodyRecord& body = state.bodies[state.particles.body[particle]];
    const Cluster& c = state.clusters.list[state.particles.cluster[particle]];
    return body.particles.size() == 1 ? turned(body.turn, c.heading) : c.heading;
}

Point spanOf(const State& state, const ArmEnds& ends, bool moved) {
    const Particles& p = state.particles;
    Point span = p.position[ends.to] - p.position[ends.from];
    if (moved)
        span += (displacementOf(state, gripOf(state, ends.to)) -
                 displacementOf(state, gripOf(state, ends.from)))
                    .cast<double>();
    return span;
}

void addAngle(const State& state, const MechanismArm& arm, double factor, CoordinateSlopes& to) {
    const ArmEnds ends = endsOf(state, arm);
    if (ends.isComponent) return addTurning(state, ends.from, factor, to);
    const Point span = spanOf(state, ends, false);
    const double square = span.squaredNorm();
    if (!(square > nothing * nothing)) return;
    const Point slope = factor / square * Point(-span[1], span[0]);
    add(state, ends.to, slope, to);
    add(state, ends.from, -slope, to);
}

/// Of a slider: what it leads, from the line's first point, along the line and across it.
struct OnLine {
    Point along{0, 0}, across{0, 0};        // unit
    double length = 0, place = 0, off = 0;  // m
};

OnLine onLine(const State& state, const Mechanism& m, bool moved) {
    const Point from = placeOf(state, m.points[1], moved);
    const Point line = placeOf(state, m.points[2], moved) - from;
    const Point reached = placeOf(state, m.points[0], moved) - from;
    OnLine on;
    on.length = line.norm();
    if (!(on.length > nothing)) return on;
    on.along = line / on.length;
    on.across = perpendicular(on.along);
    on.place = on.along.dot(reached);
    on.off = on.across.dot(reached);
    return on;
}

void addOnLine(const State& state, const Mechanism& m, bool isAcross, double factor,
               CoordinateSlopes& to) {
    const OnLine on = onLine(state, m, false);
    if (!(on.length > nothing)) return;
    // The line turns with its ends: d along = across d angle, d across = -along d angle.
    const Point own = factor * (isAcross ? on.across : on.along);
    const Point turning = factor * (isAcross ? -on.place : on.off) / on.length * on.across;
    add(state, m.points[0], own, to);
    add(state, m.points[1], -own - turning, to);
    add(state, m.points[2], turning, to);
}

/// The ends of a link hold its shape: in their frame, as complex numbers, the point is at z. What
/// pushes it by f is borne by them as -(1 - z') f and -z' f, without a momentum or a torque of all
/// three.
void addFromLink(const State& state, const Mechanism& m, const Point& share, const Point& push,
                 CoordinateSlopes& to) {
    const Point held = turnedBack(share, push);
    add(state, m.points[0], push, to);
    add(state, m.points[1], held - push, to);
    add(state, m.points[2], -held, to);
}

void addOnRail(const State& state, const Mechanism& m, bool isAcross, double factor,
               CoordinateSlopes& to) {
    const OnRail on = onRail(state, m, false);
    addFromLink(state, m, on.share, factor * (isAcross ? on.across : on.along), to);
    if (!isAcross) return;
    const Point stretch = factor * on.off * on.perLength;
    add(state, m.points[1], -stretch, to);
    add(state, m.points[2], stretch, to);
}

void addDistance(const State& state, const Mechanism& m, std::size_t first, double factor,
                 CoordinateSlopes& to) {
    const Point apart =
        placeOf(state, m.points[first + 1], false) - placeOf(state, m.points[first], false);
    const double length = apart.norm();
    if (!(length > nothing)) return;
    const Point slope = factor / length * apart;
    add(state, m.points[first + 1], slope, to);
    add(state, m.points[first], -slope, to);
}

double distanceOf(const State& state, const Mechanism& m, std::size_t first, bool moved) {
    return (placeOf(state, m.points[first + 1], moved) - placeOf(state, m.points[first], moved))
        .norm();
}

const Mechanism& partOf(const State& state, const Mechanism& gear, std::size_t k) {
    return state.mechanisms.list[state.mechanisms.slots.dense(gear.parts[k])];
}

void addSlopes(const State& state, const Mechanism& m, RowOf row, double factor,
               CoordinateSlopes& to) {
    if (row == RowOf::across || (row == RowOf::drive && m.kind == MechanismKind::slider))
        return m.rail.isNothing() ? addOnLine(state, m, row == RowOf::across, factor, to)
                                  : addOnRail(state, m, row == RowOf::across, factor, to);
    if (row == RowOf::angle || isAngular(m.kind)) {
        addAngle(state, m.arms[1], factor, to);
        addAngle(state, m.arms[0], -factor, to);
    } else if (m.kind == MechanismKind::distance || m.kind == MechanismKind::pulley) {
        addDistance(state, m, 0, factor, to);
        if (m.kind == MechanismKind::pulley)
            addDistance(state, m, 2, factor * static_cast<double>(m.ratio), to);
    }
}

}  // namespace

Point placeOf(const State& state, const MechanismPoint& point, bool moved) {
    Point sum(0, 0);
    for (std::uint32_t k = 0; k < point.count; ++k) {
        const auto i = state.particleSlots.dense(point.support[k]);
        Point place = state.particles.position[i];
        if (moved) place += displacementOf(state, gripOf(state, i)).cast<double>();
        sum += static_cast<double>(point.weight[k]) * place;
    }
    return sum;
}

double angleOf(const State& state, const MechanismArm& arm, bool moved) {
    const ArmEnds ends = endsOf(state, arm);
    double angle = arm.angle;
    if (ends.isComponent) {
        // What it was when the step began is known, and its turn counts its own whole turns.
        if (moved) return arm.angle + state.clusters.list[state.particles.cluster[ends.from]].angle;
        angle = angleOf(ends.from == ends.to ? discHeading(state, ends.from)
                                             : spanOf(state, ends, false));
    } else if (ends.from == ends.to) {
        angle = angleOf(state.bodies[state.particles.body[ends.from]].turn);
    } else if (const Point line = spanOf(state, ends, moved); line.norm() > nothing) {
        angle = angleOf(line);
    }
    return angle + fullTurn * std::nearbyint((arm.angle - angle) / fullTurn);
}

double angleApart(const State& state, const Mechanism& m, bool moved) {
    const double apart = angleOf(state, m.arms[1], moved) - angleOf(state, m.arms[0], moved);
    if (!m.angle) return apart;
    const double before = m.arms[1].angle - m.arms[0].angle;
    return apart + fullTurn * std::nearbyint((before - apart) / fullTurn);
}

double valueOf(const State& state, const Mechanism& m, RowOf row, bool moved) {
    const bool isOnRail = !m.rail.isNothing();
    if (row == RowOf::across)
        return isOnRail ? onRail(state, m, moved).off : onLine(state, m, moved).off;
    if (row == RowOf::angle) return angleApart(state, m, moved) - m.zeroAngle;
    switch (m.kind) {
        case MechanismKind::hinge:
        case MechanismKind::weld:
            return angleApart(state, m, moved) - m.zero;
        case MechanismKind::slider:
            if (isOnRail) return m.rail.begin + onRail(state, m, moved).place - m.zero;
            return onLine(state, m, moved).place - m.zero;
        case MechanismKind::distance:
            return distanceOf(state, m, 0, moved);
        case MechanismKind::pulley:
            return distanceOf(state, m, 0, moved) +
                   static_cast<double>(m.ratio) * distanceOf(state, m, 2, moved);
        case MechanismKind::gear:
            return valueOf(state, partOf(state, m, 0), row, moved) +
                   static_cast<double>(m.ratio) * valueOf(state, partOf(state, m, 1), row, moved) -
                   m.zero;
    }
    return 0;
}

std::array<std::uint32_t, 2> turningOf(const State& state, const Mechanism& m, RowOf row) {
    std::array<std::uint32_t, 2> found{none, none};
    if (row != RowOf::drive || !isAngular(m.kind) || m.angle) return found;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const ArmEnds ends = endsOf(state, m.arms[k]);
        if (!ends.isComponent) return {none, none};
        found[k] = state.particles.cluster[ends.from];
    }
    return found;
}

CoordinateSlopes slopesOf(const State& state, const Mechanism& m, RowOf row) {
    CoordinateSlopes slopes;
    if (m.kind == MechanismKind::gear) {
        addSlopes(state, partOf(state, m, 0), row, 1, slopes);
        addSlopes(state, partOf(state, m, 1), row, static_cast<double>(m.ratio), slopes);
    } else {
        addSlopes(state, m, row, 1, slopes);
    }
    return slopes;
}

CoordinateSlopes slopesFromLink(const State& state, const Mechanism& m, const Point& direction) {
    CoordinateSlopes slopes;
    addFromLink(state, m, onRail(state, m, false).share, direction, slopes);
    return slopes;
}

double freeMobility(std::span<const TurnedMover> slopes) {
    double sum = 0;
    for (const TurnedMover& m : slopes)
        sum += m.inverseMass * m.force.squaredNorm() + m.inverseInertia * m.turning * m.turning;
    return sum;
}

void strike(State& state, std::span<const TurnedMover> slopes, double impulse) {
    for (const TurnedMover& m : slopes) {
        if (m.cluster == none) {
            state.particles.velocity[m.particle] += m.inverseMass * impulse * m.force;
            continue;
        }
        Cluster& c = state.clusters.list[m.cluster];
        c.velocity += m.inverseMass * impulse * m.force;
        c.spin += m.inverseInertia * impulse * m.turning;
    }
}

double speedOf(const State& state, const Mechanism& m) {
    return speedOf(state, slopesOf(state, m, RowOf::drive));
}

double speedOf(const State& state, std::span<const TurnedMover> slopes) {
    double sum = 0;
    for (const TurnedMover& mover : slopes) {
        if (mover.cluster == none) {
            sum += mover.force.dot(state.particles.velocity[mover.particle]);
            continue;
        }
        const Cluster& c = state.clusters.list[mover.cluster];
        sum += mover.force.dot(c.velocity) + mover.turning * c.spin;
    }
    return sum;
}

bool holds(const State& state, const Mechanism& m) {
    if (m.kind == MechanismKind::gear) {
        const Mechanisms& all = state.mechanisms;
        return std::all_of(m.parts.begin(), m.parts.end(), [&](MechanismId part) {
            return all.slots.contains(part) && holds(state, all.list[all.slots.dense(part)]);
        });
    }
    if (m.angle && !state.angleSlots.contains(m.angle)) return false;
    if (!m.rail.isNothing() && !state.jointSlots.contains(m.rail.links[m.rail.link])) return false;
    const auto isThere = [&](ParticleId id) { return !id || state.particleSlots.contains(id); };
    for (const MechanismPoint& point : m.points)
        for (std::uint32_t k = 0; k < point.count; ++k)
            if (!isThere(point.support[k])) return false;
    for (const MechanismArm& arm : m.arms)
        if (!isThere(arm.from) || !isThere(arm.to)) return false;
    for (const AttachmentId pin : m.pins)
        if (pin && !state.attachmentSlots.contains(pin)) return false;
    if (m.frame && !state.bodySlots.contains(m.frame)) return false;
    return state.bodySlots.contains(m.a) && state.bodySlots.contains(m.b);
}

}  // namespace sulfur::detail
