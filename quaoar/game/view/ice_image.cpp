#include "ice_image.hpp"

#include <algorithm>
#include <cmath>
#include <quaoar/skin/skin_painter.hpp>

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

namespace {

constexpr float finest = 22;        // pixels a metre; nothing in it has edges that would need more
constexpr float mostPixels = 5e5f;  // of one block: what a start may cost

float lattice(int x, int y, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393u +
                      static_cast<std::uint32_t>(y) * 668265263u + seed * 2246822519u;
    h = (h ^ (h >> 13)) * 1274126177u;
    return static_cast<float>((h ^ (h >> 16)) & 0xffffu) / 65535.0f;
}

/// Smooth noise, 0..1, of period about 1.
float noise(Vec2 at, std::uint32_t seed) {
    const float fx = std::floor(at.x), fy = std::floor(at.y);
    const int x = static_cast<int>(fx), y = static_cast<int>(fy);
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float u = ease(at.x - fx), v = ease(at.y - fy);
    const float low = lattice(x, y, seed) * (1 - u) + lattice(x + 1, y, seed) * u;
    const float high = lattice(x, y + 1, seed) * (1 - u) + lattice(x + 1, y + 1, seed) * u;
    return low * (1 - v) + high * v;
}

/// -1..1: clouds drawn out into slanted layers.
float strata(Vec2 p, std::uint32_t seed) {
    const Vec2 slanted{p.x * 0.55f + p.y * 0.35f, p.y * 1.7f - p.x * 0.4f};
    const float broad = noise(slanted, seed), fine = noise(slanted * 2.9f, seed + 1);
    const float veins = 1 - std::abs(2 * noise(p * 1.1f, seed + 2) - 1);
    return (broad - 0.5f) * 1.0f + (fine - 0.5f) * 0.7f + std::max(0.0f, veins - 0.86f) * 3.2f;
}

/// -1..1: plates of metal with dark joints.
float panels(Vec2 p, std::uint32_t seed) {
    constexpr float wide = 0.9f, high = 0.55f;
    const float row = std::floor(p.y / high);
    const float x = p.x + wide * 0.5f * std::fmod(std::abs(row), 2.0f);
    const float u = x / wide - std::floor(x / wide), v = p.y / high - row;
    const float joint = std::min({u * wide, (1 - u) * wide, v * high, (1 - v) * high});
    const float tone = lattice(static_cast<int>(std::floor(x / wide)), static_cast<int>(row), seed);
    return joint < 0.03f ? -0.9f : (tone - 0.5f) * 0.7f + 0.15f * (noise(p * 7, seed) - 0.5f);
}

struct Grid {
    int width = 0, height = 0;
    float scale = 1;  ///< pixels a metre
    Vec2 low;
    std::vector<float> away;   ///< metres to the border
    std::vector<float> shine;  ///< light on that border
    std::vector<char> inside;
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    Vec2 place(int x, int y) const {
        return low +
               Vec2{(static_cast<float>(x) + 0.5f) / scale, (static_cast<float>(y) + 0.5f) / scale};
    }
};

/// Edge by edge over what it can light.
void measure(Grid& grid, const std::vector<Vec2>& loop, float seep) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()], along = b - a;
        const float shine = lightOn(-perpendicular(normalized(along)));
        const auto cell = [&](float v, float low, int most) {
            return std::clamp(static_cast<int>(std::floor((v - low) * grid.scale)), 0, most);
        };
        const int x0 = cell(std::min(a.x, b.x) - seep, grid.low.x, grid.width);
        const int x1 = cell(std::max(a.x, b.x) + seep, grid.low.x, grid.width);
        const int y0 = cell(std::min(a.y, b.y) - seep, grid.low.y, grid.height);
        const int y1 = cell(std::max(a.y, b.y) + seep, grid.low.y, grid.height);
        const float square = std::max(dot(along, along), 1e-9f);
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                const Vec2 p = grid.place(x, y) - a;
                const float t = std::clamp(dot(p, along) / square, 0.0f, 1.0f);
                const float away = length(p - along * t);
                const std::size_t k = grid.at(x, y);
                if (away >= grid.away[k]) continue;
                grid.away[k] = away;
                grid.shine[k] = shine;
            }
        }
    }
}

/// Row by row between every other crossing of the border.
void fillInside(Grid& grid, const std::vector<Vec2>& loop) {
    std::vector<float> crossings;
    for (int row = 0; row < grid.height; ++row) {
        const float y = grid.place(0, row).y;
        crossings.clear();
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const Vec2 a = loop[i], b = loop[j];
            if ((a.y > y) == (b.y > y)) continue;
            crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const auto column = [&](float x) {
                const float part = std::round((x - grid.low.x) * grid.scale);
                return static_cast<int>(std::clamp(part, 0.0f, static_cast<float>(grid.width)));
            };
            for (int x = column(crossings[k]); x < column(crossings[k + 1]); ++x)
                grid.inside[grid.at(x, row)] = 1;
        }
    }
}

}  // namespace

atlax::Image insideImage(const std::vector<Vec2>& loop, atlax::Rect box, const InsideLook& look) {
    Grid grid;
    grid.scale = std::min(finest, std::sqrt(mostPixels / std::max(box.size.x * box.size.y, 0.01f)));
    grid.width = std::max(2, static_cast<int>(box.size.x * grid.scale));
    grid.height = std::max(2, static_cast<int>(box.size.y * grid.scale));
    grid.low = box.min;
    const auto count = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    grid.away.assign(count, look.depth);
    grid.shine.assign(count, 0);
    grid.inside.assign(count, 0);
    fillInside(grid, loop);
    measure(grid, loop, look.depth);
    atlax::Image image({grid.width, grid.height});
    const auto byte = [](float part) {
        return static_cast<std::uint8_t>(std::clamp(part, 0.0f, 1.0f) * 255 + 0.5f);
    };
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const std::size_t k = grid.at(x, y);
            if (grid.inside[k] == 0) continue;
            const Vec2 p = grid.place(x, y);
            const float light = 1 - grid.away[k] / look.depth;
            const float texture =
                look.strata * (look.panels ? panels(p, look.seed) : strata(p, look.seed));
            const float glow = light * light * (0.62f + 0.38f * grid.shine[k]);
            const Color color = mix(look.core, look.seep, std::clamp(glow, 0.0f, 1.0f));
            const float tone = 1 + texture * (0.34f + 0.1f * light);
            image.setPixel(x, grid.height - 1 - y,
                           {byte(color.r * tone), byte(color.g * tone), byte(color.b * tone),
                            byte(grid.away[k] * grid.scale - 0.2f)});
        }
    }
    return image;
}

}  // namespace quaoar
