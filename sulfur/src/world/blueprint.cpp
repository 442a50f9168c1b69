#include <sulfur/blueprint.hpp>
#include <sulfur/error.hpp>

#include "core/bend.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "joints/turn.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace {

void validateParticle(const ParticleSpec& p, std::size_t i) {
    using namespace detail;
    for (Eigen::Index axis = 0; axis < 2; ++axis)
        requireRange(static_cast<double>(p.position[axis]), -maxCoordinate / 2, maxCoordinate / 2,
                     Subject("particle", i, "position"));
    requirePositive(static_cast<double>(p.mass), Subject("particle", i, "mass"));
    requireRange(static_cast<double>(p.radius), 0, 1e6, Subject("particle", i, "radius"));
}

double restLengthOf(const JointSpec& joint, const std::vector<ParticleSpec>& particles) {
    if (joint.restLength) return static_cast<double>(*joint.restLength);
    const Vec2 apart = particles[joint.b].position - particles[joint.a].position;
    return static_cast<double>(apart.norm());
}

void validateJoint(const JointSpec& joint, std::size_t i,
                   const std::vector<ParticleSpec>& particles) {
    using namespace detail;
    const auto named = [i](const char* property) { return Subject("joint", i, property); };
    for (const auto index : {joint.a, joint.b}) {
        if (index < particles.size()) continue;
        throw Error(ErrorCode::badIndex, named("refers to particle ").text() +
                                             std::to_string(index) + "; allowed is 0 to " +
                                             std::to_string(particles.size() - 1));
    }
    if (joint.a == joint.b)
        throw Error(ErrorCode::degenerate, named("joins a particle to itself; allowed are two "
                                                 "different particles")
                                               .text());
    requireNonNegativeOrInfinite(static_cast<double>(joint.stiffness), named("stiffness"));
    requireRange(static_cast<double>(joint.damping), 0, 1e12, named("damping"));
    requireRange(static_cast<double>(joint.radius), 0, 1e6, named("radius"));
    requireNonNegativeOrInfinite(static_cast<double>(joint.strength), named("strength"));
    const double rest = restLengthOf(joint, particles);
    requireRange(rest, 0, 1e6, named("rest length"));
    if (rest == 0 && (joint.stiffness == infinite || joint.radius > 0))
        throw Error(ErrorCode::degenerate, named("rest length is 0; a rigid or colliding joint "
                                                 "needs more than 0")
                                               .text());
    requireRange(static_cast<double>(joint.bend), -mostBend, mostBend, named("bend"));
    if (joint.bend != 0 && !(joint.stiffness == infinite && joint.radius > 0))
        throw Error(ErrorCode::outOfRange,
                    named("is bent; allowed is that of rigid joints with a radius").text());
    if (!joint.material) return;
    try {
        validate(*joint.material);
    } catch (const Error& error) {
        throw Error(error.code(), named(error.what()).text());
    }
}

/// From the first of two particles to the second.
Point apartOf(const std::vector<ParticleSpec>& particles, std::uint32_t a, std::uint32_t b) {
    return particles[b].position.cast<double>() - particles[a].position.cast<double>();
}

Drive driveOf(const AngularJointSpec& joint, Real rest) {
    return {joint.lower,      joint.upper,    joint.stiffness,   joint.damping, rest,
            joint.motorSpeed, joint.motorMax, joint.motorTarget, joint.strength};
}

void validateAngle(const AngularJointSpec& joint, std::size_t i,
                   const std::vector<ParticleSpec>& particles) {
    using namespace detail;
    const auto named = [i](const char* property) { return Subject("angle", i, property); };
    for (const auto index : {joint.a, joint.b, joint.c}) {
        if (index < particles.size()) continue;
        throw Error(ErrorCode::badIndex, named("refers to particle ").text() +
                                             std::to_string(index) + "; allowed is 0 to " +
                                             std::to_string(particles.size() - 1));
    }
    if (joint.a == joint.b || joint.b == joint.c || joint.a == joint.c)
        throw Error(ErrorCode::degenerate,
                    named("names a particle twice; allowed are three different particles").text());
    if (joint.stiffness != infinite)
        requireRange(static_cast<double>(joint.stiffness), 0, maxAngularStiffness,
                     named("stiffness"));
    requireRange(static_cast<double>(joint.damping), 0, 1e12, named("damping"));
    if (joint.restAngle)
        requireRange(static_cast<double>(*joint.restAngle), -maxAngle, maxAngle,
                     named("rest angle"));
    if (!hasTurn(apartOf(particles, joint.a, joint.b), apartOf(particles, joint.b, joint.c)))
        throw Error(ErrorCode::degenerate,
                    named("has its corner where a neighbour stands; allowed are particles that "
                          "are apart")
                        .text());
    try {
        validate(driveOf(joint, joint.restAngle.value_or(0)));
    } catch (const Error& error) {
        throw Error(error.code(), named(error.what()).text());
    }
}

void validateSkin(const Skin& skin, std::size_t particles) {
    if (skin.uv.size() != particles)
        throw Error(ErrorCode::badIndex,
                    "skin: has " + std::to_string(skin.uv.size()) +
                        " texture coordinates; needed is one for each of the " +
                        std::to_string(particles) + " particles");
    for (const auto& uv : skin.uv) detail::requireFinite(uv, "skin: texture coordinate");
    for (const auto& triangle : skin.triangles) {
        for (const auto index : triangle) {
            if (index < particles) continue;
            throw Error(ErrorCode::badIndex, "skin: triangle refers to particle " +
                                                 std::to_string(index) + "; allowed is 0 to " +
                                                 std::to_string(particles - 1));
        }
    }
}

}  // namespace

void Blueprint::validate() const {
    if (particles.empty())
        throw Error(ErrorCode::degenerate, "blueprint has no particles; needed is at least one");
    for (std::size_t i = 0; i < particles.size(); ++i) validateParticle(particles[i], i);
    for (std::size_t i = 0; i < joints.size(); ++i) validateJoint(joints[i], i, particles);
    for (std::size_t i = 0; i < angles.size(); ++i) validateAngle(angles[i], i, particles);
    detail::validate(material);
    if (skin) validateSkin(*skin, particles.size());
}

Real Blueprint::mass() const {
    double sum = 0;
    for (const auto& p : particles) sum += static_cast<double>(p.mass);
    return static_cast<Real>(sum);
}

Real Blueprint::restAngle(const AngularJointSpec& joint) const {
    if (joint.restAngle) return *joint.restAngle;
    const double angle = detail::angleBetween(apartOf(particles, joint.a, joint.b),
                                              apartOf(particles, joint.b, joint.c));
    return static_cast<Real>(angle);
}

Drive Blueprint::drive(const AngularJointSpec& joint) const {
    return driveOf(joint, restAngle(joint));
}

Vec2 Blueprint::centreOfMass() const {
    Point sum{0, 0};
    double total = 0;
    for (const auto& p : particles) {
        sum += static_cast<double>(p.mass) * p.position.cast<double>();
        total += static_cast<double>(p.mass);
    }
    return (sum / total).cast<Real>();
}

}  // namespace sulfur
