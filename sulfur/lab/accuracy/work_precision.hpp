// Error against run time.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "accuracy/subjects.hpp"

namespace sulfur::lab {

struct CostOptions {
    double least = 2e-3;  ///< s of processor time that one measurement lasts at least
    int repeats = 5;      ///< measurements; their median counts
    double most = 1;      ///< s: a subject goes no further in its rates when a run takes longer
};

/// One method at one rate.
struct WorkPoint {
    int rate = 0;      ///< Hz
    double error = 0;  ///< m, as AccuracyScene says; infinite when it exploded (see explosion)
    double cost = std::numeric_limits<double>::quiet_NaN();  ///< s of processor time for the scene,
                                                             ///< stepping only; NaN when exploded
    double strain = 0;  ///< the largest of a rigid joint, or opening of a pin in metres, at the end
                        ///< of any tick; infinite when it exploded
};

/// An error beyond this, m, or one that is not finite, is an explosion: no scene is that large.
inline constexpr double explosion = 10;

struct WorkCurve {
    std::string key, title;
    bool ours = false;
    std::vector<WorkPoint> points;
    std::string colour = {};  ///< as the subject's
};

struct WorkPrecision {
    AccuracyScene scene;
    std::vector<WorkCurve> curves;
};

/// A point of the Pareto front: no other point is as exact at less cost.
struct FrontPoint {
    std::string title;
    WorkPoint point;
};
/// By which error points are compared.
using Measure = double WorkPoint::*;
/// From the cheapest point to the most exact one; points that cost as much or more and are no more
/// exact are left out, and so are errors below `least`.
std::vector<FrontPoint> paretoFront(const WorkPrecision& work, Measure by = &WorkPoint::error,
                                    double least = 0);

WorkPrecision measureWorkPrecision(AccuracyScene scene, const std::vector<Subject>& subjects,
                                   const CostOptions& options);

}  // namespace sulfur::lab
