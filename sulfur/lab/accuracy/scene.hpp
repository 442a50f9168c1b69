// A scene whose motion is known, for every method alike.
#pragma once

#include <limits>
#include <string>
#include <sulfur/blueprint.hpp>
#include <vector>

#include "bench/bodies.hpp"
#include "spring_system.hpp"

namespace sulfur::lab {

/// The stiffness of a rigid joint, N/m.
inline constexpr double rigidStiffness = std::numeric_limits<double>::infinity();

/// A joint of a scene.
struct SceneJoint {
    std::size_t a, b;
    double stiffness;   ///< N/m
    double damping;     ///< N s/m
    double restLength;  ///< m
};

/// Particles and joints, how they start, and where some of them must be. The error of a method is
/// the largest distance, in metres, of a watched particle from its reference at any of the sample
/// times.
struct AccuracyScene {
    std::string key, title;
    std::string reference;  ///< what it is, for people
    std::string error;      ///< what is compared, for people
    State start;
    std::vector<double> masses;  ///< kg; 0: held where it is
    std::vector<SceneJoint> joints;
    /// m, centres of squares of 1 m and 1 kg, upright and at rest, above a floor along y = 0. A
    /// scene has either these, which are watched in this order, or bodies, or particles.
    Vecs squares;
    std::vector<bench::BodyPlan> bodies;  ///< by their origin, where a particle has its place
    std::vector<bench::PinPlan> pins;     ///< of the bodies
    double gravity = 0;                   ///< m/s^2
    double rigidStandIn = 0;  ///< N/m of the springs that stand for rigid joints where a method has
                              ///< none
    double interval = 0.1;    ///< s between samples; a whole number of ticks at every rate
    std::vector<std::size_t> watched;  ///< particles
    std::vector<Vecs> path;            ///< of the watched ones at interval, 2 interval, ...
    double referenceError = 0;         ///< m

    double seconds() const { return interval * static_cast<double>(path.size()); }
    bool hasRigidJoints() const;
    /// Whether rigid joints or pins hold it together.
    bool isTied() const { return hasRigidJoints() || !pins.empty(); }
    /// The largest deviation of a rigid joint from its length, in that length, where the particles
    /// are at `places`; 0 without rigid joints.
    double largestStrain(const Vecs& places) const;
    /// For integrators that know springs only.
    SpringSystem springs() const;
    /// For the library.
    Blueprint blueprint() const;
};

struct SceneOptions {
    double load = 100;   ///< in masses of a link of the rope, a node of a net, a square of the grid
    bool quick = false;  ///< nets and grids of 10 x 10 instead of 20 x 20
};

/// Whether a scene asks for a load. `key` must be one of sceneKeys().
bool isLoaded(const std::string& key);
/// The names of all scenes.
const std::vector<std::string>& sceneKeys();
/// `key` must be one of them. Computes the reference.
AccuracyScene makeScene(const std::string& key, const SceneOptions& options);

}  // namespace sulfur::lab
