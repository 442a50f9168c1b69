// Ways to find which of many capsules might touch, measured against all pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sulfur::lab {

/// Random capsules of one size, in units of a cell, dense enough that each touches a few others.
struct CapsuleCase {
    double length = 1, thickness = 0.1;
    int count = 2000;
};

/// What a way of finding pairs found and cost.
struct MethodResult {
    std::string key, title;
    double cells = 0;        ///< that a capsule is entered in, on average
    std::size_t pairs = 0;   ///< that it found
    std::size_t missed = 0;  ///< of those that touch
    double seconds = 0;      ///< a capsule: entering, sorting, finding pairs; the median
};

struct CaseResult {
    CapsuleCase capsules;
    std::size_t touching = 0;  ///< pairs, by the distance of each
    std::vector<MethodResult> methods;
};

/// The literal line, the widened one, all cells of the bounding box, and all pairs. The median of
/// `repeats` measurements.
CaseResult measureMethods(const CapsuleCase& capsules, int repeats);

}  // namespace sulfur::lab
