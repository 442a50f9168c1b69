// How the comparison is shown.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/compare.hpp"

namespace sulfur::lab::bench {

/// A table for each size of each scene, then the stages, then what is missing.
std::string asText(const Comparison& comparison);
/// One line for each quantity of each row.
std::string asCsv(const Comparison& comparison);
std::string asJson(const Comparison& comparison);
/// Pictures with the names of their files: error against time for each size of each scene, and
/// time against size for S1.
std::vector<std::pair<std::string, std::string>> asSvg(const Comparison& comparison);

/// The colour of an engine in all pictures, as in CSS.
std::string colourOf(const std::string& engine);
/// A number as JSON has it: null when it is infinite or none.
std::string jsonNumber(double value);
/// A text as a field of CSV: in quotes where it has to be.
std::string csvField(const std::string& text);
/// A text as JSON has it, with its quotes.
std::string jsonText(const std::string& text);

}  // namespace sulfur::lab::bench
