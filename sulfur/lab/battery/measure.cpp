#include "battery/measure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "battery/scenes.hpp"

namespace sulfur::lab {

Motion motionOf(const World& world, std::span<const ParticleId> particles) {
    Motion m;
    for (const ParticleId id : particles) {
        const ParticleInfo p = world.info(id);
        const double mass = static_cast<double>(p.mass);
        const Vec v = p.velocity.cast<double>();
        m.mass += mass;
        m.centre += mass * p.position;
        m.momentum += mass * v;
        m.kinetic += mass / 2 * v.squaredNorm();
        m.fastest = std::max(m.fastest, v.norm());
    }
    m.centre /= m.mass;
    for (const ParticleId id : particles) {
        const ParticleInfo p = world.info(id);
        const Vec v = p.velocity.cast<double>() - m.momentum / m.mass;
        m.angularMomentum += static_cast<double>(p.mass) * cross(p.position - m.centre, v);
        m.spinKinetic += static_cast<double>(p.mass) / 2 * v.squaredNorm();
    }
    return m;
}

void spin(World& world, Body body, double omega) {
    const Point centre = world.centreOfMass(body);
    for (const ParticleId id : body.particles()) {
        const Vec r = world.position(id) - centre;
        world.setVelocity(id, vec2(-omega * r.y(), omega * r.x()));
    }
}

bool allFinite(const World& world, std::span<const ParticleId> particles) {
    return std::all_of(particles.begin(), particles.end(), [&](ParticleId id) {
        return world.position(id).allFinite() && world.velocity(id).allFinite();
    });
}

double largestStrain(const World& world, const Body& body) {
    double most = 0;
    for (const JointId id : body.joints()) {
        const JointInfo joint = world.info(id);
        const double length = (world.position(joint.b) - world.position(joint.a)).norm();
        most = worst(most, std::abs(length / static_cast<double>(joint.restLength) - 1));
    }
    return most;
}

double worst(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

std::optional<double> EnergyMeter::add(const World& world, Body body) {
    const Vec gravity = world.gravity().cast<double>();
    double kinetic = 0, potential = 0;
    for (const ParticleId id : body.particles()) {
        const ParticleInfo p = world.info(id);
        if (p.pinned) continue;
        const double mass = static_cast<double>(p.mass);
        kinetic += mass / 2 * p.velocity.cast<double>().squaredNorm();
        potential -= mass * gravity.dot(p.position);
    }
    for (const JointId id : body.joints()) {
        const JointInfo joint = world.info(id);
        if (joint.stiffness == infinite) continue;
        if (joint.stiffness == 0) continue;
        // By its force where that is less than its stretch says: of a joint of 1e12 N/m, the
        // rounding of a length and what the sweeps leave of its error would count as mountains of
        // energy, which it never gives to anything.
        const double stiffness = static_cast<double>(joint.stiffness);
        const double stretch = (world.position(joint.b) - world.position(joint.a)).norm() -
                               static_cast<double>(joint.restLength);
        const double force =
            std::min(std::abs(static_cast<double>(joint.force)), stiffness * std::abs(stretch));
        potential += force * force / 2 / stiffness;
    }
    std::optional<double> result;
    if (potential_ && kinetic_) result = *potential_ + (*kinetic_ + kinetic) / 2;
    potential_ = potential;
    kinetic_ = kinetic;
    return result;
}

void Crossings::add(double time, double value) {
    if (begun_ && lastValue_ < 0 && value >= 0) {
        latest_ = lastTime_ + (time - lastTime_) * lastValue_ / (lastValue_ - value);
        if (count_++ == 0) first_ = latest_;
    }
    begun_ = true;
    lastTime_ = time;
    lastValue_ = value;
}

double Crossings::period() const {
    if (count_ < 2) return std::numeric_limits<double>::quiet_NaN();
    return (latest_ - first_) / static_cast<double>(count_ - 1);
}

Oscillation fitOscillation(std::span<const double> samples, double noise) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    int equations = 0;
    for (std::size_t n = 1; n + 1 < samples.size(); ++n) {
        const Eigen::Vector2d row(samples[n], -samples[n - 1]);
        if (!(row.norm() > noise)) continue;
        // Each equation counts the same, so that a motion that fades is seen in all its parts.
        const double weight = 1 / row.squaredNorm();
        normal += weight * row * row.transpose();
        right += weight * samples[n + 1] * row;
        ++equations;
    }
    Oscillation found;
    if (equations < 2 || !(std::abs(normal.determinant()) > 1e-14)) return found;
    const Eigen::Vector2d solution = normal.inverse() * right;
    const double half = solution[0] / 2, square = solution[1] - half * half;
    found.measured = true;
    if (square > 0) {
        found.factor = std::sqrt(solution[1]);
        found.angle = std::atan2(std::sqrt(square), half);
    } else {
        found.factor = std::abs(half) + std::sqrt(-square);
    }
    return found;
}

}  // namespace sulfur::lab
