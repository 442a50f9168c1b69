// What the physics library sees of a world, drawn over its picture.
#pragma once

#include <atlax/canvas.hpp>
#include <sulfur/world.hpp>

namespace sulfurchamber {

/// Draws particles, joints with their loads, surfaces, contacts, attachments, fields and grabs of a
/// world by atlax's debug drawing: the adaptor between the library's visitor and the canvas. The
/// canvas must be in world space; `alpha` as Application::draw has it.
void paintDebug(atlax::Canvas& canvas, const sulfur::World& world, double alpha);

}  // namespace sulfurchamber
