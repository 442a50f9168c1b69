// The hero and the rope.
#include <algorithm>
#include <cmath>
#include <quaoar/view/game_view.hpp>

#include "body_painter.hpp"
#include "curve.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

namespace {

constexpr float heroRadius = 0.12f;
const Color fur = Color::hex(0xF08A2C);
const Color furDark = Color::hex(0x8A4312);
const Color ink = Color::hex(0x2A1608);

std::vector<Vec2> ellipse(Vec2 centre, Vec2 half) {
    std::vector<Vec2> points;
    for (int i = 0; i < 24; ++i) {
        const float a = static_cast<float>(i) * 0.261799f;
        points.push_back(centre + Vec2{half.x * std::cos(a), half.y * std::sin(a)});
    }
    return points;
}

}  // namespace

void GameView::drawHero(atlax::Canvas& canvas, double alpha) {
    const BodyShape& plan = painter_->shape(session_.hero());
    const std::vector<Vec2> places = dressedPlaces(session_.world(), session_.hero(), plan, alpha);
    const Vec2 middle = places.front();
    std::vector<Vec2> border;
    for (const std::uint32_t i : plan.outline) border.push_back(places[i]);
    const std::vector<Vec2> fluff = smoothCurve([&] {
        std::vector<Vec2> closed = border;
        closed.push_back(border.front());
        return closed;
    }());
    Vec2 low = middle, high = middle;
    for (const Vec2 p : border) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    drawAntenna(canvas, {middle.x, high.y - 0.01f});
    canvas.polyline(fluff, 0.03f, furDark, true);
    std::vector<atlax::MeshVertex> vertices;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec2 out = normalized(places[i] - middle);
        const float light = i == 0 ? 0.5f : 0.5f + 0.5f * dot(out, normalized(Vec2{-0.4f, 0.9f}));
        vertices.push_back(
            {places[i], plan.uv[i],
             mix(Color::hex(0xC9B6C8), atlax::colors::white, 0.25f + 0.75f * light)});
    }
    std::vector<std::uint32_t> indices;
    for (const auto& t : plan.triangles) indices.insert(indices.end(), t.begin(), t.end());
    canvas.mesh(art_.picture(plan.texture), vertices, indices);
    canvas.setBlend(atlax::Blend::Additive);
    canvas.sprite(art_.light(), middle + Vec2{-0.035f, 0.05f}, {0.16f, 0.12f},
                  {.tint = palette::glow.withAlpha(0.4f)});
    canvas.setBlend(atlax::Blend::Alpha);
    const Vec2 squash{(high.x - low.x) / (2 * heroRadius), (high.y - low.y) / (2 * heroRadius)};
    drawCollar(canvas, {(low.x + high.x) * 0.5f, (low.y + high.y) * 0.5f}, squash);
    drawFace(canvas, {(low.x + high.x) * 0.5f, (low.y + high.y) * 0.5f}, squash);
    drawArm(canvas, middle, alpha);
}

/// The scarf's round about the body.
void GameView::drawCollar(atlax::Canvas& canvas, Vec2 middle, Vec2 squash) {
    std::vector<Vec2> band;
    for (int i = -4; i <= 4; ++i) {
        const float x = static_cast<float>(i) / 4;
        band.push_back(middle + Vec2{0.098f * x * squash.x, (-0.085f + 0.03f * x * x) * squash.y});
    }
    canvas.polyline(band, 0.048f, Color::hex(0x14304F));
    canvas.polyline(band, 0.034f, Color::hex(0x3F7FC0));
    canvas.polyline(band, 0.008f, Color::hex(0x8FC2F2).withAlpha(0.8f));
}

/// Upright whatever the body does: a rolling face would hide where the hero looks. Eyes widen with
/// fear and narrow with effort, the mouth opens, grits its teeth or laughs.
void GameView::drawFace(atlax::Canvas& canvas, Vec2 middle, Vec2 squash) {
    const Vec2 aim(session_.aim());
    const bool blink = time_ % 2100 < 60 && mood_.fear < 0.3f;
    const Vec2 look = aim * 0.02f;
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 eye = middle + Vec2{side * 0.043f * squash.x, 0.034f * squash.y} + look * 0.7f;
        if (mood_.joy > 0.55f || blink) {
            const float bend = blink ? 0.0f : 0.024f;
            const std::vector<Vec2> lid{eye + Vec2{-0.026f, -bend * 0.4f},
                                        eye + Vec2{0, bend * 0.6f},
                                        eye + Vec2{0.026f, -bend * 0.4f}};
            canvas.polyline(smoothCurve(lid), 0.012f, ink);
            continue;
        }
        drawEye(canvas, eye, side, squash);
    }
    drawMouth(canvas, middle + Vec2{0, -0.026f * squash.y} + look * 0.5f);
    if (mood_.joy < 0.3f) return;
    for (const float side : {-1.0f, 1.0f}) {
        canvas.circle(middle + Vec2{side * 0.075f, -0.008f}, 0.016f,
                      Color::hex(0xFF7A6A).withAlpha(0.6f * mood_.joy));
    }
}

void GameView::drawEye(atlax::Canvas& canvas, Vec2 eye, float side, Vec2 squash) {
    const Vec2 aim(session_.aim());
    const float wide = 1 + 0.28f * mood_.fear, narrow = 1 - 0.38f * mood_.effort;
    const Vec2 half{0.033f * squash.x * wide, 0.037f * squash.y * wide * narrow};
    canvas.polygon(ellipse(eye, half + Vec2{0.006f, 0.006f}), ink.withAlpha(0.55f));
    canvas.polygon(ellipse(eye, half), atlax::colors::white);
    const Vec2 pupil = eye + Vec2{aim.x * half.x, aim.y * half.y} * 0.45f;
    const float size = 0.0185f * (1 - 0.35f * mood_.fear);
    canvas.circle(pupil, std::min(size, half.y), ink);
    canvas.circle(pupil + Vec2{-0.006f, 0.007f}, 0.0062f, atlax::colors::white);
    // Brows: up in the middle with fear, down with effort.
    const float tilt = 0.016f * mood_.fear - 0.017f * mood_.effort;
    if (std::abs(tilt) < 0.004f) return;
    const float up = half.y + 0.012f;
    canvas.line(eye + Vec2{-side * 0.03f, up + tilt}, eye + Vec2{side * 0.032f, up - tilt}, 0.011f,
                furDark);
}

void GameView::drawMouth(atlax::Canvas& canvas, Vec2 mouth) {
    if (mood_.joy > 0.3f) {
        std::vector<Vec2> laugh;
        for (int i = 0; i <= 10; ++i) {
            const float a = 3.14159f + static_cast<float>(i) * 0.314159f;
            laugh.push_back(mouth +
                            Vec2{std::cos(a) * 0.036f, 0.006f + std::sin(a) * 0.034f * mood_.joy});
        }
        canvas.polygon(laugh, ink);
        canvas.circle(mouth + Vec2{0, -0.017f * mood_.joy}, 0.010f, Color::hex(0xE0576B));
    } else if (mood_.fear > 0.35f) {
        canvas.polygon(ellipse(mouth, {0.012f + 0.008f * mood_.fear, 0.010f + 0.018f * mood_.fear}),
                       ink);
    } else if (mood_.effort > 0.45f) {
        canvas.roundedRect(atlax::Rect::around(mouth, {0.056f, 0.026f}), 0.009f, ink);
        canvas.roundedRect(atlax::Rect::around(mouth, {0.046f, 0.016f}), 0.005f,
                           atlax::colors::white);
        for (const float x : {-0.012f, 0.0f, 0.012f})
            canvas.line(mouth + Vec2{x, -0.008f}, mouth + Vec2{x, 0.008f}, 0.003f, ink);
    } else {
        const std::vector<Vec2> smile{mouth + Vec2{-0.022f, 0.008f}, mouth + Vec2{0, -0.010f},
                                      mouth + Vec2{0.022f, 0.008f}};
        canvas.polyline(smoothCurve(smile), 0.009f, ink);
    }
}

void GameView::drawAntenna(atlax::Canvas& canvas, Vec2 crown) {
    const Vec2 bend = lerp(crown, antenna_, 0.5f) + Vec2{-0.012f, 0.015f};
    const std::vector<Vec2> stalk = smoothCurve({crown, bend, antenna_});
    canvas.polyline(stalk, 0.022f, furDark);
    canvas.polyline(stalk, 0.012f, fur);
    canvas.setBlend(atlax::Blend::Additive);
    canvas.sprite(art_.light(), antenna_, {0.2f, 0.2f}, {.tint = palette::ice.withAlpha(0.6f)});
    canvas.setBlend(atlax::Blend::Alpha);
    canvas.circle(antenna_, 0.024f, Color::hex(0x24507C));
    canvas.circle(antenna_, 0.019f, Color::hex(0x9FD4FF));
    canvas.circle(antenna_ + Vec2{-0.006f, 0.006f}, 0.006f, atlax::colors::white);
}

void GameView::drawScarf(atlax::Canvas& canvas) {
    std::vector<Vec2> points(scarf_.now.begin(), scarf_.now.end());
    const std::vector<Vec2> curve = smoothCurve(points);
    const auto last = static_cast<float>(curve.size() - 1);
    for (const bool border : {true, false}) {
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const float t = static_cast<float>(i) / last;
            const float width = 0.036f + 0.014f * t + (border ? 0.014f : 0);
            const std::size_t fromEnd = curve.size() - 2 - i;
            const bool stripe = fromEnd == 3 || fromEnd == 4 || fromEnd == 8 || fromEnd == 9;
            const Color cloth = stripe ? palette::frost : Color::hex(0x3F7FC0);
            canvas.line(curve[i], curve[i + 1], width, border ? Color::hex(0x14304F) : cloth);
        }
    }
}

Vec2 GameView::handPlace(Vec2 middle, double alpha) const {
    Vec2 way(session_.aim());
    const Rope& rope = session_.rope();
    if (rope.state() == Rope::State::attached) {
        const auto& beads = rope.particles();
        const std::size_t near = beads.size() > 4 ? beads.size() - 4 : 0;
        const Vec2 at(session_.world().interpolated(beads[near], alpha));
        if (length(at - middle) > 0.01f) way = normalized(at - middle);
    }
    return middle + way * 0.2f;
}

void GameView::drawArm(atlax::Canvas& canvas, Vec2 middle, double alpha) {
    const Vec2 hand = handPlace(middle, alpha);
    const Vec2 way = normalized(hand - middle);
    const Vec2 side = perpendicular(way);
    const Vec2 shoulder = middle + way * 0.075f;
    canvas.line(shoulder, hand, 0.058f, furDark);
    canvas.line(shoulder, hand, 0.04f, fur);
    canvas.line(shoulder + side * 0.006f, hand + side * 0.006f, 0.012f,
                palette::glow.withAlpha(0.5f));
    const bool holding = session_.rope().state() != Rope::State::idle;
    const Color glove = Color::hex(0x3F7FC0), gloveDark = Color::hex(0x14304F);
    canvas.line(hand - way * 0.03f - side * 0.026f, hand - way * 0.03f + side * 0.026f, 0.03f,
                gloveDark);
    canvas.circle(hand, 0.036f, gloveDark);
    for (const bool border : {true, false}) {
        for (const float spread : {-0.9f, 0.0f, 0.9f}) {
            const Vec2 finger = normalized(way + side * spread * (holding ? 0.55f : 1.0f));
            canvas.line(hand, hand + finger * (holding ? 0.03f : 0.048f), border ? 0.032f : 0.018f,
                        border ? gloveDark : glove);
        }
    }
    canvas.circle(hand, 0.028f, glove);
    canvas.circle(hand + Vec2{-0.008f, 0.009f}, 0.009f, palette::frost.withAlpha(0.6f));
}

}  // namespace quaoar
