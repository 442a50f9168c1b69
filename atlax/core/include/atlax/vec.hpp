#pragma once

#include <cmath>
#include <concepts>

namespace atlax {

/// A point or a direction: metres in world space (y up), pixels in screen space
/// (y down, origin at the top left corner of the window). Like all types here a plain value: any
/// thread, nothing throws.
struct Vec2 {
    float x = 0;
    float y = 0;

    constexpr Vec2() = default;
    constexpr Vec2(float xValue, float yValue) : x(xValue), y(yValue) {}

    /// From any vector type with x() and y(), such as those of a physics or linear
    /// algebra library, so that callers need no conversion and atlax no dependency.
    template <class V>
    requires requires(const V& v) {
        { v.x() } -> std::convertible_to<float>;
        { v.y() } -> std::convertible_to<float>;
    }
    constexpr Vec2(const V& v)  // NOLINT: implicit on purpose
        : x(static_cast<float>(v.x())), y(static_cast<float>(v.y())) {}

    constexpr Vec2 operator+(Vec2 o) const { return {x + o.x, y + o.y}; }
    constexpr Vec2 operator-(Vec2 o) const { return {x - o.x, y - o.y}; }
    constexpr Vec2 operator-() const { return {-x, -y}; }
    constexpr Vec2 operator*(float s) const { return {x * s, y * s}; }
    constexpr Vec2 operator/(float s) const { return {x / s, y / s}; }
    constexpr Vec2& operator+=(Vec2 o) { return *this = *this + o; }
    constexpr Vec2& operator-=(Vec2 o) { return *this = *this - o; }
    constexpr Vec2& operator*=(float s) { return *this = *this * s; }
    constexpr bool operator==(const Vec2&) const = default;
};

constexpr Vec2 operator*(float s, Vec2 v) {
    return v * s;
}
constexpr float dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the cross product: positive when b lies to the left of a (y up).
constexpr float cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// Turned by +90 degrees (counter-clockwise with y up).
constexpr Vec2 perpendicular(Vec2 v) {
    return {-v.y, v.x};
}
inline float length(Vec2 v) {
    return std::hypot(v.x, v.y);
}
/// Unit vector; the zero vector stays zero.
inline Vec2 normalized(Vec2 v) {
    const float l = length(v);
    return l > 0 ? v / l : Vec2{};
}
constexpr Vec2 lerp(Vec2 a, Vec2 b, float t) {
    return a + (b - a) * t;
}

/// An axis-aligned rectangle: the corner with the lowest coordinates (bottom left in
/// world space, top left in screen space) and a size that is not negative.
struct Rect {
    Vec2 min;
    Vec2 size;

    constexpr Vec2 max() const { return min + size; }
    constexpr Vec2 centre() const { return min + size * 0.5f; }
    constexpr bool contains(Vec2 p) const {
        return p.x >= min.x && p.y >= min.y && p.x < max().x && p.y < max().y;
    }
    static constexpr Rect around(Vec2 centre, Vec2 size) { return {centre - size * 0.5f, size}; }
    constexpr bool operator==(const Rect&) const = default;
};

/// A size in pixels of a window, an image or a render target.
struct PixelSize {
    int width = 0;
    int height = 0;

    constexpr Vec2 toVec() const { return {static_cast<float>(width), static_cast<float>(height)}; }
    constexpr bool empty() const { return width <= 0 || height <= 0; }
    constexpr bool operator==(const PixelSize&) const = default;
};

}  // namespace atlax
