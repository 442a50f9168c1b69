// S4, a rope of 40 links that swings or hangs under a load, and S5, pendulums.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bench/scenes.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

constexpr int links = 40;
constexpr double linkLength = 0.25;  // m

double stretchOf(const std::vector<Point>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length / (links * linkLength) - 1;
}

class Rope final : public Play {
public:
    Rope(double load, const Point& along, double seconds)
        : load_(load), along_(along), seconds_(seconds) {}

    void begin(EngineWorld& world) override {
        RopePlan plan;
        for (int i = 0; i <= links; ++i) plan.points.push_back(along_ * linkLength * i);
        plan.masses.assign(links + 1, 1);
        plan.masses.back() = load_;
        world.addRope(plan);
    }

    void look(const EngineWorld& world, double time) override {
        const double stretch = stretchOf(world.rope(0));
        if (!std::isfinite(stretch)) exploded_ = true;
        most_ = std::max(most_, stretch);
        if (time > seconds_ - 1) late_.push_back(stretch);
    }

    Figures figures(const EngineWorld&) override {
        const double none = std::numeric_limits<double>::infinity();
        double size = 0;
        for (const double stretch : late_)
            size += std::abs(stretch) / static_cast<double>(late_.size());
        return {{"max stretch", "%", exploded_ ? none : 100 * most_},
                {"mean stretch in the last s", "%", exploded_ ? none : 100 * mean(late_)},
                {"mean |stretch| in the last s", "%", exploded_ ? none : 100 * size}};
    }

private:
    double load_;
    Point along_;
    double seconds_, most_ = 0;
    std::vector<double> late_;
    bool exploded_ = false;
};

/// The exact period of a pendulum of 1 m released at 90 degrees: 4 sqrt(L/g) K, with the complete
/// elliptic integral K of the parameter 1/2, by the arithmetic-geometric mean.
double exactPeriod() {
    double a = 1, b = std::sqrt(0.5);
    for (int i = 0; i < 8; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    constexpr double pi = 3.14159265358979323846;
    return 4 * std::sqrt(1 / gravity) * pi / (2 * a);
}

class Pendulums final : public Play {
public:
    explicit Pendulums(int count) : count_(count) {}

    void begin(EngineWorld& world) override {
        for (int i = 0; i < count_; ++i) {
            const Point pivot(i % 100 * 5.0, i / 100 * 5.0);
            world.addRope({{pivot, pivot + Point(1, 0)}, {0, 1}});
        }
    }

    void look(const EngineWorld& world, double time) override {
        const std::vector<Point> points = world.rope(0);
        const Point bob = points[1] - points[0];
        lengthError_ = std::max(lengthError_, std::abs(bob.norm() - 1));
        if (last_ && (last_->x() > 0) != (bob.x() > 0)) {
            const double share = last_->x() / (last_->x() - bob.x());
            crossings_.push_back(lastTime_ + share * (time - lastTime_));
            if (std::isfinite(highest_) && crossings_.size() > 1) turning_ = highest_;
            highest_ = -std::numeric_limits<double>::infinity();
        }
        // The parabola through three samples, of which the middle one is the highest.
        if (last_ && beforeLast_ && last_->y() >= beforeLast_->y() && last_->y() >= bob.y()) {
            const double rise = bob.y() - beforeLast_->y();
            const double bend = beforeLast_->y() - 2 * last_->y() + bob.y();
            highest_ = last_->y() - (bend < 0 ? rise * rise / (8 * bend) : 0);
        }
        beforeLast_ = last_;
        last_ = bob;
        lastTime_ = time;
    }

    Figures figures(const EngineWorld&) override {
        const double exact = exactPeriod();
        const double none = std::numeric_limits<double>::infinity();
        const auto error = [&](std::size_t from, std::size_t to) {
            if (to >= crossings_.size() || from >= to) return none;
            const double half =
                (crossings_[to] - crossings_[from]) / static_cast<double>(to - from);
            return 2 * half / exact - 1;
        };
        const std::size_t n = crossings_.size();
        return {{"first period error", "", error(0, 2)},
                {"period error", "", n > 1 ? error(0, n - 1) : none},
                {"energy change", "m g L", turning_},
                {"|energy change|", "m g L", std::abs(turning_)},
                {"length error", "mm", lengthError_ * 1e3}};
    }

private:
    int count_;
    std::optional<Point> last_, beforeLast_;
    double lastTime_ = 0, lengthError_ = 0;
    double highest_ = -std::numeric_limits<double>::infinity();
    double turning_ = std::numeric_limits<double>::infinity();
    std::vector<double> crossings_;
};

Scene ropeScene(double load, const Point& along, const std::string& way, std::string error) {
    constexpr double seconds = 10;
    return {.key = "S4",
            .variant = fmt::format("{} 1:{:g}", way, load),
            .title = fmt::format("a rope of 40 links of 1 kg, load {:g} kg, {}, 10 s", load,
                                 way == "swing" ? "released horizontally" : "hanging"),
            .needs = Feature::ropes,
            .seconds = seconds,
            .size = load,
            .looksPerSecond = 60,
            .error = std::move(error),
            .play = [=] { return std::make_unique<Rope>(load, along, seconds); }};
}

}  // namespace

Scene swingingRope(double load) {
    return ropeScene(load, Point(1, 0), "swing", "max stretch");
}

Scene hangingRope(double load) {
    return ropeScene(load, Point(0, -1), "hang", "mean |stretch| in the last s");
}

Scene pendulums(int count, double seconds) {
    return {
        .key = "S5",
        .variant = fmt::format("{} pendulums", count),
        .title = fmt::format("{} pendulums of 1 m released at 90 degrees, {:g} s", count, seconds),
        .needs = Feature::ropes,
        .seconds = seconds,
        .size = static_cast<double>(count),
        .looksPerSecond = 1'000'000,
        .error = "|energy change|",
        .play = [=] { return std::make_unique<Pendulums>(count); }};
}

}  // namespace sulfur::lab::bench
