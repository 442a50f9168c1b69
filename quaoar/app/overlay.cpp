#include "overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/version.hpp>

namespace quaoar {

using atlax::AlignX;
using atlax::AlignY;
using atlax::Color;
using atlax::Vec2;

namespace {

void shadowText(atlax::Canvas& canvas, const atlax::Font& font, const std::string& text, Vec2 at,
                const atlax::TextStyle& style, float shadow) {
    atlax::TextStyle below = style;
    below.color = palette::night.withAlpha(0.75f * style.color.a);
    canvas.text(font, text, at + Vec2{0, shadow}, below);
    canvas.text(font, text, at, style);
}

void dim(atlax::Canvas& canvas, float alpha) {
    canvas.setScreenSpace();
    canvas.rect({{0, 0}, canvas.size().toVec()}, palette::night.withAlpha(alpha));
}

Color medalColour(Medal medal) {
    switch (medal) {
        case Medal::gold:
            return Color::hex(0xFFD15C);
        case Medal::silver:
            return Color::hex(0xCFDCEB);
        case Medal::bronze:
            return Color::hex(0xD08A55);
        case Medal::none:
            break;
    }
    return palette::ice.withAlpha(0.4f);
}

/// A disc on a ribbon with one, two or three points: the number tells the medal without colour.
void drawMedal(atlax::Canvas& canvas, Vec2 at, float unit, Medal medal) {
    const Color color = medalColour(medal);
    canvas.triangle(at + Vec2{-30, -70} * unit, at + Vec2{-2, -70} * unit, at + Vec2{4, -10} * unit,
                    palette::danger);
    canvas.triangle(at + Vec2{30, -70} * unit, at + Vec2{2, -70} * unit, at + Vec2{-4, -10} * unit,
                    mix(palette::danger, palette::night, 0.3f));
    canvas.circle(at, 38 * unit, mix(color, palette::night, 0.45f));
    canvas.circle(at, 34 * unit, color);
    canvas.circle(at, 27 * unit, mix(color, palette::night, 0.14f));
    const int points = medal == Medal::gold ? 3 : medal == Medal::silver ? 2 : 1;
    for (int i = 0; i < points; ++i) {
        const float offset = (static_cast<float>(i) - static_cast<float>(points - 1) * 0.5f) * 16;
        std::vector<Vec2> star;
        for (int k = 0; k < 10; ++k) {
            const float a = static_cast<float>(k) * 0.62832f - 1.5708f;
            const float r = (k % 2 == 0 ? 9.0f : 4.0f) * unit;
            star.push_back(at + Vec2{offset * unit, 0} + Vec2{std::cos(a), std::sin(a)} * r);
        }
        canvas.polygon(star, Color::hex(0xFFF8E6));
    }
}

/// The medal, and what the next one takes.
std::string medalText(const Texts& texts, const MedalTimes& times, Medal medal) {
    switch (medal) {
        case Medal::gold:
            return texts("gold");
        case Medal::none:
            return texts("bronze below {}", {clockText(times.bronze)});
        case Medal::silver:
            return texts("silver, gold below {}", {clockText(times.gold)});
        case Medal::bronze:
            break;
    }
    return texts("bronze, gold below {}", {clockText(times.gold)});
}

}  // namespace

std::string clockText(double seconds) {
    const auto hundredths = static_cast<long>(std::floor(seconds * 100 + 1e-6));
    char text[32];
    std::snprintf(text, sizeof text, "%ld:%02ld.%02ld", hundredths / 6000, hundredths / 100 % 60,
                  hundredths % 100);
    return text;
}

void drawStatus(const OverlayTools& tools, const Session& session, bool replay) {
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = screen.y / 720;
    const std::string name =
        std::to_string(session.level().number) + "   " + tools.texts(session.level().name);
    shadowText(tools.canvas, tools.art.regular(), name, {24 * unit, 38 * unit},
               {20 * unit, palette::frost.withAlpha(0.85f)}, 2 * unit);
    shadowText(tools.canvas, tools.art.bold(), clockText(session.seconds()),
               {screen.x - 24 * unit, 40 * unit}, {26 * unit, palette::frost, AlignX::Right},
               2 * unit);
    if (!replay) return;
    shadowText(tools.canvas, tools.art.bold(), tools.texts("REPLAY"), {screen.x * 0.5f, 38 * unit},
               {20 * unit, palette::amber, AlignX::Centre}, 2 * unit);
}

void drawLevelName(const OverlayTools& tools, const Level& level, double seconds) {
    const auto fade =
        static_cast<float>(std::clamp(std::min(seconds * 3, 3.2 - seconds), 0.0, 1.0));
    if (fade <= 0) return;
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = screen.y / 720;
    const float y = screen.y * 0.17f;
    shadowText(tools.canvas, tools.art.regular(),
               tools.texts("LEVEL {}", {std::to_string(level.number)}),
               {screen.x * 0.5f, y - 44 * unit},
               {19 * unit, palette::amber.withAlpha(fade), AlignX::Centre}, 2 * unit);
    shadowText(tools.canvas, tools.art.bold(), tools.texts(level.name), {screen.x * 0.5f, y},
               {46 * unit, palette::frost.withAlpha(fade), AlignX::Centre}, 3 * unit);
    tools.canvas.line({screen.x * 0.5f - 90 * unit, y + 16 * unit},
                      {screen.x * 0.5f + 90 * unit, y + 16 * unit}, 2 * unit,
                      palette::amber.withAlpha(0.8f * fade));
}

float drawTitle(const OverlayTools& tools, double seconds) {
    dim(tools.canvas, 0.35f);
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = screen.y / 720;
    const Vec2 middle{screen.x * 0.5f, screen.y * 0.36f};
    tools.canvas.setBlend(atlax::Blend::Additive);
    const float breath = 0.30f + 0.06f * static_cast<float>(std::sin(seconds * 1.3));
    tools.canvas.sprite(tools.art.light(), middle - Vec2{0, 34 * unit}, Vec2{1000, 330} * unit,
                        {.tint = palette::ice.withAlpha(breath)});
    tools.canvas.setBlend(atlax::Blend::Alpha);
    shadowText(tools.canvas, tools.art.regular(), tools.texts("ESCAPE FROM"),
               middle - Vec2{0, 92 * unit}, {34 * unit, palette::frost, AlignX::Centre}, 3 * unit);
    shadowText(tools.canvas, tools.art.bold(), "QUAOAR", middle + Vec2{0, 20 * unit},
               {124 * unit, palette::amber, AlignX::Centre}, 6 * unit);
    shadowText(tools.canvas, tools.art.regular(), tools.texts("a rope, some ice, a way home"),
               middle + Vec2{0, 66 * unit},
               {21 * unit, palette::frost.withAlpha(0.9f), AlignX::Centre}, 2 * unit);
    tools.canvas.roundedRect(
        atlax::Rect::around({screen.x * 0.5f, screen.y - 40 * unit}, Vec2{720, 36} * unit),
        18 * unit, palette::night.withAlpha(0.7f));
    tools.canvas.text(
        tools.art.regular(),
        tools.texts("Mouse: aim and fire     W S: reel     A D: swing     R: again     Esc: pause"),
        {screen.x * 0.5f, screen.y - 34 * unit},
        {17 * unit, palette::frost.withAlpha(0.8f), AlignX::Centre});
    tools.canvas.text(tools.art.regular(), std::string("sulfur ") + sulfur::version(),
                      {screen.x - 18 * unit, screen.y - 12 * unit},
                      {12 * unit, palette::frost.withAlpha(0.5f), AlignX::Right});
    return screen.y * 0.53f;
}

float drawHeadline(const OverlayTools& tools, const std::string& text) {
    dim(tools.canvas, 0.6f);
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = screen.y / 720;
    shadowText(tools.canvas, tools.art.bold(), text, {screen.x * 0.5f, screen.y * 0.30f},
               {60 * unit, palette::frost, AlignX::Centre}, 4 * unit);
    return screen.y * 0.37f;
}

float drawFinish(const OverlayTools& tools, const Session& session, double best, bool replay) {
    dim(tools.canvas, 0.5f);
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = screen.y / 720;
    const float x = screen.x * 0.5f;
    const bool finished = session.phase() == Session::Phase::finished;
    const char* headline = !finished ? "The replay ends here"
                           : replay  ? "Replay finished"
                                     : "You found the way";
    shadowText(tools.canvas, tools.art.bold(), tools.texts(headline), {x, 150 * unit},
               {50 * unit, palette::frost, AlignX::Centre}, 4 * unit);
    const Medal medal = session.medal();
    if (medal != Medal::none) drawMedal(tools.canvas, {x - 150 * unit, 262 * unit}, unit, medal);
    shadowText(tools.canvas, tools.art.bold(), clockText(session.seconds()), {x, 268 * unit},
               {62 * unit, palette::amber, AlignX::Centre}, 4 * unit);
    std::string line = medalText(tools.texts, session.level().medals, medal);
    if (best > 0) line += "     " + tools.texts("best {}", {clockText(best)});
    tools.canvas.text(tools.art.regular(), line, {x, 318 * unit},
                      {21 * unit, palette::frost, AlignX::Centre});
    return 360 * unit;
}

}  // namespace quaoar
