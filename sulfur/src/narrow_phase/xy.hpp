// Small algebra of looks: plain numbers, so that all of it stays in registers.
#pragma once

#include <cmath>
#include <sulfur/math.hpp>

namespace sulfur::detail {

/// m, from the origin of a look; or a direction.
struct Xy {
    Real x = 0, y = 0;
};
inline Xy operator-(Xy a, Xy b) {
    return {a.x - b.x, a.y - b.y};
}
inline Xy operator+(Xy a, Xy b) {
    return {a.x + b.x, a.y + b.y};
}
inline Xy operator*(Real s, Xy a) {
    return {s * a.x, s * a.y};
}
inline Real dot(Xy a, Xy b) {
    return a.x * b.x + a.y * b.y;
}
inline Real cross(Xy a, Xy b) {
    return a.x * b.y - a.y * b.x;
}
inline Real norm(Xy a) {
    return std::sqrt(dot(a, a));
}

}  // namespace sulfur::detail
