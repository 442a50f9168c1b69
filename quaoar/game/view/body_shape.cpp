#include "body_shape.hpp"

namespace quaoar {

BodyShape shapeOf(const Session& session, sulfur::BodyId body) {
    const auto origin = session.origin(body);
    if (!origin) return shapeOf(session.world(), body, nullptr);
    const sulfur::scene::Scene& scene = session.level().scene;
    const sulfur::Blueprint plan = sulfur::scene::blueprintOf(scene, scene.bodies[*origin]);
    return shapeOf(session.world(), body, &plan);
}

}  // namespace quaoar
