#include "helpers.hpp"

namespace sulfur {
namespace {

/// Writes down what it is shown.
struct Recorder final : DebugDraw {
    std::vector<Body> bodies;
    std::vector<Particle> particles;
    std::vector<Disc> discs;
    std::vector<Joint> joints;
    std::vector<Capsule> capsules;
    std::vector<ContactInfo> contacts;
    std::vector<Attachment> attachments;
    std::vector<Point> supports;
    std::vector<FieldId> fields;
    std::vector<Grab> grabs;
    std::vector<Mechanism> mechanisms;
    std::vector<std::vector<Point>> places;  // of mechanisms

    void body(const Body& b) override { bodies.push_back(b); }
    void particle(const Particle& p) override { particles.push_back(p); }
    void disc(const Disc& d) override { discs.push_back(d); }
    void joint(const Joint& j) override { joints.push_back(j); }
    void capsule(const Capsule& c) override { capsules.push_back(c); }
    void contact(const ContactInfo& c) override { contacts.push_back(c); }
    void attachment(const Attachment& a) override {
        attachments.push_back(a);
        supports.assign(a.supports.begin(), a.supports.end());
    }
    void field(const FieldShape& f) override {
        fields.push_back(f.id);
        EXPECT_TRUE(std::holds_alternative<WindField>(*f.field));
    }
    void grab(const Grab& g) override { grabs.push_back(g); }
    void mechanism(const Mechanism& m) override {
        mechanisms.push_back(m);
        places.emplace_back(m.places.begin(), m.places.end());
    }

    std::size_t count() const {
        return bodies.size() + particles.size() + discs.size() + joints.size() + capsules.size() +
               contacts.size() + attachments.size() + fields.size() + grabs.size() +
               mechanisms.size();
    }
};

struct Drawn : testing::Test {
    World world;
    Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    Body box = world.add(shapes::box(), {.position = {0, 0.56}});
    Body ball = world.add(shapes::ball({.radius = Real(0.3)}), {.position = {2, 0.35}});
    Body rope = world.add(shapes::rope({.from = {0, 4}, .to = {0, Real(0.86)}, .links = 4}));
    Body pebble = world.add(shapes::ball({.radius = Real(0.2)}), {.position = {-4, 0.25}});
    JointId tie = world.connect(rope.front(), ball[0], {.radius = Real(0.01)});
    AttachmentId hook = world.attach(rope.back(), box, {0, Real(0.3)});
    FieldId wind = world.add(WindField{});
    GrabId held = world.grab(box[0], {0, 1});
    Drawn() { test::run(world, 0.4); }
};

TEST_F(Drawn, EverythingIsShownWhereItIs) {
    Recorder seen;
    world.draw(seen);
    ASSERT_EQ(seen.bodies.size(), 5u);
    EXPECT_EQ(seen.bodies[0].kind, BodyKind::fixed);
    EXPECT_EQ(seen.bodies[1].id, box.id());
    EXPECT_NEAR((seen.bodies[1].centreOfMass - world.centreOfMass(box)).norm(), 0, 1e-9);
    Point low(9, 9), high(-9, -9);
    for (const auto p : box.particles()) {
        low = low.cwiseMin(world.position(p));
        high = high.cwiseMax(world.position(p));
    }
    EXPECT_EQ(seen.bodies[1].low, low);
    EXPECT_EQ(seen.bodies[1].high, high);

    ASSERT_EQ(seen.particles.size(), 2 + 5 + 1 + 5 + 1u);
    for (const auto& p : seen.particles) {
        EXPECT_EQ(p.place, world.position(p.id));
        EXPECT_EQ(p.velocity, world.velocity(p.id));
        EXPECT_EQ(p.body, world.info(p.id).body);
    }
    ASSERT_EQ(seen.discs.size(), 2u);
    EXPECT_EQ(seen.discs[0].radius, Real(0.3));

    ASSERT_EQ(seen.joints.size(), 1 + 10 + 4 + 1u);
    for (const auto& j : seen.joints) {
        EXPECT_EQ(j.a, world.position(world.info(j.id).a));
        EXPECT_EQ(j.b, world.position(world.info(j.id).b));
        EXPECT_EQ(j.force, world.info(j.id).force);
    }
    EXPECT_EQ(seen.joints.back().id, tie);
    EXPECT_FALSE(seen.joints.back().body);
    EXPECT_EQ(seen.capsules.size(), 1 + 4 + 4 + 1u);
    EXPECT_EQ(seen.contacts.size(), world.contacts().size());
    EXPECT_FALSE(seen.contacts.empty());

    ASSERT_EQ(seen.attachments.size(), 1u);
    EXPECT_EQ(seen.attachments[0].id, hook);
    EXPECT_EQ(seen.attachments[0].particle, world.position(rope.back()));
    EXPECT_NEAR((seen.attachments[0].point - seen.attachments[0].particle).norm(), 0, 0.01);
    EXPECT_EQ(seen.supports.size(), world.info(hook).count);
    EXPECT_EQ(seen.fields, std::vector{wind});
    ASSERT_EQ(seen.grabs.size(), 1u);
    EXPECT_EQ(seen.grabs[0].id, held);
    EXPECT_EQ(seen.grabs[0].info.target, Point(0, 1));
}

TEST_F(Drawn, OptionsLeaveThingsOut) {
    Recorder none;
    world.draw(none, {.bodies = false,
                      .particles = false,
                      .discs = false,
                      .joints = false,
                      .capsules = false,
                      .contacts = false,
                      .attachments = false,
                      .fields = false,
                      .grabs = false});
    EXPECT_EQ(none.count(), 0u);
    Recorder discs;
    world.draw(discs, {.bodies = false,
                       .particles = false,
                       .joints = false,
                       .capsules = false,
                       .contacts = false,
                       .attachments = false,
                       .fields = false,
                       .grabs = false});
    EXPECT_EQ(discs.count(), 2u);
}

TEST_F(Drawn, OnlyWhatIsInViewIsShown) {
    Recorder seen;
    world.draw(seen, {.fields = false, .grabs = false, .view = BoxZone{{4, -1}, {6, 1}}});
    ASSERT_EQ(seen.bodies.size(), 1u);
    EXPECT_EQ(seen.bodies[0].id, floor.id());
    EXPECT_EQ(seen.count(), 1 + 2 + 1 + 1u);  // with its particles, its joint and its capsule
}

TEST_F(Drawn, PlacesAreInterpolated) {
    Recorder seen;
    world.draw(seen, {.alpha = 0.25});
    for (const auto& p : seen.particles) EXPECT_EQ(p.place, world.interpolated(p.id, 0.25));
    test::expectRefused(world, ErrorCode::outOfRange, [&] { world.draw(seen, {.alpha = 2}); });
    test::expectRefused(world, ErrorCode::notFinite,
                        [&] { world.draw(seen, {.alpha = std::nan("")}); });
}

struct DrawnMechanisms : testing::Test {
    World world{{.gravity = {0, 0}}};
    Body frame = world.add(shapes::floor({-5, 5}, {5, 5}));
    Body a = world.add(shapes::box()), b = world.add(shapes::box(), {.position = {2, 0}});
    MechanismId hinge = world.hinge(frame, a, {0, 0});
    MechanismId slider =
        world.slider(frame, b, {2, 0}, {0, 2}, {.drive = {.motorSpeed = 1, .motorMax = infinite}});
    MechanismId loose = world.hinge(a, b, {1, 0}, {.collide = true, .pin = false});
    MechanismId distance = world.distance(a, {0, 0}, b, {2, 0});
    MechanismId pulley = world.pulley(a, {0, 0}, {0, 5}, b, {2, 0}, {2, 5}, frame, {.length = 99});
    Recorder seen;

    void expectPlaces(std::size_t which, MechanismId id, const std::vector<Point>& places) {
        EXPECT_EQ(seen.mechanisms[which].id, id);
        EXPECT_EQ(seen.mechanisms[which].info.kind, world.info(id).kind);
        ASSERT_EQ(seen.places[which].size(), places.size()) << which;
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_LT((seen.places[which][i] - places[i]).norm(), 1e-4) << which << ' ' << i;
    }
};

TEST_F(DrawnMechanisms, ShowWhatTheyRunThrough) {
    test::run(world, 0.1);
    const MechanismId gear = world.gear(slider, distance, 1);
    const MechanismId weld = world.weld(frame, b, {2, 0.1}, {.stiffness = 0});
    world.draw(seen);
    ASSERT_EQ(seen.mechanisms.size(), 7u);
    const double up = world.info(slider).value;
    EXPECT_NEAR(up, 0.1, 0.01);
    expectPlaces(0, hinge, {{0, 0}});
    expectPlaces(1, slider, {{2, 0}, {2, up}});
    EXPECT_EQ(seen.places[2].size(), 2u);
    expectPlaces(3, distance, {{0, 0}, {2, up}});
    expectPlaces(4, pulley, {{0, 0}, {0, 5}, {2, 5}, {2, up}});
    expectPlaces(5, gear, {{2, 0}, {0, 0}});
    expectPlaces(6, weld, {{2, 0.1}});
}

TEST_F(DrawnMechanisms, AreLeftOutWithTheirOptionAndOutOfView) {
    world.draw(seen, {.mechanisms = false});
    EXPECT_TRUE(seen.mechanisms.empty());
    world.draw(seen, {.view = CircleZone{{0, 5}, 1}});
    ASSERT_EQ(seen.mechanisms.size(), 1u);
    EXPECT_EQ(seen.mechanisms[0].id, pulley);
}

TEST(DrawnRails, ShowTheirLineAndWhatSlides) {
    World world({.gravity = {0, 0}});
    Blueprint plan{.kind = BodyKind::fixed,
                   .particles = {{.position = {0, 0}}, {.position = {2, 0}}, {.position = {2, 3}}},
                   .joints = {{.a = 1, .b = 0, .radius = Real(0.1), .bend = 3}, {.a = 2, .b = 1}}};
    const Body rail = world.add(plan);
    const Body bead = world.add({.particles = {{}}}, {.position = {2, 1}});
    const MechanismId slider = world.slider(rail, bead, {2, 1}, rail.joints());
    Recorder seen;
    world.draw(seen);
    ASSERT_EQ(seen.mechanisms.size(), 1u);
    EXPECT_EQ(seen.mechanisms[0].id, slider);
    const auto& places = seen.places[0];
    ASSERT_GT(places.size(), 5u);
    EXPECT_EQ(places[0], Point(0, 0));
    const std::size_t end = places.size() - 1;
    EXPECT_EQ(places[end - 2], Point(2, 0));
    EXPECT_EQ(places[end - 1], Point(2, 3));
    EXPECT_EQ(places[end], Point(2, 1));
    double highest = 0;
    for (std::size_t i = 1; i < end - 1; ++i) {
        EXPECT_LT((places[i] - places[i - 1]).norm(), 1) << i;
        highest = std::max(highest, std::abs(places[i].y()));
    }
    EXPECT_NEAR(highest, std::tan(0.75), 0.01) << "nearly half a circle";
}

TEST_F(Drawn, DrawingChangesNothing) {
    const auto before = world.hash();
    DebugDraw nothing;
    world.draw(nothing);
    EXPECT_EQ(world.hash(), before);
}

}  // namespace
}  // namespace sulfur
