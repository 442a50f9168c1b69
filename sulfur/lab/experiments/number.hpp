// What an option that takes a number allows.
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>

namespace sulfur::lab {

/// A number from `low` to `high`. CLI::Range asks whether a number lies outside, which "nan" never
/// does: this asks whether it lies inside.
template <class Number>
CLI::Validator between(Number low, Number high) {
    std::ostringstream range;
    range << low << " to " << high;
    const auto check = [low, high, allowed = range.str()](const std::string& text) {
        Number value{};
        const bool inside = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return inside ? "" : '"' + text + "\" is no number from " + allowed;
    };
    return {check, range.str()};
}

}  // namespace sulfur::lab
