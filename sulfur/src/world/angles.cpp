// Angular joints of bodies: making them, asking and changing them.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bodies/sleep.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "core/trigonometry.hpp"
#include "joints/turn.hpp"
#include "solver/compact.hpp"
#include "solver/coordinates.hpp"
#include "solver/mechanisms.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace detail {

namespace {

JointsByEnds jointsByEnds(const Blueprint& plan) {
    JointsByEnds list;
    if (plan.angles.empty()) return list;
    for (std::size_t j = 0; j < plan.joints.size(); ++j) {
        const auto [a, b] = std::minmax(plan.joints[j].a, plan.joints[j].b);
        list.push_back({{a, b}, j});
    }
    std::sort(list.begin(), list.end());
    return list;
}

/// Whether a row has to move it; springs move by themselves.
bool isDriven(const Drive& drive) {
    return drive.lower > -infinite || drive.upper < infinite || drive.motorMax > 0 ||
           drive.stiffness == infinite;
}

Mechanism& driverOf(State& state, std::uint32_t angle) {
    return state.mechanisms.list[state.mechanisms.slots.dense(state.angles.drive[angle])];
}

/// Makes the row that moves an angular joint: that of a hinge, whose arms are both of one body. Its
/// angle begins between -pi and pi. There is room for it.
void addDriver(State& state, std::uint32_t angle, BodyId body, const Drive& drive) {
    Angles& angles = state.angles;
    const auto& id = state.particles.id;
    Mechanism m;
    m.a = m.b = body;
    m.angle = angles.id[angle];
    m.drive = drive;
    m.arms[0] = {id[angles.a[angle]], id[angles.b[angle]]};
    m.arms[1] = {id[angles.b[angle]], id[angles.c[angle]]};
    auto& all = state.mechanisms;
    m.id = angles.drive[angle] = all.slots.insert(static_cast<std::uint32_t>(all.list.size()));
    all.list.push_back(m);
}

void addAngle(State& state, const AngularJointSpec& spec, const Drive& drive,
              const BodyRecord& body, const JointsByEnds& joints) {
    const auto between = [&](std::uint32_t i, std::uint32_t k) {
        const std::array<std::uint32_t, 2> ends{std::min(i, k), std::max(i, k)};
        const auto at = std::partition_point(joints.begin(), joints.end(),
                                             [&](const auto& joint) { return joint.first < ends; });
        return at != joints.end() && at->first == ends ? body.joints[at->second] : JointId{};
    };
    Angles& angles = state.angles;
    const auto index = static_cast<std::uint32_t>(angles.size());
    angles.a.push_back(body.firstParticle + spec.a);
    angles.b.push_back(body.firstParticle + spec.b);
    angles.c.push_back(body.firstParticle + spec.c);
    angles.restAngle.push_back(drive.rest);
    angles.stiffness.push_back(spec.stiffness);
    angles.damping.push_back(spec.damping);
    angles.explicitStiffness.push_back(0);
    angles.explicitDamping.push_back(0);
    angles.armBefore.push_back(0);
    angles.armAfter.push_back(0);
    angles.torque.push_back(0);
    angles.kind.push_back(AngleKind::held);
    angles.before.push_back(between(spec.a, spec.b));
    angles.after.push_back(between(spec.b, spec.c));
    angles.body.push_back(static_cast<std::uint32_t>(state.bodies.size()));
    angles.strength.push_back(spec.strength);
    angles.drive.push_back({});
    angles.id.push_back(state.angleSlots.insert(index));
    if (isDriven(drive)) addDriver(state, index, body.id, drive);
}

AngleInfo infoOf(const State& state, std::uint32_t i) {
    const Angles& j = state.angles;
    const Particles& p = state.particles;
    const Point before = p.position[j.b[i]] - p.position[j.a[i]];
    const Point after = p.position[j.c[i]] - p.position[j.b[i]];
    AngleInfo info;
    info.id = j.id[i];
    info.body = state.bodies[j.body[i]].id;
    info.a = p.id[j.a[i]];
    info.b = p.id[j.b[i]];
    info.c = p.id[j.c[i]];
    info.torque = j.torque[i];
    if (!j.drive[i]) {
        info.drive.stiffness = j.stiffness[i];
        info.drive.damping = j.damping[i];
        info.drive.rest = j.restAngle[i];
        info.drive.strength = j.strength[i];
        if (hasTurn(before, after)) info.angle = angleBetween(before, after);
        return info;
    }
    const Mechanism& m = state.mechanisms.list[state.mechanisms.slots.dense(j.drive[i])];
    info.drive = m.drive;
    info.angle = valueOf(state, m, RowOf::drive, false);
    info.torque = m.forces[0].sum();
    info.atLower = m.atLower != 0;
    info.atUpper = m.atUpper != 0;
    return info;
}

}  // namespace

JointsByEnds makeRoomForAngles(State& state, const Blueprint& plan) {
    state.angles.forEachArray([&](auto& list) { makeRoom(list, plan.angles.size()); });
    state.angleSlots.makeRoom(plan.angles.size());
    const auto isSo = [&](const AngularJointSpec& spec) { return isDriven(plan.drive(spec)); };
    const auto driven =
        static_cast<std::size_t>(std::count_if(plan.angles.begin(), plan.angles.end(), isSo));
    if (driven > 0) {
        makeRoom(state.mechanisms.list, driven);
        state.mechanisms.slots.makeRoom(driven);
    }
    return jointsByEnds(plan);
}

void addAngles(State& state, const Blueprint& plan, const BodyRecord& body,
               const JointsByEnds& joints) {
    for (const AngularJointSpec& spec : plan.angles)
        addAngle(state, spec, plan.drive(spec), body, joints);
}

}  // namespace detail

using detail::State;

std::vector<AngleInfo> World::angles(BodyId id) const {
    const State& state = impl_->state();
    const detail::Range range = detail::anglesOf(state, indexOf(state, id));
    std::vector<AngleInfo> found;
    found.reserve(range.last - range.first);
    for (auto i = range.first; i < range.last; ++i) found.push_back(detail::infoOf(state, i));
    return found;
}

AngleInfo World::info(AngleId id) const {
    const State& state = impl_->state();
    return detail::infoOf(state, indexOf(state, id));
}

bool World::contains(AngleId id) const {
    return impl_->known().angleSlots.contains(id);
}

void World::setDrive(AngleId id, const Drive& drive) {
    State& state = impl_->changing();
    const auto i = indexOf(state, id);
    detail::validate(drive);
    detail::requireRange(static_cast<double>(drive.rest), -detail::maxAngle, detail::maxAngle,
                         "drive: rest");
    const bool driven = detail::isDriven(drive);
    detail::makeRoom(state.mechanisms.list, 1);
    state.mechanisms.slots.makeRoom(1);
    // From here on nothing fails.
    detail::Angles& angles = state.angles;
    angles.restAngle[i] = drive.rest;
    angles.stiffness[i] = drive.stiffness;
    angles.damping[i] = drive.damping;
    angles.strength[i] = drive.strength;
    detail::wakeBody(state, angles.body[i]);
    if (driven && angles.drive[i]) {
        detail::Mechanism& m = detail::driverOf(state, i);
        m.drive = drive;
        detail::forgetTaken(drive, m.forces[0]);
        return;
    }
    angles.torque[i] = 0;
    if (driven)
        detail::addDriver(state, i, state.bodies[angles.body[i]].id, drive);
    else if (const MechanismId before = std::exchange(angles.drive[i], MechanismId{}))
        detail::dropMechanism(state, state.mechanisms.slots.dense(before));
    detail::bodyChanged(state);
}

void World::remove(AngleId id) {
    State& state = impl_->changing();
    indexOf(state, id);
    detail::makeRoomToCompact(state);
    detail::dropAngles(state, {id});
}

}  // namespace sulfur
