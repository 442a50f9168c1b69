// Curves through points.
#pragma once

#include <atlax/vec.hpp>
#include <vector>

namespace quaoar {

/// A smooth curve through points (Catmull and Rom's), four pieces between two of them.
std::vector<atlax::Vec2> smoothCurve(const std::vector<atlax::Vec2>& points);

}  // namespace quaoar
