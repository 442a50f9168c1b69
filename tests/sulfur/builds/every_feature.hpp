// A scene that uses most features of the library: builds are compared by it, and memory fails in
// it.
#pragma once

#include <sulfur/sulfur.hpp>
#include <vector>

namespace sulfur::test {

/// The bodies, and what somebody does to them.
class EveryFeature {
public:
    /// How long something is done to them.
    static constexpr int ticks = 240;

    explicit EveryFeature(Friction friction)
        : world_({.airFriction = Real(0.1), .friction = friction, .tellPersisting = true}) {
        addGround();
        addHeap();
        addDrivers();
        addTied();
    }

    World& world() { return world_; }

    void tick(int t) {
        drive(t);
        interfere(t);
        world_.step();
    }

private:
    void addGround() {
        world_.add(shapes::ground({.points = {{-9, 9}, {-9, 0}, {0, -1}, {9, 0}, {9, 9}}}));
        Blueprint belt = shapes::floor({-8, Real(0.5)}, {-5, Real(0.5)});
        belt.material.surfaceSpeed = 2;
        world_.add(belt);
    }

    void addHeap() {
        const Blueprint plans[] = {
            shapes::box({.strength = 3000}),
            shapes::ball({.material = {.restitution = Real(0.8)}}),
            shapes::wheel({.spokeStiffness = Real(3e5), .spokeDamping = 5}),
            shapes::jelly({.damping = 3}),
            shapes::jelly({.stiffness = Real(1e6)}),
            shapes::blob(),
            shapes::polygon({.points = {{0, 0}, {1, 0}, {1, 1}, {Real(0.5), Real(0.4)}, {0, 1}}}),
            shapes::wheel()};
        for (int i = 0; i < 24; ++i)
            heap_.push_back(
                world_.add(plans[i % 8], {{-7.0 + 2 * (i % 8), 1.5 + 1.6 * (i / 8)}, 0.37 * i}));
        world_.add(shapes::wall({.strength = 400}), {.position = {0, 1}});
        world_.setVelocity(heap_[9], {6, -8});
    }

    void addDrivers() {
        Blueprint rod = shapes::box({.size = {4, Real(0.2)}});
        rod.kind = BodyKind::kinematic;
        rod_ = world_.add(rod, {.position = {4, 2}});
        Blueprint lift = shapes::box({.size = {2, Real(0.2)}});
        lift.kind = BodyKind::kinematic;
        lift_ = world_.add(lift, {.position = {-4, Real(0.2)}});
        Blueprint eye = shapes::box({.size = {3, 3}});
        eye.kind = BodyKind::fixed;
        eye.sensor = true;
        world_.add(eye, {.position = {0, 3}});
        world_.add(UniformField{.zone = BoxZone{{-9, 4}, {-3, 9}}, .acceleration = {3, 2}});
        wind_ = world_.add(WindField{.zone = CircleZone{{3, 5}, 3}, .velocity = {-8, 1}});
        world_.add(RadialField{.centre = {0, 6}, .strength = 5, .falloff = 1});
    }

    void addTied() {
        rope_ = world_.add(shapes::rope({.from = {-8, 8}, .to = {8, 8}, .pinFirst = true}));
        world_.connect(rope_.back(), heap_[23].front(), {.stiffness = Real(2e4), .damping = 10});
        world_.add(shapes::rope({.from = {-8, 9},
                                 .to = {-3, 9},
                                 .stiffness = Real(1e4),
                                 .pinFirst = true,
                                 .pinLast = true}));
        chain_ = world_.add(shapes::chain({.from = {2, 9}, .to = {5, 9}, .pinFirst = true}));
        world_.attach(chain_.back(), heap_[20], {Real(0.2), Real(0.2)});
        world_.add(shapes::bridge({.from = {-8, 6}, .to = {-4, 6}}));
        const Body thread = world_.add(shapes::rope({.from = {7, 9}, .to = {7, 7}}));
        world_.attach(thread.front(), rope_.joints()[200], Real(0.3));
        world_.setSelfCollision(thread, true);
        world_.connect(heap_[0].front(), heap_[1].front(), {.radius = Real(0.02)});
        world_.add(shapes::cloth({.columns = 8, .rows = 6}), {.position = {-14, 4}});
        grab_ = world_.grab(heap_[3].front(), {-2, 6});
    }

    /// What moves all the time.
    void drive(int t) {
        const double time = 0.002 * t;
        world_.moveTo(rod_, {.position = {4, 2}, .angle = 5 * time});
        if (t % 3 != 0) world_.moveTo(lift_, {.position = {-4 + time, 0.2 + 0.7 * time}});
        world_.setTarget(grab_, {-2 + 4 * time, 6});
        world_.applyForce(heap_[5].front(), {3, 1});
    }

    /// What happens once.
    void interfere(int t) {
        const Body crate = heap_[8], jelly = heap_[11];
        if (t == 20) world_.setStiffness(jelly.joints()[3], Real(5e5));
        if (t == 30) world_.setVelocity(crate, {3, 4});
        if (t == 40) world_.setPinned(jelly.front(), true);
        if (t == 50) world_.setTickRate(120);
        if (t == 60) world_.applyImpulse(heap_[13].front(), {1, 2});
        if (t == 70) world_.setCollision(crate, heap_[16], false);
        if (t == 80)
            world_.setPosition(heap_[10].front(),
                               world_.position(heap_[10].front()) + Point(0.3, 0.1));
        if (t == 90) world_.setTickRate(1000);
        if (t == 100) world_.remove(heap_[17]);
        if (t == 110) world_.setPinned(jelly.front(), false);
        if (t == 120) world_.set(wind_, WindField{.velocity = {4, 0}, .drag = 2});
        if (t == 130) world_.setDamper(Damper::full);
        if (t == 140) world_.setMass(heap_[13].front(), 3);
        if (t == 150) world_.setGravity({2, -8});
        if (t == 160) world_.setPinned(rope_.back(), true);
        if (t == 170) world_.setTickRate(500);
        if (t == 180) world_.setMaterial(heap_[14], {.kineticFriction = Real(0.05)});
        if (t == 190) world_.restore(world_.snapshot());
        if (t == 200) heap_.push_back(world_.add(shapes::box(), {{1, 7}, 0.3}));
        if (t == 210) world_.setFilter(heap_[15], {.category = 2, .mask = 1});
        if (t == 212) world_.setMaterial(crate.joints()[0], Material{.restitution = 1});
        if (t == 214) world_.setRestLength(jelly.joints()[4], Real(0.3));
        if (t == 216) world_.setStrength(jelly.joints()[5], 1);
        if (t == 218) world_.setAirFriction(1);
        if (t == 220) world_.setSensor(heap_[12], true);
    }

    World world_;
    std::vector<Body> heap_;
    Body rod_, lift_, rope_, chain_;
    FieldId wind_;
    GrabId grab_;
};

}  // namespace sulfur::test
