#include "grid_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "palette.hpp"

namespace sulfurchamber {
namespace {

constexpr float labelledPixels = 72;  // least distance of labelled lines, logical pixels
constexpr float rulerHeight = 20;     // logical pixels
constexpr float rulerWidth = 40;

std::string label(double metres, double step) {
    std::array<char, 32> text{};
    const int digits = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    std::snprintf(text.data(), text.size(), "%.*f", digits,
                  std::abs(metres) < step / 2 ? 0 : metres);
    return text.data();
}

// Calls visit(metres, is it a labelled line) for each line between two places, with an integer
// counter, so that the lines do not drift.
template <class Visit>
void forEachLine(double from, double to, const GridSteps& steps, const Visit& visit) {
    const auto perLabel = std::llround(steps.labelled / steps.fine);
    const auto last = static_cast<long long>(std::floor(to / steps.fine));
    for (auto i = static_cast<long long>(std::ceil(from / steps.fine)); i <= last; ++i)
        visit(static_cast<double>(i) * steps.fine, i % perLabel == 0);
}

// From afar chosen lines would be one surface.
GridSteps drawnSteps(const atlax::Camera& camera, float scale, double chosen) {
    GridSteps steps = gridSteps(camera.pixelsPerMetre, scale, chosen);
    if (steps.fine * static_cast<double>(camera.pixelsPerMetre) < static_cast<double>(4 * scale))
        steps.fine = steps.labelled;
    return steps;
}

}  // namespace

GridSteps gridSteps(float pixelsPerMetre, float scaleFactor, double chosen) {
    const double least = static_cast<double>(labelledPixels * scaleFactor / pixelsPerMetre);
    for (double power = std::pow(10.0, std::floor(std::log10(least)));; power *= 10)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double step = factor * power;
            if (step < least) continue;
            if (!(chosen > 0)) return {step, step / (factor == 2.0 ? 4 : 5)};
            // Labels stand on lines.
            const double lines = step / chosen;
            if (lines > 0.5 && std::abs(lines - std::round(lines)) < 1e-6) return {step, chosen};
        }
}

void paintGrid(atlax::Canvas& canvas, const atlax::Camera& camera, double chosen) {
    const GridSteps steps = drawnSteps(camera, canvas.scaleFactor(), chosen);
    const atlax::Rect view = camera.view(canvas.size());
    const float hair = canvas.pixel();
    const auto color = [](double at, bool labelled) {
        if (at == 0) return palette::sky.withAlpha(0.34f);
        return palette::sky.withAlpha(labelled ? 0.16f : 0.06f);
    };
    forEachLine(static_cast<double>(view.min.x), static_cast<double>(view.max().x), steps,
                [&](double x, bool labelled) {
                    const auto at = static_cast<float>(x);
                    canvas.line({at, view.min.y}, {at, view.max().y}, hair, color(x, labelled));
                });
    forEachLine(static_cast<double>(view.min.y), static_cast<double>(view.max().y), steps,
                [&](double y, bool labelled) {
                    const auto at = static_cast<float>(y);
                    canvas.line({view.min.x, at}, {view.max().x, at}, hair, color(y, labelled));
                });
}

void paintRulers(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
                 double chosen) {
    const float scale = canvas.scaleFactor();
    const GridSteps steps = drawnSteps(camera, scale, chosen);
    const atlax::PixelSize size = canvas.size();
    const atlax::Vec2 extent = size.toVec() / scale;
    const atlax::Rect view = camera.view(size);
    canvas.setScreenSpace(scale);
    const float top = extent.y - rulerHeight;
    canvas.rect({{0, top}, {extent.x, rulerHeight}}, palette::deep.withAlpha(0.82f));
    canvas.rect({{0, 0}, {rulerWidth, top}}, palette::deep.withAlpha(0.82f));
    const atlax::Color ink = palette::sky.withAlpha(0.9f);
    const atlax::TextStyle below{11, ink, atlax::AlignX::Centre, atlax::AlignY::Middle};
    const atlax::TextStyle left{11, ink, atlax::AlignX::Right, atlax::AlignY::Middle};
    forEachLine(
        static_cast<double>(view.min.x), static_cast<double>(view.max().x), steps,
        [&](double x, bool labelled) {
            const float at = camera.toScreen({static_cast<float>(x), 0}, size).x / scale;
            if (at < rulerWidth + 12) return;
            canvas.line({at, top}, {at, top + (labelled ? 4.0f : 2.0f)}, 1, ink.faded(0.6f));
            if (labelled && at < extent.x - 16)
                canvas.text(font, label(x, steps.labelled), {at, top + 12}, below);
        });
    forEachLine(static_cast<double>(view.min.y), static_cast<double>(view.max().y), steps,
                [&](double y, bool labelled) {
                    const float at = camera.toScreen({0, static_cast<float>(y)}, size).y / scale;
                    if (at > top - 8) return;
                    canvas.line({rulerWidth - (labelled ? 4.0f : 2.0f), at}, {rulerWidth, at}, 1,
                                ink.faded(0.6f));
                    if (labelled)
                        canvas.text(font, label(y, steps.labelled), {rulerWidth - 7, at}, left);
                });
    canvas.text(font, "m", {rulerWidth / 2, top + 11}, below);
}

}  // namespace sulfurchamber
