// Zones of the world.
#pragma once

#include <sulfur/fields.hpp>

namespace sulfur::detail {

inline bool contains(const Zone& zone, const Point& p) {
    if (const auto* box = std::get_if<BoxZone>(&zone))
        return (p.array() >= box->low.array()).all() && (p.array() <= box->high.array()).all();
    if (const auto* circle = std::get_if<CircleZone>(&zone))
        return (p - circle->centre).norm() <= static_cast<double>(circle->radius);
    return true;
}

}  // namespace sulfur::detail
