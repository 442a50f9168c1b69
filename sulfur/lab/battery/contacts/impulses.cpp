// Soft and rigid bodies answer equal impulses alike.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// The velocity of the centre over one second, half a second after impulses that add up to `sum`.
Vec pushed(const Blueprint& plan, const Vec2& sum, bool spread, const Setup& setup) {
    World world(still(setup, 0));
    const Body body = world.add(plan);
    const auto n = static_cast<Real>(body.size());
    if (spread) {
        for (const ParticleId id : body.particles()) world.applyImpulse(id, sum / n);
    } else {
        world.applyImpulse(body.front(), sum);
    }
    run(world, 0.5);
    const Point before = world.centreOfMass(body);
    run(world, 1);
    return world.centreOfMass(body) - before;
}

Rows pushBoth(const Setup& setup) {
    const Vec2 sum = vec2(0.3, 0.1);  // N s on 1 kg
    const Vec expected = sum.cast<double>();
    Rows rows;
    for (const bool spread : {true, false}) {
        const Vec rigid = pushed(crate(), sum, spread, setup);
        const Vec soft = pushed(firmJelly(1, 1, 400, 1), sum, spread, setup);
        const std::string name =
            spread ? "impulse on all particles of 1 kg: " : "impulse on one particle of 1 kg: ";
        const double scale = expected.norm();
        rows.push_back(atMost(name + "velocity of the centre, soft against rigid (share)",
                              (soft - rigid).norm() / scale, 1e-5));
        rows.push_back(atMost(name + "velocity of the centre, rigid against the impulse (share)",
                              (rigid - expected).norm() / scale, 1e-5));
    }
    return rows;
}

Vec momentum(const World& world, const std::vector<Body>& bodies) {
    Vec sum = Vec::Zero();
    for (const Body& body : bodies) sum += motionOf(world, body.particles()).momentum;
    return sum;
}

/// A ball hits a body in free space, `offset` metres beside the middle. Share by which that changes
/// the momentum in half a second; nan if it misses.
double changeByShot(const Blueprint& plan, double offset, const std::string& picture,
                    const Setup& setup) {
    World world(still(setup, 0));
    const Body target = world.add(plan);
    const Body ball = world.add(shapes::ball({.radius = Real(0.1), .mass = Real(0.1)}),
                                {.position = Point(-2, offset)});
    world.setVelocity(ball, vec2(20, 0));
    const std::vector<Body> bodies{target, ball};
    const Vec before = momentum(world, bodies);
    run(world, 0.5);
    if (!picture.empty()) keepPicture(setup, picture, world);
    if (!(world.meanVelocity(target).norm() > 0)) return std::nan("");
    return (momentum(world, bodies) - before).norm() / before.norm();
}

/// The root mean square of nine shots within 4 mm: what is left is rounding, which goes astray at
/// random, so that one shot says little.
Row shootAt(const std::string& what, const Blueprint& plan, double offset, const Setup& setup) {
    double squares = 0;
    for (int i = -4; i <= 4; ++i) {
        const std::string picture =
            i == 0 ? fmt::format("projectile-{}-{:g}", what, offset) : std::string();
        const double change = changeByShot(plan, offset + 1e-3 * i, picture, setup);
        squares += change * change / 9;
    }
    return atMost(fmt::format("ball of 0.1 kg at 20 m/s against a {} of 1 kg, {:g} m off its "
                              "middle: change of the momentum (share)",
                              what, offset),
                  std::sqrt(squares), 1e-6);
}

}  // namespace

Rows impulses(const Setup& setup) {
    Rows rows = pushBoth(setup);
    for (const double offset : {0.0, 0.3}) {
        rows.push_back(shootAt("crate", crate(), offset, setup));
        rows.push_back(shootAt("jelly", firmJelly(1, 1, 400, 1), offset, setup));
    }
    return rows;
}

}  // namespace sulfur::lab
