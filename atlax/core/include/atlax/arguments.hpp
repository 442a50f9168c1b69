#pragma once

#include <functional>
#include <string>

namespace atlax {

/// Checks the text of a number on a command line: it must be a whole one, finite, and from `low` to
/// `high`. The function that is returned answers "" if it is, else a sentence that says what is
/// allowed. (Checks that only compare let "nan" through.) It owns all it needs, throws no errors of
/// its own, and may be called from any thread.
std::function<std::string(const std::string&)> between(double low, double high);

}  // namespace atlax
