// What several scenes of the battery measure.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <sulfur/sulfur.hpp>
#include <vector>

namespace sulfur::lab {

/// The motion of some particles in the last tick, each with its mean velocity over that tick.
struct Motion {
    double mass = 0;                                     ///< kg
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< of mass, m
    Eigen::Vector2d momentum = Eigen::Vector2d::Zero();  ///< N s
    double kinetic = 0;                                  ///< J, in all
    double spinKinetic = 0;      ///< J, of the motion about the centre of mass
    double angularMomentum = 0;  ///< N m s, about the centre of mass
    double fastest = 0;          ///< m/s, of any particle
};
Motion motionOf(const World& world, std::span<const ParticleId> particles);

/// Turns the particles of a body about their centre of mass with `omega` rad/s, at rest otherwise.
void spin(World& world, Body body, double omega);

/// Whether every particle is at a finite place with a finite velocity.
bool allFinite(const World& world, std::span<const ParticleId> particles);

/// The largest deviation of a joint of `body` from its rest length, in that length.
double largestStrain(const World& world, const Body& body);

/// The larger one; NaN if either is (std::max drops it silently).
double worst(double a, double b);

/// The energy of a body with elastic joints, J, at the end of a tick: its kinetic part is the mean
/// of that of the ticks before and after. World::energy looks at the middle of a step instead,
/// which suits rigid joints; but there a turning joint is a little shorter than at the ends of the
/// step, which counts for much where the joint is stiff.
class EnergyMeter {
public:
    /// Call after every tick. Returns the energy at the end of the tick before, from the second
    /// call on; nothing before that.
    std::optional<double> add(const World& world, Body body);

private:
    std::optional<double> potential_, kinetic_;
};

/// Times at which a quantity rises through zero, between samples by linear interpolation.
class Crossings {
public:
    void add(double time, double value);
    /// Mean time between crossings; NaN when there were fewer than two.
    double period() const;
    std::size_t count() const { return count_; }

private:
    double lastTime_ = 0, lastValue_ = 0, first_ = 0, latest_ = 0;
    bool begun_ = false;
    std::size_t count_ = 0;
};

/// A sampled oscillation x(n) = A r^n cos(n angle + phase), from the best
/// x(n+1) = p x(n) - r^2 x(n-1) (Prony's method of order two).
struct Oscillation {
    double factor = 0;  ///< r, amplitude kept per sample; the larger root when it does not swing
    double angle = 0;   ///< rad per sample, 0 when it does not swing
    bool measured = false;  ///< false when there were too few samples above `noise`
};
Oscillation fitOscillation(std::span<const double> samples, double noise);

}  // namespace sulfur::lab
