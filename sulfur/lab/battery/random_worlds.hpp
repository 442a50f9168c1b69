// Random worlds as a group of the battery.
#pragma once

#include <string>

#include "battery/row.hpp"

namespace sulfur::lab {

/// For each law how many of the seeds break it (none may), and a row for each breach with the seed,
/// the law and the tick. `setup.seeds`, or 1 to 1,000 (quick: 50).
Rows randomWorlds(const Setup& setup);

/// Makes the scene of each failing seed smaller as long as the law stays broken, and returns it as
/// C++ that can be kept as a test.
std::string shrunkWorlds(const Setup& setup);

}  // namespace sulfur::lab
