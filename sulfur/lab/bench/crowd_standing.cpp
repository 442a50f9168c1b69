// Scenes of S8 that stand or hang: pyramids, and a grid of pinned discs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/crowd.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

/// Pyramids of boxes of 1 m that touch on all sides, in rows above each other, each row on a ground
/// of its own.
class Pyramids final : public Crowd {
public:
    Pyramids(int base, int columns, int rows, double seconds)
        : Crowd(seconds), base_(base), columns_(columns), rows_(rows) {}

    void begin(EngineWorld& world) override {
        const double step = base_ + 1.0, width = columns_ * step;
        for (int row = 0; row < rows_; ++row) {
            const double ground = row * step;
            addWall(world, Point(0, ground - 0.25), Point(width / 2 + base_, 0.25));
            for (int column = 0; column < columns_; ++column)
                addPyramid(world, Point((column + 0.5) * step - width / 2, ground));
        }
    }

protected:
    Figures more(const EngineWorld& world) override {
        double sunk = 0, sideways = 0;
        int moved = 0;
        for (std::size_t i = 0; i < count(); ++i) {
            if (!moves(i)) continue;
            const Point way = world.body(i).place - plan(i).place;
            // Written so that a number that is none counts as moved.
            if (!(way.norm() <= 0.5)) ++moved;
            sideways = std::max(sideways, std::abs(way.x()));
        }
        for (const std::size_t top : tops_)
            sunk = std::max(sunk, plan(top).place.y() - world.body(top).place.y());
        return {{"top sinks", "mm", sunk * millimetres},
                {"any sideways", "mm", sideways * millimetres},
                {"moved > 0.5 m", "", static_cast<double>(moved)}};
    }

private:
    void addPyramid(EngineWorld& world, const Point& foot) {
        for (int row = 0; row < base_; ++row) {
            for (int column = 0; column < base_ - row; ++column) {
                BodyPlan box{.parts = {rectangle(Point(0.5, 0.5))}};
                box.place = foot + Point(column - (base_ - 1 - row) / 2.0, row + 0.5);
                const std::size_t body = add(world, std::move(box));
                if (row + 1 == base_) tops_.push_back(body);
            }
        }
    }

    int base_, columns_, rows_;
    std::vector<std::size_t> tops_;
};

/// A grid of discs that pass through each other, each pinned to its neighbours half a metre from
/// its middle. Seven in the middle of the upper edge are fixed, which also cannot turn, so that the
/// whole is rigid: exactly, nothing moves.
class JointGrid final : public Crowd {
public:
    JointGrid(int side, double seconds) : Crowd(seconds), side_(side) {}

    void begin(EngineWorld& world) override {
        for (int column = 0; column < side_; ++column) {
            for (int row = 0; row < side_; ++row) {
                const std::size_t body = addDisc(world, column, row);
                if (row > 0) pin(world, {body - 1, below, body, above});
                if (column > 0)
                    pin(world, {body - static_cast<std::size_t>(side_), right, body, left});
            }
        }
    }

protected:
    void note(const EngineWorld& world, double time) override {
        if (time + 1e-9 < next_) return;
        next_ += 0.1;
        for (std::size_t i = 0; i < pins_; ++i) {
            const auto [a, b] = world.pin(i);
            openings_.push_back((a - b).norm());
        }
    }

    Figures more(const EngineWorld& world) override {
        double farthest = 0;
        for (std::size_t i = 0; i < count(); ++i)
            farthest = std::max(farthest, (world.body(i).place - plan(i).place).norm());
        return {{"mean opening", "mm", mean(openings_) * millimetres},
                {"p99 opening", "mm", percentile(openings_, 0.99) * millimetres},
                {"max opening", "mm", percentile(openings_, 1) * millimetres},
                {"farthest", "mm", farthest * millimetres}};
    }

private:
    static constexpr std::size_t above = 0, below = 1, left = 2, right = 3;

    std::size_t addDisc(EngineWorld& world, int column, int row) {
        BodyPlan plan{.parts = {disc(0.4)}};
        plan.sockets = {{0, 0.5}, {0, -0.5}, {-0.5, 0}, {0.5, 0}};
        plan.place = Point(column, -row);
        plan.group = 1;
        if (row == 0 && std::abs(column - side_ / 2) <= 3) plan.mover = Mover::nobody;
        return add(world, std::move(plan));
    }

    void pin(EngineWorld& world, const PinPlan& pin) {
        if (!moves(pin.a) && !moves(pin.b)) return;
        world.addPin(pin);
        ++pins_;
    }

    int side_;
    std::size_t pins_ = 0;
    double next_ = 0;
    std::vector<double> openings_;
};

VariantScene pyramids(int base, int columns, int rows, double seconds) {
    const int boxes = columns * rows * base * (base + 1) / 2;
    const std::string title = columns * rows == 1
                                  ? fmt::format("a pyramid of {} boxes, {:.3g} s", boxes, seconds)
                                  : fmt::format("{} pyramids of {} boxes in all, {:.3g} s",
                                                columns * rows, boxes, seconds);
    return {.title = title,
            .seconds = seconds,
            .bodies = static_cast<double>(boxes),
            .error = "top sinks",
            .play = [=] { return std::make_unique<Pyramids>(base, columns, rows, seconds); }};
}

}  // namespace

VariantScene largePyramid(Extent extent) {
    const bool quick = extent == Extent::quick;
    return pyramids(quick ? 30 : 100, 1, 1, quick ? 3 : 500.0 / 60);
}

VariantScene manyPyramids(Extent extent) {
    const bool quick = extent == Extent::quick;
    return pyramids(10, quick ? 5 : 20, quick ? 5 : 20, quick ? 2 : 200.0 / 60);
}

VariantScene jointGrid(Extent extent) {
    const bool quick = extent == Extent::quick;
    const int side = quick ? 20 : 100;
    const double seconds = quick ? 3 : 500.0 / 60;
    return {.title = fmt::format("{} x {} discs, each pinned to its neighbours, {:.3g} s", side,
                                 side, seconds),
            .seconds = seconds,
            .bodies = static_cast<double>(side * side),
            .error = "p99 opening",
            .play = [=] { return std::make_unique<JointGrid>(side, seconds); }};
}

}  // namespace sulfur::lab::bench
