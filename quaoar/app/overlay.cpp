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

/// A size at which the text is no wider than `room` pixels, at most `size`.
float fitting(const atlax::Canvas& canvas, const atlax::Font& font, const std::string& text,
              float size, float room) {
    const float width = canvas.measure(font, text, size).width;
    return width > room ? size * room / width : size;
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

float unitOf(atlax::PixelSize size) {
    return std::min(static_cast<float>(size.height) / 720, static_cast<float>(size.width) / 760);
}

namespace {

/// A shard for each of the level's pick-ups, filled when it is collected; hidden ones show only
/// then.
void drawPickups(const OverlayTools& tools, const Session& session, Vec2 at, float unit) {
    const std::vector<Pickup>& all = session.level().pickups;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool taken = session.pickedUp(i);
        if (all[i].hidden && !taken) continue;
        const Vec2 shard[] = {at + Vec2{0, -9} * unit, at + Vec2{6, 0} * unit,
                              at + Vec2{0, 9} * unit, at + Vec2{-6, 0} * unit};
        if (taken) tools.canvas.polygon(shard, palette::amber);
        tools.canvas.polygonOutline(shard, 2 * unit, taken ? palette::glow : palette::ice);
        at.x += 18 * unit;
    }
}

}  // namespace

void drawStatus(const OverlayTools& tools, const Session& session, const StatusNews& news) {
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const std::string name =
        std::to_string(session.level().number) + "   " + tools.texts(session.level().name);
    const float size = fitting(tools.canvas, tools.art.regular(), name, 20 * unit, 0.4f * screen.x);
    shadowText(tools.canvas, tools.art.regular(), name, {24 * unit, 38 * unit},
               {size, palette::frost.withAlpha(0.85f)}, 2 * unit);
    shadowText(tools.canvas, tools.art.bold(), clockText(session.seconds()),
               {screen.x - 24 * unit, 40 * unit}, {26 * unit, palette::frost, AlignX::Right},
               2 * unit);
    drawPickups(tools, session, {30 * unit, 62 * unit}, unit);
    if (!news.split.empty()) {
        shadowText(tools.canvas, tools.art.bold(), news.split, {screen.x - 24 * unit, 68 * unit},
                   {20 * unit, news.ahead ? palette::amber : palette::frost, AlignX::Right},
                   2 * unit);
    }
    const Vec2 middle{screen.x * 0.5f, 40 * unit};
    if (news.replay) {
        shadowText(tools.canvas, tools.art.bold(), tools.texts("REPLAY"), middle,
                   {20 * unit, palette::amber, AlignX::Centre}, 2 * unit);
    }
    if (const auto left = session.secondsLeft()) {
        shadowText(tools.canvas, tools.art.bold(), clockText(*left),
                   middle + Vec2{0, news.replay ? 34.0f : 0.0f} * unit,
                   {30 * unit, *left < 10 ? palette::danger : palette::glow, AlignX::Centre},
                   2 * unit);
    }
}

void drawLevelName(const OverlayTools& tools, const Level& level, double seconds) {
    const auto fade =
        static_cast<float>(std::clamp(std::min(seconds * 3, 3.2 - seconds), 0.0, 1.0));
    if (fade <= 0) return;
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float y = screen.y * 0.2f;
    const std::string name = tools.texts(level.name);
    shadowText(tools.canvas, tools.art.regular(),
               tools.texts("LEVEL {}", {std::to_string(level.number)}),
               {screen.x * 0.5f, y - 44 * unit},
               {19 * unit, palette::amber.withAlpha(fade), AlignX::Centre}, 2 * unit);
    shadowText(tools.canvas, tools.art.bold(), name, {screen.x * 0.5f, y},
               {fitting(tools.canvas, tools.art.bold(), name, 46 * unit, 0.9f * screen.x),
                palette::frost.withAlpha(fade), AlignX::Centre},
               3 * unit);
    tools.canvas.line({screen.x * 0.5f - 90 * unit, y + 18 * unit},
                      {screen.x * 0.5f + 90 * unit, y + 18 * unit}, 2 * unit,
                      palette::amber.withAlpha(0.8f * fade));
}

/// Two lines fit into the lowest tenth of the picture, which the hero never enters.
void drawBanner(const OverlayTools& tools, const std::string& text, float alpha) {
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float size = 20 * unit;
    const std::string lines = tools.art.regular().wrap(text, size, 0.88f * screen.x);
    const atlax::TextExtent extent = tools.canvas.measure(tools.art.regular(), lines, size);
    const Vec2 box{extent.width + 40 * unit, extent.height + 14 * unit};
    const Vec2 middle{screen.x * 0.5f, screen.y - 8 * unit - box.y * 0.5f};
    const atlax::Rect rect = atlax::Rect::around(middle, box);
    tools.canvas.roundedRect(rect, 12 * unit, palette::night.withAlpha(0.72f * alpha));
    tools.canvas.roundedRectOutline(rect, 12 * unit, 1.5f * unit,
                                    palette::ice.withAlpha(0.5f * alpha));
    tools.canvas.text(tools.art.regular(), lines, middle,
                      {size, palette::frost.withAlpha(alpha), AlignX::Centre, AlignY::Middle});
}

void drawFooter(const OverlayTools& tools, const std::string& text, bool news) {
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float size =
        fitting(tools.canvas, tools.art.regular(), text, 17 * unit, 0.95f * screen.x - 30 * unit);
    const float width = tools.canvas.measure(tools.art.regular(), text, size).width;
    const Vec2 middle{screen.x * 0.5f, screen.y - 26 * unit};
    tools.canvas.roundedRect(atlax::Rect::around(middle, {width + 30 * unit, 30 * unit}), 15 * unit,
                             palette::night.withAlpha(0.75f));
    tools.canvas.text(tools.art.regular(), text, middle,
                      {size, news ? palette::amber : palette::frost.withAlpha(0.85f),
                       AlignX::Centre, AlignY::Middle});
}

void drawCountIn(const OverlayTools& tools, int number) {
    tools.canvas.setScreenSpace();
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    shadowText(tools.canvas, tools.art.bold(), std::to_string(number),
               {screen.x * 0.5f, screen.y * 0.36f}, {130 * unit, palette::amber, AlignX::Centre},
               5 * unit);
}

namespace {

/// Between a headline's end and the footer.
float menuBottom(const OverlayTools& tools) {
    return static_cast<float>(tools.canvas.size().height) - 50 * unitOf(tools.canvas.size());
}

}  // namespace

MenuRoom drawTitle(const OverlayTools& tools, double seconds) {
    dim(tools.canvas, 0.35f);
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const Vec2 middle{screen.x * 0.5f, screen.y * 0.10f + 124 * unit};
    tools.canvas.setBlend(atlax::Blend::Additive);
    const float breath = 0.30f + 0.06f * static_cast<float>(std::sin(seconds * 1.3));
    tools.canvas.sprite(tools.art.light(), middle - Vec2{0, 34 * unit}, Vec2{1000, 330} * unit,
                        {.tint = palette::ice.withAlpha(breath)});
    tools.canvas.setBlend(atlax::Blend::Alpha);
    shadowText(tools.canvas, tools.art.regular(), tools.texts("ESCAPE FROM"),
               middle - Vec2{0, 100 * unit}, {32 * unit, palette::frost, AlignX::Centre}, 3 * unit);
    shadowText(tools.canvas, tools.art.bold(), "QUAOAR", middle + Vec2{0, 10 * unit},
               {120 * unit, palette::amber, AlignX::Centre}, 6 * unit);
    shadowText(tools.canvas, tools.art.regular(), tools.texts("a rope, some ice, a way home"),
               middle + Vec2{0, 62 * unit},
               {21 * unit, palette::frost.withAlpha(0.9f), AlignX::Centre}, 2 * unit);
    tools.canvas.text(tools.art.regular(), std::string("sulfur ") + sulfur::version(),
                      {screen.x - 14 * unit, 22 * unit},
                      {12 * unit, palette::frost.withAlpha(0.5f), AlignX::Right});
    return {middle.y + 92 * unit, menuBottom(tools)};
}

MenuRoom drawHeadline(const OverlayTools& tools, const std::string& text,
                      const std::string& below) {
    dim(tools.canvas, 0.62f);
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float y = screen.y * 0.06f + 84 * unit;
    shadowText(tools.canvas, tools.art.bold(), text, {screen.x * 0.5f, y},
               {fitting(tools.canvas, tools.art.bold(), text, 52 * unit, 0.92f * screen.x),
                palette::frost, AlignX::Centre},
               4 * unit);
    float top = y + 36 * unit;
    if (!below.empty()) {
        const float size = 21 * unit;
        const std::string lines = tools.art.regular().wrap(below, size, 0.86f * screen.x);
        const auto extent =
            tools.canvas.text(tools.art.regular(), lines, {screen.x * 0.5f, top},
                              {size, palette::frost.withAlpha(0.9f), AlignX::Centre, AlignY::Top});
        top += extent.height + 24 * unit;
    }
    return {top, menuBottom(tools)};
}

MenuRoom drawLines(const OverlayTools& tools, const std::string& headline,
                   const std::vector<TextLine>& lines) {
    const MenuRoom room = drawHeadline(tools, headline);
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float menu = 64 * unit;  // for one entry below the lines
    const float step =
        std::min(36 * unit, (room.bottom - room.top - menu) / static_cast<float>(lines.size()));
    float y = room.top + step * 0.5f;
    for (const TextLine& line : lines) {
        const bool alone = line.value.empty();
        const float size = fitting(tools.canvas, tools.art.regular(), line.name, 0.62f * step,
                                   (alone ? 0.94f : 0.46f) * screen.x);
        const float middle = screen.x * 0.5f;
        tools.canvas.text(tools.art.regular(), line.name, {alone ? middle : middle - 12 * unit, y},
                          {size, palette::frost.withAlpha(0.9f),
                           alone ? AlignX::Centre : AlignX::Right, AlignY::Middle});
        if (!alone) {
            tools.canvas.text(tools.art.bold(), line.value, {middle + 12 * unit, y},
                              {size, palette::amber, AlignX::Left, AlignY::Middle});
        }
        y += step;
    }
    return {y, room.bottom};
}

MenuRoom drawFinish(const OverlayTools& tools, const Session& session, const FinishNews& news) {
    const bool finished = session.phase() == Session::Phase::finished;
    const char* headline = !finished     ? "The replay ends here"
                           : news.replay ? "Replay finished"
                                         : "You found the way";
    const MenuRoom room = drawHeadline(tools, tools.texts(headline));
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float x = screen.x * 0.5f;
    const float y = room.top + 62 * unit;
    const Medal medal = session.medal();
    if (medal != Medal::none) drawMedal(tools.canvas, {x - 170 * unit, y - 8 * unit}, unit, medal);
    shadowText(tools.canvas, tools.art.bold(), clockText(news.seconds), {x, y},
               {62 * unit, palette::amber, AlignX::Centre}, 4 * unit);
    std::string line = medalText(tools.texts, session.level().medals, medal);
    if (news.best > 0) line += "     " + tools.texts("best {}", {clockText(news.best)});
    if (finished && !news.replay && news.before > news.seconds) {
        line +=
            "     " + tools.texts("{} faster than ever", {clockText(news.before - news.seconds)});
    }
    tools.canvas.text(
        tools.art.regular(), line, {x, y + 46 * unit},
        {fitting(tools.canvas, tools.art.regular(), line, 21 * unit, 0.94f * screen.x),
         palette::frost, AlignX::Centre});
    return {y + 72 * unit, room.bottom};
}

namespace {

/// As many columns as make the cells largest.
int bestColumns(std::size_t count, Vec2 area, float shape) {
    int best = 1;
    float largest = 0;
    for (int columns = 1; columns <= static_cast<int>(count); ++columns) {
        const int rows = (static_cast<int>(count) + columns - 1) / columns;
        const float width = std::min(area.x / static_cast<float>(columns),
                                     area.y / static_cast<float>(rows) * shape);
        if (width <= largest) continue;
        largest = width;
        best = columns;
    }
    return best;
}

void drawLock(atlax::Canvas& canvas, Vec2 at, float size) {
    const Color color = palette::ice.withAlpha(0.7f);
    canvas.roundedRect(atlax::Rect::around(at + Vec2{0, 0.18f} * size, Vec2{0.62f, 0.46f} * size),
                       0.08f * size, color);
    std::vector<Vec2> bow;
    for (int i = 0; i <= 12; ++i) {
        const float a = 3.14159f * (1 + static_cast<float>(i) / 12);
        bow.push_back(at + Vec2{std::cos(a) * 0.2f, std::sin(a) * 0.28f - 0.04f} * size);
    }
    canvas.polyline(bow, 0.09f * size, color);
}

void drawCell(const OverlayTools& tools, const LevelCell& cell, atlax::Rect box, bool selected) {
    atlax::Canvas& canvas = tools.canvas;
    const float unit = box.size.y / 100;
    const Vec2 middle = box.min + box.size * 0.5f;
    canvas.roundedRect(box, 8 * unit, palette::night.withAlpha(0.9f));
    if (cell.open && cell.picture != nullptr)
        canvas.sprite(*cell.picture, middle, box.size - Vec2{8, 8} * unit);
    if (!cell.open) drawLock(canvas, middle, 46 * unit);
    canvas.roundedRectOutline(box, 8 * unit, (selected ? 6.0f : 2.0f) * unit,
                              selected ? palette::amber : palette::ice.withAlpha(0.6f));
    const Vec2 corner = box.min + Vec2{20, 18} * unit;
    canvas.roundedRect(atlax::Rect::around(corner, Vec2{34, 28} * unit), 6 * unit,
                       selected ? palette::amber : palette::deep);
    canvas.text(
        tools.art.bold(), std::to_string(cell.number), corner,
        {22 * unit, selected ? palette::night : palette::frost, AlignX::Centre, AlignY::Middle});
    const Vec2 badge{box.max().x - 20 * unit, box.max().y - 18 * unit};
    if (cell.medal != Medal::none) {
        drawMedal(canvas, badge, 0.36f * unit, cell.medal);
    } else if (cell.finished) {
        canvas.circle(badge, 12 * unit, palette::deep);
        const Vec2 hook[] = {badge + Vec2{-6, 0} * unit, badge + Vec2{-1, 5} * unit,
                             badge + Vec2{7, -6} * unit};
        canvas.polyline(hook, 3 * unit, palette::frost);
    }
}

}  // namespace

std::vector<atlax::Rect> drawGrid(const OverlayTools& tools, const std::vector<LevelCell>& cells,
                                  std::size_t selected, const std::string& details, int& columns) {
    constexpr float shape = 16.0f / 9.0f;
    const MenuRoom room = drawHeadline(tools, tools.texts("Levels"));
    const Vec2 screen = tools.canvas.size().toVec();
    const float unit = unitOf(tools.canvas.size());
    const float strip = 52 * unit;
    const Vec2 area{0.94f * screen.x, room.bottom - room.top - strip};
    columns = bestColumns(cells.size(), area, shape);
    const int rows = (static_cast<int>(cells.size()) + columns - 1) / columns;
    const float width = std::min({area.x / static_cast<float>(columns),
                                  area.y / static_cast<float>(rows) * shape, 340 * unit});
    const Vec2 cell{width, width / shape};
    const float spare = area.y - cell.y * static_cast<float>(rows);
    const Vec2 from{(screen.x - cell.x * static_cast<float>(columns)) * 0.5f,
                    room.top + 0.4f * std::max(spare, 0.0f)};
    std::vector<atlax::Rect> places;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto column = static_cast<float>(static_cast<int>(i) % columns);
        const auto row = static_cast<float>(static_cast<int>(i) / columns);
        const Vec2 middle = from + Vec2{(column + 0.5f) * cell.x, (row + 0.5f) * cell.y};
        places.push_back(atlax::Rect::around(middle, cell * 0.93f));
        drawCell(tools, cells[i], places.back(), i == selected);
    }
    const float size =
        fitting(tools.canvas, tools.art.regular(), details, 21 * unit, 0.94f * screen.x);
    tools.canvas.text(tools.art.regular(), details, {screen.x * 0.5f, room.bottom - strip * 0.45f},
                      {size, palette::frost, AlignX::Centre, AlignY::Middle});
    return places;
}

}  // namespace quaoar
