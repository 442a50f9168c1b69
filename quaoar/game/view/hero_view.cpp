// The hero and the rope.
#include <algorithm>
#include <cmath>
#include <quaoar/view/game_view.hpp>

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

/// A smooth curve through points (Catmull and Rom's), four pieces between two of them.
std::vector<Vec2> smooth(const std::vector<Vec2>& points) {
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

}  // namespace

void GameView::drawHero(atlax::Canvas& canvas, double alpha) {
    const SkinPlan& plan = skinPlan(session_.hero());
    const std::vector<Vec2> places = dressedPlaces(session_.hero(), plan, alpha);
    const Vec2 middle = places.front();
    std::vector<Vec2> border;
    for (const std::uint32_t i : plan.outline) border.push_back(places[i]);
    const std::vector<Vec2> fluff = smooth([&] {
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
            {places[i], Vec2(plan.skin->uv[i]),
             mix(Color::hex(0xC9B6C8), atlax::colors::white, 0.25f + 0.75f * light)});
    }
    canvas.mesh(art_.picture(plan.skin->texture), vertices, plan.indices);
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

/// Upright whatever the body does: a rolling face would hide where the hero looks.
void GameView::drawFace(atlax::Canvas& canvas, Vec2 middle, Vec2 squash) {
    const Vec2 aim(session_.aim());
    const bool finished = session_.phase() == Session::Phase::finished;
    const float speed = length(Vec2(session_.heroVelocity()));
    const bool blink = time_ % 2100 < 60;
    const Vec2 look = aim * 0.02f;
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 eye = middle + Vec2{side * 0.043f * squash.x, 0.034f * squash.y} + look * 0.7f;
        if (finished || blink) {
            const float bend = finished ? 0.022f : 0.0f;
            const std::vector<Vec2> lid{eye + Vec2{-0.026f, -bend * 0.4f},
                                        eye + Vec2{0, bend * 0.6f},
                                        eye + Vec2{0.026f, -bend * 0.4f}};
            canvas.polyline(smooth(lid), 0.012f, ink);
            continue;
        }
        const Vec2 half{0.033f * squash.x, 0.037f * squash.y};
        canvas.polygon(ellipse(eye, half + Vec2{0.006f, 0.006f}), ink.withAlpha(0.55f));
        canvas.polygon(ellipse(eye, half), atlax::colors::white);
        const Vec2 pupil = eye + Vec2{aim.x * half.x, aim.y * half.y} * 0.45f;
        canvas.circle(pupil, 0.0185f, ink);
        canvas.circle(pupil + Vec2{-0.006f, 0.007f}, 0.0062f, atlax::colors::white);
    }
    const Vec2 mouth = middle + Vec2{0, -0.026f * squash.y} + look * 0.5f;
    if (speed > 5 && !finished) {
        canvas.polygon(ellipse(mouth, {0.014f, 0.018f}), ink);
    } else {
        const float wide = finished ? 0.034f : 0.022f;
        const std::vector<Vec2> smile{mouth + Vec2{-wide, 0.008f}, mouth + Vec2{0, -0.010f},
                                      mouth + Vec2{wide, 0.008f}};
        canvas.polyline(smooth(smile), 0.009f, ink);
    }
}

void GameView::drawAntenna(atlax::Canvas& canvas, Vec2 crown) {
    const Vec2 bend = lerp(crown, antenna_, 0.5f) + Vec2{-0.012f, 0.015f};
    const std::vector<Vec2> stalk = smooth({crown, bend, antenna_});
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
    const std::vector<Vec2> curve = smooth(points);
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

void GameView::drawRope(atlax::Canvas& canvas, Vec2 middle, double alpha) {
    const Rope& rope = session_.rope();
    if (rope.state() == Rope::State::idle) return;
    const Vec2 hand = handPlace(middle, alpha);
    std::vector<Vec2> points;
    if (rope.state() == Rope::State::flying) {
        points = {Vec2(rope.head(session_.world())), hand};
    } else {
        for (const sulfur::ParticleId particle : rope.particles()) {
            const Vec2 at(session_.world().interpolated(particle, alpha));
            // The last pieces lie under the arm.
            if (!points.empty() && length(at - middle) < 0.2f) break;
            points.push_back(at);
        }
        points.push_back(hand);
    }
    const std::vector<Vec2> curve = smooth(points);
    const float strain =
        std::clamp(static_cast<float>(rope.tension(session_.world())) / 120, 0.0f, 1.0f);
    const Color body = mix(palette::amber, palette::glow, strain * 0.6f);
    const float width = 0.034f - 0.008f * strain;
    canvas.polyline(curve, width + 0.02f, palette::ember);
    canvas.polyline(curve, width, body);
    // The twist of the strands.
    for (std::size_t i = 2; i + 1 < curve.size(); i += 3) {
        const Vec2 way = normalized(curve[i + 1] - curve[i - 1]);
        const Vec2 side = perpendicular(way) * (width * 0.42f);
        canvas.line(curve[i] - side - way * 0.009f, curve[i] + side + way * 0.009f, 0.008f,
                    Color::hex(0xB8641C).withAlpha(0.8f));
    }
    canvas.polyline(curve, 0.007f, palette::glow.withAlpha(0.55f));
    const Vec2 head = points.front();
    for (int i = 0; i < 5; ++i) {
        const float a = 0.6f + static_cast<float>(i) * 1.2566f;
        const Vec2 way{std::cos(a), std::sin(a)};
        canvas.line(head, head + way * 0.06f, 0.024f, palette::ember);
        canvas.line(head, head + way * 0.055f, 0.014f, palette::amber);
    }
    canvas.circle(head, 0.042f, palette::ember);
    canvas.circle(head, 0.033f, palette::amber);
    canvas.circle(head + Vec2{-0.009f, 0.01f}, 0.01f, palette::glow);
}

}  // namespace quaoar
