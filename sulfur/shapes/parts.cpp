#include "parts.hpp"

#include <sstream>

#include "core/error_checks.hpp"

namespace sulfur::detail {

void requireOuterSize(Vec2 size, Real radius) {
    requireFinite(size, "size");
    const double smallest = 2 * static_cast<double>(radius);
    for (int axis = 0; axis < 2; ++axis) {
        if (static_cast<double>(size[axis]) > smallest) continue;
        throw Error(ErrorCode::outOfRange, "size is " + std::to_string(size[axis]) +
                                               "; allowed is more than twice the radius, " +
                                               std::to_string(smallest));
    }
}

void refuseThickness(const char* what, Real radius) {
    std::ostringstream message;
    message << what << " is " << radius
            << ", so thick that the particles inside cannot have the moment of inertia of the "
               "solid; allowed is less, or a larger shape";
    throw Error(ErrorCode::outOfRange, message.str());
}

}  // namespace sulfur::detail
