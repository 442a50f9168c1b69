#include "force_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "../model/forces.hpp"
#include "../model/meters.hpp"
#include "../model/words.hpp"
#include "palette.hpp"
#include "plot_layout.hpp"

namespace sulfurchamber {
namespace {

using atlax::Color;
using atlax::Vec2;

constexpr double weightPixels = 70;    // of the heaviest body
constexpr double longestPixels = 600;  // of any arrow
constexpr float shortestPixels = 4;
constexpr float legendWidth = 190;
constexpr float legendLine = 20;
constexpr float legendMargin = 12;
constexpr float aboveRuler = 30;

Color forceColour(ForceKind kind) {
    return kind == ForceKind::gravity   ? palette::ice
           : kind == ForceKind::contact ? palette::hot
                                        : palette::amber;
}

void paintArrow(atlax::Canvas& canvas, Vec2 from, Vec2 way, Color colour) {
    const float length = atlax::length(way);
    if (length < shortestPixels) return;
    const Vec2 along = way / length;
    const float head = std::min(8.0f, length * 0.6f);
    const Vec2 to = from + way;
    const Vec2 neck = to - along * head;
    const Vec2 side = atlax::perpendicular(along) * (head * 0.45f);
    canvas.line(from, neck, 2, colour);
    canvas.triangle(to, neck + side, neck - side, colour);
}

// One line of the legend: an arrow as long as a round number.
struct ArrowLegend {
    std::string name;
    Color colour;
    double value;  // of the arrow
    double pixels;
    std::string unit;
};

double roundBelow(double value) {
    const double above = roundAbove(value);
    for (const double part : {1.0, 0.5, 0.4, 0.2, 0.1})
        if (above * part <= value * (1 + 1e-9)) {
            const double power = std::pow(10, std::floor(std::log10(above * part) + 1e-9));
            const double digit = above * part / power;
            return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
        }
    return above / 10;
}

std::vector<ArrowLegend> arrowLegends(const atlax::Camera& camera, float scale,
                                      const sulfur::World& world, const ViewOptions& options) {
    std::vector<ArrowLegend> lines;
    if (options.velocities) {
        // Arrows of velocities are ways in metres.
        const double perUnit =
            static_cast<double>(velocityArrowSeconds * camera.pixelsPerMetre / scale);
        const double value = roundBelow(weightPixels / perUnit);
        lines.push_back({"Velocity", palette::cold, value, value * perUnit, "m/s"});
    }
    const double perNewton = pixelsPerNewton(world);
    const double newtons = roundBelow(weightPixels / perNewton);
    const auto force = [&](const char* name, ForceKind kind) {
        lines.push_back({name, forceColour(kind), newtons, newtons * perNewton, "N"});
    };
    if (options.gravity) force("Weight", ForceKind::gravity);
    if (options.contactForces) force("Contact", ForceKind::contact);
    if (options.jointForces) force("Joint", ForceKind::joint);
    return lines;
}

// The colours from pressed to stretched.
void paintStrainBar(atlax::Canvas& canvas, const atlax::Font& font, Vec2 corner) {
    const float width = legendWidth - 2 * legendMargin;
    constexpr int steps = 48;
    for (int i = 0; i < steps; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / steps;
        const float strain = (2 * share - 1) * strainAtFullColour;
        canvas.rect({corner + Vec2{width * static_cast<float>(i) / steps, 18}, {width / steps, 9}},
                    strainColour(strain));
    }
    const Color ink = palette::ice.withAlpha(0.9f);
    canvas.text(font, tr("Strain of joints"), corner + Vec2{0, 9},
                {12, ink, atlax::AlignX::Left, atlax::AlignY::Middle});
    const std::string full = numberText(static_cast<double>(strainAtFullColour) * 100, 1);
    canvas.text(font, "-" + full + " %", corner + Vec2{0, 36},
                {11, ink, atlax::AlignX::Left, atlax::AlignY::Middle});
    canvas.text(font, "0", corner + Vec2{width / 2, 36},
                {11, ink, atlax::AlignX::Centre, atlax::AlignY::Middle});
    canvas.text(font, "+" + full + " %", corner + Vec2{width, 36},
                {11, ink, atlax::AlignX::Right, atlax::AlignY::Middle});
}

}  // namespace

double pixelsPerNewton(const sulfur::World& world) {
    return weightPixels / typicalForce(world);
}

void paintForces(atlax::Canvas& canvas, const atlax::Camera& camera, const sulfur::World& world,
                 const ViewOptions& options) {
    std::vector<ForceArrow> arrows;
    const auto take = [&](std::vector<ForceArrow> more) {
        arrows.insert(arrows.end(), more.begin(), more.end());
    };
    if (options.gravity) take(gravityForces(world));
    if (options.jointForces) take(jointForces(world));
    if (options.contactForces) take(contactForces(world));
    if (arrows.empty()) return;
    const float scale = canvas.scaleFactor();
    canvas.setScreenSpace(scale);
    const double perNewton = pixelsPerNewton(world);
    for (const ForceArrow& arrow : arrows) {
        const double length = std::min(arrow.force.norm() * perNewton, longestPixels);
        if (!(length > 0)) continue;
        const sulfur::Point way = arrow.force.normalized() * length;
        const Vec2 from = camera.toScreen(Vec2(arrow.at), canvas.size()) / scale;
        paintArrow(canvas, from, {static_cast<float>(way.x()), static_cast<float>(-way.y())},
                   forceColour(arrow.kind));
    }
}

void paintLegend(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
                 const sulfur::World& world, const ViewOptions& options) {
    const float scale = canvas.scaleFactor();
    const auto arrows = arrowLegends(camera, scale, world, options);
    const float strain = options.strain ? 46.0f : 0.0f;
    if (arrows.empty() && strain == 0) return;
    canvas.setScreenSpace(scale);
    const Vec2 size = canvas.size().toVec() / scale;
    const float height = static_cast<float>(arrows.size()) * legendLine + strain + 10;
    Vec2 at = size - Vec2{legendWidth + 10, height + aboveRuler};
    canvas.roundedRect({at, {legendWidth, height}}, 6, palette::deep.withAlpha(0.8f));
    at += {legendMargin, 5};
    for (const ArrowLegend& line : arrows) {
        const float middle = at.y + legendLine / 2;
        canvas.text(font, tr(line.name), {at.x, middle},
                    {12, line.colour, atlax::AlignX::Left, atlax::AlignY::Middle});
        const float begin = at.x + 58;
        paintArrow(canvas, {begin, middle}, {static_cast<float>(line.pixels), 0}, line.colour);
        canvas.text(font, numberText(line.value, line.value) + " " + line.unit,
                    {at.x + legendWidth - 2 * legendMargin, middle},
                    {11, palette::ice, atlax::AlignX::Right, atlax::AlignY::Middle});
        at.y += legendLine;
    }
    if (strain > 0) paintStrainBar(canvas, font, at);
}

}  // namespace sulfurchamber
