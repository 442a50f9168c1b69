#include "helpers.hpp"

namespace sulfur {
namespace {

/// A body that flies and spins.
Body launch(World& world, const Blueprint& plan, const Point& from, const Vec2& velocity,
            Real omega) {
    const Body body = world.add(plan, {.position = from});
    const Point centre = world.centreOfMass(body);
    for (const ParticleId id : body.particles()) {
        const Vec2 r = (world.position(id) - centre).cast<Real>();
        world.setVelocity(id, velocity + omega * Vec2(-r[1], r[0]));
    }
    return body;
}

struct Collision {
    double growth = 0;          // largest energy after the first tick as a share of that before
    double momentumError = 0;   // kg m/s, change of the sum
    double momentumBefore = 0;  // kg m/s, of one body
};

/// Two free bodies that meet at `speed`.
Collision collide(const Blueprint& one, const Blueprint& other, Real speed, Real omega) {
    World world({.gravity = Vec2(0, 0), .tickRate = 500, .sleeping = false});
    const Body a = launch(world, one, {-2, 0.1}, Vec2(speed, 0), omega);
    const Body b = launch(world, other, {2, 0}, Vec2(-speed, 0), Real(0.3) * omega);
    const auto momentumOf = [&](const Body& body) {
        return Point(static_cast<double>(world.mass(body)) *
                     world.meanVelocity(body).cast<double>());
    };
    const auto momentum = [&] { return Point(momentumOf(a) + momentumOf(b)); };
    world.step();
    const double energy = world.energy();
    const Point before = momentum();
    Collision result;
    result.momentumBefore = momentumOf(a).norm();
    bool met = false;
    for (int i = 0; i < 100; ++i) {
        world.step();
        met = met || !world.events().contactsBegun.empty();
        result.growth = std::max(result.growth, world.energy() / energy - 1);
    }
    EXPECT_TRUE(met);
    result.momentumError = (momentum() - before).norm();
    return result;
}

TEST(Impacts, FastRigidThingsGainNoEnergy) {
    const Blueprint rod = shapes::rope({.from = {Real(-0.4), 0}, .to = {Real(0.4), 0}, .links = 1});
    const Blueprint crate = shapes::box({.size = {Real(0.6), Real(0.4)}});
    const Blueprint ball = shapes::ball({.radius = Real(0.1), .mass = 2});
    for (const Real speed : {Real(20), Real(90), Real(150)})
        for (const Real omega : {Real(-50), Real(7), Real(40)}) {
            for (const Blueprint& one : {rod, ball}) {
                const Collision c = collide(one, crate, speed, omega);
                EXPECT_LT(c.growth, 1e-6) << speed << ' ' << omega;
                EXPECT_LT(c.momentumError, 1e-5 * c.momentumBefore) << speed << ' ' << omega;
            }
        }
}

/// Before there was a limit, springs that the sweeps had not brought to rest held up to twelve
/// times the energy of the impact.
TEST(Impacts, JelliesGainNoEnergy) {
    const Blueprint jelly = shapes::jelly(
        {.size = {Real(0.5), Real(0.5)}, .columns = 4, .rows = 4, .stiffness = Real(2e4)});
    for (const Real speed : {Real(20), Real(90), Real(150)}) {
        const Collision c = collide(jelly, jelly, speed, 5);
        EXPECT_LT(c.growth, 1e-3) << speed;
        EXPECT_LT(c.momentumError, 1e-5 * c.momentumBefore) << speed;
    }
}

}  // namespace
}  // namespace sulfur
