#include "battery/row.hpp"

#include <fmt/format.h>

#include <limits>

namespace sulfur::lab {

Row atMost(std::string name, double measured, double bound) {
    // NaN compares as false, so it fails.
    return {std::move(name), measured, bound, measured <= bound};
}

Row reported(std::string name, double measured) {
    return atMost(std::move(name), measured, std::numeric_limits<double>::infinity());
}

Row fallsShort(const std::string& name, double measured, double reached, double asked) {
    return atMost(fmt::format("{} [short of {:g}]", name, asked), measured, reached);
}

}  // namespace sulfur::lab
