#include "constants.hpp"

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::Real;

bool isElastic(const sulfur::Blueprint& blueprint) {
    return std::any_of(blueprint.joints.begin(), blueprint.joints.end(),
                       [](const auto& joint) { return std::isfinite(joint.stiffness); });
}

void scalePrefab(sulfur::scene::Prefab& prefab, const Constants& constants) {
    const bool elastic = constants.elasticity != 1 && isElastic(prefab.blueprint);
    prefab.blueprint = scaled(std::move(prefab.blueprint), constants);
    if (elastic) prefab.generator = {};
    std::visit(
        [&](auto& options) {
            if constexpr (requires { options.material; })
                options.material = scaled(options.material, constants);
        },
        prefab.generator);
}

}  // namespace

Real scaled(Real stiffness, const Constants& constants) {
    if (constants.elasticity == 1 || !std::isfinite(stiffness)) return stiffness;
    return static_cast<Real>(static_cast<double>(stiffness) * constants.elasticity);
}

sulfur::Material scaled(sulfur::Material material, const Constants& constants) {
    if (constants.friction == 1) return material;
    material.staticFriction *= static_cast<Real>(constants.friction);
    material.kineticFriction *= static_cast<Real>(constants.friction);
    return material;
}

sulfur::Blueprint scaled(sulfur::Blueprint blueprint, const Constants& constants) {
    for (auto& joint : blueprint.joints) joint.stiffness = scaled(joint.stiffness, constants);
    blueprint.material = scaled(blueprint.material, constants);
    return blueprint;
}

sulfur::scene::Scene scaled(sulfur::scene::Scene scene, const Constants& constants) {
    if (constants.elasticity == 1 && constants.friction == 1) return scene;
    for (auto& prefab : scene.blueprints) scalePrefab(prefab, constants);
    for (auto& body : scene.bodies)
        if (body.material) body.material = scaled(*body.material, constants);
    for (auto& connection : scene.connections)
        connection.options.stiffness = scaled(connection.options.stiffness, constants);
    return scene;
}

}  // namespace sulfurchamber
