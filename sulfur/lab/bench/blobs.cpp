// S3: soft blobs that fall into a heap. The softer a blob, the cheaper its heap may be and the
// less it keeps its size, so that each engine's blob is also loaded with its own weight alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/scenes.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

int columnsOf(int count) {
    return count >= 1000 ? 40 : 10;
}

double heapWidth(int count) {
    return 1.8 * columnsOf(count) + 2;
}

/// Mean distance of the particles from their middle, as the root of the mean square, m.
double gyration(const std::vector<Point>& places) {
    Point centre(0, 0);
    for (const Point& p : places) centre += p / static_cast<double>(places.size());
    double square = 0;
    for (const Point& p : places)
        square += (p - centre).squaredNorm() / static_cast<double>(places.size());
    return std::sqrt(square);
}

double heightOf(const std::vector<Point>& places) {
    double low = places.front().y(), high = low;
    for (const Point& p : places) {
        low = std::min(low, p.y());
        high = std::max(high, p.y());
    }
    return high - low;
}

/// One blob on a floor: what its weight takes of its height, after the motion has died down.
Figures sagging(const Engine& engine, const Setting& setting) {
    constexpr double settling = 8, looking = 2;  // s
    const auto world = engine.make(setting);
    world->addFixed(Point(0, -1), Point(10, 1));
    world->addBlob(Point(0, 0.7));
    const double before = heightOf(world->blob(0));
    std::vector<double> heights;
    for (int tick = 0; tick < (settling + looking) * setting.rate; ++tick) {
        world->step();
        if (tick >= settling * setting.rate) heights.push_back(heightOf(world->blob(0)));
    }
    const double sag = before - mean(heights);
    return {{"sag alone", "% of height", 100 * sag / before},
            // A bar under its own weight m g gives way by m g / (2 k).
            {"stiffness", "N/m", BlobPlan::mass * gravity / (2 * sag)}};
}

class SoftBlobs final : public Play {
public:
    explicit SoftBlobs(int count) : count_(count) {}

    void begin(EngineWorld& world) override {
        const double w = heapWidth(count_);
        world.addFixed(Point(0, -1), Point(w / 2 + 2, 1));
        for (const double side : {-1.0, 1.0})
            world.addFixed(Point(side * (w / 2 + 1), 40), Point(1, 40));
        for (int k = 0; k < count_; ++k) world.addBlob(blobPlace(count_, k));
        for (int k = 0; k < count_; ++k)
            before_.push_back(gyration(world.blob(static_cast<std::size_t>(k))));
    }

    Figures figures(const EngineWorld& world) override {
        const double half = heapWidth(count_) / 2;
        std::vector<double> kept;
        int escaped = 0;
        for (std::size_t k = 0; k < before_.size(); ++k) {
            const std::vector<Point> places = world.blob(k);
            const double now = gyration(places);
            if (std::isfinite(now)) kept.push_back(now / before_[k]);
            for (const Point& p : places)
                if (!(std::abs(p.x()) <= half + 0.5 && p.y() >= -0.5 && p.y() <= 81)) ++escaped;
        }
        const double size = mean(kept);
        return {{"size kept", "", size},
                {"size lost", "%", 100 * std::abs(1 - size)},
                {"least size kept", "", percentile(kept, 0)},
                {"escaped", "", static_cast<double>(escaped)}};
    }

private:
    int count_;
    std::vector<double> before_;
};

}  // namespace

Point blobPlace(int count, int k) {
    const int columns = columnsOf(count);
    const int column = k % columns, row = k / columns;
    return {(column - (columns - 1) / 2.0) * 1.8 + (row % 2 == 0 ? -0.45 : 0.45), 1.5 + 1.8 * row};
}

Scene softBlobs(int count) {
    return {.key = "S3",
            .variant = fmt::format("{} blobs", count),
            .title = fmt::format("a heap of {} soft blobs of 16 particles, 10 s", count),
            .needs = Feature::blobs,
            .size = static_cast<double>(count),
            .error = "size lost",
            .play = [=] { return std::make_unique<SoftBlobs>(count); },
            .aside = sagging};
}

}  // namespace sulfur::lab::bench
