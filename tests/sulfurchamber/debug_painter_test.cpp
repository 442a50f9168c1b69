// The physics' own view of a world: what the library tells arrives on the canvas.
#include <gtest/gtest.h>

#include <atlax/debug_draw.hpp>
#include <atlax/offscreen.hpp>
#include <sulfur/shapes.hpp>
#include <sulfur/world.hpp>

#include "view/debug_painter.hpp"

namespace sulfurchamber {
namespace {

constexpr int side = 240;

atlax::Image picture(const sulfur::World& world) {
    atlax::OffscreenCanvas offscreen({side, side});
    atlax::Canvas& canvas = offscreen.begin();
    canvas.clear(atlax::colors::black);
    canvas.setCamera({.centre = {0, 1}, .pixelsPerMetre = 100});
    paintDebug(canvas, world, 1);
    offscreen.finish();
    return offscreen.image();
}

bool isColour(const atlax::Image& image, int x, int y, atlax::Color color) {
    const auto p = image.pixel(x, y);
    return std::abs(p[0] - color.r * 255) < 40 && std::abs(p[1] - color.g * 255) < 40 &&
           std::abs(p[2] - color.b * 255) < 40;
}

int count(const atlax::Image& image, atlax::Color color) {
    int found = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) found += isColour(image, x, y, color) ? 1 : 0;
    return found;
}

sulfur::Blueprint crate() {
    return sulfur::shapes::box({.size = {0.5f, 0.5f}});
}

const atlax::DebugStyle style;
const atlax::Color moving = style.states[0];
const atlax::Color fixed = style.states[static_cast<std::size_t>(atlax::DebugState::Fixed)];

TEST(DebugPainter, showsBodiesInTheirStatesWhereTheyAre) {
    sulfur::World world;
    world.add(sulfur::shapes::floor({-2, 0}, {2, 0}));
    world.add(crate(), {{0, 1.5}});
    const atlax::Image image = picture(world);
    EXPECT_GT(count(image, moving), 100);
    EXPECT_GT(count(image, fixed), 100);
    EXPECT_EQ(count(image, style.contact), 0);
    // A particle at the box's corner, 0.25 m from its middle; the surface lies around it.
    bool corner = false;
    for (int x = 92; x < 98; ++x)
        for (int y = 92; y < 98; ++y) corner = corner || isColour(image, x, y, moving);
    EXPECT_TRUE(corner);
}

TEST(DebugPainter, showsContactsWhenThingsLie) {
    sulfur::World world;
    world.add(sulfur::shapes::floor({-2, 0}, {2, 0}));
    world.add(crate(), {{0, 0.4}});
    for (int i = 0; i < 250; ++i) world.step();
    EXPECT_GT(count(picture(world), style.contact), 10);
}

TEST(DebugPainter, showsFieldsAndLeavesTheWorldAsItIs) {
    sulfur::World world;
    world.add(crate(), {{0, 1}});
    world.add(sulfur::WindField{.zone = sulfur::CircleZone{{0, 1}, sulfur::Real(0.8)},
                                .velocity = {3, 0}});
    const auto before = world.hash();
    const atlax::Image image = picture(world);
    EXPECT_GT(count(image, style.field), 100);
    EXPECT_EQ(world.hash(), before);
}

}  // namespace
}  // namespace sulfurchamber
