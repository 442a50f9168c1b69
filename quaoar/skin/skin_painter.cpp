#include <algorithm>
#include <array>
#include <cmath>
#include <quaoar/skin/outline.hpp>
#include <quaoar/skin/skin_painter.hpp>

namespace quaoar {

using atlax::Color;
using atlax::Vec2;

float lightOn(Vec2 normal) {
    return std::max(0.0f, dot(normal, normalized(Vec2{-0.35f, 0.94f})));
}

std::vector<Vec2> dressedPlaces(const sulfur::World& world, sulfur::BodyId body,
                                const BodyShape& shape, double alpha) {
    std::vector<Vec2> places;
    for (const sulfur::ParticleId particle : world.particles(body))
        places.emplace_back(world.interpolated(particle, alpha));
    std::vector<Vec2> border;
    for (const std::uint32_t i : shape.outline) border.push_back(places[i]);
    const std::vector<Vec2> outer = grown(border, shape.thickness);
    for (std::size_t k = 0; k < outer.size(); ++k) places[shape.outline[k]] = outer[k];
    return places;
}

void drawSkin(atlax::Canvas& canvas, const atlax::Texture* picture, const BodyShape& shape,
              const SkinColors& colors, const std::vector<Vec2>& places) {
    if (shape.triangles.empty()) return;
    std::vector<float> light(places.size(), 0.55f);
    for (const auto& edge : shape.border) {
        const Vec2 out = -perpendicular(normalized(places[edge[1]] - places[edge[0]]));
        for (const std::uint32_t i : edge)
            light[i] =
                0.5f * light[i] + 0.5f * (0.35f + 0.65f * std::max(0.0f, 0.5f + 0.5f * out.y));
    }
    std::vector<atlax::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Color shade = picture != nullptr
                                ? mix(Color::hex(0x8C9ABF), atlax::colors::white, light[i] * 1.2f)
                                : mix(colors.dark, colors.light, light[i]);
        vertices.push_back({places[i], shape.uv[i], shade});
    }
    for (const auto& t : shape.triangles) indices.insert(indices.end(), t.begin(), t.end());
    if (picture != nullptr)
        canvas.mesh(*picture, vertices, indices);
    else
        canvas.mesh({}, vertices, indices);
}

void drawSkinBorder(atlax::Canvas& canvas, const BodyShape& shape, const SkinColors& colors,
                    const std::vector<Vec2>& places) {
    std::vector<BodyShape::Edge> edges = shape.border;
    if (shape.triangles.empty()) {
        for (std::size_t i = 0; i < shape.outline.size(); ++i)
            edges.push_back({shape.outline[i], shape.outline[(i + 1) % shape.outline.size()]});
    }
    const bool thin = shape.outline.empty();
    for (const auto& edge : edges)
        canvas.line(places[edge[0]], places[edge[1]],
                    thin ? std::max(0.012f, 2 * shape.thickness) : 0.02f, colors.ink);
    for (const auto& edge : edges) {
        const Vec2 a = places[edge[0]], b = places[edge[1]];
        const Vec2 out = -perpendicular(normalized(b - a));
        const float lit = lightOn(out);
        if (lit < 0.2f) continue;
        canvas.line(a - out * 0.012f, b - out * 0.012f, 0.009f, colors.rim.withAlpha(0.7f * lit));
    }
}

void drawSkinnedDisc(atlax::Canvas& canvas, const atlax::Texture& picture, Vec2 middle,
                     float radius, float angle) {
    constexpr std::uint32_t corners = 32;
    std::array<atlax::MeshVertex, corners + 1> vertices;
    std::array<std::uint32_t, std::size_t{corners} * 3> indices{};
    vertices[corners] = {middle, {0.5f, 0.5f}, atlax::colors::white};
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float a = 6.2831853f * static_cast<float>(i) / corners;
        const Vec2 way{std::cos(a), std::sin(a)};
        const Vec2 turned{std::cos(a + angle), std::sin(a + angle)};
        vertices[i] = {middle + turned * radius,
                       {0.5f + 0.5f * way.x, 0.5f - 0.5f * way.y},
                       atlax::colors::white};
        indices[3 * i] = corners;
        indices[3 * i + 1] = i;
        indices[3 * i + 2] = (i + 1) % corners;
    }
    canvas.mesh(picture, vertices, indices);
}

}  // namespace quaoar
