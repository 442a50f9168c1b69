#include "fitting_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "palette.hpp"

namespace sulfurchamber {
namespace {

using atlax::Color;
using atlax::Vec2;
using Shape = FittingMark::Shape;

constexpr float zoneSpacing = 0.8f;   // metres between the arrows of a zone
constexpr float mostArrows = 400;     // of one zone
constexpr float windSeconds = 0.12f;  // an arrow is the way of this time

Vec2 onCircle(Vec2 centre, float radius, float angle) {
    return centre + Vec2{std::cos(angle), std::sin(angle)} * radius;
}

}  // namespace

FittingPainter::FittingPainter(atlax::Canvas& canvas, const Workbench& bench, float pixel)
    : canvas_(canvas), bench_(bench), pixel_(pixel), marks_(fittingMarks(bench.document())) {}

bool FittingPainter::isChosen(const FittingMark& mark) const {
    return bench_.fitting() == mark.ref;
}

void FittingPainter::paintZones() {
    for (const FittingMark& mark : marks_)
        if (mark.ref.kind == FittingRef::Kind::zone) paintZone(mark);
}

void FittingPainter::paintMarks() {
    for (const FittingMark& mark : marks_)
        if (mark.ref.kind != FittingRef::Kind::zone) paint(mark);
    paintPart();
}

// The particle or joint that is chosen.
void FittingPainter::paintPart() {
    const auto chosen = bench_.fitting();
    if (!chosen || !chosen->isPart()) return;
    const auto places = bench_.document().placesOf(*chosen);
    if (places.size() == 2)
        canvas_.line(Vec2(places[0]), Vec2(places[1]), 4 * pixel_, palette::ice);
    for (const sulfur::Point& place : places) {
        canvas_.circle(Vec2(place), 6 * pixel_, palette::ice);
        canvas_.circle(Vec2(place), 4 * pixel_, palette::deep);
    }
}

// A tinted pane with arrows that drift as what is in it does.
void FittingPainter::paintZone(const FittingMark& mark) {
    const Vec2 low(mark.points[0]), high(mark.points[1]);
    const Color color = mark.shape == Shape::wind ? palette::cold : palette::sky;
    const std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
    canvas_.polygon(corners, color.withAlpha(0.07f));
    const bool chosen = isChosen(mark);
    for (std::size_t i = 0; i < 4; ++i)
        canvas_.dashedLine(corners.at(i), corners.at((i + 1) % 4), (chosen ? 3 : 1.4f) * pixel_,
                           8 * pixel_, 5 * pixel_, chosen ? palette::ice : color.withAlpha(0.6f));
    const Vec2 way(mark.direction);
    const float speed = atlax::length(way);
    const Vec2 size = high - low;
    float spacing = zoneSpacing;
    while (size.x / spacing * size.y / spacing > mostArrows) spacing *= 2;
    const float length =
        std::clamp(speed * windSeconds, std::min(10 * pixel_, spacing / 3), 0.7f * spacing);
    const Vec2 along = speed > 0 ? way / speed : Vec2{};
    const auto time = static_cast<float>(std::fmod(bench_.document().world().time(), 1000.0));
    const float drift = mark.shape == Shape::wind ? std::fmod(time * speed, spacing) : 0;
    for (float x = low.x + spacing / 2 - spacing; x < high.x + spacing; x += spacing)
        for (float y = low.y + spacing / 2 - spacing; y < high.y + spacing; y += spacing) {
            const Vec2 at = Vec2{x, y} + along * (drift - length / 2);
            const Vec2 to = at + along * length;
            const auto in = [&](Vec2 p) {
                return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y;
            };
            if (!in(at) || !in(to)) continue;
            if (speed == 0) {
                canvas_.circle(at, 1.5f * pixel_, color.withAlpha(0.4f));
                continue;
            }
            canvas_.line(at, to, 1.5f * pixel_, color.withAlpha(0.4f));
            const Vec2 side = atlax::perpendicular(along) * (3 * pixel_);
            canvas_.triangle(to + along * (5 * pixel_), to + side, to - side,
                             color.withAlpha(0.5f));
        }
}

void FittingPainter::paint(const FittingMark& mark) {
    const bool chosen = isChosen(mark);
    const Color color = chosen ? palette::amber : palette::ice;
    if (chosen) canvas_.circle(Vec2(mark.at), 12 * pixel_, palette::amber.withAlpha(0.3f));
    switch (mark.shape) {
        case Shape::spring:
            paintSpring(Vec2(mark.points[0]), Vec2(mark.points[1]),
                        chosen ? palette::ice : palette::amber);
            break;
        case Shape::cable:
        case Shape::winch:
            paintRope(mark, color);
            break;
        case Shape::slider:
            paintRail(mark, color);
            break;
        case Shape::pulley:
            paintPulley(mark, color);
            break;
        case Shape::gear:
            paintGear(mark, color);
            break;
        case Shape::thruster:
            paintThruster(mark);
            break;
        default:
            paintPin(mark, color);
            break;
    }
}

void FittingPainter::paintPin(const FittingMark& mark, Color color) {
    const Vec2 at(mark.at);
    const float radius = 4.5f * pixel_;
    canvas_.circle(at, radius + 1.5f * pixel_, palette::deep);
    if (mark.shape == Shape::weld) {
        const Vec2 half{0.6f * radius, 0.6f * radius};
        canvas_.rect({at - half, half * 2.0f}, color);
        return;
    }
    canvas_.circleOutline(at, radius, 1.8f * pixel_, color);
    if (mark.shape == Shape::hinge) canvas_.circle(at, 1.4f * pixel_, color);
    if (mark.shape == Shape::motor || mark.shape == Shape::axle) paintTurning(mark);
}

// Three quarters of a turn with a head, in the direction of the motor.
void FittingPainter::paintTurning(const FittingMark& mark) {
    if (mark.direction.x() == 0) return;
    constexpr int steps = 14;
    const float sign = mark.direction.x() > 0 ? 1.0f : -1.0f;
    const float radius = 9.5f * pixel_;
    const Vec2 at(mark.at);
    std::array<Vec2, steps + 1> arc;
    const auto angle = [&](float share) {
        return sign * (share * 1.5f * static_cast<float>(std::numbers::pi) - 0.6f);
    };
    for (int i = 0; i <= steps; ++i)
        arc.at(static_cast<std::size_t>(i)) =
            onCircle(at, radius, angle(static_cast<float>(i) / steps));
    canvas_.polyline(arc, 1.8f * pixel_, palette::amber);
    const Vec2 end = arc.back();
    const Vec2 out = (end - at) / radius;
    const Vec2 along = atlax::perpendicular(out) * sign;
    canvas_.triangle(end + along * (6 * pixel_), end + out * (4 * pixel_), end - out * (4 * pixel_),
                     palette::amber);
}

void FittingPainter::paintSpring(Vec2 from, Vec2 to, Color color) {
    constexpr int turns = 9;
    const float length = atlax::length(to - from);
    if (!(length > 0)) return;
    const Vec2 along = (to - from) / length;
    const Vec2 side = atlax::perpendicular(along) * std::min(7 * pixel_, length * 0.12f);
    const float straight = std::min(8 * pixel_, length * 0.15f);
    std::vector<Vec2> points{from, from + along * straight};
    for (int i = 0; i < 2 * turns; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / (2 * turns);
        points.push_back(from + along * (straight + share * (length - 2 * straight)) +
                         side * (i % 2 == 0 ? 1.0f : -1.0f));
    }
    points.push_back(to - along * straight);
    points.push_back(to);
    canvas_.polyline(points, 2 * pixel_, color);
    canvas_.circle(from, 3 * pixel_, color);
    canvas_.circle(to, 3 * pixel_, color);
}

// One that is longer than the way sags.
void FittingPainter::paintRope(const FittingMark& mark, Color color) {
    const Vec2 from(mark.points[0]), to(mark.points[1]);
    const float length = atlax::length(to - from);
    const auto whole = static_cast<float>(mark.length);
    const float spare = std::isfinite(whole) ? std::max(0.0f, whole - length) : 0;
    const float sag = std::sqrt(0.375f * spare * std::max(length, spare / 3));
    constexpr int steps = 16;
    std::array<Vec2, steps + 1> points;
    for (int i = 0; i <= steps; ++i) {
        const float t = static_cast<float>(i) / steps;
        points.at(static_cast<std::size_t>(i)) =
            from + (to - from) * t - Vec2{0, 4 * sag * t * (1 - t)};
    }
    canvas_.polyline(points, 2.2f * pixel_, color);
    canvas_.circle(to, 3 * pixel_, color);
    if (mark.shape == Shape::cable) {
        canvas_.circle(from, 3 * pixel_, color);
        return;
    }
    canvas_.circle(from, 8 * pixel_, palette::deep);
    canvas_.circleOutline(from, 8 * pixel_, 2 * pixel_, palette::amber);
    canvas_.circle(from, 3 * pixel_, palette::amber);
}

void FittingPainter::paintRail(const FittingMark& mark, Color color) {
    std::vector<Vec2> line;
    for (const auto& point : mark.points) line.emplace_back(point);
    const Vec2 at = line.back();
    line.pop_back();
    canvas_.polyline(line, 3 * pixel_, palette::steel);
    canvas_.polyline(line, pixel_, color.withAlpha(0.8f));
    const auto paintEnd = [&](const Vec2& end, const Vec2& next) {
        const float length = atlax::length(next - end);
        if (!(length > 0)) return;
        const Vec2 across = atlax::perpendicular((next - end) / length) * (5 * pixel_);
        canvas_.line(end - across, end + across, 2 * pixel_, color);
    };
    // A closed one has no ends.
    if (atlax::length(line.back() - line.front()) > 0) {
        paintEnd(line.front(), line[1]);
        paintEnd(line.back(), line[line.size() - 2]);
    }
    const Vec2 half{5 * pixel_, 5 * pixel_};
    canvas_.rect({at - half, half * 2.0f}, palette::deep);
    canvas_.rect({at - half * 0.7f, half * 1.4f}, mark.direction.x() != 0 ? palette::amber : color);
}

void FittingPainter::paintPulley(const FittingMark& mark, Color color) {
    for (std::size_t i = 1; i < mark.points.size(); ++i)
        canvas_.line(Vec2(mark.points[i - 1]), Vec2(mark.points[i]), 2 * pixel_, color);
    for (const std::size_t over : {1u, 2u}) {
        const Vec2 at(mark.points[over]);
        canvas_.circle(at, 8 * pixel_, palette::deep);
        canvas_.circleOutline(at, 8 * pixel_, 2 * pixel_, color);
        canvas_.circle(at, 2 * pixel_, color);
    }
    for (const std::size_t end : {0u, 3u})
        canvas_.circle(Vec2(mark.points[end]), 3 * pixel_, color);
}

void FittingPainter::paintGear(const FittingMark& mark, Color color) {
    constexpr int teeth = 8;
    canvas_.dashedLine(Vec2(mark.points[0]), Vec2(mark.points[1]), 1.4f * pixel_, 5 * pixel_,
                       4 * pixel_, color.withAlpha(0.6f));
    const Vec2 at(mark.at);
    for (int i = 0; i < teeth; ++i) {
        const float angle =
            static_cast<float>(i) * 2 * static_cast<float>(std::numbers::pi) / teeth;
        canvas_.line(onCircle(at, 4 * pixel_, angle), onCircle(at, 7.5f * pixel_, angle),
                     2.4f * pixel_, color);
    }
    canvas_.circle(at, 5 * pixel_, palette::deep);
    canvas_.circleOutline(at, 5 * pixel_, 1.8f * pixel_, color);
}

// A nozzle; what comes out of it goes against the force.
void FittingPainter::paintThruster(const FittingMark& mark) {
    const Vec2 force(mark.direction);
    const float size = atlax::length(force);
    const Vec2 along = size > 0 ? force / size : Vec2{0, 1};
    const Vec2 side = atlax::perpendicular(along);
    const Vec2 at(mark.at);
    const Controls& controls = bench_.controls();
    const bool runs =
        bench_.document().playing() && (!mark.keys.any() || controls.holds(mark.keys.forward));
    const bool back = bench_.document().playing() && controls.holds(mark.keys.back);
    if (runs || back) {
        const float way = runs ? -1.0f : 1.0f;
        const auto flicker = static_cast<float>(bench_.document().world().ticks() % 7) / 7;
        const Vec2 tip = at + along * (way * (26 + 10 * flicker) * pixel_);
        canvas_.triangle(tip, at + side * (6 * pixel_), at - side * (6 * pixel_),
                         palette::hot.withAlpha(0.7f));
        canvas_.triangle(at + (tip - at) * 0.65f, at + side * (4 * pixel_),
                         at - side * (4 * pixel_), palette::amber);
    }
    const std::array<Vec2, 4> nozzle{at + along * (7 * pixel_) + side * (3 * pixel_),
                                     at - along * (5 * pixel_) + side * (7 * pixel_),
                                     at - along * (5 * pixel_) - side * (7 * pixel_),
                                     at + along * (7 * pixel_) - side * (3 * pixel_)};
    canvas_.polygon(nozzle, palette::deep);
    canvas_.polygonOutline(nozzle, 1.8f * pixel_, isChosen(mark) ? palette::amber : palette::ice);
    const Vec2 head = at + along * (22 * pixel_);
    canvas_.line(at + along * (8 * pixel_), head, 1.6f * pixel_, palette::amber);
    canvas_.triangle(head + along * (6 * pixel_), head + side * (4 * pixel_),
                     head - side * (4 * pixel_), palette::amber);
}

void FittingPainter::paintKeys(const atlax::Font& font) {
    for (const FittingMark& mark : marks_) {
        Vec2 at = Vec2(mark.at) + Vec2{13 * pixel_, -24 * pixel_};
        for (const std::string& key : {mark.keys.forward, mark.keys.back}) {
            if (key.empty()) continue;
            paintKey(key, at, font);
            at.x += 20 * pixel_;
        }
    }
}

// A key cap with a letter or an arrow; bright while it is held.
void FittingPainter::paintKey(const std::string& key, Vec2 low, const atlax::Font& font) {
    const bool held = bench_.controls().holds(key);
    const Color ink = held ? palette::deep : palette::amber;
    const Vec2 size{18 * pixel_, 18 * pixel_};
    canvas_.roundedRect({low, size}, 4 * pixel_,
                        held ? palette::amber : palette::deep.withAlpha(0.85f));
    canvas_.roundedRectOutline({low, size}, 4 * pixel_, 1.2f * pixel_, palette::amber);
    const Vec2 middle = low + size * 0.5f;
    if (key.size() == 1) {
        canvas_.text(font, key, middle,
                     {13 * pixel_, ink, atlax::AlignX::Centre, atlax::AlignY::Middle});
        return;
    }
    const Vec2 way = key == "Right"  ? Vec2{1, 0}
                     : key == "Left" ? Vec2{-1, 0}
                     : key == "Up"   ? Vec2{0, 1}
                                     : Vec2{0, -1};
    const Vec2 side = atlax::perpendicular(way) * (4.5f * pixel_);
    canvas_.triangle(middle + way * (5 * pixel_), middle - way * (3.5f * pixel_) + side,
                     middle - way * (3.5f * pixel_) - side, ink);
}

}  // namespace sulfurchamber
