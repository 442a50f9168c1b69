// The gate, the sentences and the range line.
#include <algorithm>
#include <cmath>
#include <quaoar/view/game_view.hpp>

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

void GameView::drawGate(atlax::Canvas& canvas, bool front) {
    const Exit& exit = session_.level().exit;
    const Vec2 at(exit.position);
    const auto radius = static_cast<float>(exit.radius);
    const float t = static_cast<float>(static_cast<double>(time_) / Session::tickRate);
    const bool open = session_.exitOpen();
    const float pulse = open ? 0.85f + 0.15f * std::sin(t * 2.1f) : 0.12f;
    if (!front) {
        canvas.setBlend(atlax::Blend::Additive);
        canvas.sprite(art_.light(), at, Vec2{5.2f, 5.2f} * radius,
                      {.tint = palette::amber.withAlpha(0.42f * pulse)});
        canvas.sprite(art_.light(), at, Vec2{2.3f, 2.3f} * radius,
                      {.tint = palette::glow.withAlpha(0.8f * pulse)});
        canvas.setBlend(atlax::Blend::Alpha);
        return;
    }
    if (!open) {
        // Shut: a dark disc behind bars.
        canvas.circle(at, radius * 0.95f, palette::night.withAlpha(0.85f));
        for (int i = -2; i <= 2; ++i) {
            const float x = static_cast<float>(i) * 0.36f * radius;
            const float tall = std::sqrt(std::max(0.0f, radius * radius * 0.9f - x * x));
            canvas.line(at + Vec2{x, -tall}, at + Vec2{x, tall}, 0.07f, palette::night);
            canvas.line(at + Vec2{x, -tall}, at + Vec2{x, tall}, 0.045f, Color::hex(0x6C7A94));
        }
        canvas.sprite(art_.picture("gate.svg"), at, Vec2{2.42f, 2.42f} * radius,
                      {.tint = Color::hex(0x7C88A4)});
        return;
    }
    canvas.setBlend(atlax::Blend::Additive);
    for (int arm = 0; arm < 3; ++arm) {
        std::vector<Vec2> spiral;
        for (int i = 0; i <= 18; ++i) {
            const float s = static_cast<float>(i) / 18;
            const float angle = t * 0.9f + static_cast<float>(arm) * 2.0944f + s * 3.4f;
            spiral.push_back(at + Vec2{std::cos(angle), std::sin(angle)} * (radius * 0.9f * s));
        }
        canvas.polyline(spiral, 0.035f * radius, palette::glow.withAlpha(0.30f));
    }
    for (int i = 0; i < 14; ++i) {
        const float seed = static_cast<float>(i) * 2.399f;
        const float life = std::fmod(t * 0.35f + static_cast<float>(i) * 0.137f, 1.0f);
        const float out = radius * (1.1f - life);
        const float angle = seed + life * 2.6f;
        canvas.circle(at + Vec2{std::cos(angle), std::sin(angle)} * out, 0.014f,
                      palette::glow.withAlpha(0.9f * std::sin(life * 3.14159f)));
    }
    canvas.setBlend(atlax::Blend::Alpha);
    canvas.sprite(art_.picture("gate.svg"), at, Vec2{2.42f, 2.42f} * radius);
}

/// Where the head would fly. In reach: dots and a ring where it sticks; out of reach: short
/// dashes and an open end; on a surface that does not hold: a cross. Shape tells, not colour alone.
void GameView::drawRange(atlax::Canvas& canvas) {
    const AimPreview preview = session_.preview(session_.aim());
    const Vec2 from = Vec2(preview.from) + Vec2(session_.aim()) * 0.27f;
    const Vec2 to(preview.to);
    if (preview.hits && preview.sticks) {
        const float span = length(to - from);
        for (float s = 0.05f; s < span - 0.06f; s += 0.085f) {
            canvas.circle(lerp(from, to, s / span), 0.011f, palette::amber.withAlpha(0.75f));
        }
        canvas.circle(to, 0.022f, palette::amber);
        std::vector<Vec2> ring;
        for (int i = 0; i < 20; ++i) {
            const float a = static_cast<float>(i) * 0.31416f;
            ring.push_back(to + Vec2{std::cos(a), std::sin(a)} * 0.062f);
        }
        canvas.polyline(ring, 0.014f, palette::amber.withAlpha(0.9f), true);
        return;
    }
    canvas.dashedLine(from, to, 0.012f, 0.1f, 0.12f, palette::frost.withAlpha(0.28f));
    const float arm = 0.05f;
    const Color color = preview.hits ? palette::danger : palette::frost.withAlpha(0.45f);
    canvas.line(to + Vec2{-arm, -arm}, to + Vec2{arm, arm}, 0.014f, color);
    canvas.line(to + Vec2{-arm, arm}, to + Vec2{arm, -arm}, 0.014f, color);
}

void GameView::drawCrosshair(atlax::Canvas& canvas, Vec2 pixels) {
    canvas.setScreenSpace();
    const float unit = canvas.size().toVec().y / 720;
    for (const Vec2 way : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
        canvas.line(pixels + way * (5 * unit), pixels + way * (11 * unit), 4 * unit,
                    palette::night.withAlpha(0.6f));
        canvas.line(pixels + way * (5 * unit), pixels + way * (11 * unit), 2 * unit,
                    palette::glow.withAlpha(0.9f));
    }
    canvas.circle(pixels, 1.6f * unit, palette::glow);
}

}  // namespace quaoar
