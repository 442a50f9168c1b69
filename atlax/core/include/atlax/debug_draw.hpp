#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include <atlax/canvas.hpp>

namespace atlax {

/// What a thing of a physics world is doing; told by its colour.
enum class DebugState : std::uint8_t {
    Moving = 0,
    Asleep,
    Driven,  ///< moved by the program
    Fixed,
};
inline constexpr int debugStateCount = 4;

/// How debug drawing looks. Lengths are logical pixels, so that they look alike at any zoom.
struct DebugStyle {
    Color states[debugStateCount] = {Color::hex(0x8FE388), Color::hex(0x6F7FA3),
                                     Color::hex(0x6FA8DC), Color::hex(0xC9CFDA)};
    Color pulled = Color::hex(0xFFB347);   ///< a joint that pulls with all it can bear
    Color pressed = Color::hex(0x43D9E8);  ///< one that is pressed so
    Color contact = Color::hex(0xFF5E57);
    Color spring = Color::hex(0xE08CFF);  ///< what holds or pulls from outside
    Color velocity = Color::hex(0xF4F1A6);
    Color field = Color::hex(0x4E7FD0);
    float line = 1.25f;
    float dot = 2.5f;                    ///< radius of a particle
    float velocitySeconds = 0.1f;        ///< arrows are as long as the way of this time
    float metresPerNewtonSecond = 0.2f;  ///< length of a contact's arrow
};

/// What an adaptor of a physics library draws with: the things that such libraries have, in metres,
/// each as the few lines that show it. Knows no library; made by drawDebug(). Whatever is not
/// finite, or has no size, is left out. Thread of the canvas; nothing throws.
class DebugPen {
public:
    /// Both must outlive the pen.
    DebugPen(Canvas& canvas, const DebugStyle& style);

    /// A point mass.
    void particle(Vec2 place, DebugState state);
    /// Something round that collides.
    void disc(Vec2 centre, float radius, DebugState state);
    /// A line with a radius that collides.
    void capsule(Vec2 a, Vec2 b, float radius, DebugState state);
    /// A closed outline that collides.
    void outline(std::span<const Vec2> points, DebugState state);
    /// What keeps two points apart; `load` -1..1 is its force as a share of what it bears, positive
    /// when it pulls. Beyond that it counts as 1.
    void joint(Vec2 a, Vec2 b, float load, DebugState state);
    /// Where two things touch: a cross, and an arrow along the normal as long as the impulse (N s).
    void contact(Vec2 point, Vec2 normal, float impulse);
    /// Something that pulls a point to another place: dashes with a ring at the place.
    void spring(Vec2 held, Vec2 target);
    void velocity(Vec2 place, Vec2 metresPerSecond);
    /// A cross in a ring.
    void centreOfMass(Vec2 place, DebugState state);
    void bounds(Rect rect, DebugState state);
    /// Where a field of force acts; `direction` (0 for none) points where it pushes.
    void field(Vec2 centre, float radius, Vec2 direction);
    void field(Rect zone, Vec2 direction);
    /// A few words beside a point.
    void label(const Font& font, Vec2 place, std::string_view utf8);

private:
    Color colorOf(DebugState state) const;
    void arrow(Vec2 from, Vec2 to, Color color);
    void cross(Vec2 place, float reach, Color color);

    Canvas& canvas_;
    const DebugStyle& style_;
    float pixel_;  ///< a logical pixel in metres
};

/// Tells a pen what there is in a world; an adaptor of a physics library is one.
using DebugWorld = std::function<void(DebugPen&)>;

/// Draws a physics world over what is drawn already, with the canvas's present camera (see
/// Canvas::setCamera), clip and opacity; alpha blending afterwards. A null `world` draws nothing;
/// what it throws passes through. Between beginFrame and endFrame, thread of the canvas.
void drawDebug(Canvas& canvas, const DebugWorld& world, const DebugStyle& style = {});

}  // namespace atlax
