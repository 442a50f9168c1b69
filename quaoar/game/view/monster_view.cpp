#include "monster_view.hpp"

#include <algorithm>
#include <cmath>

#include "ice_image.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

MonsterView::MonsterView(Art& art, const Session& session, BodyPainter& painter)
    : art_(art), session_(session), painter_(painter) {
    for (const Monster& monster : session.level().monsters)
        bodies_.push_back(session.instance().body(monster.body));
}

void MonsterView::draw(atlax::Canvas& canvas, double alpha, double seconds) {
    const auto& monsters = session_.level().monsters;
    for (std::size_t i = 0; i < monsters.size(); ++i) {
        const sulfur::BodyId body = bodies_[i];
        if (!session_.world().contains(body) || !session_.world().isEnabled(body)) continue;
        const BodyShape& shape = painter_.shape(body);
        const std::vector<Vec2> places = dressedPlaces(session_.world(), body, shape, alpha);
        std::vector<Vec2> border;
        for (const std::uint32_t k : shape.outline) border.push_back(places[k]);
        if (border.empty()) border = places;
        const Frame frame = frameOf(i, border);
        const bool hangs = monsters[i].behaviour == Monster::Behaviour::hang;
        const bool leech = monsters[i].target == Monster::Target::rope || monsters[i].flies ||
                           monsters[i].behaviour == Monster::Behaviour::lunge;
        if (!hangs && !leech) drawSlug(canvas, frame, border, seconds);
        drawBody(canvas, monsters[i], shape, places, seconds);
        if (hangs)
            drawWarden(canvas, frame, border, seconds);
        else if (leech)
            drawLeech(canvas, frame, border, seconds);
        const Vec2 eye = frame.middle + Vec2{0, frame.size.y * 0.16f};
        const float size = std::min(frame.size.x, frame.size.y);
        const Color iris = hangs   ? palette::danger
                           : leech ? Color::hex(0xFFD84A)
                                   : Color::hex(0x4FE0FF);
        for (const float side : {-1.0f, 1.0f}) {
            const float apart = (hangs ? 0.2f : 0.17f) * size;
            const Vec2 lean{frame.facing * (hangs ? 0.0f : 0.16f) * frame.size.x, 0};
            drawEye(canvas, eye + lean + Vec2{side * apart, 0}, size * (hangs ? 0.13f : 0.135f),
                    frame, side, iris);
        }
    }
}

MonsterView::Frame MonsterView::frameOf(std::size_t place, const std::vector<Vec2>& border) const {
    Frame frame;
    Vec2 low = border.front(), high = low;
    for (const Vec2 p : border) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    frame.middle = (low + high) * 0.5f;
    frame.size = high - low;
    const Vec2 way = Vec2(session_.heroPosition()) - frame.middle;
    frame.looks = normalized(way);
    const Monsters& monsters = session_.workings().monsters;
    switch (monsters.mood(place)) {
        case Monsters::Mood::idle:
            break;
        case Monsters::Mood::alert:
            frame.alarm = 0.6f;
            break;
        case Monsters::Mood::angry:
            frame.alarm = 1;
            break;
        case Monsters::Mood::defeated:
            frame.defeated = true;
            break;
    }
    frame.facing = monsters.facing(place) < 0 ? -1.0f : 1.0f;
    return frame;
}

void MonsterView::drawBody(atlax::Canvas& canvas, const Monster& monster, const BodyShape& shape,
                           const std::vector<Vec2>& places, double seconds) const {
    const bool hangs = monster.behaviour == Monster::Behaviour::hang;
    const bool leech = monster.target == Monster::Target::rope || monster.flies ||
                       monster.behaviour == Monster::Behaviour::lunge;
    const std::string texture = !shape.texture.empty() ? shape.texture
                                : hangs                ? "warden.svg"
                                : leech                ? "leech.svg"
                                                       : "slug.svg";
    std::vector<atlax::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < places.size(); ++i)
        vertices.push_back({places[i], shape.uv[i], atlax::colors::white});
    for (const auto& t : shape.triangles) indices.insert(indices.end(), t.begin(), t.end());
    for (const auto& edge : shape.border)
        canvas.line(places[edge[0]], places[edge[1]], 0.05f, Color::hex(0x120A1E));
    canvas.mesh(art_.picture(texture), vertices, indices);
    for (const auto& edge : shape.border) {
        const Vec2 a = places[edge[0]], b = places[edge[1]],
                   out = -perpendicular(normalized(b - a));
        const float lit = lightOn(out);
        canvas.line(a - out * 0.014f, b - out * 0.014f, 0.012f,
                    palette::frost.withAlpha(0.6f * lit));
    }
    (void)seconds;
}

/// Frost spines along the back, and a trail of slime below.
void MonsterView::drawSlug(atlax::Canvas& canvas, const Frame& frame,
                           const std::vector<Vec2>& border, double seconds) const {
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec2 a = border[i], b = border[(i + 1) % border.size()];
        const Vec2 out = -perpendicular(normalized(b - a));
        if (out.y < 0.25f) continue;
        const float size = (0.10f + 0.05f * frame.alarm) * std::min(1.4f, length(b - a) / 0.12f);
        const auto wave = static_cast<float>(0.2 * std::sin(seconds * 3 + static_cast<double>(i)));
        const Vec2 tip = lerp(a, b, 0.5f) + out * size + perpendicular(out) * (size * wave);
        canvas.triangle(a - out * 0.03f, b - out * 0.03f, tip, Color::hex(0x120A1E));
        canvas.triangle(lerp(a, b, 0.15f) - out * 0.03f, lerp(a, b, 0.85f) - out * 0.03f,
                        lerp(tip, lerp(a, b, 0.5f), 0.12f), Color::hex(0xBFF4FF));
    }
    // Feelers.
    for (const float side : {0.1f, 0.3f}) {
        const Vec2 root =
            frame.middle + Vec2{frame.facing * frame.size.x * side, frame.size.y * 0.4f};
        const auto sway =
            static_cast<float>(std::sin(seconds * 2.3 + static_cast<double>(side) * 9));
        const Vec2 tip = root + Vec2{frame.facing * 0.1f + 0.03f * sway, 0.2f};
        canvas.line(root, tip, 0.035f, Color::hex(0x120A1E));
        canvas.line(root, tip, 0.018f, Color::hex(0x6FD0E8));
        canvas.circle(tip, 0.035f, Color::hex(0x120A1E));
        canvas.circle(tip, 0.024f, Color::hex(0xD8FBFF));
    }
    const float y = frame.middle.y - frame.size.y * 0.5f + 0.01f;
    canvas.line({frame.middle.x - frame.facing * frame.size.x * 0.9f, y}, {frame.middle.x, y},
                0.03f, Color::hex(0x9FF0FF).withAlpha(0.3f));
}

/// A round mouth full of teeth that opens as it comes near.
void MonsterView::drawLeech(atlax::Canvas& canvas, const Frame& frame,
                            const std::vector<Vec2>& border, double seconds) const {
    const float size = std::min(frame.size.x, frame.size.y);
    const auto chews = static_cast<float>(
        0.5 + 0.5 * std::sin(seconds * (4 + 8 * static_cast<double>(frame.alarm))));
    const float open = size * (0.10f + 0.11f * frame.alarm * (0.6f + 0.4f * chews));
    const Vec2 mouth =
        frame.middle + Vec2{frame.facing * frame.size.x * 0.16f, -frame.size.y * 0.14f};
    canvas.circle(mouth, open + 0.03f * size, Color::hex(0x2A0614));
    canvas.circle(mouth, open, Color::hex(0x7A0F2E));
    for (int i = 0; i < 9; ++i) {
        const float a = static_cast<float>(i) * 0.698f;
        const Vec2 way{std::cos(a), std::sin(a)}, side = perpendicular(way) * (open * 0.22f);
        canvas.triangle(mouth + way * open + side, mouth + way * open - side,
                        mouth + way * (open * 0.42f), Color::hex(0xFFF2D8));
    }
    // Fins or tails that beat.
    const auto beat = static_cast<float>(std::sin(seconds * 9));
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 root =
            frame.middle + Vec2{-frame.facing * frame.size.x * 0.42f, side * frame.size.y * 0.16f};
        const Vec2 tip =
            root + Vec2{-frame.facing * size * 0.42f, side * size * (0.2f + 0.16f * beat)};
        canvas.triangle(root + Vec2{0, 0.05f}, root - Vec2{0, 0.05f}, tip, Color::hex(0x4A0E2C));
        canvas.line(root, tip, 0.014f, palette::danger);
    }
    (void)border;
}

/// A cracked mask with a jaw that drops, and burning eyes.
void MonsterView::drawWarden(atlax::Canvas& canvas, const Frame& frame,
                             const std::vector<Vec2>& border, double seconds) const {
    const float size = std::min(frame.size.x, frame.size.y);
    const auto talk = static_cast<float>(0.5 + 0.5 * std::sin(seconds * 2.2));
    const float open = size * (0.03f + 0.12f * frame.alarm * (0.5f + 0.5f * talk));
    const Vec2 jaw = frame.middle - Vec2{0, frame.size.y * 0.2f};
    const float wide = frame.size.x * 0.27f;
    canvas.roundedRect(atlax::Rect::around(jaw, {2 * wide, open * 2 + 0.04f}), 0.03f,
                       Color::hex(0x12060F));
    for (int i = 0; i < 6; ++i) {
        const float x = jaw.x - wide + wide * 2 * (static_cast<float>(i) + 0.5f) / 6, w = wide / 7;
        canvas.triangle({x - w, jaw.y + open + 0.02f}, {x + w, jaw.y + open + 0.02f},
                        {x, jaw.y + open - 0.07f * size * 2}, palette::frost);
        canvas.triangle({x - w, jaw.y - open - 0.02f}, {x + w, jaw.y - open - 0.02f},
                        {x, jaw.y - open + 0.07f * size * 2}, palette::frost);
    }
    canvas.setBlend(atlax::Blend::Additive);
    canvas.glow(frame.middle + Vec2{0, frame.size.y * 0.16f}, size * (0.6f + 0.3f * frame.alarm),
                palette::danger.withAlpha(0.25f + 0.3f * frame.alarm));
    canvas.setBlend(atlax::Blend::Alpha);
    for (std::size_t i = 0; i < border.size(); i += 3)
        canvas.circle(border[i], 0.035f, Color::hex(0x2A2230));
}

void MonsterView::drawEye(atlax::Canvas& canvas, Vec2 at, float radius, const Frame& frame,
                          float side, Color iris) const {
    const Color ink = Color::hex(0x120A1E);
    if (frame.defeated) {
        for (const float s : {-1.0f, 1.0f})
            canvas.line(at + Vec2{-0.7f, -0.7f * s} * radius, at + Vec2{0.7f, 0.7f * s} * radius,
                        radius * 0.36f, ink);
        return;
    }
    canvas.circle(at, radius * 1.18f, ink);
    canvas.circle(at, radius, mix(Color::hex(0xF4FBFF), iris, 0.12f));
    const Vec2 pupil = at + frame.looks * (radius * 0.36f);
    canvas.circle(pupil, radius * 0.62f, iris);
    canvas.circle(pupil, radius * (0.46f - 0.2f * frame.alarm), ink);
    canvas.circle(pupil + Vec2{-0.2f, 0.24f} * radius, radius * 0.16f, atlax::colors::white);
    // A brow that comes down with anger, or hangs in sleep.
    const float angry = frame.alarm;
    const Vec2 inner = at + Vec2{-side * radius * 1.15f, radius * (1.15f - 0.75f * angry)};
    const Vec2 outer = at + Vec2{side * radius * 1.2f, radius * (0.75f + 0.6f * angry)};
    canvas.line(inner, outer, radius * 0.42f, ink);
}

}  // namespace quaoar
