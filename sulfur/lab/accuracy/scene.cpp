#include "accuracy/scene.hpp"

#include <algorithm>
#include <cmath>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

bool AccuracyScene::hasRigidJoints() const {
    return std::any_of(joints.begin(), joints.end(),
                       [](const SceneJoint& joint) { return std::isinf(joint.stiffness); });
}

double AccuracyScene::largestStrain(const Vecs& places) const {
    double largest = 0;
    for (const SceneJoint& joint : joints)
        if (std::isinf(joint.stiffness))
            largest =
                worst(largest,
                      std::abs((places[joint.b] - places[joint.a]).norm() / joint.restLength - 1));
    return largest;
}

SpringSystem AccuracyScene::springs() const {
    SpringPlan plan;
    plan.gravity = gravity;
    for (const double mass : masses) plan.inverseMass.push_back(mass == 0 ? 0 : 1 / mass);
    for (const SceneJoint& joint : joints)
        plan.springs.push_back({joint.a, joint.b,
                                std::isinf(joint.stiffness) ? rigidStandIn : joint.stiffness,
                                joint.damping, joint.restLength});
    return SpringSystem(std::move(plan));
}

Blueprint AccuracyScene::blueprint() const {
    Blueprint body = ghost(key);
    for (std::size_t i = 0; i < masses.size(); ++i)
        body.particles.push_back({.position = start.x[i].cast<Real>(),
                                  .mass = masses[i] == 0 ? 1 : real(masses[i]),
                                  .pinned = masses[i] == 0});
    for (const SceneJoint& joint : joints)
        body.joints.push_back({.a = static_cast<std::uint32_t>(joint.a),
                               .b = static_cast<std::uint32_t>(joint.b),
                               .stiffness = real(joint.stiffness),
                               .damping = real(joint.damping),
                               .restLength = real(joint.restLength)});
    return body;
}

}  // namespace sulfur::lab
