#include "load.hpp"

#include <cmath>

using namespace atlax;

namespace {

constexpr int sheets = 100;
constexpr int columns = 25;  // two triangles in each cell of a sheet
constexpr int rows = 20;
constexpr int capsuleCount = 10'000;

float part(int i, int n) {
    return static_cast<float>(i) / static_cast<float>(n);
}

}  // namespace

Load::Load() {
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x)
            sheet_.push_back(
                {{part(x, columns), part(y, rows)}, {part(x, columns), part(y, rows)}});
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const std::uint32_t a = y * (columns + 1) + x;
            const std::uint32_t b = a + columns + 1;
            indices_.insert(indices_.end(), {a, a + 1, b, a + 1, b + 1, b});
        }
    for (int i = 0; i < capsuleCount; ++i) {
        const Vec2 at{part(i % 125, 125) * 18 - 9, part(i / 125, 80) * 9 - 0.5f};
        const float a = part(i, 97) * 6.2831853f;
        capsules_.push_back({at, at + Vec2{std::cos(a), std::sin(a)} * 0.08f,
                             Color{part(i % 7, 7), 0.6f, part(i % 11, 11), 0.8f}});
    }
}

void Load::draw(Canvas& canvas, const Texture& texture, float angle) const {
    std::vector<MeshVertex> moved = sheet_;
    for (int i = 0; i < sheets; ++i) {
        const Vec2 corner{part(i % 10, 10) * 16 - 8, part(i / 10, 10) * 9 - 0.5f};
        const float sway = 0.1f * std::sin(angle + static_cast<float>(i));
        for (std::size_t v = 0; v < moved.size(); ++v)
            moved[v].position = corner + sheet_[v].position * 0.8f + Vec2{sway, 0};
        canvas.mesh(texture, moved, indices_);
    }
    for (const Capsule& c : capsules_) canvas.capsule(c.from, c.to, 0.02f, c.color);
}
