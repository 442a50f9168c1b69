#include "battery/row.hpp"

#include <limits>

namespace sulfur::lab {

Row atMost(std::string name, double measured, double bound) {
    // NaN compares as false, so it fails.
    return {std::move(name), measured, bound, measured <= bound};
}

Row reported(std::string name, double measured) {
    return atMost(std::move(name), measured, std::numeric_limits<double>::infinity());
}

}  // namespace sulfur::lab
