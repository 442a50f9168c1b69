// Motors and limits of hinges and sliders, and gears.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "battery/joints/joints.hpp"
#include "battery/joints/subjects.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

using bench::BodyPlan;
using bench::JointPlan;

/// A wheel on a nail at the origin, with a motor.
struct Flywheel {
    Flywheel(const JointSubject& subject, double speed, double most)
        : world(subject.world(true)), workshop(*world) {
        const auto nail = workshop.addNail({0, 0});
        wheel = workshop.add({.parts = {bench::disc(0.5)}, .group = 1});
        joint = workshop.join({.a = nail, .b = wheel, .motorSpeed = speed, .motorMax = most});
    }
    double inertia() const { return workshop.plan(wheel).inertia(); }

    std::unique_ptr<bench::EngineWorld> world;
    Workshop workshop;
    std::size_t wheel = 0, joint = 0;
};

Rows loadedMotor(const JointSubject& subject) {
    constexpr double speed = 7, load = 3;  // rad/s, N m
    Flywheel strong(subject, speed, 100);
    double slowest = 0, torque = 0;
    const long ticks = subject.ticks(3);
    for (long i = 0; i < ticks; ++i) {
        strong.world->applyTorque(strong.wheel, -load);
        strong.world->step();
        if (2 * i < ticks) continue;
        slowest = worst(slowest, std::abs(strong.world->body(strong.wheel).spin / speed - 1));
        torque = worst(torque, std::abs(strong.world->motorForce(strong.joint) / load - 1));
    }
    constexpr double most = 2;  // N m
    Flywheel weak(subject, speed, most);
    double middle = 0;  // rad/s: velocities of ours are those half a step ago
    for (long i = 0; i < subject.ticks(1); ++i) {
        weak.world->applyTorque(weak.wheel, -load);
        weak.world->step();
        if (i + 1 == subject.ticks(0.5)) middle = weak.world->body(weak.wheel).spin;
    }
    const double expected = (most - load) / weak.inertia();
    const double reached = (weak.world->body(weak.wheel).spin - middle) / 0.5;
    return {subject.row("motor against 3 N m: error of its speed (share)", slowest, 1e-3),
            subject.row("motor against 3 N m: error of its torque (share)", torque, 1e-3),
            subject.row("motor of 2 N m against 3: error of the acceleration (share)",
                        std::abs(reached / expected - 1), 1e-3)};
}

/// A beam that a motor turns about its end with 0.5 rad/s, once around, under gravity.
Rows liftedBeam(const JointSubject& subject) {
    constexpr double speed = 0.5, half = 0.5;
    const auto world = subject.world(false);
    Workshop workshop(*world);
    const auto nail = workshop.addNail({0, 0});
    const auto beam = workshop.add(
        {.parts = {bench::rectangle({half, 0.05})}, .place = {half, 0}, .density = 50, .group = 1});
    const auto joint = workshop.join({.a = nail, .b = beam, .motorSpeed = speed, .motorMax = 1e5});
    const double most = workshop.plan(beam).mass() * bench::gravity * half;
    double slow = 0, torque = 0;
    const long ticks = subject.ticks(2 * std::numbers::pi / speed);
    for (long i = 0; i < ticks; ++i) {
        world->step();
        if (4 * i < subject.ticks(1)) continue;
        slow = worst(slow, std::abs(world->body(beam).spin / speed - 1));
        // The torque is that of where the last step began.
        const double angle = world->body(beam).angle - speed * subject.step();
        torque = worst(torque, std::abs(world->motorForce(joint) - most * std::cos(angle)) / most);
    }
    return {subject.row("beam that a motor lifts: error of its speed (share)", slow, 1e-3),
            subject.row("beam that a motor lifts: error of the torque (share of the largest)",
                        torque, 1e-3)};
}

/// Turns a beam on a hinge against a limit of 1 rad at 10 rad/s, and lets it rest there or fly.
struct Hit {
    double overshoot = 0, later = 0;  // rad; when it comes, and over the next second
};
Hit hitLimit(const JointSubject& subject, double arm, bool nailed) {
    constexpr double speed = 10, limit = 1, pushed = 0.05;  // rad/s, rad, s
    const auto world = subject.world(true);
    Workshop workshop(*world);
    const BodyPlan plan{
        .parts = {bench::rectangle({0.5, 0.1})}, .place = {arm, 0}, .density = 20, .group = 1};
    const auto beam = workshop.add(plan);
    BodyPlan other = plan;
    other.place = {-arm, 0};
    const auto base = nailed ? workshop.addNail({0, 0}) : workshop.add(other);
    const auto joint = workshop.join({.a = base, .b = beam, .lower = -limit, .upper = limit});
    const double inertia = plan.inertia() + (nailed ? plan.mass() * arm * arm : 0);
    // Two free beams turn about their middles as the hinge lets them, against each other.
    const double share = nailed ? 1 : 0.5;
    const double reduced = nailed ? inertia : inertia + plan.mass() * arm * arm;
    Hit hit;
    bool reached = false;
    long since = 0;
    for (long i = 0; since < subject.ticks(1) && i < subject.ticks(3); ++i) {
        if (i < std::max(1L, subject.ticks(pushed))) {
            const double torque = share * speed * reduced * subject.setting.rate /
                                  static_cast<double>(std::max(1L, subject.ticks(pushed)));
            world->applyTorque(beam, torque);
            if (!nailed) world->applyTorque(base, -torque);
        }
        world->step();
        const double beyond = std::abs(workshop.anchors(joint).value(*world)) - limit;
        reached = reached || beyond > -1e-3;
        since += reached ? 1 : 0;
        hit.overshoot = worst(hit.overshoot, beyond);
        if (since > subject.ticks(0.1)) hit.later = worst(hit.later, beyond);
    }
    if (!reached) hit.overshoot = hit.later = unmeasured;
    return hit;
}

Rows rail(const JointSubject& subject) {
    constexpr double slope = std::numbers::pi / 6, end = 3;
    const Point along(std::cos(slope), -std::sin(slope)), across(-along.y(), along.x());
    const auto make = [&](Workshop& workshop, double speed, double most) {
        const auto nail = workshop.addNail({0, 0});
        const auto wagon =
            workshop.add({.parts = {bench::rectangle({0.3, 0.2})}, .density = 20, .group = 1});
        workshop.join({.kind = JointPlan::Kind::slider,
                       .a = nail,
                       .b = wagon,
                       .axis = along,
                       .upper = end,
                       .motorSpeed = speed,
                       .motorMax = most});
        return wagon;
    };
    const auto world = subject.world(false);
    Workshop workshop(*world);
    const auto wagon = make(workshop, 0, 0);
    const double pull = bench::gravity * std::sin(slope);  // m/s^2
    double off = 0, turned = 0, beyond = 0, error = unmeasured;
    for (long i = 1; i <= subject.ticks(3); ++i) {
        world->step();
        const bench::Motion now = world->body(wagon);
        off = worst(off, std::abs(now.place.dot(across)));
        turned = worst(turned, std::abs(now.angle));
        beyond = worst(beyond, now.place.dot(along) - end);
        if (i == subject.ticks(1)) error = std::abs(2 * now.place.dot(along) / pull - 1);
    }
    const auto lift = subject.world(false);
    Workshop lifting(*lift);
    const auto lifted = make(lifting, -0.5, 1e5);
    const double weight = lifting.plan(lifted).mass() * pull;  // N, along the rail
    double slow = 0, force = 0;
    for (long i = 0; i < subject.ticks(2); ++i) {
        lift->step();
        if (2 * i < subject.ticks(1)) continue;
        slow = worst(slow, std::abs(lift->body(lifted).velocity.dot(along) / -0.5 - 1));
        force = worst(force, std::abs(-lift->motorForce(0) / weight - 1));
    }
    return {subject.row("wagon on a rail: error of its way in 1 s (share)", error, 0.01),
            subject.row("wagon on a rail: off its line (m)", off, 1e-6),
            subject.row("wagon on a rail: turned (rad)", turned, 1e-3),
            subject.row("wagon on a rail: beyond its end, met at 5 m/s (m)", beyond, 1e-3),
            subject.row("wagon that a motor lifts: error of its speed (share)", slow, 1e-3),
            subject.row("wagon that a motor lifts: error of the force (share)", force, 1e-3)};
}

/// A bead on a hoop of arcs that stands upright, for ten seconds.
Rows hoop(const Setup& setup, int rate) {
    World world(still({.tickRate = rate, .sweeps = setup.sweeps}, standardGravity));
    constexpr int count = 8;
    constexpr double step = 2 * std::numbers::pi / count, radius = 1, speed = 8;  // m, m/s
    Blueprint ring = ghost("ring"), point = ghost("bead");
    ring.kind = BodyKind::fixed;
    for (int i = 0; i < count; ++i) {
        const Point at(radius * std::sin(i * step), -radius * std::cos(i * step));
        ring.particles.push_back({.position = at.cast<Real>()});
        ring.joints.push_back({.a = static_cast<std::uint32_t>(i),
                               .b = static_cast<std::uint32_t>((i + 1) % count),
                               .radius = real(0.01),
                               .bend = real(step)});
    }
    point.particles.push_back({});
    const Body on = world.add(ring), bead = world.add(point, {.position = Point(0, -radius)});
    world.slider(on, bead, Point(0, -radius), on.joints());
    bead.setVelocity({real(speed), 0});
    world.step();
    const double before = world.energy();
    double off = 0, gain = 0;
    for (int i = 0; i < 10 * rate; ++i) {
        world.step();
        off = worst(off, std::abs(bead.centreOfMass().norm() - radius));
        gain = worst(gain, std::abs(world.energy() - before) / (speed * speed / 2));
    }
    return {atMost(fmt::format("{} Hz: bead on a hoop of arcs: off it (m)", rate), off, 1e-6),
            atMost(fmt::format("{} Hz: bead on a hoop of arcs: change of its energy (share)", rate),
                   gain, 1e-3)};
}

}  // namespace

Rows motors(const Setup& setup) {
    Rows rows;
    for (const JointSubject& subject : jointSubjects(setup)) {
        for (Row& row : loadedMotor(subject)) rows.push_back(std::move(row));
        for (Row& row : liftedBeam(subject)) rows.push_back(std::move(row));
    }
    return rows;
}

Rows limits(const Setup& setup) {
    Rows rows;
    for (const JointSubject& subject : jointSubjects(setup)) {
        const auto add = [&](const std::string& what, const Hit& hit) {
            rows.push_back(subject.row(what + " meets its limit at 10 rad/s: beyond it (rad)",
                                       hit.overshoot, 0.01));
            rows.push_back(subject.row(
                what + " meets its limit at 10 rad/s: beyond it a tenth of a second later (rad)",
                hit.later, 1e-3));
        };
        add("beam on a hinge in its middle", hitLimit(subject, 0, true));
        add("beam on a hinge at its end", hitLimit(subject, 0.5, true));
        add("one of two free beams", hitLimit(subject, 0.5, false));
    }
    return rows;
}

Rows sliders(const Setup& setup) {
    Rows rows;
    for (const JointSubject& subject : jointSubjects(setup))
        for (Row& row : rail(subject)) rows.push_back(std::move(row));
    for (const int rate : jointRates())
        for (Row& row : hoop(setup, rate)) rows.push_back(std::move(row));
    return rows;
}

Rows gears(const Setup& setup) {
    Rows rows;
    const int turns = setup.quick ? 100 : 1000;
    for (const int rate : jointRates()) {
        constexpr double ratio = 2.5;
        World world(still({.tickRate = rate, .sweeps = setup.sweeps}, 0));
        const auto wheel = [&](double x, double radius, const Drive& drive) {
            Blueprint nail = ghost("nail");
            nail.kind = BodyKind::fixed;
            nail.particles.push_back({});
            const Body on = world.add(nail, {.position = Point(x, 0)});
            const Body body =
                world.add(shapes::ball({.radius = real(radius)}), {.position = Point(x, 0)});
            return std::pair(world.hinge(on, body, Point(x, 0), {.drive = drive}), body);
        };
        const auto [motor, first] = wheel(0, 0.4, {.motorSpeed = 40, .motorMax = 500});
        const auto [driven, second] = wheel(5, 1, {});
        world.gear(motor, driven, Real(ratio));
        double error = 0;
        while (world.info(motor).value < turns * 2 * std::numbers::pi) {
            world.applyTorque(second, 2);
            world.step();
            error =
                worst(error, std::abs(world.info(motor).value + ratio * world.info(driven).value));
        }
        rows.push_back(
            atMost(fmt::format("{} Hz: gears of 1 to 2.5 under a load: error in {} turns (rad)",
                               rate, turns),
                   error, 1e-6));
    }
    return rows;
}

}  // namespace sulfur::lab
