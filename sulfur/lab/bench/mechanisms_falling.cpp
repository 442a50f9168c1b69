// Scenes of S9 that fall or are struck: doohickeys, ragdolls, doors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/mechanisms.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

using std::numbers::pi;

/// Pairs of wheels on a rod that slides in itself, which fall on a box, four on each.
class Doohickeys final : public Contraption {
public:
    explicit Doohickeys(int columns) : columns_(columns) {}

protected:
    void build(Workshop& workshop) override {
        for (int column = 0; column < columns_; ++column) {
            const double x = 40.0 * column;
            workshop.add(
                {.parts = {rectangle(Point(20, 0.5))}, .mover = Mover::nobody, .place = {x, -0.5}});
            workshop.add(
                {.parts = {rectangle(Point(1, 1))}, .mover = Mover::nobody, .place = {x, 1}});
            for (int i = 0; i < 4; ++i) addOne(workshop, Point(x, 5.5 + 2 * i));
        }
    }

private:
    static void addOne(Workshop& workshop, const Point& middle) {
        std::size_t bars[2];
        for (int side = 0; side < 2; ++side) {
            const double sign = side == 0 ? -1 : 1;
            const std::size_t wheel =
                workshop.add({.parts = {disc(0.5)}, .place = middle + Point(2.5 * sign, 0)});
            bars[side] = workshop.add({.parts = {rectangle(Point(1.75, 0.075))},
                                       .place = middle + Point(0.75 * sign, 0)});
            workshop.join(
                {.a = wheel, .b = bars[side], .at = middle + Point(2.5 * sign, 0), .motorMax = 1});
        }
        workshop.join({.kind = JointPlan::Kind::slider,
                       .a = bars[0],
                       .b = bars[1],
                       .at = middle,
                       .lower = -1,
                       .upper = 1,
                       .motorMax = 1,
                       .hertz = 1,
                       .dampingRatio = 0.5});
    }

    int columns_;
};

/// A capsule from one end to the other that hangs on another bone, of a doll whose feet are at the
/// origin. Bones reach their pivots, where Box2D's end up to 65 mm before them: a capsule of ours
/// has its mass in its two ends and holds nothing beyond them.
struct DollBone {
    int parent;
    double low, high, radius, pivot;   // m above the feet; radius m
    double lower, upper, rest, share;  // rad, rad, rad, of the friction
};

constexpr DollBone dollBones[] = {
    {-1, 0.9, 1.0, 0.095, 0, 0, 0, 0, 0},                       // hip
    {0, 1.0, 1.4, 0.09, 1, -0.25 * pi, 0, 0, 0.5},              // torso
    {1, 1.4, 1.514, 0.075, 1.4, -0.3 * pi, 0.1 * pi, 0, 0.25},  // head
    {0, 0.625, 0.9, 0.06, 0.9, -0.05 * pi, 0.4 * pi, 0, 1},     // thighs
    {0, 0.625, 0.9, 0.06, 0.9, -0.05 * pi, 0.4 * pi, 0, 1},
    {3, 0.32, 0.625, 0.045, 0.625, -0.5 * pi, 0, 0, 0.5},  // shanks
    {4, 0.32, 0.625, 0.045, 0.625, -0.5 * pi, 0, 0, 0.5},
    {1, 1.1, 1.35, 0.035, 1.35, -0.1 * pi, 0.8 * pi, 0, 0.5},  // upper arms
    {1, 1.1, 1.35, 0.035, 1.35, -0.1 * pi, 0.8 * pi, 0, 0.5},
    {7, 0.85, 1.1, 0.03, 1.1, 0, 0.55 * pi, 0.25 * pi, 0.1},  // forearms
    {8, 0.85, 1.1, 0.03, 1.1, 0, 0.55 * pi, 0.25 * pi, 0.1}};

/// Ragdolls with springs and friction in their joints that fall into a pit.
class Ragdolls final : public Contraption {
public:
    Ragdolls(int columns, int rows) : columns_(columns), rows_(rows) {}

protected:
    void build(Workshop& workshop) override {
        const double half = 0.5 * columns_ + 0.5;
        const auto wall = [&](const Point& place, const Point& size) {
            workshop.add({.parts = {rectangle(size)}, .mover = Mover::nobody, .place = place});
        };
        wall({0, -1}, {half + 2, 1});
        for (const double side : {-1.0, 1.0}) wall({side * (half + 1), 10}, {1, 10});
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                addDoll(workshop, Point(column - (columns_ - 1) / 2.0 + (row % 2 ? 0.2 : -0.2),
                                        2 + 1.8 * row));
    }

    void note(const EngineWorld& world, double) override {
        const double half = 0.5 * columns_ + 1.5;
        lost_ = 0;
        for (std::size_t i = 0; i < workshop().bodies(); ++i) {
            if (workshop().plan(i).mover != Mover::physics) continue;
            const Point place = world.body(i).place;
            if (!(std::abs(place.x()) < half && place.y() > -1)) ++lost_;
        }
    }

    Figures more(const EngineWorld&) override { return {{"lost", "", static_cast<double>(lost_)}}; }

private:
    void addDoll(Workshop& workshop, const Point& feet) {
        ++group_;
        std::vector<std::size_t> bones;
        for (const DollBone& bone : dollBones) {
            const double half = (bone.high - bone.low) / 2;
            bones.push_back(
                workshop.add({.parts = {capsule(Point(0, -half), Point(0, half), bone.radius)},
                              .place = feet + Point(0, bone.low + half),
                              .friction = 0.2,
                              .group = group_}));
            if (bone.parent < 0) continue;
            workshop.join({.a = bones[static_cast<std::size_t>(bone.parent)],
                           .b = bones.back(),
                           .at = feet + Point(0, bone.pivot),
                           .lower = bone.lower,
                           .upper = bone.upper,
                           .motorMax = 0.03 * bone.share,
                           .hertz = 5,
                           .dampingRatio = 0.5,
                           .rest = bone.rest});
        }
    }

    int columns_, rows_, group_ = 0, lost_ = 0;
};

/// Heavy doors seen from above, with a spring, that are struck at their edge every other second,
/// to one side and the other. A blow turns the last one at 83 rad/s.
class Doors final : public Contraption {
public:
    explicit Doors(int count) : count_(count) {}

    void before(EngineWorld& world, double time) override {
        if (time + 1e-9 < 2 * blows_) return;
        const double side = blows_++ % 2 == 0 ? 1 : -1;
        for (int i = 0; i < count_; ++i) {
            const auto door = static_cast<std::size_t>(2 * i + 1);
            const Motion now = world.body(door);
            const Point across = Motion{.place = {0, 0}, .angle = now.angle}.at(Point(1, 0));
            world.applyImpulse(door, side * hardest * (i + 1) / count_ * across,
                               now.at(Point(0, half)));
        }
    }

protected:
    double weight() const override { return 0; }

    void build(Workshop& workshop) override {
        for (int i = 0; i < count_; ++i) {
            const Point pivot(8.0 * i, 0);
            const std::size_t frame = workshop.addNail(pivot);
            const std::size_t door = workshop.add({.parts = {rectangle(Point(0.1, half))},
                                                   .place = pivot + Point(0, half),
                                                   .density = 1000,
                                                   .group = 1});
            workshop.join({.a = frame,
                           .b = door,
                           .at = pivot,
                           .lower = -pi / 2,
                           .upper = pi / 2,
                           .hertz = 1,
                           .dampingRatio = 0.5,
                           .heldHertz = 240,
                           .heldDampingRatio = 1});
        }
    }

private:
    static constexpr double half = 1.5, hardest = 5e4;  // m, N s
    int count_, blows_ = 0;
};

}  // namespace

VariantScene doohickeys(Extent extent) {
    const int columns = extent == Extent::quick ? 1 : 10;
    return {.title = fmt::format("{} pairs of wheels on sliding rods that fall on boxes, 10 s",
                                 4 * columns),
            .seconds = 10,
            .bodies = 16.0 * columns,
            .play = [=] { return std::make_unique<Doohickeys>(columns); }};
}

VariantScene ragdollHeap(Extent extent) {
    const int columns = extent == Extent::quick ? 4 : 10, rows = extent == Extent::quick ? 3 : 10;
    return {.title = fmt::format("{} ragdolls that fall into a pit, 10 s", columns * rows),
            .seconds = 10,
            .bodies = 11.0 * columns * rows,
            .play = [=] { return std::make_unique<Ragdolls>(columns, rows); }};
}

VariantScene doors(Extent extent) {
    const int count = extent == Extent::quick ? 4 : 20;
    return {.title = fmt::format("{} doors that are struck with up to 50,000 N s, 10 s", count),
            .seconds = 10,
            .bodies = static_cast<double>(count),
            .error = "beyond a limit",
            .play = [=] { return std::make_unique<Doors>(count); },
            .weightless = true};
}

}  // namespace sulfur::lab::bench
