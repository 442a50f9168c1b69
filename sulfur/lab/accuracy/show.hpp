// How work-precision diagrams are shown.
#pragma once

#include <string>
#include <vector>

#include "accuracy/work_precision.hpp"

namespace sulfur::lab {

std::string asText(const std::vector<WorkPrecision>& scenes, const CostOptions& options);
std::string asCsv(const std::vector<WorkPrecision>& scenes);
std::string asJson(const std::vector<WorkPrecision>& scenes);
/// Error, or the measure that is asked for, against run time on logarithmic axes, one line a
/// method, one mark a rate.
std::string asSvg(const WorkPrecision& scene, Measure by = &WorkPoint::error);

}  // namespace sulfur::lab
