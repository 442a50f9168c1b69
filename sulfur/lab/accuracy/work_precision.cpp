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

double errorOf(const AccuracyScene& scene, Run& run, long ticksPerSample) {
    double largest = 0;
    for (const Vecs& places : scene.path) {
        run.advance(ticksPerSample);
        for (std::size_t k = 0; k < places.size(); ++k)
            largest = worst(largest, (run.position(scene.watched[k]) - places[k]).norm());
        if (!(largest < explosion)) return std::numeric_limits<double>::infinity();
    }
    return largest;
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

std::vector<FrontPoint> paretoFront(const WorkPrecision& work) {
    std::vector<FrontPoint> all, front;
    for (const WorkCurve& curve : work.curves)
        for (const WorkPoint& point : curve.points)
            if (std::isfinite(point.error) && std::isfinite(point.cost))
                all.push_back({curve.title, point});
    std::sort(all.begin(), all.end(), [](const FrontPoint& a, const FrontPoint& b) {
        return a.point.cost != b.point.cost ? a.point.cost < b.point.cost
                                            : a.point.error < b.point.error;
    });
    for (FrontPoint& p : all)
        if (front.empty() || p.point.error < front.back().point.error)
            front.push_back(std::move(p));
    return front;
}

WorkPrecision measureWorkPrecision(AccuracyScene scene, const std::vector<Subject>& subjects,
                                   const CostOptions& options) {
    WorkPrecision result{std::move(scene), {}};
    for (const Subject& subject : subjects) {
        if (subject.plays && !subject.plays(result.scene)) continue;
        WorkCurve curve{subject.key, subject.title, subject.ours, {}, subject.colour};
        for (const int rate : subject.rates) {
            const auto ticksPerSample = std::lround(result.scene.interval * rate);
            const auto ticks = ticksPerSample * static_cast<long>(result.scene.path.size());
            const double begin = processorTime();
            const auto run = subject.start(result.scene, rate);
            WorkPoint point{.rate = rate, .error = errorOf(result.scene, *run, ticksPerSample)};
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
