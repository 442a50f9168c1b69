#include <cmath>
#include <quaoar/tick_input.hpp>

namespace quaoar {

void setAim(TickInput& input, double x, double y) {
    const double length = std::hypot(x, y);
    if (!std::isfinite(length) || length <= 0) return;
    input.aimX = static_cast<std::int16_t>(std::lround(32767 * (x / length)));
    input.aimY = static_cast<std::int16_t>(std::lround(32767 * (y / length)));
}

sulfur::Vec2 aimDirection(const TickInput& input) {
    const double x = input.aimX;
    const double y = input.aimY;
    if (input.aimX == 0 && input.aimY == 0) return {1, 0};
    const double length = std::sqrt(x * x + y * y);
    return {static_cast<sulfur::Real>(x / length), static_cast<sulfur::Real>(y / length)};
}

}  // namespace quaoar
