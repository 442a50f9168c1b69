// Bodies that start in each other.
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

constexpr double width = 1;   // m, of every body, except that a rope is thin
constexpr double settle = 3;  // s

/// Two bodies of 1 m, their middles `width` apart when they only touch.
struct Pair {
    std::string name;
    Blueprint first, second;
    double full = width;  // m, how far the second is moved at 100 %
};

Blueprint disc() {
    return shapes::ball({.radius = real(width / 2)});
}

Blueprint hook() {
    const double h = width / 2;
    return shapes::polygon(
        {.points = {vec2(-h, -h), vec2(h, -h), vec2(h, h), vec2(0.2, h), vec2(0.2, -0.2),
                    vec2(-0.2, -0.2), vec2(-0.2, h), vec2(-h, h)}});
}

Blueprint wallPiece() {
    return shapes::wall({.size = vec2(width, width), .columns = 2, .rows = 2, .mass = 1});
}

/// Upright, its left side at -width / 2, so that at 100 % it lies in the middle of the first.
Blueprint uprightRope() {
    constexpr double radius = 0.015;
    const double x = radius - width / 2;
    return shapes::rope({.from = vec2(x, -1.2), .to = vec2(x, 1.2), .radius = real(radius)});
}

std::vector<Pair> pairs() {
    const Blueprint soft = firmJelly(width, 1, 400, 1);
    return {{"crate in crate", crate(), crate()},
            {"jelly in crate", crate(), soft},
            {"disc in disc", disc(), disc()},
            {"disc in crate", crate(), disc()},
            {"jelly in jelly", soft, soft},
            {"rope in crate", crate(), uprightRope(), width / 2},
            {"wall in crate", crate(), wallPiece()},
            {"wall in wall", wallPiece(), wallPiece()},
            {"hook in crate", crate(), hook()},
            {"hook in hook", hook(), hook()}};
}

/// Of the capsules; of a disc that of a crate's, for a tenth of a disc is no small overlap.
double smallestRadius(const World& world, const std::vector<Body>& bodies) {
    double smallest = 0.02;
    for (const Body& body : bodies) {
        for (const JointId id : body.joints())
            if (const auto r = static_cast<double>(world.info(id).radius); r > 0)
                smallest = std::min(smallest, r);
    }
    return smallest;
}

/// Lets go for three seconds. Overlap: of what is left, in capsule thicknesses.
Rows release(const std::string& name, World& world, const std::vector<Body>& bodies, bool free,
             const Setup& setup) {
    SpeedMeter meter(world, bodies);
    double fastest = 0;
    for (int i = 0; i < std::lround(settle * setup.tickRate); ++i) {
        world.step();
        fastest = worst(fastest, meter.add());
    }
    const double left = deepestOverlap(world).depth / (2 * smallestRadius(world, bodies));
    const std::string speed = name + "largest speed of a particle (m/s)";
    return {atMost(name + "overlap after 3 s (share of a thickness)", left, 0.1),
            // Under gravity they also fall off each other.
            free ? atMost(speed, fastest, 1) : reported(speed, fastest)};
}

Rows separate(const Pair& pair, double share, bool free, const Setup& setup) {
    World world(still(setup, free ? 0 : standardGravity));
    if (!free) addFloor(world, 20);
    const double height = pair.name.starts_with("rope") ? 1.3 : width / 2;
    const Point place(0, free ? 0 : height);
    const std::vector<Body> bodies{
        world.add(pair.first, {.position = Point(0, free ? 0 : width / 2)}),
        world.add(pair.second, {.position = place + Point(width - share * pair.full, 0)})};
    const std::string name =
        fmt::format("{} by {:g} %, {}: ", pair.name, 100 * share, free ? "free" : "on a floor");
    Rows rows = release(name, world, bodies, free, setup);
    if (share == 0.5 || share == 1)
        keepPicture(setup,
                    fmt::format("overlap-{}-{:g}{}", pair.name, 100 * share, free ? "" : "-floor"),
                    world);
    return rows;
}

/// Ten discs in one heap, their middles within a tenth of a radius.
Rows heap(bool free, const Setup& setup) {
    World world(still(setup, free ? 0 : standardGravity));
    if (!free) addFloor(world, 20);
    Random random(3);
    std::vector<Body> bodies;
    for (int i = 0; i < 10; ++i)
        bodies.push_back(world.add(
            shapes::ball({.radius = Real(0.25)}),
            {.position = Point(random.uniform(-0.025, 0.025), 0.3 + random.uniform(0, 0.025))}));
    return release(fmt::format("heap of 10 discs, {}: ", free ? "free" : "on a floor"), world,
                   bodies, free, setup);
}

}  // namespace

Rows overlaps(const Setup& setup) {
    Rows rows;
    for (const bool free : {true, false}) {
        for (const Pair& pair : pairs())
            for (const double share : {0.1, 0.25, 0.5, 0.75, 1.0})
                for (Row& row : separate(pair, share, free, setup)) rows.push_back(std::move(row));
        for (Row& row : heap(free, setup)) rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace sulfur::lab
