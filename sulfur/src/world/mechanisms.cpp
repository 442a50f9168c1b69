// World: mechanisms that there are.
#include <cmath>
#include <string>
#include <utility>

#include "bodies/sleep.hpp"
#include "core/error_checks.hpp"
#include "solver/coordinates.hpp"
#include "solver/mechanisms.hpp"
#include "solver/rails.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::Mechanism;
using detail::RowOf;
using detail::State;

namespace detail {

constexpr double stiffest = 1e12;  // also of damping

void requireStrength(Real strength, const char* what) {
    if (strength == infinite) return;
    requirePositive(static_cast<double>(strength), what);
}

void validate(const Drive& d) {
    if (std::isnan(d.lower) || std::isnan(d.upper) || d.lower > d.upper || d.lower == infinite ||
        d.upper == -infinite)
        throw Error(ErrorCode::outOfRange,
                    "drive: limits of " + std::to_string(static_cast<double>(d.lower)) + " to " +
                        std::to_string(static_cast<double>(d.upper)) +
                        "; allowed is a lower one that is not above the upper one");
    if (d.stiffness != infinite)
        requireRange(static_cast<double>(d.stiffness), 0, stiffest, "drive: stiffness");
    requireRange(static_cast<double>(d.damping), 0, stiffest, "drive: damping");
    requireRange(static_cast<double>(d.rest), -1e6, 1e6, "drive: rest");
    requireRange(static_cast<double>(d.motorSpeed), -1e6, 1e6, "drive: motor speed");
    requireNonNegativeOrInfinite(static_cast<double>(d.motorMax), "drive: motor maximum");
    if (d.motorTarget)
        requireRange(static_cast<double>(*d.motorTarget), -1e6, 1e6, "drive: motor target");
    requireStrength(d.strength, "drive: strength");
}

const Mechanism& knownMechanism(const State& state, MechanismId id) {
    if (state.mechanisms.slots.contains(id))
        return state.mechanisms.list[state.mechanisms.slots.dense(id)];
    throw Error(ErrorCode::staleHandle,
                "the mechanism handle " + std::to_string(id.index) + ":" +
                    std::to_string(id.generation) +
                    " refers to nothing; allowed is one that was not removed, did not break, and "
                    "whose bodies are still in this world");
}

void wakeBoth(State& state, const Mechanism& m) {
    for (const BodyId body : {m.a, m.b})
        if (state.bodySlots.contains(body)) wakeBody(state, state.bodySlots.dense(body));
}

void forgetTaken(const Drive& drive, RowForces& forces) {
    if (!(drive.stiffness > 0) && !(drive.damping > 0)) forces.spring = 0;
    if (!(drive.motorMax > 0)) forces.motor = 0;
    if (drive.lower == -infinite) forces.lower = 0;
    if (drive.upper == infinite) forces.upper = 0;
}

}  // namespace detail

void World::setDrive(MechanismId id, const Drive& drive) {
    State& state = impl_->changing();
    const auto kind = detail::knownMechanism(state, id).kind;
    detail::validate(drive);
    if (kind == MechanismKind::distance && !(drive.upper > 0))
        throw Error(ErrorCode::outOfRange, "drive: the upper limit of a distance is " +
                                               std::to_string(static_cast<double>(drive.upper)) +
                                               "; allowed is more than 0");
    Mechanism& m = state.mechanisms.list[state.mechanisms.slots.dense(id)];
    m.drive = drive;
    detail::forgetTaken(drive, m.forces[0]);
    detail::wakeBoth(state, m);
}

void World::remove(MechanismId id) {
    State& state = impl_->changing();
    detail::knownMechanism(state, id);
    detail::dropMechanism(state, state.mechanisms.slots.dense(id));
    detail::forgetMechanisms(state);
}

bool World::contains(MechanismId id) const {
    return impl_->known().mechanisms.slots.contains(id);
}

std::vector<MechanismId> World::mechanisms() const {
    std::vector<MechanismId> found;
    for (const Mechanism& m : impl_->known().mechanisms.list)
        if (!m.angle) found.push_back(m.id);
    return found;
}

namespace {

/// What of it says how it was made.
void tellMaking(const State& state, const Mechanism& m, MechanismInfo& info) {
    info.collide = m.apart == 0;
    info.vetoes = m.vetoes != 0;
    info.pin = static_cast<bool>(m.pins[0]);
    info.strength = m.pinStrength;
    info.turns = m.turns != 0;
    info.frame = m.frame;
    info.first = m.parts[0];
    info.second = m.parts[1];
    info.pins = m.pins;
    info.own = m.own;
    if (m.kind != MechanismKind::pulley) return;
    info.overA = placeOf(state, m.points[0], false);
    info.overB = placeOf(state, m.points[2], false);
}

/// `line`: where that goes there.
void tellRail(const State& state, const Mechanism& m, MechanismInfo& info, Point& line) {
    const detail::OnRail on = onRail(state, m, false);
    detail::RailRun run = runOf(state, m);
    info.pointA = info.pointB - on.off * on.across;
    info.rail = std::move(run.links);
    info.railBegin = run.begin;
    line = on.tangent();
}

}  // namespace

MechanismInfo World::info(MechanismId id) const {
    const State& state = impl_->state();
    const Mechanism& m = detail::knownMechanism(state, id);
    MechanismInfo info;
    info.kind = m.kind;
    info.a = m.a;
    info.b = m.b;
    info.value = valueOf(state, m, RowOf::drive, false);
    info.speed = speedOf(state, m);
    info.force = m.forces[0].sum();
    info.atLower = m.atLower != 0;
    info.atUpper = m.atUpper != 0;
    info.drive = m.drive;
    info.ratio = m.ratio;
    tellMaking(state, m, info);
    const auto& p = m.points;
    switch (m.kind) {
        case MechanismKind::gear:
            break;
        case MechanismKind::hinge:
        case MechanismKind::weld:
            if (m.pins[0]) {
                const auto& held = state.attachments[state.attachmentSlots.dense(m.pins[0])];
                info.pointA = info.pointB = state.particles.position[held.particle];
                const bool onB = state.bodies[state.particles.body[held.particle]].id == m.b;
                info.holding = onB ? held.force : Vec2(-held.force);
            } else {
                info.pointA = state.particles.position[state.particleSlots.dense(m.arms[0].from)];
                info.pointB = state.particles.position[state.particleSlots.dense(m.arms[1].from)];
            }
            break;
        case MechanismKind::slider: {
            info.pointA = placeOf(state, p[1], false);
            info.pointB = placeOf(state, p[0], false);
            Point line = placeOf(state, p[2], false) - info.pointA;
            if (!m.rail.isNothing()) tellRail(state, m, info, line);
            const double length = line.norm();
            if (length > 0) {
                info.axis = Point(line / length).cast<Real>();
                info.holding = m.forces[1].sum() * Vec2(-info.axis.y(), info.axis.x());
            }
            break;
        }
        case MechanismKind::distance:
            info.pointA = placeOf(state, p[0], false);
            info.pointB = placeOf(state, p[1], false);
            break;
        case MechanismKind::pulley:
            info.pointA = placeOf(state, p[1], false);
            info.pointB = placeOf(state, p[3], false);
            break;
    }
    return info;
}

}  // namespace sulfur
