// The kernel of area_look.hpp, for the vectors of LANE_BYTES that the including file has set.
#include "kernels/lanes.ipp"

namespace sulfur::detail {

namespace {

/// The same as areaAhead() in solver/areas.cpp, of the triangles from `k` on.
inline Lanes areasAhead(const AreaView& t, std::size_t k) {
    const Places a = gather(t.displacement, t.a + k);
    const auto way = [&](const std::uint32_t* to) {
        const Places start = between(t.position, t.a + k, to);
        const Places moved = gather(t.displacement, to);
        return Places{start.x + (moved.x - a.x), start.y + (moved.y - a.y)};
    };
    const Places toB = way(t.b + k), toC = way(t.c + k);
    return toB.x * toC.y - toB.y * toC.x;
}

void look(const AreaView& triangles, SweepReal share, std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
        std::uint32_t flat = 0;
        for (std::size_t i = 0; i < 8; i += width) {
            const Lanes least = share * load(triangles.rest + 8 * block + i);
            const auto enough = areasAhead(triangles, 8 * block + i) >= least;
            flat |= (bits(enough) ^ everyLane) << i;
        }
        triangles.flat[block] = static_cast<std::uint8_t>(flat);
    }
}

}  // namespace

}  // namespace sulfur::detail
