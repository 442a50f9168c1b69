// The constants that one turns while the simulation runs, and what they do to plans.
#pragma once

#include <sulfur/scene.hpp>

namespace sulfurchamber {

/// Gravity and air friction are those of the scene, the two others are factors on all that is
/// there.
struct Constants {
    double gravity = 9.81;   ///< m/s^2 downwards; negative lets things rise
    double elasticity = 1;   ///< factor on the stiffness of all elastic joints
    double friction = 1;     ///< factor on the sliding and static friction of all bodies
    double airFriction = 0;  ///< 1/s

    friend bool operator==(const Constants&, const Constants&) = default;
};

/// Bounds of Constants, for sliders and for checks.
struct ConstantLimits {
    static constexpr double gravity = 30;  ///< -gravity to gravity
    static constexpr double minElasticity = 0.05;
    static constexpr double maxElasticity = 20;
    static constexpr double friction = 3;     ///< 0 to friction
    static constexpr double airFriction = 5;  ///< 0 to airFriction, and at most the tick rate
};

/// A stiffness under the factor on elasticity: rigid joints stay rigid.
sulfur::Real scaled(sulfur::Real stiffness, const Constants& constants);
/// A surface under the factor on friction.
sulfur::Material scaled(sulfur::Material material, const Constants& constants);
/// A plan under both.
sulfur::Blueprint scaled(sulfur::Blueprint blueprint, const Constants& constants);
/// A scene that behaves without factors as this one does with them. Recipes of elastic bodies
/// become explicit blueprints, where the factor on elasticity is not 1.
sulfur::scene::Scene scaled(sulfur::scene::Scene scene, const Constants& constants);

}  // namespace sulfurchamber
