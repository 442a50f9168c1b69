// The shapes of the four worlds far away: mountains, caves, machines, crystals.
#include <algorithm>
#include <array>
#include <cmath>

#include "backdrop.hpp"
#include "dice.hpp"

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

namespace {

/// Builds the layers of one level; all of it repeatable by the theme's seed.
class LayerMaker {
public:
    LayerMaker(const Theme& theme, Vec2 anchor, float width)
        : theme_(theme),
          look_(lookOf(theme.world)),
          anchor_(anchor),
          width_(width),
          sky_(Color::hex(theme.skyBottom)) {}

    std::vector<BackdropLayer> make() {
        switch (theme_.world) {
            case Theme::World::dawn:
                dawn();
                break;
            case Theme::World::bog:
                bog();
                break;
            case Theme::World::machine:
                machine();
                break;
            case Theme::World::deep:
                deep();
                break;
        }
        return std::move(layers_);
    }

private:
    void dawn() {
        ridge(0.08f, -0.15f, 1.15f, 0.16f, look_.far, mix(look_.far, look_.horizon, 0.55f), 11, 1);
        ridge(0.18f, -0.65f, 1.1f, 0.13f, mix(look_.far, look_.near, 0.45f),
              mix(look_.haze, sky_, 0.45f), 23, 1);
        ridge(0.36f, -1.25f, 1.05f, 0.11f, mix(look_.near, look_.far, 0.16f), look_.near, 37, 1);
    }

    void bog() {
        ridge(0.08f, -0.5f, 1.0f, 0.12f, look_.far, mix(look_.far, look_.haze, 0.5f), 11, 1, true);
        ridge(0.08f, 1.7f, 1.0f, 0.12f, mix(look_.far, look_.near, 0.3f), look_.near, 12, -1, true);
        begin(0.2f);
        for (float x = -reach(); x < reach(); x += dice_.between(0.5f, 1.9f)) mushroom(x, -1.3f);
        ridge(0.2f, -1.15f, 0.6f, 0.12f, mix(look_.far, look_.near, 0.5f),
              mix(look_.near, look_.haze, 0.12f), 23, 1, true);
        ridge(0.36f, 2.15f, 1.1f, 0.10f, mix(look_.near, look_.far, 0.22f), look_.near, 37, -1,
              true);
        vines(0.36f, 2.2f);
        ridge(0.36f, -1.75f, 0.8f, 0.10f, mix(look_.near, look_.far, 0.15f), look_.near, 41, 1,
              true);
    }

    void machine() {
        begin(0.08f);
        towers(look_.far, mix(look_.far, look_.haze, 0.6f), 0.2f, 1.5f, 0.25f, 0.9f);
        begin(0.19f);
        for (float x = -reach(); x < reach(); x += dice_.between(2.2f, 4.5f)) wheel(x);
        towers(mix(look_.far, look_.near, 0.5f), mix(look_.near, look_.haze, 0.35f), -0.5f, 1.4f,
               0.4f, 1.4f);
        begin(0.36f);
        towers(mix(look_.near, look_.far, 0.18f), look_.near, -1.5f, 1.0f, 0.6f, 2.4f);
        pipes();
    }

    void deep() {
        ridge(0.08f, -0.5f, 0.9f, 0.2f, look_.far, mix(look_.far, look_.horizon, 0.4f), 11, 1);
        begin(0.08f);
        rocket();
        begin(0.19f);
        crystals(-0.95f, 0.8f, 2.2f, mix(look_.far, look_.near, 0.35f), 0.5f);
        begin(0.36f);
        crystals(-1.7f, 0.7f, 1.9f, mix(look_.near, look_.far, 0.25f), 0.9f);
    }

    BackdropLayer& layer() { return layers_.back(); }
    float reach() const { return width_ * layer_().parallax / 2 + 9; }
    const BackdropLayer& layer_() const { return layers_.back(); }

    void begin(float parallax) {
        BackdropLayer next;
        next.parallax = parallax;
        next.edgeColor = mix(look_.far, look_.cap, 0.45f);
        dice_ = Dice(theme_.seed * 101 + static_cast<std::uint32_t>(parallax * 1000));
        layers_.push_back(std::move(next));
    }

    std::uint32_t corner(Vec2 at, Color color) {
        layer().vertices.push_back({anchor_ + at, {}, color});
        return static_cast<std::uint32_t>(layer().vertices.size() - 1);
    }
    void quad(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Color top, Color foot) {
        const std::uint32_t first = corner(a, top);
        corner(b, top);
        corner(c, foot);
        corner(d, foot);
        layer().indices.insert(layer().indices.end(),
                               {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    void triangle(Vec2 a, Vec2 b, Vec2 c, Color color, Color tip) {
        const std::uint32_t first = corner(a, color);
        corner(b, color);
        corner(c, tip);
        layer().indices.insert(layer().indices.end(), {first, first + 1, first + 2});
    }

    /// Crests by summed waves of falling size; their signs folded gives peaks, left as they are
    /// gives rounded hills. `up` is 1 for a ground, -1 for a roof.
    void ridge(float parallax, float base, float height, float step, Color top, Color foot,
               std::uint32_t seed, float up, bool round = false) {
        if (layers_.empty() || layer().parallax != parallax) begin(parallax);
        Dice dice(theme_.seed * 101 + seed);
        std::array<float, 5> phase{};
        for (float& p : phase) p = dice.between(0, 6.28f);
        std::vector<Vec2> crest;
        for (float x = -reach(); x <= reach(); x += step * dice.between(0.6f, 1.4f)) {
            float y = 0, size = 0.5f, rate = round ? 0.8f : 0.55f;
            for (const float p : phase) {
                const float wave = std::sin(x * rate + p);
                y += size * (round ? wave : 1 - 2 * std::abs(wave));
                size *= round ? 0.45f : 0.52f;
                rate *= 2.13f;
            }
            crest.push_back({x, base + up * height * (0.45f + 0.62f * y)});
        }
        strip(crest, base - up * 0.6f, top, foot, up);
        for (Vec2& p : crest) p += anchor_;
        layer().edges.push_back(std::move(crest));
    }

    void strip(const std::vector<Vec2>& crest, float below, Color top, Color foot, float up) {
        std::uint32_t before = 0;
        for (std::size_t i = 0; i < crest.size(); ++i) {
            const Vec2 p = crest[i];
            const Vec2 slope = normalized(crest[std::min(i + 1, crest.size() - 1)] - p);
            // Light from the left: what rises to the right faces it.
            const Color lit = slope.y > 0 ? mix(top, look_.horizon, 0.34f * slope.y)
                                          : mix(top, foot, -0.6f * slope.y);
            const float middle = up > 0 ? std::min(below, p.y - 0.1f) : std::max(below, p.y + 0.1f);
            const std::uint32_t first = corner(p, lit);
            corner({p.x, middle}, foot);
            corner({p.x, up * -40}, foot);
            if (i > 0) {
                for (const std::uint32_t k : {0u, 1u}) {
                    const std::uint32_t a = before + k, b = first + k;
                    layer().indices.insert(layer().indices.end(), {a, a + 1, b, b, a + 1, b + 1});
                }
            }
            before = first;
        }
    }

    /// A glowing cap on a bent stalk.
    void mushroom(float x, float foot) {
        const float tall = dice_.between(0.5f, 1.7f), wide = tall * dice_.between(0.22f, 0.4f);
        const Color stalk = mix(look_.far, look_.near, 0.4f);
        const float lean = dice_.between(-0.12f, 0.12f);
        quad({x - wide * 0.12f + lean, foot + tall}, {x + wide * 0.12f + lean, foot + tall},
             {x + wide * 0.2f, foot}, {x - wide * 0.2f, foot}, mix(stalk, look_.accent, 0.25f),
             stalk);
        const Vec2 top{x + lean, foot + tall};
        const Color cap = mix(look_.haze, look_.accent, dice_.between(0.1f, 0.4f));
        const std::uint32_t middle = corner(top, mix(cap, look_.near, 0.35f));
        std::uint32_t last = 0;
        for (int i = 0; i <= 12; ++i) {
            const float a = static_cast<float>(i) * 0.2618f;
            const std::uint32_t here =
                corner(top + Vec2{std::cos(a) * wide, std::sin(a) * wide * 0.62f - wide * 0.06f},
                       mix(cap, look_.near, 0.45f - 0.35f * std::sin(a)));
            if (i > 0) layer().indices.insert(layer().indices.end(), {middle, last, here});
            last = here;
        }
        layer().lamps.push_back({anchor_ + top - Vec2{0, wide * 0.2f}, wide * 3.2f,
                                 dice_.between(0, 6.28f), look_.accent.withAlpha(0.26f)});
    }

    void vines(float parallax, float from) {
        (void)parallax;
        for (float x = -reach(); x < reach(); x += dice_.between(0.25f, 1.5f)) {
            const float hangs = dice_.between(0.3f, 1.3f), wide = dice_.between(0.012f, 0.03f);
            const float tip = from - 0.9f - hangs;
            quad({x - wide, from}, {x + wide, from}, {x + wide * 0.3f + 0.06f, tip},
                 {x - wide * 0.3f + 0.06f, tip}, look_.near, mix(look_.near, look_.far, 0.5f));
            if (dice_.unit() < 0.45f) {
                layer().lamps.push_back({anchor_ + Vec2{x + 0.06f, tip}, dice_.between(0.12f, 0.3f),
                                         dice_.between(0, 6.28f), look_.accent.withAlpha(0.5f)});
            }
        }
    }

    void towers(Color top, Color foot, float base, float height, float narrow, float wide) {
        for (float x = -reach(); x < reach();) {
            const float width = dice_.between(narrow, wide);
            const float high = base + height * dice_.between(0.15f, 1.1f);
            tower(x, width, high, mix(top, foot, dice_.between(0, 0.35f)), foot);
            x += width * dice_.between(0.75f, 1.6f);
        }
    }

    void tower(float x, float width, float high, Color top, Color foot) {
        quad({x, high}, {x + width, high}, {x + width, high - 2}, {x, high - 2}, top, foot);
        quad({x, high - 2}, {x + width, high - 2}, {x + width, -40}, {x, -40}, foot, foot);
        // The side that faces the glow, a ledge, a chimney.
        quad({x, high}, {x + width * 0.06f, high}, {x + width * 0.06f, high - 1.6f},
             {x, high - 1.6f}, mix(top, look_.horizon, 0.5f), foot);
        quad({x - 0.04f, high + 0.05f}, {x + width + 0.04f, high + 0.05f},
             {x + width + 0.04f, high}, {x - 0.04f, high}, mix(top, look_.horizon, 0.25f), top);
        if (dice_.unit() < 0.5f) {
            const float at = x + width * dice_.between(0.15f, 0.7f),
                        tall = dice_.between(0.2f, 0.7f);
            quad({at, high + tall}, {at + 0.1f, high + tall}, {at + 0.12f, high},
                 {at - 0.02f, high}, mix(top, look_.horizon, 0.15f), top);
            layer().lamps.push_back({anchor_ + Vec2{at + 0.05f, high + tall}, 0.16f,
                                     dice_.between(0, 6.28f), Color::hex(0xFF5A3C, 0.8f)});
        }
        for (float wy = high - 0.22f; wy > high - 1.5f; wy -= 0.24f) {
            for (float wx = x + 0.12f; wx < x + width - 0.15f; wx += 0.2f) {
                if (dice_.unit() > 0.22f) continue;
                const Color glass = look_.accent.withAlpha(dice_.between(0.25f, 0.85f));
                quad({wx, wy}, {wx + 0.07f, wy}, {wx + 0.07f, wy - 0.1f}, {wx, wy - 0.1f}, glass,
                     glass.faded(0.6f));
            }
        }
    }

    void wheel(float x) {
        BackdropLayer::Wheel wheel;
        wheel.at = anchor_ + Vec2{x, dice_.between(-0.5f, 0.7f)};
        wheel.radius = dice_.between(0.45f, 1.1f);
        wheel.speed = dice_.between(0.1f, 0.3f) * (dice_.unit() < 0.5f ? 1.0f : -1.0f);
        wheel.teeth = static_cast<int>(wheel.radius * 16);
        wheel.color = mix(look_.far, look_.near, 0.55f);
        layer().wheels.push_back(wheel);
    }

    void pipes() {
        for (int k = 0; k < 3; ++k) {
            const float y = -0.75f - 0.3f * static_cast<float>(k), half = 0.05f;
            quad({-reach(), y + half}, {reach(), y + half}, {reach(), y - half},
                 {-reach(), y - half}, mix(look_.near, look_.horizon, 0.2f), look_.near);
            for (float x = -reach(); x < reach(); x += dice_.between(0.9f, 2.2f)) {
                quad({x, y + 0.085f}, {x + 0.07f, y + 0.085f}, {x + 0.07f, y - 0.085f},
                     {x, y - 0.085f}, mix(look_.near, look_.horizon, 0.3f), look_.near);
            }
        }
    }

    /// Clusters of shards that lean away from each other, one side lit.
    void crystals(float foot, float low, float high, Color color, float spread) {
        for (float x = -reach(); x < reach(); x += dice_.between(0.5f, 1.3f) * spread) {
            const int shards = 2 + static_cast<int>(dice_.between(0, 3));
            for (int k = 0; k < shards; ++k) {
                const float tall = dice_.between(low, high) * (k == 0 ? 1.0f : 0.65f);
                const float lean = dice_.between(-0.35f, 0.35f),
                            wide = tall * dice_.between(0.09f, 0.16f);
                const float at = x + dice_.between(-0.2f, 0.2f);
                const Vec2 tip{at + lean * tall, foot + tall};
                const Vec2 shoulder = tip - normalized(Vec2{lean, 1}) * (wide * 1.7f);
                const Color dark = mix(color, look_.near, 0.45f);
                const Color bright = mix(color, look_.accent, 0.3f);
                quad({shoulder.x - wide, shoulder.y}, shoulder, {at, foot - 0.5f},
                     {at - wide, foot - 0.5f}, mix(color, look_.accent, 0.16f), color);
                quad(shoulder, {shoulder.x + wide, shoulder.y}, {at + wide, foot - 0.5f},
                     {at, foot - 0.5f}, dark, dark);
                triangle({shoulder.x - wide, shoulder.y}, shoulder, tip, bright, bright);
                triangle(shoulder, {shoulder.x + wide, shoulder.y}, tip, dark, bright);
                if (k == 0 && dice_.unit() < 0.5f) {
                    layer().lamps.push_back({anchor_ + tip - Vec2{0, tall * 0.3f}, tall * 0.7f,
                                             dice_.between(0, 6.28f),
                                             look_.accent.withAlpha(0.16f)});
                }
            }
        }
        quad({-reach(), foot}, {reach(), foot}, {reach(), foot - 0.7f}, {-reach(), foot - 0.7f},
             color, look_.near);
        quad({-reach(), foot - 0.7f}, {reach(), foot - 0.7f}, {reach(), -40}, {-reach(), -40},
             look_.near, look_.near);
    }

    /// What waits at the end of it all: a slim ship beside its gantry.
    void rocket() {
        const float x = 1.6f, foot = -0.3f;
        const Color hull = mix(look_.far, look_.cap, 0.35f),
                    shade = mix(look_.far, look_.near, 0.4f);
        quad({x - 0.13f, foot + 1.25f}, {x, foot + 1.25f}, {x, foot}, {x - 0.13f, foot}, hull,
             hull);
        quad({x, foot + 1.25f}, {x + 0.13f, foot + 1.25f}, {x + 0.13f, foot}, {x, foot}, shade,
             shade);
        triangle({x - 0.13f, foot + 1.25f}, {x, foot + 1.25f}, {x, foot + 1.75f}, hull, hull);
        triangle({x, foot + 1.25f}, {x + 0.13f, foot + 1.25f}, {x, foot + 1.75f}, shade, shade);
        triangle({x - 0.13f, foot + 0.4f}, {x - 0.13f, foot}, {x - 0.34f, foot - 0.12f}, hull,
                 shade);
        triangle({x + 0.13f, foot + 0.4f}, {x + 0.13f, foot}, {x + 0.34f, foot - 0.12f}, shade,
                 shade);
        for (float y = foot - 0.3f; y < foot + 1.5f; y += 0.2f) {
            quad({x + 0.45f, y + 0.2f}, {x + 0.48f, y + 0.2f}, {x + 0.66f, y}, {x + 0.63f, y},
                 shade, shade);
            quad({x + 0.63f, y + 0.2f}, {x + 0.66f, y + 0.2f}, {x + 0.48f, y}, {x + 0.45f, y},
                 shade, shade);
        }
        for (const float side : {0.44f, 0.65f})
            quad({x + side, foot + 1.5f}, {x + side + 0.03f, foot + 1.5f},
                 {x + side + 0.03f, foot - 0.6f}, {x + side, foot - 0.6f}, shade, shade);
        layer().lamps.push_back({anchor_ + Vec2{x, foot + 0.95f}, 0.22f, 0, look_.accent});
        layer().lamps.push_back(
            {anchor_ + Vec2{x + 0.55f, foot + 1.55f}, 0.2f, 1, Color::hex(0xFF5A7A)});
    }

    const Theme& theme_;
    const WorldLook& look_;
    Vec2 anchor_;
    float width_;
    Color sky_;
    Dice dice_{1};
    std::vector<BackdropLayer> layers_;
};

}  // namespace

std::vector<BackdropLayer> makeLayers(const Theme& theme, Vec2 anchor, float width) {
    return LayerMaker(theme, anchor, width).make();
}

}  // namespace quaoar
