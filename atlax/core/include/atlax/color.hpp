#pragma once

#include <cstdint>

namespace atlax {

/// A colour with straight (not premultiplied) alpha. Components are sRGB-encoded in
/// 0..1, as in design programs; the canvas premultiplies and blends in that space. A
/// plain value: any thread, nothing throws.
struct Color {
    float r = 1;
    float g = 1;
    float b = 1;
    float a = 1;

    /// From a number as in style sheets: Color::hex(0xFFB347) is amber.
    static constexpr Color hex(std::uint32_t rrggbb, float alpha = 1) {
        return {static_cast<float>((rrggbb >> 16) & 255u) / 255.0f,
                static_cast<float>((rrggbb >> 8) & 255u) / 255.0f,
                static_cast<float>(rrggbb & 255u) / 255.0f, alpha};
    }
    constexpr Color withAlpha(float alpha) const { return {r, g, b, alpha}; }
    constexpr Color faded(float factor) const { return {r, g, b, a * factor}; }
    constexpr bool operator==(const Color&) const = default;
};

constexpr Color mix(Color from, Color to, float t) {
    return {from.r + (to.r - from.r) * t, from.g + (to.g - from.g) * t,
            from.b + (to.b - from.b) * t, from.a + (to.a - from.a) * t};
}

namespace colors {
inline constexpr Color white{1, 1, 1, 1};
inline constexpr Color black{0, 0, 0, 1};
inline constexpr Color transparent{0, 0, 0, 0};
}  // namespace colors

}  // namespace atlax
