// What the reader of scenes refuses, and how it says so.
#include <gtest/gtest.h>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;
using sulfur::BodyKind;
using sulfur::Real;

/// A scene with one blueprint and one body of it, on the lines 3 and 4.
std::string around(const std::string& blueprint, const std::string& more = "") {
    return "{\"format\": \"sulfur-scene\", \"version\": 1,\n\"blueprints\": {\n\"thing\": " +
           blueprint + "},\n\"bodies\": [{\"id\": \"one\", \"blueprint\": \"thing\"}" + more + "]}";
}

TEST(Read, GivesEveryMember) {
    const Scene scene = parse(fullScene, "full.json");
    EXPECT_EQ(scene.title, "Everything \"at once\"\n\xC3\xA9\xE2\x98\x83");
    EXPECT_EQ(scene.settings.tickRate, 240);
    EXPECT_FALSE(scene.settings.sleeping);
    EXPECT_EQ(scene.settings.gravity, sulfur::Vec2(Real(0.5), Real(-3.7)));
    ASSERT_EQ(scene.blueprints.size(), 14u);
    const auto& plain = scene.prefab("plain")->blueprint;
    EXPECT_EQ(plain.kind, BodyKind::kinematic);
    EXPECT_EQ(plain.particles[0].mass, Real(0.1));
    EXPECT_TRUE(plain.particles[0].pinned);
    EXPECT_EQ(plain.joints[0].restLength, Real(1.5));
    EXPECT_EQ(plain.joints[1].stiffness, sulfur::infinite);
    EXPECT_EQ(plain.filter.mask, 4294967294u);
    EXPECT_EQ(plain.filter.group, -3);
    EXPECT_FALSE(plain.sensor);
    EXPECT_TRUE(scene.prefab("box")->blueprint.sensor);
    EXPECT_TRUE(sulfur::scene::blueprintOf(scene, *scene.body("lift")).sensor);
    EXPECT_EQ(plain.skin->uv[0], sulfur::Vec2(0, 1));
    const auto* lift = scene.body("lift");
    EXPECT_EQ(lift->pose.position, sulfur::Point(3, 4.25));
    EXPECT_EQ(blueprintOf(scene, *lift).kind, BodyKind::dynamic);
    EXPECT_EQ(blueprintOf(scene, *lift).material.restitution, Real(0.5));
    EXPECT_EQ(scene.body("crate")->state->velocities[2].y(), Real(0.125));
    EXPECT_EQ(scene.settings.friction, sulfur::Friction::sliding);
    EXPECT_TRUE(plain.selfCollision);
    EXPECT_TRUE(scene.prefab("rope")->blueprint.selfCollision);
    EXPECT_FALSE(scene.prefab("chain")->blueprint.selfCollision);
    EXPECT_EQ(plain.material.surfaceSpeed, Real(1.5));
    EXPECT_EQ(plain.material.rollingResistance, Real(0.25));
    EXPECT_FALSE(plain.joints[0].material);
    EXPECT_EQ(plain.joints[1].material->surfaceSpeed, Real(-2.5));
    EXPECT_EQ(scene.connections[0].options.material->restitution, Real(0.45));
    ASSERT_EQ(scene.vetoes.size(), 2u);
    EXPECT_EQ(scene.vetoes[1].a, "crate");
    EXPECT_EQ(scene.connections[0].b.particle, 3u);
    EXPECT_EQ(scene.attachments[0].point.x(), Real(0.25));
    ASSERT_EQ(scene.fields.size(), 4u);
    const auto& river = std::get<sulfur::UniformField>(scene.fields[0].field);
    EXPECT_EQ(std::get<sulfur::BoxZone>(river.zone).low, sulfur::Point(-3, -2.5));
    EXPECT_EQ(river.acceleration.y(), 12);
    EXPECT_EQ(river.mask, 6u);
    const auto& radial = std::get<sulfur::RadialField>(scene.fields[1].field);
    EXPECT_EQ(radial.strength, -30);
    EXPECT_EQ(radial.falloff, 1);
    EXPECT_EQ(radial.reach, 8);
    const auto& wind = std::get<sulfur::WindField>(scene.fields[2].field);
    EXPECT_EQ(std::get<sulfur::CircleZone>(wind.zone).radius, Real(4.5));
    EXPECT_EQ(wind.drag, Real(2.5));
    EXPECT_EQ(scene.prefab("jelly")->blueprint.particles.size(), 15u);
    EXPECT_EQ(scene.prefab("jelly")->blueprint.skin->triangles.size(), 16u);
    EXPECT_EQ(scene.prefab("box")->blueprint.skin->triangles.size(), 2u);
}

TEST(Read, GivesSectionsOfOthersWithTheirLines) {
    const Scene scene = parse(fullScene, "full.json");
    const auto level = scene.section("level");
    ASSERT_TRUE(level);
    EXPECT_EQ(level->root().at("spawn").point(10), sulfur::Point(1, 2));
    const auto error = errorOf([&] { level->root().at("exit").at("at").point(5); });
    EXPECT_EQ(error.object(), "door");
    EXPECT_EQ(error.file(), "full.json");
    // The line of the file, counted in the text itself.
    const auto before = fullScene.substr(0, fullScene.find("\"door\""));
    EXPECT_EQ(error.line(), 1 + std::count(before.begin(), before.end(), '\n'));
    EXPECT_FALSE(scene.section("other"));
}

TEST(Read, RefusesWrongHeaders) {
    EXPECT_NE(errorOf("{\"version\": 1}").message().find("\"format\""), std::string::npos);
    EXPECT_NE(errorOf("{\"format\": \"sulfur-scene\"}").message().find("\"version\""),
              std::string::npos);
    const auto version = errorOf("{\"format\": \"sulfur-scene\",\n\"version\": 2}");
    EXPECT_STREQ(version.what(),
                 "test.json:2: version: is 2; allowed is 1, the only version that this program "
                 "reads");
    EXPECT_NE(errorOf("{\"format\": \"sulfur-blueprint\", \"version\": 1}").message(), "");
    EXPECT_NE(errorOf("[]").message(), "");
    EXPECT_NE(errorOf("7").message(), "");
    EXPECT_STREQ(errorOf(around("5")).what(),
                 "test.json:3: object \"blueprints\": thing: is a number; allowed is an object, "
                 "{...}");
    EXPECT_EQ(errorOf("{\"format\": \"sulfur-scene\", \"version\": 1}").message(), "");
}

struct Mistake {
    const char* blueprint;
    const char* says;
};

class BadBlueprint : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadBlueprint, IsRefusedWithLineAndObject) {
    const auto& [blueprint, says] = GetParam();
    const auto error = errorOf(around(blueprint));
    EXPECT_EQ(error.line(), 3) << error.what();
    EXPECT_EQ(error.object(), "thing") << error.what();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.what();
}

const Mistake mistakes[] = {
    {"{}", "needed is one of them"},
    {R"({"shape": "cone"})", "allowed is one of \"floor\""},
    {R"({"particles": []})", "allowed is an array of 1 to 24000"},
    {R"({"particles": [{}]})", "has no \"position\""},
    {R"({"particles": [{"position": [0, 1000.5]}]})", "-1000 to 1000"},
    {R"({"particles": [{"position": [0]}]})", "an array of 2"},
    {R"({"particles": [{"position": ["0", 0]}]})", "is a string"},
    {R"({"particles": [{"position": [0, 0], "mass": 0}]})", "more than 0"},
    {R"({"particles": [{"position": [0, 0], "mass": -1}]})", "more than 0"},
    {R"({"particles": [{"position": [0, 0], "mass": 1e-10}]})", "1e-9"},
    {R"({"particles": [{"position": [0, 0], "mass": 1e10}]})", "at most"},
    {R"({"particles": [{"position": [0, 0], "mass": null}]})", "is null"},
    {R"({"particles": [{"position": [0, 0], "radius": -0.1}]})", "radius"},
    {R"({"particles": [{"position": [0, 0], "pinned": 1}]})", "true or false"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 0, "b": 1, "c": 3}]})",
     "0 to 2"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 0, "b": 1}]})",
     "has no \"c\""},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 0, "b": 1, "c": 0}]})",
     "twice"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 0, "b": 1, "c": 2}]})",
     "corner"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 1, "b": 0, "c": 2, "stiffness": "soft"}]})",
     "angles[0].stiffness"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 1, "b": 0, "c": 2, "strength": 0}]})",
     "angles[0].strength"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 1, "b": 0, "c": 2, "lower": 1, "upper": 0.5}]})",
     "lower is above upper"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [1, 0]}], "angles": [{"a": 1, "b": 0, "c": 2, "restAngle": 3.2}]})",
     "-3.1415928 to 3.1415928"},
    {R"({"particles": [{"position": [0, 0]}], "joints": [{"a": 0, "b": 1}]})", "0 to 0"},
    {R"({"particles": [{"position": [0, 0]}], "joints": [{"a": 0}]})", "has no \"b\""},
    {R"({"particles": [{"position": [0, 0]}], "joints": [{"a": 0, "b": -1}]})", "joints[0].b"},
    {R"({"particles": [{"position": [0, 0]}], "joints": [{"a": 0, "b": 0}]})", "to itself"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [0, 0]}], "joints": [{"a": 0, "b": 0.5}]})",
     "whole number"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [0, 0]}], "joints": [{"a": 0, "b": 1}]})",
     "length 0"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "stiffness": -1}]})",
     "0 to 1e+18"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "stiffness": "stiff"}]})",
     "allowed is \"rigid\""},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "stiffness": true}]})",
     "or \"rigid\""},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "stiffness": 1e40}]})",
     "0 to 1e+18"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "damping": -1}]})",
     "damping"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "restLength": -1}]})",
     "restLength"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "strength": "strong"}]})",
     "\"unbreakable\""},
    {R"({"particles": [{"position": [0, 0]}], "kind": "static"})", "\"kinematic\""},
    {R"({"particles": [{"position": [0, 0]}], "material": {"restitution": 1.1}})", "0 to 1"},
    {R"({"particles": [{"position": [0, 0]}], "material": {"staticFriction": 0.2}})",
     "kineticFriction"},
    {R"({"particles": [{"position": [0, 0]}], "material": {"surfaceSpeed": 1001}})",
     "-1000 to 1000"},
    {R"({"particles": [{"position": [0, 0]}], "material": {"rollingResistance": -1}})",
     "0 to 1000"},
    {R"({"particles": [{"position": [0, 0]}], "selfCollision": 1})", "true or false"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "material": {"kineticFriction": 2}}]})",
     "kineticFriction"},
    {R"({"particles": [{"position": [0, 0]}], "filter": {"mask": -1}})", "4294967295"},
    {R"({"particles": [{"position": [0, 0]}], "filter": {"category": 4294967296}})", "4294967295"},
    {R"({"particles": [{"position": [0, 0]}], "filter": {"group": 2147483648}})", "2147483647"},
    {R"({"particles": [{"position": [0, 0]}], "skin": {"texture": "../x.png", "uv": [[0,0]], "triangles": []}})",
     "relative path"},
    {R"({"particles": [{"position": [0, 0]}], "skin": {"texture": "x.png"}})", "has no \"uv\""},
    {R"({"particles": [{"position": [0, 0]}], "skin": {"texture": "x.png", "uv": [], "triangles": []}})",
     "an array of 1"},
    {R"({"particles": [{"position": [0, 0]}], "skin": {"texture": "x.png", "uv": [[0,0]], "triangles": [[0, 0, 1]]}})",
     "0 to 0"},
    {R"({"shape": "box", "size": [0, 1]})", "more than 0"},
    {R"({"shape": "box", "size": [0.01, 1]})", "radius"},
    {R"({"shape": "box", "mass": 1e-9})", "1e-9"},
    {R"({"shape": "ball", "radius": 0})", "more than 0"},
    {R"({"shape": "rope", "links": 24000})", "0 to 23999"},
    {R"({"shape": "rope", "to": [0, 0]})", "length"},
    {R"({"shape": "rope", "bending": 101})", "0 to 100"},
    {R"({"shape": "rope", "bendingDamping": -1})", "0 to 100"},
    {R"({"shape": "jelly", "columns": 1})", "2 to 1000"},
    {R"({"shape": "jelly", "columns": 1000, "rows": 1000})", "1000000 particles"},
    {R"({"shape": "blob", "segments": 2})", "3 to 1000"},
    {R"({"shape": "polygon", "points": [[0, 0], [1, 0]]})", "3"},
    {R"({"shape": "polygon", "points": [[0, 0], [1, 1], [1, 0], [0, 1]]})", "touch"},
    {R"({"shape": "wheel", "rimRadius": 0.4})", "radius"},
    {R"({"shape": "bridge", "planks": 0})", "1 to 10000"},
    {R"({"shape": "cloth", "columns": 1000, "rows": 1000})", "1000000 particles"},
    {R"({"shape": "wall", "columns": 999, "rows": 999})", "1000000 particles"},
    {R"({"shape": "ground", "points": [[0, 0]]})", "2 to 24000"},
    {R"({"shape": "ground"})", "\"points\""},
    {R"({"shape": "ground", "points": [[0, 0], [1, 0]], "bends": [1, 2]})", "one for each of its 1"},
    {R"({"shape": "ground", "points": [[0, 0], [1, 0]], "bends": [4]})", "-3.14"},
    {R"({"particles": [{"position": [0, 0]}, {"position": [1, 0]}], "joints": [{"a": 0, "b": 1, "bend": 1}]})",
     "rigid joint with a radius"},
};
INSTANTIATE_TEST_SUITE_P(Read, BadBlueprint, ::testing::ValuesIn(mistakes));

class BadField : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadField, IsRefused) {
    const auto& [field, says] = GetParam();
    const auto error =
        errorOf(std::string(R"({"format": "sulfur-scene", "version": 1, "fields": [)") + "\n" +
                field + "]}");
    EXPECT_EQ(error.line(), 2) << error.what();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.what();
}

const Mistake wrongFields[] = {
    {R"({"acceleration": [1, 0]})", "\"type\""},
    {R"({"type": "magnet"})", "\"radial\""},
    {R"({"type": "uniform", "acceleration": [0, 2e6]})", "1e+06"},
    {R"({"type": "uniform", "zone": {}})", "\"low\""},
    {R"({"type": "uniform", "zone": {"low": [0, 0]}})", "\"high\""},
    {R"({"type": "uniform", "zone": {"low": [0, 0], "high": [1, 0]}})", "extent"},
    {R"({"type": "wind", "zone": {"centre": [0, 0]}})", "\"radius\""},
    {R"({"type": "wind", "zone": {"centre": [0, 0], "radius": 0}})", "1e-09 to 2000"},
    {R"({"type": "wind", "drag": 501})", "tickRate"},
    {R"({"type": "radial"})", "\"centre\""},
    {R"({"type": "radial", "centre": [0, 0], "falloff": 5})", "0 to 4"},
    {R"({"type": "radial", "centre": [0, 0], "reach": 0})", "unlimited"},
};
INSTANTIATE_TEST_SUITE_P(Read, BadField, ::testing::ValuesIn(wrongFields));

class BadBody : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadBody, IsRefused) {
    const auto& [body, says] = GetParam();
    const auto error = errorOf(around(R"({"shape": "box"})", std::string(",\n") + body));
    EXPECT_EQ(error.line(), 5) << error.what();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.what();
}

const Mistake badBodies[] = {
    {R"({"blueprint": "thing"})", "has no \"id\""},
    {R"({"id": "two"})", "has no \"blueprint\""},
    {R"({"id": "one", "blueprint": "thing"})", "on line 4"},
    {R"({"id": "", "blueprint": "thing"})", "1 to 100"},
    {R"({"id": 7, "blueprint": "thing"})", "is a number"},
    {R"({"id": "a\nb", "blueprint": "thing"})", "one line"},
    {R"({"id": "two", "blueprint": "none"})", "allowed is a name from"},
    {R"({"id": "two", "blueprint": "thing", "position": [0, 1e4]})", "-1000 to 1000"},
    {R"({"id": "two", "blueprint": "thing", "position": [0, 999.9]})", "world coordinates"},
    {R"({"id": "two", "blueprint": "thing", "angle": 1e7})", "angle"},
    {R"({"id": "two", "blueprint": "thing", "velocity": [2001, 0]})", "-2000 to 2000"},
    {R"({"id": "two", "blueprint": "thing", "velocity": [1, 0], "kind": "fixed"})", "fixed body"},
    {R"({"id": "two", "blueprint": "thing", "state": {"positions": [], "velocities": []}})",
     "an array of 5"},
    {R"({"id": "two", "blueprint": "thing", "state": {"positions": [[0,0],[0,0],[0,0],[0,0],[0,0]], "velocities": [[0,0],[0,0],[0,0],[0,0],[0,0]], "spin": 1}})",
     "those of one"},
};
INSTANTIATE_TEST_SUITE_P(Read, BadBody, ::testing::ValuesIn(badBodies));

TEST(Read, RefusesLooseEnds) {
    const auto with = [](const std::string& tail) {
        const std::string scene =
            around(R"({"shape": "box"})", R"(, {"id": "f", "blueprint": "thing", "kind": "fixed"},
              {"id": "g", "blueprint": "thing", "kind": "fixed", "position": [2, 0]})");
        return errorOf(scene.substr(0, scene.size() - 1) + ",\n" + tail + "}").message();
    };
    const auto says = [&](const std::string& tail, const char* part) {
        EXPECT_NE(with(tail).find(part), std::string::npos) << tail << ": " << with(tail);
    };
    says(R"("connections": [{"a": ["one", 5], "b": ["f", 0]}])", "0 to 4");
    says(R"("connections": [{"a": ["none", 0], "b": ["f", 0]}])", "id of a body");
    says(R"("connections": [{"a": ["one", 0]}])", "has no \"b\"");
    says(R"("connections": [{"a": ["one", 0], "b": ["one", 0]}])", "to itself");
    says(R"("connections": [{"a": ["f", 0], "b": ["g", 0]}])", "cannot move");
    says(R"("connections": [{"a": ["one", 0], "b": ["f", 0]}])", "length 0");
    says(R"("attachments": [{"particle": ["one", 0], "body": "one", "point": [0, 0]}])",
         "another body");
    says(R"("attachments": [{"particle": ["one", 0], "body": "f"}])", "has no \"point\"");
    says(R"("world": {"tickRate": 59})", "60 to 10000");
    says(R"("world": {"tickRate": 100, "airFriction": 101})", "tickRate");
    says(R"("vetoes": [["one", "one"]])", "two different bodies");
    says(R"("vetoes": [["one"]])", "an array of 2");
    says(R"("vetoes": [["one", "none"]])", "id of a body");
    says(R"("world": {"sweeps": 0})", "1 to 100");
    says(R"("world": {"sleepSpeed": -1})", "sleepSpeed");
    says(R"("world": {"friction": "none"})", "\"sliding\"");
    says(R"("world": {"gravity": 9.81})", "an array of 2");
    says(R"("title": 5)", "a string");
}

TEST(Read, RefusesTooMuch) {
    std::string bodies;
    for (int i = 0; i < 25; ++i)
        bodies += ", {\"id\": \"j" + std::to_string(i) + "\", \"blueprint\": \"thing\"}";
    const auto particles = errorOf(around(R"({"shape": "rope", "links": 1000})", bodies));
    EXPECT_NE(particles.message().find("at most 24000"), std::string::npos) << particles.what();
    EXPECT_EQ(particles.object(), "j22");
    const auto joints = errorOf(around(R"({"shape": "jelly", "columns": 30, "rows": 30})", bodies));
    EXPECT_NE(joints.message().find("at most 72000"), std::string::npos) << joints.what();
    const auto megabytes = errorOf(std::string(40'000'000, ' '));
    EXPECT_NE(megabytes.message().find("33554432"), std::string::npos) << megabytes.what();
}

TEST(Read, TruncatedAnywhereIsRefused) {
    const auto end = fullScene.rfind('}');
    for (std::size_t size = 0; size <= end; size += 7) {
        const auto error = errorOf(fullScene.substr(0, size));
        EXPECT_NE(error.message(), "") << size;
        EXPECT_GE(error.line(), 1) << size;
    }
}

TEST(Read, NotesUnknownKeys) {
    const auto notes = unknownKeys(parse(fullScene, "full.json"));
    ASSERT_EQ(notes.size(), 18u);
    EXPECT_EQ(notes[0],
              "full.json:7: object \"world\": unknown key \"wind\"; it is kept but means nothing "
              "here");
}

}  // namespace
