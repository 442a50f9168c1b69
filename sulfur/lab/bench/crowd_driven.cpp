// Scenes of S8 in which something drives a crowd: a drum, a rod, a blow.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/crowd.hpp"

namespace sulfur::lab::bench {

namespace {

using std::numbers::pi;

/// A square drum with walls of 1 m that turns at 25 degrees a second.
class Tumbler final : public Crowd {
public:
    Tumbler(int side, double seconds) : Crowd(seconds), side_(side) {}

    void begin(EngineWorld& world) override {
        BodyPlan drum;
        drum.mover = Mover::motor;
        drum.place = middle;
        drum.spin = 25 * pi / 180;
        const Point corners[] = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
        for (std::size_t i = 0; i < 4; ++i)
            drum.parts.push_back(capsule(corners[i], corners[(i + 1) % 4], 0.5));
        drum_ = add(world, std::move(drum));
        for (int row = 0; row < side_; ++row) {
            for (int column = 0; column < side_; ++column) {
                BodyPlan box{.parts = {rectangle(Point(0.125, 0.125))}};
                box.place = middle + Point(0.4 * column - 0.2 * side_, 0.4 * row - 0.2 * side_);
                add(world, std::move(box));
            }
        }
    }

protected:
    bool lost(const BodyPlan&, const Motion& motion, double time) const override {
        const double turned = -plan(drum_).spin * time;
        const Point inside = Motion{.place = {0, 0}, .angle = turned}.at(motion.place - middle);
        return inside.cwiseAbs().maxCoeff() > 10.5;
    }

private:
    inline static const Point middle{0, 10};
    int side_;
    std::size_t drum_ = 0;
};

/// A rod of 40 m that turns at 5 rad/s in a ring of 360 sides, among discs, capsules and squares
/// that begin in each other. Its ends move at 101 m/s.
class Spinner final : public Crowd {
public:
    Spinner(int bodies, double seconds) : Crowd(seconds), bodies_(bodies) {}

    void begin(EngineWorld& world) override {
        add(world, ring());
        BodyPlan rod{.parts = {rectangle(Point(0.4, 20), 0.2)}};
        rod.mover = Mover::motor;
        rod.place = Point(0, 12);
        rod.spin = 5;
        rod.friction = 0;
        add(world, std::move(rod));
        const Outline kinds[] = {capsule(Point(-0.25, 0), Point(0.25, 0), 0.25), disc(0.35),
                                 rectangle(Point(0.35, 0.35))};
        constexpr int columns = 92;
        for (int i = 0; i < bodies_; ++i) {
            BodyPlan body{.parts = {kinds[i % 3]}};
            body.place = Point(-23 + 0.5 * (i % columns), 2 + 0.5 * (i / columns));
            body.density = 0.25;
            body.friction = 0.1;
            body.restitution = 0.1;
            add(world, std::move(body));
        }
    }

protected:
    bool lost(const BodyPlan&, const Motion& motion, double) const override {
        return (motion.place - middle).norm() > radius;
    }

private:
    static BodyPlan ring() {
        constexpr int sides = 360;
        constexpr double half = 0.25;  // m, of its thickness, which lies outside
        BodyPlan plan;
        plan.mover = Mover::nobody;
        plan.place = middle;
        plan.friction = 0.1;
        const auto corner = [&](int i) {
            const double angle = 2 * pi * (i % sides) / sides;
            return Point((radius + half) * std::cos(angle), (radius + half) * std::sin(angle));
        };
        for (int i = 0; i < sides; ++i)
            plan.parts.push_back(capsule(corner(i), corner(i + 1), half));
        return plan;
    }

    inline static const Point middle{0, 32};
    static constexpr double radius = 40;
    int bodies_;
};

/// A block of 512 kg at 40 m/s into a wall of sleeping boxes of 0.16 kg, without gravity. Nothing
/// holds them: momentum stays, energy never grows.
class Smash final : public Crowd {
public:
    Smash(int columns, int rows, double seconds) : Crowd(seconds), columns_(columns), rows_(rows) {}

    void begin(EngineWorld& world) override {
        BodyPlan block{.parts = {rectangle(Point(4, 4))}};
        block.place = Point(-20, 0);
        block.velocity = Point(40, 0);
        block.density = 8;
        add(world, std::move(block));
        constexpr double size = 0.4;
        for (int column = 0; column < columns_; ++column) {
            for (int row = 0; row < rows_; ++row) {
                BodyPlan box{.parts = {rectangle(Point(size / 2, size / 2))}};
                box.place = Point(30 + size * column, size * (row - rows_ / 2.0));
                box.asleep = true;
                add(world, std::move(box));
            }
        }
    }

protected:
    Figures more(const EngineWorld& world) override {
        Point momentum(0, 0), before(0, 0);
        double energyBefore = 0;
        for (std::size_t i = 0; i < count(); ++i) {
            momentum += plan(i).mass() * world.body(i).velocity;
            before += plan(i).mass() * plan(i).velocity;
            energyBefore += plan(i).mass() * plan(i).velocity.squaredNorm() / 2;
        }
        const double kept = kineticEnergy(world) / energyBefore;
        return {{"momentum change", "%", 100 * (momentum - before).norm() / before.norm()},
                {"energy kept", "%", 100 * kept}};
    }

private:
    int columns_, rows_;
};

}  // namespace

VariantScene tumbler(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int side = quick ? 20 : 45;
    const double seconds = quick ? 5 : 12.5;
    return {.title = fmt::format("{} boxes in a turning drum, {:g} s", side * side, seconds),
            .seconds = seconds,
            .bodies = static_cast<double>(side * side),
            .play = [=] { return std::make_unique<Tumbler>(side, seconds); }};
}

VariantScene spinner(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int bodies = quick ? 500 : 6076;
    const double seconds = quick ? 4 : 500.0 / 60;
    return {.title = fmt::format("{} bodies round a turning rod, {:.3g} s", bodies, seconds),
            .seconds = seconds,
            .bodies = static_cast<double>(bodies),
            .play = [=] { return std::make_unique<Spinner>(bodies, seconds); }};
}

VariantScene smash(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int columns = quick ? 20 : 120, rows = quick ? 10 : 80;
    const double seconds = quick ? 3 : 5;
    return {.title = fmt::format("a heavy block into {} sleeping boxes, {:g} s", columns * rows,
                                 seconds),
            .seconds = seconds,
            .bodies = columns * rows + 1.0,
            .error = "momentum change",
            .play = [=] { return std::make_unique<Smash>(columns, rows, seconds); },
            .sleeping = true,
            .weightless = true};
}

}  // namespace sulfur::lab::bench
