#include <quaoar/level_check.hpp>

#include <quaoar/hero.hpp>
#include <sulfur/world.hpp>

namespace quaoar {
namespace {

using sulfur::Point;

/// A world with the bodies of a level, without a hero.
struct BareLevel {
    explicit BareLevel(const Level& level)
        : world(level.scene.settings), instance(sulfur::scene::instantiate(level.scene, world)) {}
    sulfur::World world;
    sulfur::scene::Instance instance;
};

/// The fixed body that a place lies in, none if it is free.
std::optional<sulfur::BodyId> rockAt(const sulfur::World& world, const Point& place,
                                     double radius) {
    const sulfur::QueryFilter filter{.mask = Category::scenery};
    for (const sulfur::BodyId body : world.bodiesAt(place, filter)) {
        if (world.kind(body) == sulfur::BodyKind::fixed) return body;
    }
    const auto nearest = world.closestPoint(place, 1, filter);
    if (!nearest || world.kind(nearest->body) != sulfur::BodyKind::fixed) return std::nullopt;
    if (nearest->distance > radius) return std::nullopt;
    return nearest->body;
}

/// Whether a fixed line that is closed runs around a place, by the crossings of a ray to the right.
bool surrounds(const sulfur::World& world, sulfur::BodyId body, const Point& place) {
    const auto particles = world.particles(body);
    if (particles.size() < 3 || world.joints(body).size() != particles.size()) return false;
    bool inside = false;
    Point before = world.position(particles.back());
    for (const sulfur::ParticleId particle : particles) {
        const Point here = world.position(particle);
        if ((here.y() > place.y()) != (before.y() > place.y())) {
            const double part = (place.y() - here.y()) / (before.y() - here.y());
            if (place.x() < here.x() + part * (before.x() - here.x())) inside = !inside;
        }
        before = here;
    }
    return inside;
}

std::string nameOf(const BareLevel& bare, sulfur::BodyId body) {
    for (const auto& [id, known] : bare.instance.bodies) {
        if (known == body) return "\"" + id + "\"";
    }
    return "rock";
}

std::optional<LevelProblem> inRock(const BareLevel& bare, const Level& level) {
    const double skin = static_cast<double>(HeroRules().radius) / 2;
    if (const auto rock = rockAt(bare.world, level.spawn, skin)) {
        return LevelProblem{"spawn", "lies in " + nameOf(bare, *rock) +
                                         "; allowed is a place where the hero has room"};
    }
    if (const auto rock = rockAt(bare.world, level.exit.position, 0)) {
        return LevelProblem{"exit", "lies in " + nameOf(bare, *rock) +
                                        "; allowed is a place that the hero can come to"};
    }
    return std::nullopt;
}

}  // namespace

std::optional<LevelProblem> checkLevel(const Level& level) {
    const BareLevel bare(level);
    if (auto problem = inRock(bare, level)) return problem;
    for (const auto& [id, body] : bare.instance.bodies) {
        if (bare.world.kind(body) != sulfur::BodyKind::fixed) continue;
        const bool spawn = surrounds(bare.world, body, level.spawn);
        if (spawn == surrounds(bare.world, body, level.exit.position)) continue;
        return LevelProblem{spawn ? "spawn" : "exit",
                            "lies within the closed outline of \"" + id + "\", and the " +
                                (spawn ? "exit" : "spawn") +
                                " does not; allowed are both on the same side of it"};
    }
    return std::nullopt;
}

}  // namespace quaoar
