// Scenes of S9 that lift: scissors with a car on them, and gears with a chain and a gate.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/mechanisms.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

using std::numbers::pi;

/// Three pairs of crossed links that an actuator spreads, with a platform and a car above. All left
/// pins stay above each other; the actuator goes from the lowest one to a point of the second
/// pair, and is sqrt(9 + 40 s^2) m long where s is the sine of the links' angle. The platform's
/// pins are 15 s m above.
class Scissors final : public Contraption {
protected:
    void build(Workshop& workshop) override {
        using enum JointPlan::Kind;
        workshop.add(road({{-20, 0}, {20, 0}}, 0.6));
        const double c = std::cos(start), s = std::sin(start);
        // What the next pair stands on: at its left pin and at its right one.
        const std::size_t nail = workshop.addNail(foot);
        std::size_t left = nail, pushed = 0;
        std::size_t right = workshop.addNail(foot + Point(2 * half * c, 0));
        for (int i = 0; i < 3; ++i) {
            const Point middle = foot + Point(half * c, half * s * (2 * i + 1));
            std::size_t links[2];
            for (const int k : {0, 1})
                links[k] = workshop.add({.parts = {capsule(Point(-half, 0), Point(half, 0), 0.15)},
                                         .place = middle,
                                         .angle = k == 0 ? start : -start,
                                         .group = 1});
            const Point low = middle - half * Point(c, s);
            const Point across = low + Point(2 * half * c, 0);
            joinStiffly(workshop, {.a = left, .b = links[0], .at = low});
            joinStiffly(workshop,
                        {.kind = i == 0 ? wheel : hinge, .a = right, .b = links[1], .at = across});
            joinStiffly(workshop, {.a = links[0], .b = links[1], .at = middle});
            left = links[1];
            right = links[0];
            if (i == 1) pushed = links[1];
        }
        const Point top = foot + Point(0, 6 * half * s);
        platform_ = workshop.add({.parts = {rectangle(Point(3, 0.2))},
                                  .place = top + Point(half, 0.4),
                                  .friction = 0.6,
                                  .group = 1});
        joinStiffly(workshop, {.a = platform_, .b = left, .at = top});
        joinStiffly(
            workshop,
            {.kind = wheel, .a = platform_, .b = right, .at = top + Point(2 * half * c, 0)});
        actuator_ = workshop.join({.kind = distance,
                                   .a = nail,
                                   .b = pushed,
                                   .at = foot,
                                   .atB = foot + Point(3 * c, 7 * s),
                                   .lower = 0.2,
                                   .upper = longest,
                                   .motorSpeed = speed,
                                   .motorMax = 2000});
        car_ = addCar(workshop, top + Point(half, 0.6), 2, 3, 5, 0);
    }

    void note(const EngineWorld& world, double time) override {
        const double wanted = std::min(longest, lengthAt(std::sin(start)) + speed * time);
        const double length = workshop().anchors(actuator_).gap(world).norm();
        short_ = worse(short_, wanted - length);
        const double sine = std::sqrt((length * length - 9) / 40);
        const double height = foot.y() + 6 * half * sine + 0.4;
        error_ = worse(error_, std::abs(world.body(platform_).place.y() - height));
    }

    Figures more(const EngineWorld& world) override {
        const Point car = world.body(car_.chassis).place;
        const Point platform = world.body(platform_).place;
        return {{"height error", "mm", error_ * millimetres},
                {"actuator short", "mm", short_ * millimetres},
                {"height", "m", platform.y()},
                {"car strays", "mm",
                 std::abs(car.x() - platform.x() - away(workshop())) * millimetres}};
    }

private:
    static void joinStiffly(Workshop& workshop, JointPlan plan) {
        plan.heldHertz = 240;
        plan.heldDampingRatio = 20;
        workshop.join(plan);
    }

    static double lengthAt(double sine) { return std::sqrt(9 + 40 * sine * sine); }
    double away(const Workshop& workshop) const {
        return workshop.plan(car_.chassis).place.x() - workshop.plan(platform_).place.x();
    }

    inline static const Point foot{-2.5, 0.2};
    static constexpr double start = 0.15, half = 2.5;     // rad; m, of a link
    static constexpr double speed = 0.25, longest = 5.5;  // m/s, m, of the actuator
    std::size_t platform_ = 0, actuator_ = 0;
    Car car_;
    double error_ = 0, short_ = 0;
};

/// A gear with 16 teeth of 0.18 m.
BodyPlan gearWheel(const Point& place, double angle) {
    constexpr int teeth = 16;
    constexpr double radius = 1, outer = 1.18;  // m
    const auto at = [](double r, double side, int tooth) {
        const double turn = 2 * pi * tooth / teeth;
        return Motion{.place = {0, 0}, .angle = turn}.at(
            Point(std::sqrt(r * r - side * side), side));
    };
    BodyPlan plan;
    plan.place = place;
    plan.angle = angle;
    plan.friction = 0.1;
    std::vector<Point> hub;
    for (int i = 0; i < teeth; ++i) {
        const Point foot[] = {at(radius, -0.09, i), at(radius, 0.09, i)};
        const Point tip[] = {at(outer, -0.07, i), at(outer, 0.07, i)};
        plan.parts.push_back({{foot[0], tip[0], tip[1], foot[1]}});
        for (const Point& p : {foot[0], tip[0], tip[1], foot[1]}) plan.contour.push_back(p);
        hub.insert(hub.end(), {foot[0], foot[1]});
    }
    // The hub in pieces of at most eight corners.
    for (std::size_t from = 0; from < hub.size(); from += 6) {
        Outline piece{{Point(0, 0)}};
        for (std::size_t i = from; i <= std::min(from + 6, hub.size()); ++i)
            piece.points.push_back(hub[i % hub.size()]);
        plan.parts.push_back(std::move(piece));
    }
    return plan;
}

/// A driven gear turns another one, on which a chain is wound that lifts a gate, behind which lie
/// stones.
class Gears final : public Contraption {
public:
    explicit Gears(int rows) : rows_(rows) {}

protected:
    void build(Workshop& workshop) override {
        addPit(workshop);
        const double along = std::atan2(1.0, 2.0);
        // A tooth of the one is in a gap of the other.
        driver_ = workshop.add(gearWheel(drive, along));
        follower_ = workshop.add(gearWheel(drive + Point(2, 1), along + pi + pi / 16));
        workshop.join({.a = workshop.addNail(drive),
                       .b = driver_,
                       .at = drive,
                       .motorSpeed = -speed,
                       .motorMax = 80});
        workshop.join({.a = workshop.addNail(drive + Point(2, 1)),
                       .b = follower_,
                       .at = drive + Point(2, 1),
                       .lower = -0.05 * pi,
                       .upper = 0.9 * pi,
                       .motorMax = 0.5});
        addChain(workshop);
        addStones(workshop);
    }

    void note(const EngineWorld& world, double time) override {
        const auto turned = [&](std::size_t gear) {
            return std::remainder(world.body(gear).angle - workshop().plan(gear).angle, 2 * pi);
        };
        const double driver = turned(driver_), follower = turned(follower_);
        stall_ = worse(stall_, std::abs(driver + speed * time));
        slip_ = worse(slip_, std::abs(driver + follower));
    }

    Figures more(const EngineWorld& world) override {
        const double lift = world.body(gate_).place.y() - workshop().plan(gate_).place.y();
        return {{"slip", "deg", slip_ * 180 / pi},
                {"stall", "deg", stall_ * 180 / pi},
                {"gate lifted", "m", lift}};
    }

private:
    /// A floor, and steps that lead down to the gate.
    void addPit(Workshop& workshop) {
        const auto block = [&](const Point& low, const Point& high) {
            workshop.add({.parts = {rectangle((high - low) / 2)},
                          .mover = Mover::nobody,
                          .place = (low + high) / 2});
        };
        block({-12, 1}, {12, floor});
        constexpr double step = 0.53;  // m
        for (int i = 0; i < 9; ++i)
            block({-12, floor + i * step}, {-1.8 - i * step, floor + (i + 1) * step});
    }

    void addChain(Workshop& workshop) {
        constexpr double half = 0.07;  // m, of a link
        Point at = drive + Point(2 + 1.21, 1);
        std::size_t before = follower_;
        for (int i = 0; i < 40; ++i) {
            const std::size_t link =
                workshop.add({.parts = {capsule(Point(0, -half), Point(0, half), 0.05)},
                              .place = at - Point(0, half),
                              .density = 2});
            workshop.join({.a = before, .b = link, .at = at, .motorMax = 0.05});
            at.y() -= 2 * half;
            before = link;
        }
        gate_ = workshop.add(
            {.parts = {rectangle(Point(0.15, 1.5))}, .place = at - Point(0, 1.5), .friction = 0.1});
        workshop.join({.a = before, .b = gate_, .at = at, .motorMax = 0.05});
        workshop.join({.kind = JointPlan::Kind::slider,
                       .a = workshop.addNail(at - Point(0, 1.5)),
                       .b = gate_,
                       .at = at - Point(0, 1.5),
                       .axis = {0, 1},
                       .motorMax = 0.2});
    }

    /// Hexagons of any size.
    void addStones(Workshop& workshop) {
        Lcg random(7);
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < 10; ++column) {
                const double size = 0.06 + 0.04 * random.next();
                std::vector<Point> corners;
                for (int i = 0; i < 6; ++i) {
                    const double angle = 2 * pi * (i + 0.6 * random.next()) / 6;
                    corners.push_back(size * Point(std::cos(angle), std::sin(angle)));
                }
                const Point middle = centre(corners);
                workshop.add({.parts = {Outline{corners, 0}},
                              .place = Point(-3.2 + 0.2 * column, 4.25 + 0.2 * row) + middle});
            }
        }
    }

    inline static const Point drive{-4.25, 9.75};
    static constexpr double speed = 0.3, floor = 2.1;  // rad/s, m
    int rows_;
    std::size_t driver_ = 0, follower_ = 0, gate_ = 0;
    double slip_ = 0, stall_ = 0;
};

}  // namespace

VariantScene scissorLift(Extent extent) {
    const double seconds = extent == Extent::quick ? 5 : 12;
    return {.title = fmt::format("scissors of three pairs lift a car, {:g} s", seconds),
            .seconds = seconds,
            .bodies = 10,
            .error = "height error",
            .play = [] { return std::make_unique<Scissors>(); }};
}

VariantScene gearLift(Extent extent) {
    const int rows = extent == Extent::quick ? 4 : 20;
    const double seconds = extent == Extent::quick ? 4 : 9;
    return {.title = fmt::format("gears, a chain and a gate before {} stones, {:g} s", 10 * rows,
                                 seconds),
            .seconds = seconds,
            .bodies = 43.0 + 10 * rows,
            .error = "slip",
            .play = [=] { return std::make_unique<Gears>(rows); }};
}

}  // namespace sulfur::lab::bench
