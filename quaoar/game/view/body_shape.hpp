// The shape of a body of a session.
#pragma once

#include <quaoar/session.hpp>
#include <quaoar/skin/body_shape.hpp>

namespace quaoar {

BodyShape shapeOf(const Session& session, sulfur::BodyId body);

}  // namespace quaoar
