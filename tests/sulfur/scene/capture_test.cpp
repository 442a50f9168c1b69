// From a scene to a world and back.
#include <gtest/gtest.h>

#include <array>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;
using sulfur::Real;
using sulfur::World;

TEST(Instantiate, MakesEverything) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const Instance instance = instantiate(scene, world);
    EXPECT_EQ(instance.bodies.size(), scene.bodies.size());
    EXPECT_EQ(instance.mechanisms.size(), scene.mechanisms.size());
    EXPECT_EQ(instance.connections.size(), 1u);
    EXPECT_EQ(instance.attachments.size(), 1u);
    EXPECT_EQ(world.connections().size(), 1u);
    const auto lift = instance.body("lift");
    EXPECT_EQ(instance.id(lift), "lift");
    EXPECT_EQ(world.kind(lift), sulfur::BodyKind::dynamic);
    EXPECT_FALSE(instance.body("none"));
    const auto crate = world.particles(instance.body("crate"));
    EXPECT_EQ(world.position(crate[1]), sulfur::Point(8.7, 2));
    EXPECT_EQ(world.velocity(crate[2]), sulfur::Vec2(1, sulfur::Real(0.125)));
}

TEST(Instantiate, IsDeterministic) {
    const auto hash = [](const Scene& scene) {
        World world(scene.settings);
        instantiate(scene, world);
        for (int i = 0; i < 200; ++i) world.step();
        return world.hash();
    };
    const Scene scene = parse(fullScene, "a");
    EXPECT_EQ(hash(scene), hash(scene));
    EXPECT_EQ(hash(scene), hash(parse(format(scene), "b")));
}

TEST(Capture, OfAFreshWorldIsTheScene) {
    Scene scene = parse(fullScene, "a");
    scene.bodies[1].velocity = {0, 0};
    World world(scene.settings);
    const auto instance = instantiate(scene, world);
    const Scene captured = capture(world, scene, instance);
    EXPECT_EQ(captured.blueprints.size(), scene.blueprints.size());
    EXPECT_FALSE(captured.body("ground")->state);
    EXPECT_EQ(captured.bodies.size(), scene.bodies.size());
    EXPECT_EQ(captured.attachments.size(), 1u);
}

TEST(Capture, HoldsPositionsAndVelocitiesExactly) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const auto instance = instantiate(scene, world);
    for (int i = 0; i < 50; ++i) world.step();
    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    EXPECT_NE(findExtra(captured.extra, "level"), nullptr);
    World second(captured.settings);
    const auto again = instantiate(captured, second);
    for (const auto& [id, body] : instance.bodies) {
        const auto before = world.particles(body), after = second.particles(again.body(id));
        ASSERT_EQ(before.size(), after.size()) << id;
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(world.position(before[i]), second.position(after[i])) << id;
            EXPECT_EQ(world.velocity(before[i]), second.velocity(after[i])) << id;
        }
        EXPECT_EQ(world.joints(body).size(), second.joints(again.body(id)).size());
    }
}

TEST(Capture, SeesNewChangedAndRemovedBodies) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const auto instance = instantiate(scene, world);
    const auto dropped = world.add(sulfur::shapes::box({.mass = 5}), {.position = {0, 12}});
    world.connect(dropped.front(), world.particles(instance.body("b"))[1], {.stiffness = 9});
    world.setStiffness(world.joints(instance.body("b"))[0], 1234);
    world.setGravity({0, -1});
    world.remove(instance.body("r"));
    for (int i = 0; i < 20; ++i) world.step();
    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    EXPECT_EQ(captured.body("r"), nullptr);
    EXPECT_TRUE(captured.attachments.empty());
    EXPECT_EQ(captured.settings.gravity.y(), -1);
    const auto* box = captured.body("box");
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(captured.prefab(box->blueprint)->blueprint.mass(), 5);
    EXPECT_EQ(captured.prefab(box->blueprint)->generator.index(), 0u);
    const auto* blob = captured.body("b");
    EXPECT_EQ(captured.prefab(blob->blueprint)->blueprint.joints[0].stiffness, 1234);
    // Its rest shape is still the shape's, though it has fallen and deformed.
    EXPECT_EQ(captured.prefab(blob->blueprint)->blueprint.particles[2].position,
              scene.prefab("blob")->blueprint.particles[2].position);
    ASSERT_EQ(captured.connections.size(), 2u);
    EXPECT_EQ(findExtra(captured.connections[0].extra.at(""), "colour")->json, "\"blue\"");
}

TEST(Capture, SeesNewAttachmentsAndWhereTheyAre) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const auto instance = instantiate(scene, world);
    const auto hook = world.add(sulfur::shapes::ball(), {.position = {4, 9}});
    const auto hung =
        world.attach(hook.front(), instance.body("lift"), {sulfur::Real(0.4), sulfur::Real(0.3)});
    // By a joint of a body that then changes, so that it gets a frame of its own.
    const auto crate = instance.body("crate");
    const auto second = world.add(sulfur::shapes::ball(), {.position = {8, 3}});
    const auto tied = world.attach(second.front(), world.joints(crate)[2], sulfur::Real(0.25));
    world.remove(world.joints(crate)[5]);
    // Nothing that a scene could say: a joint between bodies, and the particle's own body.
    const auto third = world.add(sulfur::shapes::ball(), {.position = {8, 4}});
    world.attach(third.front(), world.connections()[0], sulfur::Real(0.5));
    world.attach(world.particles(crate)[0], world.joints(crate)[1], sulfur::Real(0.5));

    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    ASSERT_EQ(captured.attachments.size(), 3u);
    EXPECT_NEAR((captured.attachments[0].point - scene.attachments[0].point).norm(), 0, 1e-6);
    EXPECT_EQ(findExtra(captured.attachments[0].extra, "hook")->json, "[]");
    EXPECT_NEAR((captured.attachments[1].point - sulfur::Vec2(0.4f, 0.3f)).norm(), 0, 1e-6);

    World again(captured.settings);
    const auto copy = instantiate(captured, again);
    const auto place = [](const World& from, sulfur::AttachmentId id) {
        const auto info = from.info(id);
        sulfur::Point sum(0, 0);
        for (std::uint32_t k = 0; k < info.count; ++k)
            sum += static_cast<double>(info.weights[k]) * from.position(info.supports[k]);
        return sum;
    };
    const std::array places{instance.attachments[0], hung, tied};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto before = place(world, places[i]);
        EXPECT_NEAR((place(again, copy.attachments[i]) - before).norm(), 0, 1e-5) << i;
    }
}

TEST(Capture, SeesNewChangedAndRemovedFields) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const auto instance = instantiate(scene, world);
    ASSERT_EQ(instance.fields.size(), 4u);
    world.remove(instance.fields[1]);
    world.set(instance.fields[0], sulfur::UniformField{.acceleration = {7, 0}});
    world.add(sulfur::RadialField{.centre = {1, 2}, .falloff = 3});
    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    ASSERT_EQ(captured.fields.size(), 4u);
    EXPECT_EQ(std::get<sulfur::UniformField>(captured.fields[0].field).acceleration.x(), 7);
    EXPECT_EQ(findExtra(captured.fields[0].extra.at(""), "flow")->json, "\"river\"");
    const auto& round = std::get<sulfur::WindField>(captured.fields[1].field);
    EXPECT_EQ(std::get<sulfur::CircleZone>(round.zone).centre, sulfur::Point(5, 6));
    const auto& radial = std::get<sulfur::RadialField>(captured.fields[3].field);
    EXPECT_EQ(radial.falloff, 3);
    EXPECT_EQ(radial.reach, sulfur::infinite);
}

TEST(Capture, HoldsSurfacesSelfCollisionAndVetoes) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const auto instance = instantiate(scene, world);
    const auto body = [&](const char* id) { return instance.body(id); };
    EXPECT_FALSE(world.collision(body("lift"), body("b")));
    EXPECT_FALSE(world.collision(body("ground"), body("crate")));
    EXPECT_TRUE(world.selfCollision(body("r")));
    EXPECT_EQ(world.material(world.joints(body("lift"))[1]).surfaceSpeed, Real(-2.5));
    EXPECT_EQ(world.material(world.connections()[0]).restitution, Real(0.45));
    world.setCollision(body("ground"), body("crate"), true);
    world.setCollision(body("r"), body("crate"), false);
    world.setSelfCollision(body("r"), false);
    world.setSelfCollision(body("b"), true);
    const sulfur::Material ice{.staticFriction = 0, .kineticFriction = 0};
    world.setMaterial(world.joints(body("crate"))[2], ice);
    world.setMaterial(world.connections()[0], std::nullopt);
    world.setMaterial(body("ground"), {.surfaceSpeed = 3});

    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    EXPECT_EQ(captured.settings.friction, sulfur::Friction::sliding);
    EXPECT_EQ(captured.body("lift")->blueprint, "plain");  // as it was
    ASSERT_EQ(captured.vetoes.size(), 2u);
    World again(captured.settings);
    const auto copy = instantiate(captured, again);
    EXPECT_TRUE(again.collision(copy.body("ground"), copy.body("crate")));
    EXPECT_FALSE(again.collision(copy.body("r"), copy.body("crate")));
    EXPECT_FALSE(again.collision(copy.body("b"), copy.body("lift")));
    EXPECT_FALSE(again.selfCollision(copy.body("r")));
    EXPECT_TRUE(again.selfCollision(copy.body("b")));
    EXPECT_EQ(again.material(again.joints(copy.body("crate"))[2]), ice);
    EXPECT_EQ(again.material(again.joints(copy.body("crate"))[1]), world.material(body("crate")));
    EXPECT_EQ(again.material(again.connections()[0]), world.material(body("b")));
    EXPECT_FALSE(captured.connections[0].options.material);
    EXPECT_EQ(again.material(copy.body("ground")).surfaceSpeed, 3);
}

TEST(Capture, HoldsHowDiscsTurn) {
    World world;
    const auto ball = world.add(sulfur::shapes::ball(), {.position = {0, 5}, .angle = 1}).id();
    world.setVelocity(ball, {1, 0}, 7);
    for (int i = 0; i < 30; ++i) world.step();
    const Scene captured = parse(format(capture(world)), "saved");
    World again(captured.settings);
    const auto same = instantiate(captured, again).body(captured.bodies[0].id);
    EXPECT_NEAR(again.angle(same), world.angle(ball), 1e-9);
    EXPECT_NEAR(again.angularVelocity(same), world.angularVelocity(ball), 1e-6);
    EXPECT_EQ(again.position(again.particles(same)[0]), world.position(world.particles(ball)[0]));
    EXPECT_EQ(again.meanVelocity(same), world.meanVelocity(ball));
}

TEST(Capture, HoldsDiscsThatHaveTurnedBackToZero) {
    const Scene scene = parse(R"({"format": "sulfur-scene", "version": 1,
      "settings": {"gravity": [0, 0]},
      "blueprints": {"disc": {"particles": [{"position": [0, 0], "radius": 0.5}]}},
      "bodies": [{"id": "disc", "blueprint": "disc", "angle": 0.3}]})",
                              "a");
    World world(scene.settings);
    const Instance instance = instantiate(scene, world);
    world.setPose(instance.body("disc"), {.position = {1, 0}, .angle = 0});
    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    World again(captured.settings);
    EXPECT_NEAR(again.angle(instantiate(captured, again).body("disc")), 0, 1e-9);
}

TEST(Capture, HoldsDiscsThatSpinFasterThanAFileCanSay) {
    World world({.gravity = {0, 0}});
    const auto disc = world.add({.particles = {{.radius = Real(0.0005)}}}).id();
    world.applyAngularImpulse(disc, Real(0.2));
    world.step();
    ASSERT_GT(world.angularVelocity(disc), Limits::spin);
    const Scene captured = parse(format(capture(world)), "saved");
    EXPECT_EQ(captured.bodies.at(0).state->spin, Limits::spin);
}

TEST(Capture, OfAWorldWithoutAScene) {
    World world;
    world.add(sulfur::shapes::floor({-5, 0}, {5, 0}));
    for (int i = 0; i < 3; ++i) world.add(sulfur::shapes::jelly(), {.position = {0, 2.0 + 2 * i}});
    for (int i = 0; i < 100; ++i) world.step();
    const Scene captured = parse(format(capture(world)), "saved");
    ASSERT_EQ(captured.bodies.size(), 4u);
    EXPECT_EQ(captured.bodies[1].id, "jelly");
    EXPECT_EQ(captured.bodies[3].id, "jelly3");
    World second(captured.settings);
    instantiate(captured, second);
    for (int i = 0; i < 100; ++i) second.step();
    EXPECT_EQ(second.validate(), "");
}

}  // namespace
