// S1, boxes that drop into an arena, and S2 and S7, a pyramid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bench/scenes.hpp"
#include "bench/spread.hpp"
#include "bench/squares.hpp"

namespace sulfur::lab::bench {

namespace {

std::vector<Square> squaresOf(const EngineWorld& world, std::size_t count) {
    std::vector<Square> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(world.square(i));
    return all;
}

/// What has exploded has no place.
bool finite(const Square& square) {
    return square.first.allFinite() && std::isfinite(square.second);
}

Figures overlapFigures(const std::vector<Square>& squares, double cornerRadius) {
    const std::vector<double> depths = overlaps(squares, cornerRadius);
    return {{"mean overlap", "mm", mean(depths) * millimetres},
            {"p99 overlap", "mm", percentile(depths, 0.99) * millimetres},
            {"max overlap", "mm", percentile(depths, 1) * millimetres}};
}

class DroppedBoxes final : public Play {
public:
    DroppedBoxes(int perSecond, double seconds)
        : perSecond_(perSecond), pairs_(static_cast<int>(std::lround(perSecond * seconds / 2))) {}

    void begin(EngineWorld& world) override {
        const double w = arenaWidth(perSecond_);
        world.addFixed(Point(0, -1), Point(w / 2 + 2, 1));
        for (const double side : {-1.0, 1.0})
            world.addFixed(Point(side * (w / 2 + 1), 20), Point(1, 20));
    }

    void before(EngineWorld& world, double time) override {
        // Ticks of some rates begin a rounding error before the moment that is meant.
        for (; made_ < pairs_ && time + 1e-9 >= made_ * 2.0 / perSecond_; ++made_) {
            const double x = pairPlace(perSecond_, made_);
            for (const double side : {-1.0, 1.0}) {
                const double angle = (random_.next() - 0.5) * 0.6;
                world.addSquare(Point(x + side * 0.65, 30), angle, Point(0, -5));
            }
        }
    }

    Figures figures(const EngineWorld& world) override {
        std::vector<Square> squares = squaresOf(world, static_cast<std::size_t>(2 * made_));
        const double half = arenaWidth(perSecond_) / 2;
        const auto gone = std::erase_if(squares, [&](const Square& square) {
            // More than its own size outside is no overlap but an escape.
            return !finite(square) || square.first.y() < -1 ||
                   std::abs(square.first.x()) > half + 1;
        });
        const double round = world.cornerRadius();
        Figures all = overlapFigures(squares, round);
        all.push_back({"wall", "mm", wallOverlap(squares, half, round) * millimetres});
        all.push_back({"escaped", "", static_cast<double>(gone)});
        return all;
    }

private:
    int perSecond_, pairs_, made_ = 0;
    Lcg random_{12345};
};

class Pyramid final : public Play {
public:
    explicit Pyramid(int base) : base_(base) {}

    void begin(EngineWorld& world) override {
        world.addFixed(Point(0, -1), Point(base_ + 20, 1));
        for (int row = 0; row < base_; ++row) {
            for (int column = 0; column < base_ - row; ++column) {
                const Point place((column - (base_ - 1 - row) / 2.0) * 1.05, 0.5 + row);
                world.addSquare(place, 0, Point(0, 0));
                start_.push_back(place);
            }
        }
    }

    Figures figures(const EngineWorld& world) override {
        std::vector<Square> squares = squaresOf(world, start_.size());
        const Point top = squares.back().first - start_.back();
        double farthest = 0, sideways = 0;
        int moved = 0;
        for (std::size_t i = 0; i < start_.size(); ++i) {
            const Point way = squares[i].first - start_[i];
            // Written so that a number that is none counts as moved.
            if (!(way.norm() <= 0.5)) ++moved;
            farthest = std::max(farthest, way.norm());
            sideways = std::max(sideways, std::abs(way.x()));
        }
        const bool stands = top.norm() < 1;
        std::erase_if(squares, [](const Square& square) { return !finite(square); });
        Figures all{{"top sinks", "mm", -top.y() * millimetres},
                    {"top sideways", "mm", top.x() * millimetres},
                    {"any sideways", "mm", sideways * millimetres},
                    {"moved > 0.5 m", "", static_cast<double>(moved)},
                    {"farthest", "m", farthest},
                    {"stands", "", stands ? 1.0 : 0.0}};
        for (Figure& figure : overlapFigures(squares, world.cornerRadius()))
            all.push_back(std::move(figure));
        return all;
    }

private:
    int base_;
    std::vector<Point> start_;
};

}  // namespace

double arenaWidth(int perSecond) {
    return std::max(20.0, perSecond / 2.0);
}

double pairPlace(int perSecond, int k) {
    const double w = arenaWidth(perSecond);
    const int slots = static_cast<int>(std::floor(w / 2.6));
    int stride = static_cast<int>(std::ceil(0.618 * slots));
    while (std::gcd(stride, slots) != 1) ++stride;
    const int slot = static_cast<int>(static_cast<long>(k) * stride % slots);
    return -w / 2 + (slot + 0.5) * w / slots;
}

Scene droppedBoxes(int perSecond, double seconds) {
    return {
        .key = "S1",
        .variant = fmt::format("{} boxes/s", perSecond),
        .title = fmt::format("boxes of 1 m dropped for {:g} s, {} a second", seconds, perSecond),
        .needs = Feature::squares,
        .seconds = seconds,
        .size = static_cast<double>(perSecond),
        .error = "p99 overlap",
        .play = [=] { return std::make_unique<DroppedBoxes>(perSecond, seconds); }};
}

Scene pyramid(int base, bool threads) {
    return {.key = threads ? "S7" : "S2",
            .variant = fmt::format("base {}", base),
            .title = fmt::format("a pyramid of {} boxes, base {}, 10 s{}", base * (base + 1) / 2,
                                 base, threads ? ", with one thread and with two" : ""),
            .needs = threads ? Feature::threads : Feature::squares,
            .size = base * (base + 1) / 2.0,
            .onWall = threads,
            .error = "top sinks",
            .play = [=] { return std::make_unique<Pyramid>(base); }};
}

}  // namespace sulfur::lab::bench
