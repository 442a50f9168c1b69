// Bodies in pictures that tear where joints break, for the game and the sandbox.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/skin/body_shape.hpp>

namespace quaoar {

/// What a body wears where it has no picture, and around it.
struct SkinColors {
    atlax::Color light, dark, rim, ink;
};

/// 0 in the shade to 1 in the light, for an outward normal.
float lightOn(atlax::Vec2 normal);

/// Particles where they are, those of the outline moved out by its thickness, so that the skin
/// covers what collides. `alpha` as Application::draw has it.
std::vector<atlax::Vec2> dressedPlaces(const sulfur::World& world, sulfur::BodyId body,
                                       const BodyShape& shape, double alpha);
/// The picture over all triangles, or without one colours from light above to dark below.
void drawSkin(atlax::Canvas& canvas, const atlax::Texture* picture, const BodyShape& shape,
              const SkinColors& colors, const std::vector<atlax::Vec2>& places);
/// A dark outline, and the light of the sky where it faces up.
void drawSkinBorder(atlax::Canvas& canvas, const BodyShape& shape, const SkinColors& colors,
                    const std::vector<atlax::Vec2>& places);
/// A picture on a disc, turned with it; its rim is the circle in the
/// picture's square.
void drawSkinnedDisc(atlax::Canvas& canvas, const atlax::Texture& picture, atlax::Vec2 middle,
                     float radius, float angle);

}  // namespace quaoar
