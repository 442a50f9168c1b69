#include "parts.hpp"

#include <sstream>

#include "core/error_checks.hpp"

namespace sulfur::detail {

void addLobes(Blueprint& plan, const std::vector<Point>& lobes, const Bracing& bracing) {
    const auto count = static_cast<std::uint32_t>(lobes.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        plan.particles.push_back({.position = lobes[i].cast<Real>()});
        for (const auto corner : {(i + count - 1) % count, i, (i + 1) % count})
            join(plan, corner, count + i, 0, bracing);
    }
}

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
