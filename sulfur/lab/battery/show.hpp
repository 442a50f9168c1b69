// How the rows of the battery are shown.
#pragma once

#include <string>
#include <vector>

#include "battery/row.hpp"

namespace sulfur::lab {

/// The rows of one group.
struct GroupResult {
    std::string key, title;
    Rows rows;
};

std::string asText(const std::vector<GroupResult>& groups, const Setup& setup);
std::string asCsv(const std::vector<GroupResult>& groups);
std::string asJson(const std::vector<GroupResult>& groups, const Setup& setup);
/// Whether all rows passed.
bool allPassed(const std::vector<GroupResult>& groups);

}  // namespace sulfur::lab
