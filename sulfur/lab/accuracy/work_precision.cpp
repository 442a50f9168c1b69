#include "accuracy/work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "battery/measure.hpp"

namespace sulfur::lab {

namespace {

/// Seconds of processor time that this process has used.
double processorTime() {
    std::timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What a run shows, without its cost.
WorkPoint follow(const AccuracyScene& scene, Run& run, int rate) {
    const auto ticksPerSample = std::lround(scene.interval * rate);
    const bool tied = scene.isTied();
    WorkPoint point{.rate = rate};
    for (const Vecs& expected : scene.path) {
        for (long tick = 0; tick < ticksPerSample; ++tick) {
            run.advance(1);
            if (tied) point.strain = worst(point.strain, run.strain(scene));
        }
        const Vecs places = run.places();
        for (std::size_t k = 0; k < expected.size(); ++k)
            point.error = worst(point.error, (places[scene.watched[k]] - expected[k]).norm());
        if (point.error < explosion) continue;
        point.error = point.strain = std::numeric_limits<double>::infinity();
        break;
    }
    return point;
}

/// One measurement: as many runs as fill the least time, all made before the clock starts.
double timeOf(const AccuracyScene& scene, const Subject& subject, int rate, long ticks, int runs) {
    std::vector<std::unique_ptr<Run>> prepared;
    for (int i = 0; i < runs; ++i) prepared.push_back(subject.start(scene, rate));
    const double begin = processorTime();
    for (const auto& run : prepared) run->advance(ticks);
    return (processorTime() - begin) / runs;
}

double medianTime(const AccuracyScene& scene, const Subject& subject, int rate, long ticks,
                  const CostOptions& options) {
    constexpr int mostRuns = 1000;
    const double first = timeOf(scene, subject, rate, ticks, 1);
    if (first > options.most / 4) return first;  // long enough to be exact by itself
    const int runs = static_cast<int>(std::clamp(options.least / first, 1.0, double{mostRuns}));
    std::vector<double> times;
    for (int i = 0; i < options.repeats; ++i)
        times.push_back(timeOf(scene, subject, rate, ticks, runs));
    std::nth_element(times.begin(), times.begin() + options.repeats / 2, times.end());
    return times[static_cast<std::size_t>(options.repeats / 2)];
}

}  // namespace

std::vector<FrontPoint> paretoFront(const WorkPrecision& work, Measure by, double least) {
    std::vector<FrontPoint> all, front;
    for (const WorkCurve& curve : work.curves)
        for (const WorkPoint& point : curve.points)
            if (std::isfinite(point.*by) && point.*by >= least && std::isfinite(point.cost))
                all.push_back({curve.title, point});
    std::sort(all.begin(), all.end(), [by](const FrontPoint& a, const FrontPoint& b) {
        return a.point.cost != b.point.cost ? a.point.cost < b.point.cost
                                            : a.point.*by < b.point.*by;
    });
    for (FrontPoint& p : all)
        if (front.empty() || p.point.*by < front.back().point.*by) front.push_back(std::move(p));
    return front;
}

WorkPrecision measureWorkPrecision(AccuracyScene scene, const std::vector<Subject>& subjects,
                                   const CostOptions& options) {
    WorkPrecision result{std::move(scene), {}};
    for (const Subject& subject : subjects) {
        if (subject.plays && !subject.plays(result.scene)) continue;
        WorkCurve curve{subject.key, subject.title, subject.ours, {}, subject.colour};
        for (const int rate : subject.rates) {
            const auto ticks = std::lround(result.scene.interval * rate) *
                               static_cast<long>(result.scene.path.size());
            const double begin = processorTime();
            const auto run = subject.start(result.scene, rate);
            WorkPoint point = follow(result.scene, *run, rate);
            if (std::isfinite(point.error))
                point.cost = medianTime(result.scene, subject, rate, ticks, options);
            curve.points.push_back(point);
            if (point.cost > options.most || processorTime() - begin > 8 * options.most) break;
        }
        result.curves.push_back(std::move(curve));
    }
    return result;
}

}  // namespace sulfur::lab
