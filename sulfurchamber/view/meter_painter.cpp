#include "meter_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "palette.hpp"
#include "plot_layout.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {
namespace {

using atlax::Color;
using atlax::Vec2;
using sulfur::Point;

constexpr double traceSeconds = 20;
constexpr std::size_t tracePoints = 800;
constexpr float dialStart = 210;  // degrees of a dial's zero, anticlockwise from the right
constexpr float dialSweep = 240;  // degrees, clockwise
constexpr float radian = std::numbers::pi_v<float> / 180;

// One frame's way from metres to logical pixels.
class MeterPen {
public:
    MeterPen(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
             const Workbench& bench, double alpha)
        : canvas_(canvas), camera_(camera), font_(font), bench_(bench), alpha_(alpha) {
        canvas_.setScreenSpace(canvas_.scaleFactor());
    }

    void paint(const Meter& meter) {
        selected_ = bench_.meterSelected(meter.id);
        ink_ = selected_ ? palette::ice : palette::amber;
        std::vector<Vec2> ends;
        for (std::size_t i = 0; i < meter.ends.size(); ++i)
            if (const auto place = meters().place(meter, i, alpha_)) ends.push_back(pixels(*place));
        if (ends.size() != meter.ends.size()) return;
        switch (meter.kind) {
            case MeterKind::ruler:
                ruler(meter, ends[0], ends[1]);
                break;
            case MeterKind::protractor:
                protractor(meter, ends);
                break;
            case MeterKind::tracer:
                tracer(meter, ends[0]);
                break;
            case MeterKind::gauge:
                gauge(meter, ends.size() == 1 ? ends[0] : (ends[0] + ends[1]) * 0.5f);
                break;
            case MeterKind::gun:
                gun(meter, ends[0], ends[1]);
                break;
        }
        if (selected_ && meter.kind != MeterKind::gauge)
            for (const Vec2& end : ends) handle(end);
    }

private:
    const Meters& meters() const { return bench_.meters(); }
    Vec2 pixels(const Point& place) const {
        return camera_.toScreen(Vec2(place), canvas_.size()) / canvas_.scaleFactor();
    }
    void handle(Vec2 at) {
        canvas_.rect({at - Vec2{4, 4}, {8, 8}}, palette::ice);
        canvas_.rect({at - Vec2{2.4f, 2.4f}, {4.8f, 4.8f}}, palette::steel);
    }
    // A text on a plate, its middle at a place.
    void label(const std::string& words, Vec2 middle, Color ink) {
        const auto extent = canvas_.measure(font_, words, 15);
        const Vec2 half{extent.width / 2 + 6, 11};
        canvas_.roundedRect({middle - half, half * 2}, 5, palette::deep.withAlpha(0.82f));
        canvas_.text(font_, words, middle, {15, ink, atlax::AlignX::Centre, atlax::AlignY::Middle});
    }

    // Strokes at round lengths, longer ones at each fifth.
    void ruler(const Meter& meter, Vec2 from, Vec2 to) {
        const float length = atlax::length(to - from);
        if (!(length > 0)) return;
        const Vec2 along = (to - from) / length;
        Vec2 across{along.y, -along.x};
        if (across.y > 0) across = across * -1.0f;
        canvas_.line(from, to, 2, ink_);
        canvas_.line(from - across * 5, from + across * 9, 2, ink_);
        canvas_.line(to - across * 5, to + across * 9, 2, ink_);
        const double perPixel = canvas_.scaleFactor() / camera_.pixelsPerMetre;
        const double step = roundAbove(7 * perPixel);
        const double metres = static_cast<double>(length) * perPixel;
        for (int i = 1; i * step < metres && i < 1000; ++i) {
            const Vec2 at = from + along * static_cast<float>(i * step / perPixel);
            const float stroke = i % 10 == 0 ? 9.0f : i % 5 == 0 ? 7.0f : 4.0f;
            canvas_.line(at, at + across * stroke, 1, ink_.withAlpha(0.8f));
        }
        label(meterText(meters(), meter), (from + to) * 0.5f - across * 18, ink_);
    }

    void protractor(const Meter& meter, const std::vector<Vec2>& ends) {
        const Vec2 corner = ends[0];
        const Vec2 a = ends[1] - corner, b = ends[2] - corner;
        canvas_.line(corner, ends[1], 1.6f, ink_);
        canvas_.line(corner, ends[2], 1.6f, ink_);
        canvas_.circle(corner, 3, ink_);
        const float shorter = std::min(atlax::length(a), atlax::length(b));
        const float radius = std::clamp(shorter * 0.6f, 14.0f, 70.0f);
        const float from = std::atan2(-a.y, a.x);
        float turn = std::remainder(std::atan2(-b.y, b.x) - from, 360 * radian);
        const auto at = [&](float angle, float r) {
            return corner + Vec2{std::cos(angle), -std::sin(angle)} * r;
        };
        const int steps = std::max(2, static_cast<int>(std::abs(turn) / (4 * radian)));
        for (int i = 0; i < steps; ++i)
            canvas_.line(
                at(from + turn * static_cast<float>(i) / static_cast<float>(steps), radius),
                at(from + turn * static_cast<float>(i + 1) / static_cast<float>(steps), radius), 2,
                ink_);
        // A stroke for each ten degrees from the first leg on.
        const float way = turn < 0 ? -10 * radian : 10 * radian;
        for (int i = 1; std::abs(way) * static_cast<float>(i) < std::abs(turn); ++i) {
            const float angle = from + way * static_cast<float>(i);
            canvas_.line(at(angle, radius - 3), at(angle, radius + 3), 1, ink_.withAlpha(0.7f));
        }
        label(meterText(meters(), meter), at(from + turn / 2, radius + 26), ink_);
    }

    // What is old fades. In a moment that was rewound to, what came later is not shown.
    void tracer(const Meter& meter, Vec2 at) {
        const auto record = meters().record(meter.id);
        const double now = bench_.document().world().time();
        if (record.size() == 3) {
            const auto x = between(record[1].samples, now - traceSeconds, now + 1e-9);
            const auto y = between(record[2].samples, now - traceSeconds, now + 1e-9);
            const std::size_t step = x.size() / tracePoints + 1;
            for (std::size_t k = step; k < x.size() && k < y.size(); k += step) {
                const auto age = static_cast<float>((now - x[k].time) / traceSeconds);
                canvas_.line(pixels({x[k - step].value, y[k - step].value}),
                             pixels({x[k].value, y[k].value}), 2,
                             palette::amber.withAlpha(0.95f * (1 - age)));
            }
        }
        canvas_.circle(at, 4.5f, palette::deep);
        canvas_.circleOutline(at, 4.5f, 1.6f, ink_);
        canvas_.circle(at, 1.8f, ink_);
        if (selected_) label(meterText(meters(), meter), at + Vec2{0, -20}, ink_);
    }

    Vec2 onDial(Vec2 middle, double share, float radius) const {
        const float angle = (dialStart - dialSweep * static_cast<float>(share)) * radian;
        return middle + Vec2{std::cos(angle), -std::sin(angle)} * radius;
    }

    void gauge(const Meter& meter, Vec2 anchor) {
        const Vec2 middle = dialPixels(anchor);
        const auto radius = static_cast<float>(dialRadius(reachPixels));
        canvas_.line(anchor, middle + Vec2{0, radius}, 1.4f, ink_.withAlpha(0.8f));
        canvas_.circle(anchor, 3, ink_);
        canvas_.circle(middle, radius, palette::deep.withAlpha(0.9f));
        canvas_.circleOutline(middle, radius, 2, ink_);
        const double scale = meters().scaleOf(meter);
        for (int i = 0; i <= 10; ++i)
            canvas_.line(onDial(middle, i / 10.0, radius - (i % 5 == 0 ? 8.0f : 5.0f)),
                         onDial(middle, i / 10.0, radius - 2), i % 5 == 0 ? 1.6f : 1.0f,
                         palette::ice.withAlpha(0.8f));
        const auto force = meters().read(meter, readingsOf(meter.kind)[0]);
        const double share = std::clamp(std::abs(force.value_or(0)) / scale, 0.0, 1.0);
        if (force)
            canvas_.line(middle, onDial(middle, share, radius - 6), 2.4f,
                         *force < 0 ? palette::cold : palette::hot);
        canvas_.circle(middle, 2.5f, palette::ice);
        const Color faint = palette::ice.withAlpha(0.75f);
        canvas_.text(font_, numberText(scale, scale / 10), middle + Vec2{0, 13},
                     {9, faint, atlax::AlignX::Centre, atlax::AlignY::Middle});
        label(meterText(meters(), meter), middle + Vec2{0, -radius - 14}, ink_);
    }
    // The dial stands above, as far as the pointer's reach has it.
    static Vec2 dialPixels(Vec2 anchor) {
        const Point above = dialOf({0, 0}, reachPixels);
        return anchor - Vec2{0, static_cast<float>(above.y())};
    }

    void gun(const Meter& meter, Vec2 from, Vec2 to) {
        const float length = atlax::length(to - from);
        if (!(length > 0)) return;
        const Vec2 along = (to - from) / length;
        const Vec2 across{along.y, -along.x};
        const bool seen = meters().read(meter, readingsOf(meter.kind)[0]).has_value();
        const auto end = meters().beamEnd(meter);
        const Color light = seen ? palette::hot : palette::cold;
        canvas_.dashedLine(from, end ? pixels(*end) : to, 1.6f, 7, 4, light.withAlpha(0.9f));
        canvas_.circleOutline(to, 3, 1.2f, light.withAlpha(0.6f));
        if (seen && end) canvas_.circle(pixels(*end), 4, palette::hot);
        const std::array<Vec2, 4> body{from + across * 6, from + along * 16 + across * 4,
                                       from + along * 16 - across * 4, from - across * 6};
        canvas_.polygon(body, palette::deep);
        canvas_.polygonOutline(body, 1.8f, ink_);
        label(meterText(meters(), meter), from - along * 4 + Vec2{0, -22}, ink_);
    }

    atlax::Canvas& canvas_;
    const atlax::Camera& camera_;
    const atlax::Font& font_;
    const Workbench& bench_;
    double alpha_;
    bool selected_ = false;
    Color ink_ = palette::amber;
};

}  // namespace

std::string meterText(const Meters& meters, const Meter& meter) {
    const Quantity& reading = readingsOf(meter.kind)[0];
    auto value = meters.read(meter, reading);
    if (!value && meter.kind == MeterKind::gun)
        if (const auto last = meters.last(meter)) value = last->value;
    if (!value) return "\xE2\x80\x93";
    std::array<char, 48> text{};
    const bool degrees = meter.kind == MeterKind::protractor;
    const char* format = degrees                          ? "%.1f%s"
                         : meter.kind == MeterKind::gauge ? "%.4g %s"
                         : meter.kind == MeterKind::ruler ? "%.3f %s"
                                                          : "%.2f %s";
    std::snprintf(text.data(), text.size(), format, *value, reading.unit.data());
    return text.data();
}

void paintMeters(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
                 const Workbench& bench, double alpha) {
    MeterPen pen(canvas, camera, font, bench, alpha);
    for (const Meter& meter : bench.meters().all()) pen.paint(meter);
}

}  // namespace sulfurchamber
