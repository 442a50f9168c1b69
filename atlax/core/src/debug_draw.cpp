#include <algorithm>
#include <atlax/debug_draw.hpp>
#include <cmath>

namespace atlax {

namespace {

constexpr float arrowHead = 6;  // logical pixels, as all here
constexpr float crossReach = 4;
constexpr float ringRadius = 5;
constexpr float dash = 5;
constexpr float labelSize = 12;
constexpr float faint = 0.35f;

bool finite(Vec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

Color between(Color a, Color b, float t) {
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t,
            a.a + (b.a - a.a) * t};
}

}  // namespace

DebugPen::DebugPen(Canvas& canvas, const DebugStyle& style)
    : canvas_(canvas), style_(style), pixel_(canvas.pixel() * canvas.scaleFactor()) {}

Color DebugPen::colorOf(DebugState state) const {
    const auto index = static_cast<std::size_t>(state);
    return style_.states[index < debugStateCount ? index : 0];
}

void DebugPen::cross(Vec2 place, float reach, Color color) {
    const float r = reach * pixel_;
    const float width = style_.line * pixel_;
    canvas_.line(place - Vec2{r, r}, place + Vec2{r, r}, width, color);
    canvas_.line(place - Vec2{r, -r}, place + Vec2{r, -r}, width, color);
}

void DebugPen::arrow(Vec2 from, Vec2 to, Color color) {
    if (!finite(from) || !finite(to)) return;
    const Vec2 way = to - from;
    const float head = std::min(arrowHead * pixel_, length(way) * 0.5f);
    if (!(head > 0)) return;
    const Vec2 back = normalized(way) * head;
    canvas_.line(from, to, style_.line * pixel_, color);
    canvas_.triangle(to, to - back + perpendicular(back) * 0.5f,
                     to - back - perpendicular(back) * 0.5f, color);
}

void DebugPen::particle(Vec2 place, DebugState state) {
    canvas_.circle(place, style_.dot * pixel_, colorOf(state));
}

void DebugPen::disc(Vec2 centre, float radius, DebugState state) {
    if (!(radius > 0)) return;
    canvas_.circleOutline(centre, radius, style_.line * pixel_, colorOf(state));
}

void DebugPen::capsule(Vec2 a, Vec2 b, float radius, DebugState state) {
    if (!(radius > 0)) return;
    canvas_.capsuleOutline(a, b, radius, style_.line * pixel_, colorOf(state));
}

void DebugPen::outline(std::span<const Vec2> points, DebugState state) {
    if (points.size() < 2 || !std::all_of(points.begin(), points.end(), finite)) return;
    canvas_.polyline(points, style_.line * pixel_, colorOf(state), points.size() > 2);
}

void DebugPen::joint(Vec2 a, Vec2 b, float load, DebugState state) {
    const float share = std::isfinite(load) ? std::clamp(load, -1.0f, 1.0f) : 0.0f;
    const Color calm = colorOf(state).faded(faint * 2);
    const Color color =
        between(calm, share > 0 ? style_.pulled : style_.pressed, std::sqrt(std::abs(share)));
    canvas_.line(a, b, style_.line * pixel_, color);
}

void DebugPen::contact(Vec2 point, Vec2 normal, float impulse) {
    if (!finite(point) || !finite(normal) || !std::isfinite(impulse)) return;
    cross(point, crossReach * 0.7f, style_.contact);
    arrow(point, point + normal * (impulse * style_.metresPerNewtonSecond), style_.contact);
}

void DebugPen::spring(Vec2 held, Vec2 target) {
    if (!finite(held) || !finite(target)) return;
    canvas_.dashedLine(held, target, style_.line * pixel_, dash * pixel_, dash * pixel_,
                       style_.spring);
    canvas_.circleOutline(target, ringRadius * pixel_, style_.line * pixel_, style_.spring);
}

void DebugPen::velocity(Vec2 place, Vec2 metresPerSecond) {
    arrow(place, place + metresPerSecond * style_.velocitySeconds, style_.velocity);
}

void DebugPen::centreOfMass(Vec2 place, DebugState state) {
    cross(place, crossReach, colorOf(state));
    canvas_.circleOutline(place, ringRadius * pixel_, style_.line * pixel_, colorOf(state));
}

void DebugPen::bounds(Rect rect, DebugState state) {
    const Vec2 corners[] = {
        rect.min, {rect.max().x, rect.min.y}, rect.max(), {rect.min.x, rect.max().y}};
    if (!std::all_of(std::begin(corners), std::end(corners), finite)) return;
    canvas_.polyline(corners, style_.line * pixel_, colorOf(state).faded(faint), true);
}

void DebugPen::field(Vec2 centre, float radius, Vec2 direction) {
    if (radius > 0) canvas_.circleOutline(centre, radius, style_.line * pixel_, style_.field);
    arrow(centre, centre + direction, style_.field);
}

void DebugPen::field(Rect zone, Vec2 direction) {
    const Vec2 corners[] = {
        zone.min, {zone.max().x, zone.min.y}, zone.max(), {zone.min.x, zone.max().y}};
    if (!std::all_of(std::begin(corners), std::end(corners), finite)) return;
    canvas_.polyline(corners, style_.line * pixel_, style_.field, true);
    arrow(zone.centre(), zone.centre() + direction, style_.field);
}

void DebugPen::label(const Font& font, Vec2 place, std::string_view utf8) {
    canvas_.text(font, utf8, place + Vec2{ringRadius, ringRadius} * pixel_,
                 {labelSize * pixel_, colors::white});
}

void drawDebug(Canvas& canvas, const DebugWorld& world, const DebugStyle& style) {
    if (!world) return;
    canvas.setBlend(Blend::Alpha);
    DebugPen pen(canvas, style);
    world(pen);
}

}  // namespace atlax
