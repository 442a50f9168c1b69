// How far plans are from each other where they are placed, before there is a world.
#pragma once

#include <Eigen/Core>
#include <sulfur/sulfur.hpp>
#include <vector>

namespace sulfur::lab {

/// The capsules and discs of a body.
struct Outline {
    struct Capsule {
        Eigen::Vector2d a, b;
        double radius;
    };
    std::vector<Capsule> capsules;

    /// Of a plan that is turned by `angle` and moved to `place`.
    Outline(const Blueprint& plan, const Eigen::Vector2d& place, double angle);
    void move(const Eigen::Vector2d& way);
};

/// Between surfaces, m; negative where they overlap. What is within the other is not seen.
double distance(const Outline& one, const Outline& other);

}  // namespace sulfur::lab
