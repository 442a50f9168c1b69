#include "body_painter.hpp"

#include <algorithm>
#include <cmath>
#include <quaoar/skin/outline.hpp>

#include "dice.hpp"
#include "ice_image.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

BodyPainter::BodyPainter(Art& art, const Session& session)
    : art_(art), session_(session), look_(lookOf(session.level().theme.world)) {
    const Level& level = session.level();
    for (std::size_t i = 0; i < level.scene.bodies.size(); ++i) {
        for (const Mover& mover : level.movers)
            if (mover.body == level.scene.bodies[i].id && mover.spin != 0) gears_.push_back(i);
    }
}

void BodyPainter::draw(atlax::Canvas& canvas, atlax::Rect view, double alpha, double seconds,
                       const std::vector<sulfur::BodyId>& others) {
    const sulfur::World& world = session_.world();
    for (const sulfur::BodyId body : world.bodies()) {
        if (!session_.origin(body) || !world.isEnabled(body) || world.sensor(body)) continue;
        if (std::find(others.begin(), others.end(), body) != others.end()) continue;
        const sulfur::Bounds box = world.bounds(body);
        const Vec2 low(box.low), high(box.high);
        const bool seen = high.x > view.min.x && low.x < view.max().x && high.y > view.min.y &&
                          low.y < view.max().y;
        if (seen) drawBody(canvas, body, alpha, seconds);
    }
}

const BodyShape& BodyPainter::shape(sulfur::BodyId body) {
    const auto known = shapes_.find(body);
    if (known != shapes_.end() && known->second.fits(session_.world(), body)) return known->second;
    return shapes_[body] = shapeOf(session_, body);
}

BodyPainter::Dress BodyPainter::dressOf(const BodyShape& shape, const Surface& surface) const {
    Dress dress{shape.texture,
                {palette::ice, palette::deep, palette::frost, palette::night.withAlpha(0.8f)},
                surface.deadly};
    const bool net = shape.outline.empty() && shape.soft && shape.triangles.size() > 8;
    // What comes loose from the ground is of the world's own stone.
    const Theme& theme = session_.level().theme;
    if (surface.look == Surface::Look::ice && theme.world != Theme::World::dawn) {
        dress.colors.light = mix(Color::hex(theme.ice), palette::frost, 0.25f);
        dress.colors.dark = mix(Color::hex(theme.ice), palette::night, 0.4f);
        dress.colors.rim = Color::hex(theme.rim);
    }
    switch (surface.look) {
        case Surface::Look::metal:
            if (dress.texture.empty()) dress.texture = "plate.svg";
            dress.colors.light = Color::hex(0x8492AC);
            dress.colors.dark = Color::hex(0x39414F);
            dress.colors.rim = Color::hex(0xC7D0DE);
            break;
        case Surface::Look::rock:
            if (dress.texture.empty()) dress.texture = "boulder.svg";
            dress.colors.light = Color::hex(0x9A8672);
            dress.colors.dark = Color::hex(0x4A3B33);
            dress.colors.rim = Color::hex(0xE6D3B8);
            break;
        case Surface::Look::mirror:
            dress.colors.light = Color::hex(0xD9FBFF);
            dress.colors.dark = Color::hex(0x5FB6CE);
            break;
        case Surface::Look::ice:
        case Surface::Look::peg:
            if (!dress.texture.empty()) break;
            if (net)
                dress.texture = "flag.svg";
            else if (shape.soft)
                dress.texture = shape.width > 2.2f * shape.height ? "goo.svg" : "jelly.svg";
            else
                dress.texture = "iceblock.svg";
            break;
    }
    if (surface.deadly) {
        dress.colors.light = palette::danger;
        dress.colors.dark = Color::hex(0x5A1236);
        dress.colors.rim = Color::hex(0xFF9CC0);
        if (shape.texture.empty()) dress.texture.clear();
    }
    // Kills only by its speed: no spikes, but the colour of danger along its edges.
    if (surface.deadlySpeed) {
        dress.colors.rim = palette::danger;
        dress.colors.ink = Color::hex(0x4A0E2C);
    }
    return dress;
}

void BodyPainter::drawBody(atlax::Canvas& canvas, sulfur::BodyId body, double alpha,
                           double seconds) {
    const sulfur::World& world = session_.world();
    const Surface& surface = session_.surface(body);
    if (surface.look == Surface::Look::peg && world.kind(body) == sulfur::BodyKind::fixed) {
        drawBolt(canvas, Vec2(world.centreOfMass(body)), seconds);
        return;
    }
    const BodyShape& form = shape(body);
    const Dress dress = dressOf(form, surface);
    if (form.particles == 1) {
        drawBall(canvas, body, form, dress, alpha);
        return;
    }
    const std::vector<Vec2> places = dressedPlaces(world, body, form, alpha);
    drawLoose(canvas, form, dress, places);
    std::vector<Vec2> loop;
    for (const std::uint32_t i : form.outline) loop.push_back(places[i]);
    if (dress.spikes) drawSpikes(canvas, loop, seconds);
    if (form.triangles.empty() && !loop.empty()) {
        canvas.polygon(loop, dress.colors.dark);
        canvas.polygon(grown(loop, -std::min(0.05f, form.thickness)),
                       mix(dress.colors.dark, dress.colors.light, 0.55f));
    }
    const atlax::Texture* picture = dress.texture.empty() ? nullptr : &art_.picture(dress.texture);
    drawSkin(canvas, picture, form, dress.colors, places);
    drawSkinBorder(canvas, form, dress.colors, places);
    drawHub(canvas, body, form, alpha);
    const auto worn = static_cast<float>(session_.workings().crumbling.worn(body));
    if (surface.crumbles) drawCracks(canvas, loop, worn);
    const auto speed = static_cast<float>(world.material(body).surfaceSpeed);
    if (speed != 0 && !loop.empty()) drawBelt(canvas, loop, speed, seconds, look_.accent);
}

void BodyPainter::drawBall(atlax::Canvas& canvas, sulfur::BodyId body, const BodyShape& shape,
                           const Dress& dress, double alpha) const {
    const sulfur::World& world = session_.world();
    const sulfur::ParticleId particle = world.particles(body).front();
    const auto radius = static_cast<float>(world.info(particle).radius);
    const Vec2 at(world.interpolated(particle, alpha));
    if (radius <= 0) return;
    if (!shape.texture.empty()) {
        const double turn = world.interpolatedPose(body, alpha).angle;
        drawSkinnedDisc(canvas, art_.picture(shape.texture), at, radius, static_cast<float>(turn));
        return;
    }
    const bool snow = session_.surface(body).look == Surface::Look::ice && !dress.spikes;
    const Color low = snow ? Color::hex(0xA9C4E8) : dress.colors.dark;
    const Color high = snow ? palette::frost : dress.colors.light;
    canvas.circle(at, radius, mix(low, palette::night, 0.25f));
    canvas.circle(at + Vec2{-0.04f, 0.06f} * radius, radius * 0.9f, low);
    canvas.circle(at + Vec2{-0.14f, 0.2f} * radius, radius * 0.66f, high);
    if (snow || radius < 0.08f) return;
    const double angle = world.interpolatedPose(body, alpha).angle;
    for (int i = 0; i < 3; ++i) {
        const auto a = static_cast<float>(angle + 2.1 * i);
        canvas.circle(at + Vec2{std::cos(a), std::sin(a)} * (radius * 0.55f), radius * 0.16f, low);
    }
}

/// Links of a chain, planks, cords.
void BodyPainter::drawLoose(atlax::Canvas& canvas, const BodyShape& shape, const Dress& dress,
                            const std::vector<Vec2>& places) const {
    if (!shape.outline.empty()) return;
    const float radius = std::max(shape.thickness, 0.014f);
    bool odd = false;
    for (const auto& link : shape.loose) {
        const Vec2 a = places[link[0]], b = places[link[1]];
        const Vec2 way = normalized(b - a);
        odd = !odd;
        if (shape.soft) {
            canvas.line(a, b, 2 * radius + 0.014f, Color::hex(0x2C2118));
            canvas.line(a, b, 2 * radius, Color::hex(0xA98257));
            const Vec2 mid = lerp(a, b, 0.5f), twist = (way + perpendicular(way)) * (radius * 0.7f);
            canvas.line(mid - twist, mid + twist, 0.007f, Color::hex(0x5E4630));
        } else if (radius > 0.034f && length(b - a) > 3 * radius) {
            // A plank.
            canvas.capsule(a, b, radius, Color::hex(0x2A1F1A));
            canvas.capsule(a, b, radius * 0.8f,
                           dress.spikes ? dress.colors.dark : Color::hex(0x7C5B43));
            const Vec2 up = perpendicular(way) * (radius * 0.45f);
            const Vec2 lit = up.y > 0 ? up : -up;
            canvas.line(a + lit, b + lit, radius * 0.35f, Color::hex(0xC39A73).withAlpha(0.8f));
            canvas.circle(a, radius * 0.3f, Color::hex(0x2A1F1A));
        } else {
            const Color steel = dress.spikes ? palette::danger : Color::hex(0x9FB0C8);
            const Vec2 reach = way * (radius * 0.7f);
            if (odd) {
                canvas.capsule(a - reach, b + reach, radius * 1.5f, palette::night);
                canvas.capsuleOutline(a - reach, b + reach, radius * 1.35f, radius * 0.75f, steel);
            } else {
                canvas.line(a - reach, b + reach, radius * 1.5f, palette::night);
                canvas.line(a - reach, b + reach, radius * 0.9f, mix(steel, palette::night, 0.25f));
            }
        }
    }
}

/// What kills is spiky and magenta.
void drawSpikes(atlax::Canvas& canvas, const std::vector<Vec2>& loop, double seconds) {
    const auto pulse = static_cast<float>(0.5 + 0.5 * std::sin(seconds * 3));
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
        const float edge = length(b - a);
        if (edge < 0.02f || edge > 12) continue;
        const Vec2 along = (b - a) / edge, out = -perpendicular(along);
        const int count = std::max(1, static_cast<int>(edge / 0.13f));
        const float step = edge / static_cast<float>(count);
        for (int k = 0; k < count; ++k) {
            const Vec2 left = a + along * (step * static_cast<float>(k)) - out * 0.03f;
            const Vec2 right = left + along * step,
                       tip = lerp(left, right, 0.5f) + out * (0.03f + std::min(0.15f, step));
            canvas.triangle(left, right, tip, Color::hex(0x3A0A24));
            canvas.triangle(lerp(left, right, 0.14f), lerp(left, right, 0.86f),
                            lerp(tip, lerp(left, right, 0.5f), 0.14f), palette::danger);
            canvas.triangle(lerp(left, right, 0.2f), lerp(left, right, 0.42f),
                            lerp(tip, left, 0.2f),
                            mix(Color::hex(0xFF9CC0), atlax::colors::white, 0.4f * pulse));
        }
    }
}

/// The more it is worn, the more and the longer.
void BodyPainter::drawCracks(atlax::Canvas& canvas, const std::vector<Vec2>& loop,
                             float worn) const {
    if (loop.size() < 3) return;
    Vec2 middle{};
    for (const Vec2 p : loop) middle += p / static_cast<float>(loop.size());
    Dice dice(17);
    const int count = 4 + static_cast<int>(10 * worn);
    for (int k = 0; k < count; ++k) {
        const std::size_t i = dice.next() % loop.size();
        Vec2 at = lerp(loop[i], loop[(i + 1) % loop.size()], dice.unit());
        const Vec2 goal = lerp(middle, loop[dice.next() % loop.size()], dice.between(0, 0.6f));
        std::vector<Vec2> crack{at};
        const float reach = 0.25f + 0.75f * worn;
        for (int s = 1; s <= 4; ++s) {
            const float t = reach * static_cast<float>(s) / 4;
            const float jag = dice.between(-0.035f, 0.035f);
            crack.push_back(lerp(at, goal, t) + Vec2{jag, -jag});
        }
        canvas.polyline(crack, 0.008f + 0.010f * worn, palette::night.withAlpha(0.75f));
        canvas.polyline(crack, 0.004f, palette::frost.withAlpha(0.35f + 0.4f * worn));
    }
}

/// The axle of what turns.
void BodyPainter::drawHub(atlax::Canvas& canvas, sulfur::BodyId body, const BodyShape& shape,
                          double alpha) const {
    const auto origin = session_.origin(body);
    if (!origin || std::find(gears_.begin(), gears_.end(), *origin) == gears_.end()) return;
    const sulfur::Pose pose = session_.world().interpolatedPose(body, alpha);
    const Vec2 at(pose.position);
    const float radius = std::max(0.08f, std::min(shape.width, shape.height) * 0.5f);
    const Color steel = Color::hex(0x8492AC), dark = Color::hex(0x1E2532);
    for (int i = 0; i < 5; ++i) {
        const auto a = static_cast<float>(pose.angle + 1.2566 * i);
        const Vec2 way{std::cos(a), std::sin(a)};
        canvas.circle(at + way * (radius * 0.45f), radius * 0.13f, dark);
        canvas.circle(at + way * (radius * 0.45f) + Vec2{0.006f, -0.006f}, radius * 0.10f,
                      Color::hex(0x2B3448));
    }
    canvas.circle(at, radius * 0.2f, dark);
    canvas.circle(at, radius * 0.16f, steel);
    canvas.circle(at, radius * 0.07f, dark);
}

void BodyPainter::drawBolt(atlax::Canvas& canvas, Vec2 at, double seconds) {
    canvas.setBlend(atlax::Blend::Additive);
    const auto pulse =
        static_cast<float>(0.8 + 0.2 * std::sin(std::fmod(seconds, 1000.0) * 3.14159));
    canvas.glow(at, 0.5f, palette::amber.withAlpha(0.55f * pulse));
    canvas.setBlend(atlax::Blend::Alpha);
    canvas.sprite(art_.picture("bolt.svg"), at, {0.34f, 0.34f});
}

void BodyPainter::drawTies(atlax::Canvas& canvas, double alpha) {
    const sulfur::World& world = session_.world();
    const auto& beads = session_.rope().particles();
    for (const sulfur::JointId joint : world.connections()) {
        const sulfur::JointInfo info = world.info(joint);
        const auto ours = [&](sulfur::ParticleId p) {
            return p == session_.hand() || std::find(beads.begin(), beads.end(), p) != beads.end();
        };
        if (ours(info.a) || ours(info.b)) continue;
        const Vec2 a(world.interpolated(info.a, alpha)), b(world.interpolated(info.b, alpha));
        const float width = std::max(0.022f, 2 * static_cast<float>(info.radius));
        canvas.line(a, b, width + 0.014f, palette::night.withAlpha(0.8f));
        canvas.line(a, b, width, Color::hex(0xA98257));
    }
    for (const sulfur::MechanismId mechanism : world.mechanisms()) {
        const sulfur::MechanismInfo info = world.info(mechanism);
        if (info.kind == sulfur::MechanismKind::gear) continue;
        const Vec2 a(info.pointA), b(info.pointB);
        if (info.kind == sulfur::MechanismKind::distance ||
            info.kind == sulfur::MechanismKind::pulley) {
            const bool pulley = info.kind == sulfur::MechanismKind::pulley;
            const std::vector<Vec2> way =
                pulley ? std::vector<Vec2>{a, Vec2(info.overA), Vec2(info.overB), b}
                       : std::vector<Vec2>{a, b};
            canvas.polyline(way, 0.036f, palette::night.withAlpha(0.8f));
            canvas.polyline(way, 0.022f, Color::hex(0xA98257));
        }
        if (info.kind == sulfur::MechanismKind::slider) continue;
        for (const Vec2 at : {a, b}) {
            canvas.circle(at, 0.06f, Color::hex(0x1E2532));
            canvas.circle(at, 0.045f, Color::hex(0x9FB0C8));
            canvas.line(at - Vec2{0.026f, 0.012f}, at + Vec2{0.026f, 0.012f}, 0.012f,
                        Color::hex(0x1E2532));
        }
    }
}

/// The surface runs to the right of the outward normal, clockwise round the body.
void drawBelt(atlax::Canvas& canvas, const std::vector<Vec2>& loop, float speed, double seconds,
              Color color) {
    constexpr float gap = 0.16f;
    const auto moved = static_cast<float>(
        std::fmod(seconds * static_cast<double>(std::abs(speed)), static_cast<double>(gap)));
    const float sense = speed > 0 ? -1.0f : 1.0f;  // along the loop
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
        const float edge = length(b - a);
        if (edge < gap || edge > 40) continue;
        const Vec2 along = (b - a) / edge, in = perpendicular(along);
        canvas.line(a + in * 0.035f, b + in * 0.035f, 0.07f, Color::hex(0x1B1D26));
        for (float t = sense > 0 ? moved : gap - moved; t < edge - 0.03f; t += gap) {
            const Vec2 at = a + along * t, tip = at + along * (0.05f * sense) + in * 0.035f;
            canvas.line(at + in * 0.008f, tip, 0.016f, color);
            canvas.line(at + in * 0.062f, tip, 0.016f, color);
        }
    }
}

}  // namespace quaoar
