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

/// At least `wanted` pieces.
Rows hitWall(double strength, int wanted, const Setup& setup) {
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
    const auto standing = moving(world).size();
    const Body ball = world.add(shapes::ball({.radius = real(ballRadius), .mass = 50}),
                                {.position = Point(-4, 1.5)});
    world.setVelocity(ball, vec2(20, 3));
    run(world, setup.seconds(20, 10));
    std::vector<Body> bodies = moving(world);
    const int pieces = static_cast<int>(bodies.size()) - 1;
    SpeedMeter meter(world, bodies);
    double fastest = 0;
    for (int i = 0; i < setup.tickRate; ++i) {
        world.step();
        fastest = worst(fastest, meter.add());
    }
    keepPicture(setup, fmt::format("crumbling-{:g}", strength), world);
    const std::string name =
        fmt::format("wall of strength {:g} N hit by a ball of 50 kg at 20 m/s: ", strength);
    return {
        atMost(name + "bodies before the hit beside the wall", static_cast<double>(standing) - 1,
               0),
        atMost(name + fmt::format("pieces missing to {}", wanted), std::max(0, wanted - pieces), 0),
        reported(name + "pieces", pieces),
        atMost(name + "deepest below the floor (m)", belowFloor(world, bodies, radius),
               radius / 10),
        fallsShort(name + "overlap at last (share of a radius)", deepestOverlap(world).share, 5, 0.1),
        reported(name + "largest speed at last (m/s)", fastest)};
}

}  // namespace

Rows crumbling(const Setup& setup) {
    Rows rows;
    for (Rows more : {hitWall(1500, 3, setup), hitWall(5000, 1, setup)})
        for (Row& row : more) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
