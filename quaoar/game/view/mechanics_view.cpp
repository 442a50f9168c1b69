#include "mechanics_view.hpp"

#include <algorithm>
#include <cmath>

#include "dice.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Rect;
using atlax::Vec2;

namespace {

/// 0..1, from a number that only grows.
float cycle(double value) {
    return static_cast<float>(value - std::floor(value));
}

const sulfur::scene::Placement* placementOf(const Level& level, const std::string& id) {
    for (const auto& body : level.scene.bodies)
        if (body.id == id) return &body;
    return nullptr;
}

Rect rectOf(const Zone& zone) {
    return {Vec2(zone.low), Vec2(zone.high) - Vec2(zone.low)};
}

}  // namespace

MechanicsView::MechanicsView(const Session& session)
    : session_(session), look_(lookOf(session.level().theme.world)) {
    layCables();
}

void MechanicsView::layCables() {
    const Level& level = session_.level();
    const auto lay = [&](const Switch& from, Vec2 to) {
        const auto signal = level.signal(from.signal);
        if (!signal) return;
        const Vec2 a(from.position);
        // Down into the ground, along, and up again, as cables are laid.
        const float low = std::min(a.y, to.y) - 0.16f;
        cables_.push_back({*signal, {a, {a.x, low}, {to.x, low}, to}});
    };
    for (const Switch& one : level.switches) {
        for (const Mover& mover : level.movers) {
            const auto* body = placementOf(level, mover.body);
            if (mover.needs == one.signal && body != nullptr) lay(one, Vec2(body->pose.position));
        }
        for (const Zone& zone : level.zones)
            if (zone.needs == one.signal) lay(one, {rectOf(zone).centre().x, Vec2(zone.low).y});
        if (level.exit.needs == one.signal) lay(one, Vec2(level.exit.position));
    }
}

void MechanicsView::drawBehind(atlax::Canvas& canvas, Art& art, double seconds) {
    const Level& level = session_.level();
    const Workings& works = session_.workings();
    for (std::size_t i = 0; i < level.movers.size(); ++i) drawRail(canvas, i);
    for (const Cable& cable : cables_) {
        const bool on = works.signals.on(cable.signal);
        canvas.polyline(cable.way, 0.045f, palette::night.withAlpha(0.85f));
        canvas.polyline(cable.way, 0.02f, on ? palette::amber : Color::hex(0x3E4658));
        if (!on) continue;
        canvas.setBlend(atlax::Blend::Additive);
        for (std::size_t k = 0; k + 1 < cable.way.size(); ++k) {
            for (int n = 0; n < 3; ++n) {
                const float t = cycle(seconds * 0.7 + n / 3.0);
                canvas.glow(lerp(cable.way[k], cable.way[k + 1], t), 0.09f, palette::amber);
            }
        }
        canvas.setBlend(atlax::Blend::Alpha);
    }
    for (std::size_t i = 0; i < level.zones.size(); ++i) {
        const Zone& zone = level.zones[i];
        const auto strength = static_cast<float>(works.zones.strength(i));
        if (zone.gravity) drawGravity(canvas, zone, strength, seconds);
        if (zone.wind) drawWind(canvas, zone, strength, seconds);
        if (zone.wind && zone.pulse) drawVent(canvas, zone, strength, seconds);
        if (zone.deadly) drawDeadly(canvas, zone, strength, seconds);
    }
    for (std::size_t i = 0; i < level.switches.size(); ++i) drawSwitch(canvas, i);
    for (std::size_t i = 0; i < level.checkpoints.size(); ++i)
        drawCheckpoint(canvas, art, i, seconds);
}

void MechanicsView::drawBefore(atlax::Canvas& canvas, Art& art, double seconds) {
    for (std::size_t i = 0; i < session_.level().pickups.size(); ++i)
        drawPickup(canvas, art, i, seconds);
}

void MechanicsView::drawLiquids(atlax::Canvas& canvas, Rect view, double seconds) {
    const Level& level = session_.level();
    for (std::size_t i = 0; i < level.zones.size(); ++i) {
        const auto strength = static_cast<float>(session_.workings().zones.strength(i));
        if (level.zones[i].liquid) drawLiquid(canvas, level.zones[i], view, strength, seconds);
    }
}

/// A groove with stops at both ends.
void MechanicsView::drawRail(atlax::Canvas& canvas, std::size_t place) const {
    const Mover& mover = session_.level().movers[place];
    const auto* body = placementOf(session_.level(), mover.body);
    if (mover.path.empty() || body == nullptr) return;
    std::vector<Vec2> way{Vec2(body->pose.position)};
    for (const sulfur::Point& p : mover.path) way.emplace_back(p);
    const bool loop = mover.mode == Mover::Mode::loop;
    canvas.polyline(way, 0.09f, palette::night.withAlpha(0.7f), loop);
    canvas.polyline(way, 0.06f, Color::hex(0x4A5266).withAlpha(0.9f), loop);
    canvas.polyline(way, 0.02f, palette::night.withAlpha(0.8f), loop);
    for (const Vec2 at : way) {
        canvas.circle(at, 0.075f, palette::night);
        canvas.circle(at, 0.055f, Color::hex(0x8492AC));
        canvas.circle(at, 0.022f, palette::night);
    }
}

/// A plate that sinks; its lamp tells whether it is on, its shape who presses it.
void MechanicsView::drawSwitch(atlax::Canvas& canvas, std::size_t place) const {
    const Switch& one = session_.level().switches[place];
    const Switches& states = session_.workings().switches;
    const bool on = states.on(place), pressed = states.pressed(place);
    const Vec2 at(one.position), half = Vec2(one.size) * 0.5f;
    const Color lamp = on ? palette::amber : Color::hex(0x5B2434);
    if (one.by == "rope") {
        // A ring to hook.
        canvas.circleOutline(at, std::min(half.x, half.y), 0.07f, palette::night);
        canvas.circleOutline(at, std::min(half.x, half.y) - 0.012f, 0.045f, lamp);
    } else {
        const float sunk = pressed ? 0.045f : 0;
        const Rect base{{at.x - half.x, at.y - half.y - 0.02f}, {2 * half.x, 0.07f}};
        canvas.roundedRect({base.min - Vec2{0.03f, 0.01f}, base.size + Vec2{0.06f, 0.02f}}, 0.03f,
                           palette::night);
        canvas.roundedRect(base, 0.02f, Color::hex(0x59637A));
        const Rect plate{{at.x - half.x * 0.86f, at.y - half.y + 0.045f - sunk},
                         {half.x * 1.72f, 0.065f}};
        canvas.roundedRect(plate, 0.025f, mix(lamp, palette::night, 0.2f));
        canvas.line(plate.min + Vec2{0.03f, 0.055f}, plate.min + Vec2{plate.size.x - 0.03f, 0.055f},
                    0.012f, mix(lamp, palette::frost, 0.5f));
    }
    if (!on) return;
    canvas.setBlend(atlax::Blend::Additive);
    canvas.glow(at - Vec2{0, half.y * 0.6f}, half.x + 0.25f, palette::amber.withAlpha(0.4f));
    canvas.setBlend(atlax::Blend::Alpha);
}

/// A lantern on a pole; it burns once it is reached.
void MechanicsView::drawCheckpoint(atlax::Canvas& canvas, Art& art, std::size_t place,
                                   double seconds) const {
    const Vec2 at(session_.level().checkpoints[place].position);
    const bool lit = session_.reached(place);
    const bool last = session_.checkpoint() == place;
    const Vec2 foot = at - Vec2{0, 0.14f}, top = at + Vec2{0, 0.52f};
    canvas.line(foot, top, 0.06f, palette::night);
    canvas.line(foot, top, 0.035f, Color::hex(0x6C7A94));
    canvas.line(foot - Vec2{0.1f, 0}, foot + Vec2{0.1f, 0}, 0.05f, palette::night);
    const auto flicker =
        static_cast<float>(0.85 + 0.1 * std::sin(seconds * 7) + 0.05 * std::sin(seconds * 17));
    if (lit) {
        canvas.setBlend(atlax::Blend::Additive);
        const float size = last ? 1.0f : 0.55f;
        canvas.glow(top, size, palette::amber.withAlpha(0.5f * flicker));
        canvas.setBlend(atlax::Blend::Alpha);
    }
    const Color glass = lit ? mix(palette::amber, palette::glow, flicker) : Color::hex(0x2A3550);
    const Vec2 lamp = top + Vec2{0, 0.05f};
    canvas.roundedRect(Rect::around(lamp, {0.21f, 0.25f}), 0.05f, palette::night);
    canvas.roundedRect(Rect::around(lamp, {0.15f, 0.18f}), 0.035f, glass);
    canvas.line(lamp + Vec2{-0.12f, 0.13f}, lamp + Vec2{0.12f, 0.13f}, 0.04f, Color::hex(0x6C7A94));
    canvas.triangle(lamp + Vec2{-0.1f, 0.14f}, lamp + Vec2{0.1f, 0.14f}, lamp + Vec2{0, 0.23f},
                    Color::hex(0x6C7A94));
    if (lit) {
        const Vec2 tip =
            lamp + Vec2{0.01f * std::sin(static_cast<float>(std::fmod(seconds, 100.0)) * 9),
                        0.075f * flicker};
        canvas.triangle(lamp + Vec2{-0.035f, -0.05f}, lamp + Vec2{0.035f, -0.05f}, tip,
                        palette::frost);
    }
    (void)art;
}

/// A shard of amber that turns and glows; a hidden one only close by.
void MechanicsView::drawPickup(atlax::Canvas& canvas, Art& art, std::size_t place,
                               double seconds) const {
    if (session_.pickedUp(place)) return;
    const Pickup& pickup = session_.level().pickups[place];
    Vec2 at(pickup.position);
    float clear = 1;
    if (pickup.hidden) {
        const float away = length(Vec2(session_.heroPosition()) - at);
        clear = std::clamp(1.9f - away / 1.6f, 0.0f, 1.0f);
        if (clear <= 0) return;
    }
    const double phase = seconds + 0.7 * static_cast<double>(place);
    at.y += static_cast<float>(0.045 * std::sin(phase * 2.1));
    const float turn = std::abs(static_cast<float>(std::cos(phase * 1.6)));
    canvas.setBlend(atlax::Blend::Additive);
    canvas.glow(at, 0.42f, palette::amber.withAlpha(0.55f * clear));
    canvas.setBlend(atlax::Blend::Alpha);
    canvas.sprite(art.picture("shard.svg"), at, {0.10f + 0.14f * turn, 0.30f},
                  {.tint = atlax::colors::white.withAlpha(clear)});
    for (int i = 0; i < 3; ++i) {
        const auto a = static_cast<float>(phase * 1.2 + 2.1 * i);
        const Vec2 spark = at + Vec2{std::cos(a) * 0.2f, std::sin(a * 1.3f) * 0.13f};
        canvas.circle(spark, 0.012f, palette::glow.withAlpha(0.9f * clear));
    }
}

void MechanicsView::drawWind(atlax::Canvas& canvas, const Zone& zone, float strength,
                             double seconds) const {
    if (strength <= 0) return;
    const Rect box = rectOf(zone);
    const Vec2 wind(zone.wind->velocity);
    const float speed = length(wind);
    if (speed <= 0) return;
    const Vec2 way = wind / speed, side = perpendicular(way);
    const float along = std::abs(way.x) * box.size.x + std::abs(way.y) * box.size.y;
    const float across = std::abs(way.y) * box.size.x + std::abs(way.x) * box.size.y;
    Dice dice(static_cast<std::uint32_t>(box.min.x * 31) + 77);
    const int count = std::clamp(static_cast<int>(along * across * 7), 10, 90);
    canvas.setBlend(atlax::Blend::Additive);
    for (int i = 0; i < count; ++i) {
        const float lane = dice.between(-0.5f, 0.5f), start = dice.unit(),
                    quick = dice.between(0.6f, 1.1f);
        const float t = cycle(static_cast<double>(start) +
                              seconds * static_cast<double>(quick * speed / along));
        const Vec2 at = box.centre() + side * (lane * across) + way * ((t - 0.5f) * along);
        const float fade = std::sin(t * 3.14159f) * strength;
        const float reach = std::min(0.5f, 0.05f * speed) * quick;
        canvas.line(at - way * reach, at, 0.014f, palette::frost.withAlpha(0.55f * fade));
        if (i % 3 == 0) canvas.glow(at, 0.22f, palette::frost.withAlpha(0.24f * fade));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

/// The mouth of a geyser: it bubbles and glows before it blows.
void MechanicsView::drawVent(atlax::Canvas& canvas, const Zone& zone, float strength,
                             double seconds) const {
    const Rect box = rectOf(zone);
    const Vec2 way = normalized(Vec2(zone.wind->velocity));
    const float across = std::abs(way.y) * box.size.x + std::abs(way.x) * box.size.y;
    const float along = std::abs(way.x) * box.size.x + std::abs(way.y) * box.size.y;
    const Vec2 mouth = box.centre() - way * (along * 0.5f), side = perpendicular(way);
    const double ticks = static_cast<double>(session_.ticks()) / Session::tickRate;
    const Zone::Pulse& pulse = *zone.pulse;
    const double part = std::fmod(ticks + pulse.phase, pulse.period);
    // The last second before it comes.
    const auto warning = static_cast<float>(std::clamp(1 - (pulse.period - part), 0.0, 1.0));
    const float heat = std::max(strength, part > pulse.on ? warning : 0.0f);
    for (const float s : {-1.0f, 1.0f}) {
        canvas.triangle(mouth + side * (s * across * 0.5f),
                        mouth + side * (s * (across * 0.5f + 0.16f)) - way * 0.05f,
                        mouth + side * (s * (across * 0.5f + 0.03f)) + way * 0.13f,
                        mix(look_.near, look_.cap, 0.35f));
    }
    canvas.setBlend(atlax::Blend::Additive);
    canvas.glow(mouth, across * 0.8f + 0.1f, look_.accent.withAlpha(0.15f + 0.6f * heat));
    for (int i = 0; i < 10; ++i) {
        const float t = cycle(seconds * (1.2 + 0.13 * i) + 0.31 * i);
        const float lane = (static_cast<float>(i) / 9 - 0.5f) * across * 0.8f;
        const float high = 0.08f + 0.45f * heat;
        canvas.circle(mouth + side * lane + way * (t * high), 0.012f + 0.02f * heat * (1 - t),
                      palette::frost.withAlpha((0.25f + 0.6f * heat) * (1 - t)));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

/// Motes that drift where things fall, and faint arrows.
void MechanicsView::drawGravity(atlax::Canvas& canvas, const Zone& zone, float strength,
                                double seconds) const {
    if (strength <= 0) return;
    const Rect box = rectOf(zone);
    const Vec2 pull(*zone.gravity);
    const float speed = length(pull);
    const Vec2 way = speed > 0 ? pull / speed : Vec2{0, 1};
    const Color tint = Color::hex(0xC79BFF);  // in every world, for it means the same
    canvas.rect(box, tint.withAlpha(0.12f * strength));
    canvas.setBlend(atlax::Blend::Additive);
    Dice dice(static_cast<std::uint32_t>(box.min.x * 17 + box.min.y * 5) + 3);
    const int count = std::clamp(static_cast<int>(box.size.x * box.size.y * 2), 12, 80);
    for (int i = 0; i < count; ++i) {
        const double rate = static_cast<double>(dice.between(0.02f, 0.05f) * (0.6f + speed));
        const Vec2 start{dice.unit(), dice.unit()};
        const Vec2 place{
            cycle(static_cast<double>(start.x) + seconds * rate * static_cast<double>(way.x)),
            cycle(static_cast<double>(start.y) + seconds * rate * static_cast<double>(way.y))};
        const Vec2 at = box.min + Vec2{place.x * box.size.x, place.y * box.size.y};
        const auto beat = static_cast<float>(0.6 + 0.4 * std::sin(seconds * 1.7 + 2.3 * i));
        canvas.circleOutline(at, 0.028f, 0.007f, tint.withAlpha(0.7f * beat * strength));
        if (i % 2 != 0) continue;
        const Vec2 side = perpendicular(way) * 0.08f;
        const Vec2 tip = at + way * 0.12f;
        canvas.line(at + side, tip, 0.018f, tint.withAlpha(0.7f * beat * strength));
        canvas.line(at - side, tip, 0.018f, tint.withAlpha(0.7f * beat * strength));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

void MechanicsView::drawDeadly(atlax::Canvas& canvas, const Zone& zone, float strength,
                               double seconds) const {
    if (strength <= 0) return;
    const Rect box = rectOf(zone);
    canvas.rect(box, palette::danger.withAlpha(0.13f * strength));
    canvas.setBlend(atlax::Blend::Additive);
    const int count = std::clamp(static_cast<int>(box.size.x / 0.16f), 3, 200);
    for (int i = 0; i < count; ++i) {
        const float x =
            box.min.x + box.size.x * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        const auto tall = static_cast<float>(0.5 + 0.3 * std::sin(seconds * 4 + 1.9 * i));
        const Vec2 foot{x, box.min.y};
        canvas.triangle(foot - Vec2{0.09f, 0}, foot + Vec2{0.09f, 0},
                        foot + Vec2{0, std::min(box.size.y, 0.45f) * tall},
                        palette::danger.withAlpha(0.5f * strength));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

/// A surface with waves, a bright line on it, dark below, light that dances.
void MechanicsView::drawLiquid(atlax::Canvas& canvas, const Zone& zone, Rect view, float strength,
                               double seconds) const {
    if (strength <= 0) return;
    const Rect box = rectOf(zone);
    const float left = std::max(box.min.x, view.min.x - 0.2f);
    const float right = std::min(box.max().x, view.max().x + 0.2f);
    if (left >= right) return;
    const Color high =
        zone.deadly ? palette::danger : mix(look_.accent, Color::hex(0x4FC3E8), 0.55f);
    const Color deep = mix(high, palette::night, 0.7f);
    const auto t = std::fmod(seconds, 1000.0);
    std::vector<atlax::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Vec2> crest;
    constexpr float step = 0.12f;
    for (float x = left;; x = std::min(x + step, right)) {
        const auto px = static_cast<double>(x);
        const auto wave = static_cast<float>(0.022 * std::sin(2.1 * px + 1.7 * t) +
                                             0.014 * std::sin(5.3 * px - 2.6 * t));
        const Vec2 top{x, box.max().y + wave};
        crest.push_back(top);
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back({top, {}, high.withAlpha(0.42f * strength)});
        vertices.push_back({{x, std::max(box.min.y, top.y - 0.5f)},
                            {},
                            mix(high, deep, 0.5f).withAlpha(0.46f * strength)});
        vertices.push_back({{x, box.min.y}, {}, deep.withAlpha(0.72f * strength)});
        if (first > 0) {
            for (const std::uint32_t k : {0u, 1u}) {
                const std::uint32_t a = first - 3 + k, b = first + k;
                indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
            }
        }
        if (x >= right) break;
    }
    canvas.mesh({}, vertices, indices);
    canvas.polyline(crest, 0.028f, mix(high, palette::frost, 0.55f).withAlpha(0.85f * strength));
    canvas.setBlend(atlax::Blend::Additive);
    Dice dice(static_cast<std::uint32_t>(box.min.x * 13) + 5);
    for (int i = 0; i < 40; ++i) {
        const float x = box.min.x + box.size.x * dice.unit();
        const float up = cycle(static_cast<double>(dice.unit()) +
                               seconds * static_cast<double>(dice.between(0.05f, 0.12f)));
        if (x < left || x > right) continue;
        canvas.circleOutline({x, box.min.y + box.size.y * up}, 0.015f + 0.012f * dice.unit(),
                             0.005f,
                             palette::frost.withAlpha(0.35f * strength * std::sin(up * 3.14159f)));
    }
    canvas.setBlend(atlax::Blend::Alpha);
}

}  // namespace quaoar
