// Mechanisms in files: what is read, refused and written, and what a running world says of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;
using sulfur::MechanismInfo;
using sulfur::MechanismKind;
using sulfur::Real;
using sulfur::World;

TEST(MechanismsInFiles, GiveEveryMember) {
    const Scene scene = parse(fullScene, "a");
    ASSERT_EQ(scene.mechanisms.size(), 7u);
    const auto& hinge = std::get<Hinge>(scene.mechanisms[0].spec);
    EXPECT_EQ(scene.mechanisms[0].id, "turn");
    EXPECT_EQ(hinge.a, "lift");
    EXPECT_EQ(hinge.b, "crate");
    EXPECT_EQ(hinge.at, sulfur::Point(8, 2.3));
    EXPECT_TRUE(hinge.options.collide);
    EXPECT_FALSE(hinge.options.pin);
    EXPECT_EQ(hinge.options.strength, 40);
    EXPECT_EQ(hinge.options.value, 0.25);
    const sulfur::Drive& drive = hinge.options.drive;
    EXPECT_EQ(drive.lower, Real(-1.5));
    EXPECT_EQ(drive.upper, Real(2.5));
    EXPECT_EQ(drive.stiffness, 30);
    EXPECT_EQ(drive.damping, 2);
    EXPECT_EQ(drive.rest, Real(0.1));
    EXPECT_EQ(drive.motorSpeed, 3);
    EXPECT_EQ(drive.motorMax, 25);
    EXPECT_EQ(drive.motorTarget, Real(0.5));
    EXPECT_EQ(drive.strength, 90);
    const auto& weld = std::get<Weld>(scene.mechanisms[1].spec);
    EXPECT_EQ(weld.options.stiffness, 500);
    EXPECT_EQ(weld.options.torqueStrength, 70);
    EXPECT_EQ(weld.drive->upper, 1);
    const auto& slider = std::get<Slider>(scene.mechanisms[2].spec);
    EXPECT_EQ(slider.axis, sulfur::Vec2(0, 2));
    EXPECT_FALSE(slider.options.turns);
    EXPECT_EQ(slider.options.drive.motorMax, sulfur::infinite);
    EXPECT_EQ(slider.options.drive.upper, sulfur::infinite);
    const auto& wheel = std::get<Wheel>(scene.mechanisms[3].spec);
    EXPECT_EQ(wheel.options.spring.stiffness, 200);
    EXPECT_EQ(wheel.options.motor.motorSpeed, 5);
    EXPECT_FALSE(std::get<Distance>(scene.mechanisms[4].spec).options.collide);
    const auto& pulley = std::get<Pulley>(scene.mechanisms[5].spec);
    EXPECT_EQ(pulley.frame, "ground");
    EXPECT_EQ(pulley.overB, sulfur::Point(8.5, 9));
    EXPECT_EQ(pulley.options.length, 30);
    EXPECT_EQ(std::get<Gear>(scene.mechanisms[6].spec).ratio, Real(-2.5));
}

TEST(MechanismsInFiles, AreWrittenWithEveryMember) {
    const std::string text = format(parse(fullScene, "a"));
    for (
        const char* line :
        {R"({"type": "hinge", "id": "turn", "a": "lift", "b": "crate", "at": [8, 2.3], "collide": true, "pin": false, "strength": 40, "value": 0.25, "drive": {"lower": -1.5, "upper": 2.5, "stiffness": 30, "damping": 2, "rest": 0.1, "motorSpeed": 3, "motorMax": 25, "motorTarget": 0.5, "strength": 90, "oil": 1}, "paint": "red"})",
         R"({"type": "weld", "id": "bracket", "a": "ground", "b": "lift", "at": [3, 4], "stiffness": 500, "damping": 5, "collide": true, "strength": 800, "torqueStrength": 70, "value": 0.125, "drive": {"upper": 1, "stiffness": 500}})",
         R"({"type": "slider", "id": "rail", "a": "ground", "b": "b", "at": [-3, 6], "axis": [0, 2], "collide": true, "turns": false, "value": -0.5, "drive": {"lower": -4, "motorMax": "unlimited"}})",
         R"({"type": "wheel", "id": "axle", "a": "lift", "b": "crate", "at": [8, 2.3], "axis": [1, 1], "collide": true, "spring": {"stiffness": 200}, "motor": {"motorSpeed": 5, "motorMax": 3}})",
         R"({"type": "distance", "id": "line", "a": "b", "b": "r", "atA": [-3, 6], "atB": [1, 2], "collide": false, "drive": {"upper": 12}})",
         R"({"type": "pulley", "id": "lines", "a": "b", "b": "crate", "frame": "ground", "atA": [-3, 6], "atB": [8.7, 2.6], "overA": [-3, 9], "overB": [8.5, 9], "ratio": 2, "length": 30, "strength": 5000, "drive": {"upper": 31}})",
         R"({"type": "gear", "id": "mesh", "first": "turn", "second": "axle", "ratio": -2.5, "drive": {"stiffness": "rigid", "strength": 60}})"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\nis not in\n" << text;
}

// --- what is refused -------------------------------------------------------------------------

/// A fixed post of one particle, a beam, a bar of two particles, and mechanisms on the next lines.
std::string with(const std::string& mechanisms) {
    return R"({"format": "sulfur-scene", "version": 1, "blueprints": {
        "post": {"kind": "fixed", "particles": [{"position": [0, 0]}]},
        "beam": {"shape": "box", "size": [1, 0.2]},
        "bar": {"particles": [{"position": [0, 0]}, {"position": [1, 0]}],
                "joints": [{"a": 0, "b": 1}]}},
      "bodies": [{"id": "post", "blueprint": "post"}, {"id": "post2", "blueprint": "post"},
                 {"id": "beam", "blueprint": "beam", "position": [0.5, 0]},
                 {"id": "bar", "blueprint": "bar", "position": [3, 0]}], "mechanisms": [)" +
           ("\n" + mechanisms) + "]}";
}

struct Wrong {
    const char* mechanism;
    const char* says;
};

class BadMechanism : public ::testing::TestWithParam<Wrong> {};

TEST_P(BadMechanism, IsRefused) {
    const auto& [mechanism, says] = GetParam();
    const auto error = errorOf(with(mechanism));
    EXPECT_EQ(error.line(), 9) << error.what();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.what();
}

const Wrong wrongMechanisms[] = {
    {R"({"a": "post", "b": "beam", "at": [0, 0]})", "\"type\""},
    {R"({"type": "magnet"})", "\"gear\""},
    {R"({"type": "hinge", "b": "beam", "at": [0, 0]})", "has no \"a\""},
    {R"({"type": "hinge", "a": "post", "b": "beam"})", "has no \"at\""},
    {R"({"type": "hinge", "a": "post", "b": "none", "at": [0, 0]})", "id of a body"},
    {R"({"type": "hinge", "a": "beam", "b": "beam", "at": [0, 0]})", "allowed are two bodies"},
    {R"({"type": "hinge", "a": "post", "b": "post2", "at": [0, 0]})", "cannot move"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 1001]})", "-1000 to 1000"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "strength": 0})", "more than 0"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "strength": "strong"})",
     "\"unbreakable\""},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "value": 1e7})",
     "-1e+06 to 1e+06"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": {"lower": 1, "upper": 0}})",
     "lower is above upper"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": {"upper": 2e6}})",
     "drive.upper"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": {"stiffness": -1}})",
     "0 to 1e+12"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": {"stiffness": "stiff"}})",
     "\"rigid\""},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": {"motorMax": -1}})",
     "motorMax"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": {"strength": 0}})",
     "more than 0"},
    {R"({"type": "hinge", "a": "post", "b": "beam", "at": [0, 0], "drive": []})", "an object"},
    {R"({"type": "hinge", "a": "bar", "b": "beam", "at": [3.5, 1]})", "cannot hold that point"},
    {R"({"type": "weld", "a": "post", "b": "beam", "at": [900, 0]})", "cannot hold that point"},
    {R"({"type": "slider", "a": "post", "b": "beam", "at": [0, 0], "axis": [0, 0]})",
     "any other vector"},
    {R"({"type": "slider", "a": "bar", "b": "beam", "at": [0.5, 0], "rail": []})", "1 to 72000"},
    {R"({"type": "slider", "a": "bar", "b": "beam", "at": [0.5, 0], "rail": [-1]})", "0 to 71999"},
    {R"({"type": "slider", "a": "bar", "b": "beam", "at": [0.5, 0], "rail": [1]})",
     "has 1 joints and no joint 1"},
    {R"({"type": "slider", "a": "bar", "b": "beam", "at": [0.5, 0], "rail": [0]})",
     "beside the rail"},
    {R"({"type": "wheel", "a": "post", "b": "beam", "at": [0, 0], "axis": [0, 0]})",
     "any other vector"},
    {R"({"type": "wheel", "a": "post", "b": "beam", "at": [0, 0], "motor": {"rest": 1e9}})",
     "motor.rest"},
    {R"({"type": "distance", "a": "post", "b": "beam", "atA": [0, 0]})", "has no \"atB\""},
    {R"({"type": "distance", "a": "post", "b": "beam", "atA": [0, 0], "atB": [0, 0], "drive": {"upper": 0}})",
     "more than 0"},
    {R"({"type": "pulley", "a": "bar", "b": "beam", "atA": [3, 0], "atB": [0.5, 0], "overA": [3, 2], "overB": [0, 2]})",
     "has no \"frame\""},
    {R"({"type": "pulley", "a": "bar", "b": "beam", "frame": "x", "atA": [3, 0], "atB": [0.5, 0], "overA": [3, 2], "overB": [0, 2]})",
     "id of a body"},
    {R"({"type": "pulley", "a": "bar", "b": "beam", "frame": "post", "atA": [3, 0], "atB": [0.5, 0], "overA": [3, 2], "overB": [0, 2], "ratio": 0})",
     "1e-06 to 1e+06"},
    {R"({"type": "gear", "first": "x", "second": "y"})", "before this one"},
    {R"({"type": "hinge", "id": "h", "a": "post", "b": "beam", "at": [0, 0]}, {"type": "gear", "first": "h", "second": "h"})",
     "allowed are two mechanisms"},
    {R"({"type": "hinge", "id": "h", "a": "post", "b": "beam", "at": [0, 0]}, {"type": "gear", "id": "h", "first": "h", "second": "h"})",
     "two mechanisms"},
    {R"({"type": "hinge", "id": "h", "a": "post", "b": "beam", "at": [0, 0]}, {"type": "hinge", "id": "h", "a": "post", "b": "bar", "at": [3, 0]})",
     "on line 9"},
    {R"({"type": "hinge", "id": "h", "a": "post", "b": "beam", "at": [0, 0]}, {"type": "hinge", "id": "i", "a": "post", "b": "bar", "at": [3, 0]}, {"type": "gear", "first": "h", "second": "i", "ratio": 0})",
     "too near 0"},
    {R"({"type": "hinge", "id": "h", "a": "post", "b": "beam", "at": [0, 0]}, {"type": "hinge", "id": "i", "a": "post", "b": "bar", "at": [3, 0]}, {"type": "gear", "id": "g", "first": "h", "second": "i"}, {"type": "gear", "first": "h", "second": "g"})",
     "all other mechanisms"},
};
INSTANTIATE_TEST_SUITE_P(MechanismsInFiles, BadMechanism, ::testing::ValuesIn(wrongMechanisms));

TEST(MechanismsInFiles, AreLimitedInNumber) {
    std::string many;
    for (std::size_t i = 0; i <= Limits::mechanisms; ++i) many += i == 0 ? "0" : ",0";
    EXPECT_NE(errorOf(with(many)).message().find("0 to 24000"), std::string::npos)
        << errorOf(with(many)).what();
}

/// Each looks for the particles that hold its points.
TEST(MechanismsInFiles, AreLimitedByTheParticlesOfTheirBodies) {
    std::string hinges;
    for (int i = 0; i < 300; ++i)
        hinges += std::string(i == 0 ? "" : ",\n") +
                  R"({"type": "hinge", "a": "rope", "b": "post", "at": [0, 0]})";
    const std::string text = R"({"format": "sulfur-scene", "version": 1, "blueprints": {
        "post": {"kind": "fixed", "particles": [{"position": [0, 0]}]},
        "rope": {"shape": "rope", "links": 20000, "to": [900, 0], "bending": 0}},
      "bodies": [{"id": "post", "blueprint": "post"}, {"id": "rope", "blueprint": "rope"}],
      "mechanisms": [)" + hinges +
                             "]}";
    const std::string message = errorOf(text).message();
    EXPECT_NE(message.find("allowed are at most 4000000"), std::string::npos) << message;
}

// --- in worlds -------------------------------------------------------------------------------

/// All kinds between boxes that swing, roll and hang.
struct Works {
    explicit Works(int rate) : world({.tickRate = rate}) {
        using sulfur::shapes::box;
        const auto at = [&](double x, double y) {
            return world.add(box({.size = {1, Real(0.2)}}), {.position = {x, y}}).id();
        };
        const auto post = world.add(sulfur::shapes::floor({-20, -3}, {20, -3})).id();
        const auto door = at(0.5, 0), flap = at(1.5, 0), shelf = at(5.5, 0), cart = at(9.5, 0);
        const auto left = at(15, -1), right = at(17, -1), second = at(20.5, 0);
        const auto wheel =
            world.add(sulfur::shapes::ball({.radius = Real(0.3)}), {.position = {9.5, Real(-0.5)}});
        const auto turn = world.hinge(post, door, {0, 0}, {.drive = {.lower = -2, .upper = 1}});
        world.hinge(door, flap, {1, 0},
                    {.drive = {.motorSpeed = 4, .motorMax = 2}, .strength = 1e6});
        world.weld(post, shelf, {5, 0}, {.stiffness = 40, .damping = 2});
        world.slider(post, cart, {9.5, 0}, {1, 1},
                     {.drive = {.stiffness = 200, .damping = 3}, .turns = false});
        world.wheel(cart, wheel, {9.5, Real(-0.5)}, {0, 1},
                    {.spring = {.stiffness = 900, .damping = 4},
                     .motor = {.motorSpeed = 6, .motorMax = 5}});
        world.pulley(left, {15, -1}, {15, 3}, right, {17, -1}, {17, 3}, post, {.ratio = 2});
        world.distance(post, {17, 0}, left, {15, -1}, {.drive = {.upper = 4}});
        const auto other = world.hinge(post, second, {20, 0});
        world.gear(turn, other, Real(1.5));
    }
    World world;
};

TEST(MechanismsInFiles, GoOnFromWhereTheyWere) {
    for (const int rate : {60, 500}) {
        Works works(rate);
        World& world = works.world;
        for (int i = 0; i < rate; ++i) world.step();
        const Scene captured = parse(format(capture(world)), "saved");
        // The scene has no bodies that are pins, and two mechanisms for a wheel.
        EXPECT_EQ(captured.bodies.size(), 9u);
        EXPECT_TRUE(captured.attachments.empty());
        EXPECT_TRUE(captured.vetoes.empty());
        ASSERT_EQ(captured.mechanisms.size(), 10u);
        World again(captured.settings);
        const Instance instance = instantiate(captured, again);
        ASSERT_EQ(again.mechanisms().size(), world.mechanisms().size());
        EXPECT_EQ(again.bodies().size(), world.bodies().size());
        EXPECT_EQ(again.vetoes().size(), world.vetoes().size());
        for (const int seconds : {0, 1}) {
            for (int i = 0; i < seconds * rate; ++i) {
                world.step();
                again.step();
            }
            for (std::size_t i = 0; i < instance.mechanisms.size(); ++i) {
                const MechanismInfo a = world.info(world.mechanisms()[i]);
                const MechanismInfo b = again.info(instance.mechanisms[i].id);
                EXPECT_EQ(a.kind, b.kind);
                EXPECT_NEAR(a.value, b.value, seconds == 0 ? 1e-6 : 0.02) << i << " at " << rate;
                EXPECT_NEAR((a.pointB - b.pointB).norm(), 0, seconds == 0 ? 1e-6 : 0.02) << i;
            }
        }
        EXPECT_EQ(again.validate(), "");
    }
}

TEST(MechanismsInFiles, KeepTheRailOfASliderAndWhereItIs) {
    const Scene scene = parse(R"({"format": "sulfur-scene", "version": 1, "blueprints": {
        "bowl": {"kind": "fixed",
                 "particles": [{"position": [-1, 0]}, {"position": [0, -1]}, {"position": [1, 0]},
                               {"position": [1, 1]}],
                 "joints": [{"a": 2, "b": 3, "radius": 0.1},
                            {"a": 0, "b": 1, "radius": 0.1, "bend": 1.5707963},
                            {"a": 1, "b": 2, "radius": 0.1, "bend": 1.5707963}]},
        "bead": {"particles": [{"position": [0, 0]}]}},
      "bodies": [{"id": "bowl", "blueprint": "bowl"},
                 {"id": "bead", "blueprint": "bead", "position": [-0.70710678, -0.70710678]}],
      "mechanisms": [{"type": "slider", "a": "bowl", "b": "bead", "at": [-0.70710678, -0.70710678],
                      "rail": [1, 2, 0], "value": 10, "drive": {"motorSpeed": 1, "motorMax": 50}}]})",
                              "a");
    EXPECT_EQ(std::get<Slider>(scene.mechanisms[0].spec).rail,
              (std::vector<std::uint32_t>{1, 2, 0}));
    World world(scene.settings);
    const Instance instance = instantiate(scene, world);
    const auto slider = instance.mechanisms[0].id;
    const auto quarter = std::acos(-1.0) / 4;
    EXPECT_NEAR(world.info(slider).value, 10 + quarter, 1e-6);
    for (int i = 0; i < 600; ++i) world.step();
    world.remove(world.joints(instance.body("bowl"))[0]);
    const Scene captured = parse(format(capture(world, scene, instance)), "saved");
    ASSERT_EQ(captured.mechanisms.size(), 1u);
    EXPECT_EQ(std::get<Slider>(captured.mechanisms[0].spec).rail,
              (std::vector<std::uint32_t>{0, 1}));
    World again(captured.settings);
    const Instance other = instantiate(captured, again);
    EXPECT_NEAR(again.info(other.mechanisms[0].id).value, world.info(slider).value, 1e-6);
    EXPECT_NEAR(again.info(other.mechanisms[0].id).value, 10 + quarter + 1.2, 0.02);
}

TEST(MechanismsInFiles, KeepIdsAndUnknownMembersAndAWheelThatIsAsItWasMade) {
    const Scene scene = parse(fullScene, "a");
    World world(scene.settings);
    const Instance instance = instantiate(scene, world);
    ASSERT_EQ(instance.mechanisms.size(), 7u);
    EXPECT_TRUE(instance.mechanisms[3].spring);
    const Scene fresh = capture(world, scene, instance);
    ASSERT_EQ(fresh.mechanisms.size(), 7u);
    EXPECT_TRUE(std::holds_alternative<Wheel>(fresh.mechanisms[3].spec));
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_EQ(fresh.mechanisms[i].id, scene.mechanisms[i].id) << i;
    EXPECT_EQ(findExtra(fresh.mechanisms[0].extra.at(""), "paint")->json, "\"red\"");
    EXPECT_EQ(findExtra(fresh.mechanisms[0].extra.at("drive"), "oil")->json, "1");
    const auto& gear = std::get<Gear>(fresh.mechanisms[6].spec);
    EXPECT_EQ(gear.first, "turn");
    EXPECT_EQ(gear.second, "axle");
    EXPECT_EQ(gear.drive->strength, 60);
    EXPECT_EQ(std::get<Pulley>(fresh.mechanisms[5].spec).drive, std::nullopt);
    EXPECT_EQ(std::get<Pulley>(fresh.mechanisms[5].spec).options.length, 31);
    EXPECT_EQ(std::get<Weld>(fresh.mechanisms[1].spec).drive->upper, 1);
    world.setDrive(instance.mechanisms[3].spring, {.stiffness = 5});
    const Scene changed = parse(format(capture(world, scene, instance)), "saved");
    ASSERT_EQ(changed.mechanisms.size(), 8u);
    EXPECT_EQ(std::get<Slider>(changed.mechanisms[3].spec).options.drive.stiffness, 5);
    EXPECT_EQ(changed.mechanisms[4].id, "axle");
    EXPECT_FALSE(std::get<Hinge>(changed.mechanisms[4].spec).options.pin);
}

TEST(MechanismsInFiles, GiveTheAxisOfAWheelWhoseCartHasTurnedAboutIt) {
    const Scene scene = parse(R"({"format": "sulfur-scene", "version": 1,
      "blueprints": {"beam": {"shape": "box", "size": [1, 0.2]}},
      "bodies": [{"id": "cart", "blueprint": "beam"}, {"id": "wheel", "blueprint": "beam"}],
      "mechanisms": [{"type": "wheel", "a": "cart", "b": "wheel", "at": [0, 0], "axis": [0, 1]}]})",
                              "a");
    World world(scene.settings);
    const Instance instance = instantiate(scene, world);
    EXPECT_EQ(capture(world, scene, instance).mechanisms.size(), 1u);
    for (const char* id : {"cart", "wheel"}) world.setPose(instance.body(id), {.angle = 0.5});
    const Scene turned = capture(world, scene, instance);
    ASSERT_EQ(turned.mechanisms.size(), 2u) << "a slider and a hinge";
    const auto& slider = std::get<Slider>(turned.mechanisms[0].spec);
    EXPECT_NEAR(static_cast<double>(slider.axis.x()), -std::sin(0.5), 1e-5);
}

TEST(MechanismsInFiles, KeepParticlesOfSoftBodiesWhereverTheyAre) {
    World world;
    const auto post = world.add({.kind = sulfur::BodyKind::fixed, .particles = {{}}}).id();
    const auto jelly = world.add(sulfur::shapes::jelly({.stiffness = 200}), {}).id();
    const auto corner = world.particles(jelly).front();
    const auto start = world.position(corner);
    world.hinge(post, jelly, start);
    for (int i = 0; i < 300; ++i) world.step();
    const Scene captured = parse(format(capture(world)), "saved");
    World again(captured.settings);
    const Instance instance = instantiate(captured, again);
    for (int i = 0; i < 300; ++i) again.step();
    const auto now = again.particles(instance.body(captured.bodies[1].id)).front();
    EXPECT_NEAR((again.position(now) - start).norm(), 0, 1e-3);
}

TEST(MechanismsInFiles, AreLeftOutWithWhatTheyHoldOnTo) {
    World world;
    const auto box = [&](double x) {
        return world.add(sulfur::shapes::box(), {.position = {x, 0}}).id();
    };
    const auto a = box(0), b = box(2), c = box(4);
    const auto hinge = world.hinge(a, b, {1, 1});
    const auto pin = world.info(hinge).own[0];
    ASSERT_TRUE(pin);
    // Whoever holds on to the pin holds on to what no scene has.
    world.connect(world.particles(pin).front(), world.particles(c).front(), {.stiffness = 1});
    world.setCollision(pin, c, false);
    world.distance(pin, {1, 1}, c, {4, 0});
    const Scene captured = parse(format(capture(world)), "saved");
    EXPECT_EQ(captured.bodies.size(), 3u);
    EXPECT_TRUE(captured.connections.empty());
    EXPECT_TRUE(captured.vetoes.empty());
    EXPECT_EQ(captured.mechanisms.size(), 1u);
}

TEST(MechanismsInFiles, GoWithTheirBodies) {
    Scene scene = parse(fullScene, "a");
    EXPECT_EQ(pointsOf(scene.mechanisms[0], "lift").size(), 0u);
    EXPECT_EQ(pointsOf(scene.mechanisms[0], "crate").size(), 1u);
    EXPECT_EQ(pointsOf(scene.mechanisms[5], "ground").size(), 2u);
    removeMechanisms(scene.mechanisms, [](const std::string& id) { return id == "lift"; });
    ASSERT_EQ(scene.mechanisms.size(), 3u);
    EXPECT_EQ(scene.mechanisms[0].id, "rail");
    EXPECT_EQ(scene.mechanisms[2].id, "lines");
}

}  // namespace
