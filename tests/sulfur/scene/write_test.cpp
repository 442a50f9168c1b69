// What is written reads back as the same.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;
using sulfur::Real;

TEST(Format, IsAFixedPoint) {
    const std::string once = format(parse(fullScene, "a"));
    EXPECT_EQ(format(parse(once, "b")), once);
}

TEST(Format, KeepsUnknownMembersVerbatim) {
    const std::string text = format(parse(fullScene, "a"));
    for (const char* kept :
         {"\"wind\": [1, 2]", "\"tint\": \"red\"", "\"tag\": {\"deep\": [1, 2.50, -0e1]}",
          "\"wet\": true", "\"why\": null", "\"blend\": 1", "\"note\": \"kept\"", "\"layer\": 3",
          "\"when\": 1", "\"colour\": \"blue\"", "\"slick\": 1", "\"worn\": 2", "\"hook\": []",
          "\"level\": {\n    \"spawn\": [1, 2],\n    \"exit\": {\"id\": \"door\", \"at\": [9, "
          "9]}\n  }"})
        EXPECT_NE(text.find(kept), std::string::npos) << kept << " in\n" << text;
}

TEST(Format, LosesNoMember) {
    const Scene before = parse(fullScene, "a");
    const Scene after = parse(format(before), "b");
    EXPECT_EQ(after.title, before.title);
    EXPECT_EQ(after.description, before.description);
    EXPECT_EQ(after.settings.gravity, before.settings.gravity);
    EXPECT_EQ(after.settings.friction, before.settings.friction);
    ASSERT_EQ(after.vetoes.size(), before.vetoes.size());
    EXPECT_EQ(after.vetoes[0].b, before.vetoes[0].b);
    ASSERT_EQ(after.blueprints.size(), before.blueprints.size());
    for (std::size_t i = 0; i < before.blueprints.size(); ++i) {
        const auto &a = before.blueprints[i].blueprint, &b = after.blueprints[i].blueprint;
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.material, b.material) << a.name;
        EXPECT_EQ(a.filter, b.filter) << a.name;
        EXPECT_EQ(a.sensor, b.sensor) << a.name;
        EXPECT_EQ(a.selfCollision, b.selfCollision) << a.name;
        EXPECT_EQ(a.skin.has_value(), b.skin.has_value());
        if (a.skin && b.skin) {
            EXPECT_EQ(a.skin->uv, b.skin->uv);
            EXPECT_EQ(a.skin->triangles, b.skin->triangles);
        }
        ASSERT_EQ(a.particles.size(), b.particles.size());
        for (std::size_t p = 0; p < a.particles.size(); ++p) {
            EXPECT_EQ(a.particles[p].position, b.particles[p].position);
            EXPECT_EQ(a.particles[p].mass, b.particles[p].mass);
            EXPECT_EQ(a.particles[p].radius, b.particles[p].radius);
            EXPECT_EQ(a.particles[p].pinned, b.particles[p].pinned);
        }
        ASSERT_EQ(a.joints.size(), b.joints.size());
        for (std::size_t j = 0; j < a.joints.size(); ++j) {
            EXPECT_EQ(a.joints[j].stiffness, b.joints[j].stiffness);
            EXPECT_EQ(a.joints[j].damping, b.joints[j].damping);
            EXPECT_EQ(a.joints[j].restLength, b.joints[j].restLength);
            EXPECT_EQ(a.joints[j].radius, b.joints[j].radius);
            EXPECT_EQ(a.joints[j].strength, b.joints[j].strength);
            EXPECT_EQ(a.joints[j].material, b.joints[j].material);
        }
    }
    EXPECT_EQ(after.body("crate")->state->positions, before.body("crate")->state->positions);
    EXPECT_EQ(after.connections[0].options.restLength, before.connections[0].options.restLength);
    EXPECT_EQ(after.connections[0].options.material, before.connections[0].options.material);
}

TEST(Format, EveryNumberReadsBackExactly) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> exponent(-30, 2), sign(-1, 1);
    Scene scene;
    scene.blueprints.push_back(makePrefab("ball", sulfur::shapes::BallOptions{}));
    for (int i = 0; i < 2000; ++i) {
        Placement body;
        body.id = "b" + std::to_string(i);
        body.blueprint = "ball";
        body.pose.position = {std::pow(10, exponent(random)) * sign(random), sign(random)};
        body.velocity = {static_cast<Real>(std::pow(10, exponent(random))), -Real(0)};
        scene.bodies.push_back(body);
    }
    const Scene back = parse(format(scene), "back");
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        EXPECT_EQ(back.bodies[i].pose.position, scene.bodies[i].pose.position);
        EXPECT_EQ(back.bodies[i].velocity, scene.bodies[i].velocity);
    }
}

TEST(Format, BlueprintFilesToo) {
    const Scene scene = parse(fullScene, "a");
    for (const auto& prefab : scene.blueprints) {
        const std::string text = format(prefab);
        const Prefab back = parseBlueprint(text, "b");
        EXPECT_EQ(back.blueprint.name, prefab.blueprint.name);
        EXPECT_EQ(back.generator.index(), prefab.generator.index());
        EXPECT_EQ(format(back), text);
    }
    const std::string own = replaced(format(scene.blueprints[4]), "\"version\": 1,",
                                     "\"version\": 1, \"author\": \"me\",");
    EXPECT_NE(format(parseBlueprint(own, "c")).find("\"author\": \"me\""), std::string::npos);
    EXPECT_EQ(errorOf([] { parseBlueprint("{\"format\": \"sulfur-blueprint\"}", "d"); }).file(),
              "d");
}

TEST(Extra, IsSetReplacedAndErased) {
    Scene scene;
    setExtra(scene.extra, "level", " {\"a\": 1} ");
    EXPECT_EQ(findExtra(scene.extra, "level")->json, "{\"a\": 1}");
    setExtra(scene.extra, "level", "2");
    EXPECT_EQ(scene.extra.size(), 1u);
    EXPECT_THROW(setExtra(scene.extra, "level", "{"), ReadError);
    EXPECT_EQ(findExtra(scene.extra, "level")->json, "2");
    eraseExtra(scene.extra, "level");
    EXPECT_EQ(findExtra(scene.extra, "level"), nullptr);
}

TEST(Scene, FindsFreeNames) {
    const Scene scene = parse(fullScene, "a");
    EXPECT_EQ(scene.freeId("new"), "new");
    EXPECT_EQ(scene.freeId("crate"), "crate2");
    EXPECT_EQ(scene.freeName("box"), "box2");
}

}  // namespace
