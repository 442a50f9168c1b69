// Contacts of one body are those of the world that name it.
#include <algorithm>
#include <array>
#include <tuple>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// Crates, discs and a jelly in a heap.
World heap(Real restitution) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    for (int i = 0; i < 12; ++i) {
        const Body body =
            world.add(i % 3 == 0 ? shapes::ball() : shapes::box(),
                      {.position = {0.3 * (i % 4) - 0.5, 1 + 0.9 * i}, .angle = 0.1 * i});
        Material material = body.material();
        material.restitution = restitution;
        body.setMaterial(material);
    }
    world.add(shapes::jelly(), {.position = {3, 1}});
    return world;
}

using Key = std::tuple<BodyId, BodyId, double, double, Real, Real>;
Key keyOf(const ContactInfo& c) {
    return {c.a, c.b, c.point.x(), c.point.y(), c.impulse, c.friction};
}

/// Those of the world that name a body.
std::vector<Key> expected(const std::vector<ContactInfo>& all, BodyId body) {
    std::vector<Key> keys;
    for (const ContactInfo& c : all)
        if (c.a == body || c.b == body) keys.push_back(keyOf(c));
    std::sort(keys.begin(), keys.end());
    return keys;
}

TEST(ContactsOfABody, AreThoseOfTheWorld) {
    for (const Real restitution : {Real(0), Real(0.7)}) {
        World world = heap(restitution);
        std::size_t most = 0;
        for (int i = 0; i < 2500; ++i) {
            world.step();
            if (i % 20 != 0) continue;
            const auto all = world.contacts();
            for (const BodyId body : world.bodies()) {
                std::array<ContactInfo, 64> found;
                const std::size_t count = world.contacts(body, found);
                ASSERT_LE(count, found.size());
                most = std::max(most, count);
                std::vector<Key> keys;
                for (std::size_t k = 0; k < count; ++k) keys.push_back(keyOf(found[k]));
                std::sort(keys.begin(), keys.end());
                ASSERT_EQ(keys, expected(all, body)) << "tick " << i;
            }
        }
        EXPECT_GE(most, 4u);
    }
}

TEST(ContactsOfABody, AreCutToTheRoomThatThereIs) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body crate = world.add(shapes::box(), {.position = {0, 0.55}});
    test::run(world, 1);
    std::array<ContactInfo, 3> found;
    EXPECT_EQ(crate.contacts({}), 2u);
    EXPECT_EQ(crate.contacts(std::span(found).first(1)), 2u);
    EXPECT_EQ(found[0].a, crate.id());
    EXPECT_FALSE(found[1].a);
    EXPECT_THROW(world.contacts(BodyId{}, found), Error);
}

TEST(ContactsOfABody, TouchesIsWhatEventsTell) {
    World world = heap(0);
    std::vector<std::pair<BodyId, BodyId>> touching;
    for (int i = 0; i < 1500; ++i) {
        world.step();
        for (const ContactBegun& e : world.events().contactsBegun) {
            touching.emplace_back(std::min(e.a, e.b), std::max(e.a, e.b));
            EXPECT_TRUE(world.touches(e.a, e.b) && world.touches(e.b, e.a));
        }
        for (const ContactEnded& e : world.events().contactsEnded) {
            std::erase(touching, std::pair(std::min(e.a, e.b), std::max(e.a, e.b)));
            EXPECT_FALSE(world.touches(e.a, e.b));
        }
    }
    EXPECT_FALSE(touching.empty());
    std::size_t count = 0;
    const auto bodies = world.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t k = i + 1; k < bodies.size(); ++k)
            count += world.touches(bodies[i], bodies[k]) ? 1 : 0;
    EXPECT_EQ(count, touching.size());
    EXPECT_THROW(world.touches(bodies[0], {}), Error);
}

}  // namespace
}  // namespace sulfur
