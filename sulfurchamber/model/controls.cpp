#include "controls.hpp"

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::Drive;
using sulfur::MechanismInfo;
using sulfur::Real;

bool isSameDrive(const Drive& a, const Drive& b) {
    return a.lower == b.lower && a.upper == b.upper && a.stiffness == b.stiffness &&
           a.damping == b.damping && a.rest == b.rest && a.motorSpeed == b.motorSpeed &&
           a.motorMax == b.motorMax && a.motorTarget == b.motorTarget && a.strength == b.strength;
}

// Its longest length follows what it winds; beyond that it only pulls.
Drive wound(Drive drive, int direction, const MechanismInfo& now, double tick) {
    const double speed = direction * static_cast<double>(drive.motorSpeed);
    const bool was = std::isfinite(now.drive.upper);
    drive.upper = was ? now.drive.upper : static_cast<Real>(now.value);
    drive.motorSpeed = static_cast<Real>(speed);
    if (speed < 0) {
        drive.upper = sulfur::infinite;
    } else {
        drive.motorMax = 0;
        if (speed > 0)
            drive.upper = static_cast<Real>(std::max(now.value, static_cast<double>(drive.upper)) +
                                            speed * tick);
    }
    drive.upper = std::max(drive.upper, std::max(drive.lower, Real(1e-3)));
    return drive;
}

}  // namespace

Drive drivenBy(const Drive& plan, const DriveKeys& keys, int direction, const MechanismInfo& now,
               double tick) {
    if (now.kind == sulfur::MechanismKind::distance) return wound(plan, direction, now, tick);
    Drive drive = plan;
    if (plan.motorTarget) {
        *drive.motorTarget = static_cast<Real>(direction) * *plan.motorTarget;
        return drive;
    }
    drive.motorSpeed = static_cast<Real>(direction) * plan.motorSpeed;
    if (direction == 0) drive.motorMax = static_cast<Real>(keys.brake) * plan.motorMax;
    return drive;
}

void Controls::hold(const std::string& key, bool down) {
    if (!isControlKey(key)) return;
    if (down)
        held_.insert(key);
    else
        held_.erase(key);
}

int Controls::direction(const DriveKeys& keys) const {
    return (holds(keys.forward) ? 1 : 0) - (holds(keys.back) ? 1 : 0);
}

void Controls::readPlan(const Document& document) {
    if (revision_ == document.revision()) return;
    revision_ = document.revision();
    driven_.clear();
    const auto& mechanisms = document.scene().mechanisms;
    for (std::size_t i = 0; i < mechanisms.size(); ++i) {
        const sulfur::Drive* drive = driveOf(mechanisms[i]);
        if (drive == nullptr || !(drive->motorMax > 0)) continue;
        if (DriveKeys keys = keysOf(mechanisms[i]); keys.any())
            driven_.push_back({i, std::move(keys)});
    }
}

void Controls::tick(Document& document) {
    readPlan(document);
    const double tick = static_cast<double>(document.world().tickDuration());
    for (const Driven& one : driven_) {
        const auto id = document.made().at(one.mechanism).id;
        if (!id || !document.world().contains(id)) continue;
        const Drive& plan = *driveOf(document.scene().mechanisms[one.mechanism]);
        const MechanismInfo now = document.world().info(id);
        const Drive wanted = drivenBy(plan, one.keys, direction(one.keys), now, tick);
        if (!isSameDrive(wanted, now.drive)) document.drive(id, wanted);
    }
    for (const Thruster& thruster : document.thrusters()) {
        const int way = thruster.keys.any() ? direction(thruster.keys) : 1;
        if (way == 0) continue;
        if (const auto body = document.bodyOf(thruster.body))
            document.thrust({body, thruster.at, Real(way) * thruster.force});
    }
}

bool answersTo(const Document& document, const std::string& key) {
    const auto has = [&](const DriveKeys& keys) { return keys.forward == key || keys.back == key; };
    const auto& mechanisms = document.scene().mechanisms;
    const auto& thrusters = document.thrusters();
    return std::any_of(mechanisms.begin(), mechanisms.end(),
                       [&](const auto& one) { return has(keysOf(one)); }) ||
           std::any_of(thrusters.begin(), thrusters.end(),
                       [&](const auto& one) { return has(one.keys); });
}

}  // namespace sulfurchamber
