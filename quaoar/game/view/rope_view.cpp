// The rope: how it strains, and what is left of it when nothing holds it any more.
#include <algorithm>
#include <cmath>
#include <quaoar/view/game_view.hpp>

#include "curve.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

std::vector<Vec2> smoothCurve(const std::vector<Vec2>& points) {
    if (points.size() < 3) return points;
    std::vector<Vec2> curve;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 a = points[i > 0 ? i - 1 : 0], b = points[i], c = points[i + 1];
        const Vec2 d = points[std::min(i + 2, points.size() - 1)];
        for (int k = 0; k < 4; ++k) {
            const float t = static_cast<float>(k) * 0.25f;
            curve.push_back((b * 2 + (c - a) * t + (a * 2 - b * 5 + c * 4 - d) * (t * t) +
                             (b * 3 - a - c * 3 + d) * (t * t * t)) *
                            0.5f);
        }
    }
    curve.push_back(points.back());
    return curve;
}

namespace {

/// From slack over the strength of a hanging hero to about to burst.
Color strainColour(float strain) {
    const Color slack = Color::hex(0xD98A35), taut = Color::hex(0xFFC257),
                hot = Color::hex(0xFF5A2E);
    return strain < 0.25f ? mix(slack, taut, strain * 4) : mix(taut, hot, (strain - 0.25f) / 0.75f);
}

void drawCord(atlax::Canvas& canvas, const std::vector<Vec2>& curve, float width, Color body,
              float alpha) {
    canvas.polyline(curve, width + 0.02f, palette::ember.withAlpha(alpha));
    canvas.polyline(curve, width, body.withAlpha(alpha));
    // The twist of the strands.
    for (std::size_t i = 2; i + 1 < curve.size(); i += 3) {
        const Vec2 way = normalized(curve[i + 1] - curve[i - 1]);
        const Vec2 side = perpendicular(way) * (width * 0.42f);
        canvas.line(curve[i] - side - way * 0.009f, curve[i] + side + way * 0.009f, 0.008f,
                    Color::hex(0xB8641C).withAlpha(0.8f * alpha));
    }
}

void drawHook(atlax::Canvas& canvas, Vec2 head, float alpha) {
    for (int i = 0; i < 5; ++i) {
        const float a = 0.6f + static_cast<float>(i) * 1.2566f;
        const Vec2 way{std::cos(a), std::sin(a)};
        canvas.line(head, head + way * 0.06f, 0.024f, palette::ember.withAlpha(alpha));
        canvas.line(head, head + way * 0.055f, 0.014f, palette::amber.withAlpha(alpha));
    }
    canvas.circle(head, 0.042f, palette::ember.withAlpha(alpha));
    canvas.circle(head, 0.033f, palette::amber.withAlpha(alpha));
    canvas.circle(head + Vec2{-0.009f, 0.01f}, 0.01f, palette::glow.withAlpha(alpha));
}

}  // namespace

/// From the head to the hand; empty while it is idle.
std::vector<Vec2> GameView::ropePoints(double alpha) const {
    const Rope& rope = session_.rope();
    const Vec2 middle(session_.world().interpolated(session_.hand(), alpha));
    std::vector<Vec2> points;
    if (rope.state() == Rope::State::idle) return points;
    if (rope.state() == Rope::State::flying) {
        points = {Vec2(rope.head(session_.world()))};
    } else {
        for (const sulfur::ParticleId particle : rope.particles()) {
            const Vec2 at(session_.world().interpolated(particle, alpha));
            // The last pieces lie under the arm.
            if (!points.empty() && length(at - middle) < 0.2f) break;
            points.push_back(at);
        }
    }
    points.push_back(handPlace(middle, alpha));
    return points;
}

void GameView::drawRope(atlax::Canvas& canvas, Vec2 middle, double alpha) {
    (void)middle;
    std::vector<Vec2> points = ropePoints(alpha);
    if (points.empty()) return;
    // A string that is plucked: standing waves that grow with strain and with its change.
    const float tremor = std::min(0.022f, 0.010f * strain_ * strain_ + 0.02f * strainRate_);
    const auto last = static_cast<float>(points.size() - 1);
    const float t = static_cast<float>(time_ % 50000) / Session::tickRate;
    const std::vector<Vec2> still = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const float s = static_cast<float>(i) / last;
        const Vec2 side = perpendicular(normalized(still[i + 1] - still[i - 1]));
        const float wave = std::sin(s * 3.14159f) * std::sin(t * 190) +
                           0.5f * std::sin(s * 9.42f) * std::sin(t * 310);
        points[i] += side * (tremor * wave);
    }
    const std::vector<Vec2> curve = smoothCurve(points);
    const Color body = strainColour(strain_);
    const float width = 0.040f - 0.020f * strain_;
    if (strain_ > 0.45f) {
        canvas.setBlend(atlax::Blend::Additive);
        canvas.polyline(curve, width + 0.07f, body.withAlpha(0.30f * (strain_ - 0.45f)));
        canvas.setBlend(atlax::Blend::Alpha);
    }
    drawCord(canvas, curve, width, body, 1);
    canvas.polyline(curve, 0.007f,
                    mix(palette::glow, palette::frost, strain_).withAlpha(0.45f + 0.5f * strain_));
    // Fibres that stand off when it is about to burst.
    if (strain_ > 0.7f) {
        for (std::size_t i = 3; i + 1 < curve.size(); i += 5) {
            const Vec2 side = perpendicular(normalized(curve[i + 1] - curve[i - 1])) *
                              (i % 2 == 0 ? 0.035f : -0.035f);
            canvas.line(curve[i], curve[i] + side, 0.005f, body.withAlpha((strain_ - 0.7f) * 3));
        }
    }
    drawHook(canvas, points.front(), 1);
}

void GameView::dropRope(const std::vector<Vec2>& points, bool drawnBack) {
    if (points.size() < 2 || strands_.size() > 6) return;
    Strand strand;
    strand.drawnBack = drawnBack;
    // A flying rope has two ends only; to fall like one it needs more between them.
    const std::size_t pieces = std::max<std::size_t>(points.size() - 1, 16);
    for (std::size_t i = 0; i <= pieces; ++i) {
        const float at = static_cast<float>(i) / static_cast<float>(pieces) *
                         static_cast<float>(points.size() - 1);
        const std::size_t k = std::min(static_cast<std::size_t>(at), points.size() - 2);
        const Vec2 p = lerp(points[k], points[k + 1], at - static_cast<float>(k));
        strand.now.push_back(p);
        // Each piece starts on a way of its own, so that it curls.
        strand.before.push_back(p - Vec2{random() - 0.5f, random() - 0.5f} * 0.002f);
    }
    strands_.push_back(std::move(strand));
}

void GameView::moveRopes() {
    constexpr float tick = 1.0f / Session::tickRate;
    const Rope& rope = session_.rope();
    const double tension =
        rope.state() == Rope::State::attached ? rope.tension(session_.world()) : 0;
    // A hanging hero's 20 N are a sixth of it, a launch's 300 N nearly all.
    const float goal = 1 - std::exp(-std::max(0.0f, static_cast<float>(tension)) / 110);
    const float change = std::abs(goal - strain_);
    strain_ += 0.05f * (goal - strain_);
    strainRate_ += 0.02f * (std::min(1.0f, change * 4) - strainRate_);
    reachFlash_ = std::max(0.0f, reachFlash_ - tick / 0.6f);
    const Vec2 hand = Vec2(session_.heroPosition());
    for (Strand& strand : strands_) {
        strand.life -= tick / (strand.drawnBack ? 0.28f : 0.9f);
        for (std::size_t i = 0; i < strand.now.size(); ++i) {
            const Vec2 moved = (strand.now[i] - strand.before[i]) * 0.996f;
            strand.before[i] = strand.now[i];
            strand.now[i] += moved - Vec2{0, 9.81f * tick * tick};
            if (strand.drawnBack)
                strand.now[i] = lerp(strand.now[i], hand, 0.018f);
            else if (follow_.space().isRock(strand.now[i]))
                strand.now[i] = strand.before[i];  // it comes to lie on the ground
        }
        if (!strand.drawnBack) strand.now.back() = hand;
    }
    std::erase_if(strands_, [](const Strand& strand) { return strand.life <= 0; });
    lastRope_ = ropePoints(1);
}

void GameView::drawStrands(atlax::Canvas& canvas) {
    for (const Strand& strand : strands_) {
        const std::vector<Vec2> curve = smoothCurve(strand.now);
        const float alpha = std::clamp(strand.life * 1.6f, 0.0f, 1.0f);
        drawCord(canvas, curve, 0.03f, Color::hex(0xD98A35), alpha);
        drawHook(canvas, strand.now.front(), alpha);
    }
}

/// A dashed ring where the rope ends, so that the next shot is aimed nearer.
void GameView::drawReachFlash(atlax::Canvas& canvas, bool bright) {
    if (reachFlash_ <= 0) return;
    const Vec2 middle(session_.heroPosition());
    const auto reach = static_cast<float>(session_.rope().rules().reach);
    const float grown = reach * (1 - 0.06f * reachFlash_ * reachFlash_);
    const float strength =
        (bright ? 0.85f : 0.35f) * (bright ? reachFlash_ : std::min(1.0f, reachFlash_ * 2));
    constexpr int dashes = 48;
    for (int i = 0; i < dashes; ++i) {
        const float a = 6.2831853f * static_cast<float>(i) / dashes,
                    b = a + 6.2831853f / dashes * 0.55f;
        const Vec2 from{std::cos(a), std::sin(a)}, to{std::cos(b), std::sin(b)};
        // Brightest where the shot went.
        const float near = 0.35f + 0.65f * std::max(0.0f, dot(from, Vec2(session_.aim())));
        canvas.line(middle + from * grown, middle + to * grown, 0.026f,
                    palette::glow.withAlpha(near * strength));
    }
}

}  // namespace quaoar
