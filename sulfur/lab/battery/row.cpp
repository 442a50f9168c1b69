#include "battery/row.hpp"

namespace sulfur::lab {

Row atMost(std::string name, double measured, double bound) {
    // NaN compares as false, so it fails.
    return {std::move(name), measured, bound, measured <= bound};
}

}  // namespace sulfur::lab
