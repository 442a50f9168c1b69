// What ours took in the past, in a file to which each comparison adds.
#pragma once

#include <string>

#include "bench/compare.hpp"

namespace sulfur::lab::bench {

/// More than this share above the last entry is a regression.
inline constexpr double regression = 0.15;

/// Today as YYYY-MM-DD, by the clock, UTC.
std::string today();
/// Throws std::runtime_error unless `date` is YYYY-MM-DD.
void checkDate(const std::string& date);

/// Compares the rows of ours with the last entry of each in `file`, and adds them with `date`. A
/// file that is not there is made; its folder must be. A line that is no entry stops it with
/// std::runtime_error before anything is written; what was in the file is never changed. Rows that
/// the limit stopped are left out. Returns what changed, for people.
std::string keepHistory(const std::string& file, const std::string& date,
                        const Comparison& comparison);

}  // namespace sulfur::lab::bench
