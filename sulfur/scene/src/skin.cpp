// Skins for shapes whose layout of particles is known.
#include <algorithm>
#include <sulfur/scene/prefab.hpp>

namespace sulfur::scene {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Triangles from a middle particle to a closed ring of `count` particles before it.
Triangles fan(std::uint32_t count) {
    Triangles result;
    for (std::uint32_t i = 0; i < count; ++i) result.push_back({count, i, (i + 1) % count});
    return result;
}

Triangles lattice(std::uint32_t columns, std::uint32_t rows) {
    Triangles result;
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const auto corner = row * columns + column;
            result.push_back({corner, corner + 1, corner + columns + 1});
            result.push_back({corner, corner + columns + 1, corner + columns});
        }
    }
    return result;
}

Triangles trianglesOf(const Generator& generator, const Blueprint& blueprint) {
    if (const auto* jelly = std::get_if<shapes::JellyOptions>(&generator))
        return lattice(static_cast<std::uint32_t>(jelly->columns),
                       static_cast<std::uint32_t>(jelly->rows));
    if (const auto* cloth = std::get_if<shapes::ClothOptions>(&generator))
        return lattice(static_cast<std::uint32_t>(cloth->columns),
                       static_cast<std::uint32_t>(cloth->rows));
    if (const auto* wall = std::get_if<shapes::WallOptions>(&generator))
        return lattice(static_cast<std::uint32_t>(wall->columns + 1),
                       static_cast<std::uint32_t>(wall->rows + 1));
    if (const auto* blob = std::get_if<shapes::BlobOptions>(&generator))
        return fan(static_cast<std::uint32_t>(blob->segments));
    if (const auto* wheel = std::get_if<shapes::WheelOptions>(&generator))
        return fan(static_cast<std::uint32_t>(wheel->segments));
    if (std::holds_alternative<shapes::BoxOptions>(generator)) {
        // Four corners, and a particle in the middle or two at the sides if the corners do not
        // carry all of the mass.
        if (blueprint.particles.size() == 5) return fan(4);
        return {{0, 1, 2}, {0, 2, 3}};
    }
    return {};
}

}  // namespace

Skin fitSkin(const Generator& generator, const Blueprint& blueprint, std::string texture) {
    Skin skin;
    skin.texture = std::move(texture);
    skin.triangles = trianglesOf(generator, blueprint);
    if (blueprint.particles.empty()) return skin;
    Vec2 low(infinite, infinite), high(-infinite, -infinite);
    const auto include = [&](const ParticleSpec& particle) {
        low = low.cwiseMin(particle.position);
        high = high.cwiseMax(particle.position);
    };
    // What is in no triangle, such as the side particles of a thick box, is not in the picture.
    for (const auto& triangle : skin.triangles)
        for (const auto i : triangle) include(blueprint.particles[i]);
    if (skin.triangles.empty())
        for (const auto& particle : blueprint.particles) include(particle);
    const Vec2 size = high - low;
    for (const auto& particle : blueprint.particles) {
        // Where there is no extent, the middle of the picture; v points down.
        const Real u = size.x() > 0 ? (particle.position.x() - low.x()) / size.x() : Real(0.5);
        const Real v = size.y() > 0 ? (high.y() - particle.position.y()) / size.y() : Real(0.5);
        skin.uv.push_back({u, v});
    }
    return skin;
}

}  // namespace sulfur::scene
