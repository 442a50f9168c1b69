// A wall that a heavy ball breaks into pieces, which collide and come to rest on the floor.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// All dynamic bodies.
std::vector<Body> moving(World& world) {
    std::vector<Body> found;
    for (const BodyId id : world.bodies())
        if (world.kind(id) == BodyKind::dynamic) found.push_back(world.body(id));
    return found;
}

/// How deep the lowest surface of any body is below the floor's, m; `radius` is that of capsules.
double belowFloor(const World& world, const std::vector<Body>& bodies, double radius) {
    double deepest = 0;
    for (const Body& body : bodies)
        for (const ParticleId id : body.particles()) {
            const double own = std::max(radius, static_cast<double>(world.info(id).radius));
            deepest = worst(deepest, own - world.position(id).y());
        }
    return deepest;
}

/// What becomes of a wall.
struct Ruin {
    int standing = 0, pieces = 0;
    double below = 0, overlap = 0, fastest = 0;  // m, share of a radius, m/s
};

Ruin hitWall(double strength, double height, const Setup& setup) {
    constexpr double radius = 0.02, ballRadius = 0.3;  // m
    World world(still(setup, standardGravity));
    addFloor(world, 200);
    world.add(shapes::wall({.size = vec2(2, 3),
                            .columns = 4,
                            .rows = 6,
                            .radius = real(radius),
                            .strength = real(strength)}),
              {.position = Point(0, 1.5)});
    run(world, 1);
    Ruin ruin;
    ruin.standing = static_cast<int>(moving(world).size());
    const Body ball = world.add(shapes::ball({.radius = real(ballRadius), .mass = 50}),
                                {.position = Point(-4, height)});
    world.setVelocity(ball, vec2(20, 3));
    run(world, setup.seconds(20, 10));
    std::vector<Body> bodies = moving(world);
    ruin.pieces = static_cast<int>(bodies.size()) - 1;
    SpeedMeter meter(world, bodies);
    for (int i = 0; i < setup.tickRate; ++i) {
        world.step();
        ruin.fastest = worst(ruin.fastest, meter.add());
    }
    ruin.below = belowFloor(world, bodies, radius) / radius;
    ruin.overlap = deepestOverlap(world).share;
    keepPicture(setup, fmt::format("crumbling-{:g}-{:g}", strength, height), world);
    return ruin;
}

/// At least `wanted` pieces of a wall, in the mean: where a wall breaks hangs on how it is hit, and
/// the pieces of one wall deviate by 1.4. So many walls are hit, at heights about its middle.
Rows hitWalls(double strength, int wanted, const Setup& setup) {
    Ruin all;
    constexpr int hits = 25;
    for (int i = 0; i < hits; ++i) {
        const Ruin ruin = hitWall(strength, 1.1 + 0.8 * i / (hits - 1), setup);
        all.standing = std::max(all.standing, ruin.standing);
        all.pieces += ruin.pieces;
        all.below = worst(all.below, ruin.below);
        all.overlap = worst(all.overlap, ruin.overlap);
        all.fastest = worst(all.fastest, ruin.fastest);
    }
    const double pieces = static_cast<double>(all.pieces) / hits;
    const std::string name = fmt::format(
        "{} walls of strength {:g} N hit by a ball of 50 kg at 20 m/s: ", hits, strength);
    return {atMost(name + "bodies before the hit beside the wall", all.standing - 1, 0),
            atMost(name + fmt::format("pieces missing to {}, mean", wanted),
                   std::max(0.0, wanted - pieces), 0),
            reported(name + "pieces, mean", pieces),
            atMost(name + "deepest below the floor (share of a radius)", all.below, 0.1),
            atMost(name + "overlap at last (share of a radius)", all.overlap, 0.1),
            reported(name + "largest speed at last (m/s)", all.fastest)};
}

}  // namespace

Rows crumbling(const Setup& setup) {
    Rows rows;
    for (Rows more : {hitWalls(1500, 3, setup), hitWalls(5000, 1, setup)})
        for (Row& row : more) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
