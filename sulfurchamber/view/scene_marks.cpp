// What the painter of scenes shows above bodies: pins, strain, speeds, trails and contacts.
#include <algorithm>
#include <cmath>

#include "palette.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {

using atlax::Color;
using atlax::Vec2;
namespace {

using sulfur::BodyId;
using sulfur::JointId;
using sulfur::ParticleId;

constexpr double trailSeconds = 20;
constexpr std::size_t trailPoints = 600;  // of one trail

}  // namespace

Color strainColour(float strain) {
    const float t = std::clamp(strain / strainAtFullColour, -1.0f, 1.0f);
    if (t < 0) return atlax::mix(palette::sky.withAlpha(0.45f), palette::cold, -t);
    return t < 0.5f ? atlax::mix(palette::sky.withAlpha(0.45f), palette::amber, t * 2)
                    : atlax::mix(palette::amber, palette::hot, t * 2 - 1);
}

void ScenePainter::paintPins() {
    for (const Posed& body : posed_) {
        if (body.kind != sulfur::BodyKind::dynamic) continue;
        const auto particles = world_->particles(body.id);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            if (!world_->info(particles[i]).pinned) continue;
            const Vec2 at = body.points[i];
            canvas_->circle(at, 5 * pixel_, palette::deep);
            canvas_->circleOutline(at, 5 * pixel_, 1.6f * pixel_, palette::ice);
            canvas_->circle(at, 1.8f * pixel_, palette::amber);
        }
    }
}

void ScenePainter::paintStrain() {
    const auto paintOne = [&](JointId joint) {
        const auto info = world_->info(joint);
        const Vec2 a = place(info.a);
        const Vec2 b = place(info.b);
        const float rest = std::max(1e-4f, static_cast<float>(info.restLength));
        canvas_->line(a, b, 2.4f * pixel_, strainColour(atlax::length(b - a) / rest - 1));
    };
    for (const BodyId body : world_->bodies()) {
        if (world_->kind(body) == sulfur::BodyKind::fixed || isHidden(body)) continue;
        for (const JointId joint : world_->joints(body)) paintOne(joint);
    }
    for (const JointId joint : world_->connections()) paintOne(joint);
}

void ScenePainter::arrow(Vec2 from, Vec2 to, Color color) {
    const float length = atlax::length(to - from);
    if (length < 5 * pixel_) return;
    const Vec2 along = (to - from) / length;
    const float head = std::min(9 * pixel_, length * 0.6f);
    const Vec2 neck = to - along * head;
    const Vec2 side = atlax::perpendicular(along) * (head * 0.45f);
    canvas_->line(from, neck, 2 * pixel_, color);
    canvas_->triangle(to, neck + side, neck - side, color);
}

void ScenePainter::paintVelocities() {
    for (const BodyId body : world_->bodies()) {
        if (world_->kind(body) == sulfur::BodyKind::fixed || isHidden(body)) continue;
        const auto particles = world_->particles(body);
        // A rope swings in itself: its particles tell more than their mean.
        const bool each = looks_.at(body).fills.empty() && particles.size() > 2;
        if (!each) {
            Vec2 middle;
            for (const ParticleId particle : particles) middle += place(particle);
            middle = middle / static_cast<float>(std::max<std::size_t>(1, particles.size()));
            arrow(middle, middle + Vec2(world_->meanVelocity(body)) * velocityArrowSeconds,
                  palette::cold);
            continue;
        }
        const std::size_t stride = std::max<std::size_t>(1, particles.size() / 8);
        for (std::size_t i = 0; i < particles.size(); i += stride) {
            const Vec2 at = place(particles[i]);
            arrow(at, at + Vec2(world_->velocity(particles[i])) * velocityArrowSeconds,
                  palette::cold);
        }
    }
}

// What is old fades. In a moment that was rewound to, what came later is not shown.
void ScenePainter::paintTrails(const Workbench& bench) {
    const auto& series = bench.trailMeasurements().series();
    const double now = world_->time();
    for (std::size_t i = 0; i + 1 < series.size(); i += 2) {
        const auto x = between(series[i].samples, now - trailSeconds, now);
        const auto y = between(series[i + 1].samples, now - trailSeconds, now);
        const std::size_t step = x.size() / trailPoints + 1;
        for (std::size_t k = step; k < x.size() && k < y.size(); k += step) {
            const auto from = sulfur::Point(x[k - step].value, y[k - step].value);
            const auto to = sulfur::Point(x[k].value, y[k].value);
            const auto age = static_cast<float>((now - x[k].time) / trailSeconds);
            canvas_->line(Vec2(from), Vec2(to), 2 * pixel_,
                          palette::amber.withAlpha(0.85f * (1 - age)));
        }
    }
}

void ScenePainter::paintContacts() {
    for (const auto& contact : world_->contacts()) {
        const Vec2 at = contact.point;
        canvas_->line(at, at + Vec2(contact.normal) * (10 * pixel_), 1.5f * pixel_, palette::hot);
        canvas_->circle(at, 2.4f * pixel_, palette::hot);
    }
}

}  // namespace sulfurchamber
