// What stands by friction alone: an arch and a house of cards.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

Rows standStill(const std::string& title, const std::string& picture, World& world,
                const std::vector<Body>& bodies, const Setup& setup) {
    const Places places(world, bodies);
    const double seconds = setup.seconds(60, 20);
    run(world, 10);
    const Places after(world, bodies);
    run(world, seconds - 10);
    keepPicture(setup, picture, world);
    const std::string name = fmt::format("{}, {:g} s: ", title, seconds);
    return {atMost(name + "parts more than 0.1 m from their places", places.moved(0.1), 0),
            reported(name + "farthest from its place (m)", places.farthest()),
            reported(name + "way of any after the first 10 s (m)", after.farthest()),
            reported(name + "overlap (share of a radius)", deepestOverlap(world).share)};
}

/// A wedge between two angles of a ring about the origin, seen from the middle of the wedge.
Blueprint voussoir(double from, double to, double inner, double outer, const Material& material) {
    const auto at = [](double angle, double radius) {
        return vec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    return shapes::polygon(
        {.points = {at(from, inner), at(from, outer), at(to, outer), at(to, inner)},
         .mass = 100,
         .material = material});
}

Rows arch(int stones, const Setup& setup) {
    constexpr double inner = 2.5, outer = 3.5;  // m
    const Material stone{.staticFriction = Real(0.6), .kineticFriction = Real(0.5)};
    World world(still(setup, standardGravity));
    for (const double side : {-1.0, 1.0}) {
        Blueprint abutment = crate({.size = 1.4, .material = stone});
        abutment.kind = BodyKind::fixed;
        world.add(abutment, {.position = Point(side * (inner + outer) / 2, -0.7)});
    }
    std::vector<Body> bodies;
    for (int i = 0; i < stones; ++i)
        bodies.push_back(
            world.add(voussoir(std::numbers::pi * i / stones, std::numbers::pi * (i + 1) / stones,
                               inner, outer, stone)));
    return standStill(fmt::format("arch of {} stones of 100 kg", stones),
                      fmt::format("arch{}", stones), world, bodies, setup);
}

constexpr double plankLength = 1, plankThickness = 0.06, plankRadius = 0.02;  // m

/// Planks leaning against each other in pairs, with planks across their tops.
class CardHouse {
public:
    CardHouse(World& world, int storeys, double lean) : world_(world), lean_(lean) {
        // The capsules' axes, and then the radius round them.
        const double thick = plankThickness / 2 - plankRadius;
        const double high = plankLength / 2 - plankRadius;
        reachX_ = thick * std::cos(lean) + high * std::sin(lean) + plankRadius;
        reachY_ = thick * std::sin(lean) + high * std::cos(lean) + plankRadius;
        const double pitch = plankLength;  // of the pairs, so that the planks above just meet
        double ground = 0;
        for (int storey = storeys; storey > 0; --storey) {
            for (int pair = 0; pair < storey; ++pair)
                addPair(pitch * (pair - (storey - 1) / 2.0), ground);
            ground += 2 * reachY_;
            for (int i = 0; i + 1 < storey; ++i)
                add(pitch * (i - (storey - 2) / 2.0), ground + plankThickness / 2,
                    std::numbers::pi / 2);
            ground += plankThickness;
        }
    }

    std::vector<Body> bodies;

private:
    void addPair(double x, double ground) {
        add(x - reachX_, ground + reachY_, -lean_);
        add(x + reachX_, ground + reachY_, lean_);
    }
    void add(double x, double y, double angle) {
        bodies.push_back(world_.add(
            shapes::box({.size = vec2(plankThickness, plankLength),
                         .radius = real(plankRadius),
                         .material = {.staticFriction = Real(0.8), .kineticFriction = Real(0.7)}}),
            {.position = Point(x, y), .angle = angle}));
    }

    World& world_;
    double lean_, reachX_, reachY_;
};

Rows cardHouse(const Setup& setup) {
    World world(still(setup, standardGravity));
    addFloor(world, 10, {.staticFriction = Real(0.8), .kineticFriction = Real(0.7)});
    const CardHouse house(world, 3, 0.2);
    return standStill("house of cards of 3 storeys, friction 0.8", "card-house", world,
                      house.bodies, setup);
}

}  // namespace

Rows arches(const Setup& setup) {
    Rows rows;
    for (const int stones : {11, 15})
        for (Row& row : arch(stones, setup)) rows.push_back(std::move(row));
    for (Row& row : cardHouse(setup)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
