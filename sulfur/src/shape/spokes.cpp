#include "shape/spokes.hpp"

#include <algorithm>
#include <vector>

namespace sulfur::detail {

namespace {

/// Whether two capsules of one mover go on in one line there: what meets them meets their
/// sides.
bool isFlat(const Shapes& shapes, const Corner& corner) {
    if (corner.spokes != 2) return false;
    const Corner &a = shapes.corners[shapes.spokes[corner.firstSpoke]],
                 &b = shapes.corners[shapes.spokes[corner.firstSpoke + 1]];
    if (a.mover != corner.mover || b.mover != corner.mover || (a.x == b.x && a.y == b.y))
        return false;
    const Vec2 u(a.x - corner.x, a.y - corner.y), v(b.x - corner.x, b.y - corner.y);
    return u.dot(v) < -Real(0.999999) * u.norm() * v.norm();
}

}  // namespace

void giveSpokes(Shapes& shapes, std::uint32_t bodySlot,
                const std::map<std::uint32_t, std::uint32_t>& hulls) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> ends;  // by particle slot: corners
    std::map<std::uint32_t, Real> thickest;                    // of these capsules, m
    std::map<std::uint32_t, std::uint32_t> owner;
    const auto forEachOwnChunk = [&](auto&& f) {
        std::vector<std::uint32_t> list;
        for (auto c = shapes.firstChunk[bodySlot]; c != none; c = shapes.chunks[c].nextOfBody)
            list.push_back(c);
        for (auto at = list.rbegin(); at != list.rend(); ++at) f(shapes.chunks[*at]);
    };
    if (shapes.firstChunk.size() <= bodySlot) return;
    forEachOwnChunk([&](const Chunk& chunk) {
        for (auto s = chunk.firstSide; s < chunk.firstSide + chunk.sides; ++s) {
            const Side& side = shapes.sides[s];
            if (side.a == side.b) continue;
            const bool bent = arcRadius(side) > 0;
            const auto hull = bent ? hulls.at(side.joint) : none;
            ends[shapes.corners[side.a].particle].push_back(bent ? hull : side.b);
            ends[shapes.corners[side.b].particle].push_back(bent ? hull + 1 : side.a);
            for (const auto end : {side.a, side.b}) {
                Real& radius = thickest[shapes.corners[end].particle];
                radius = std::max(radius, side.radius);
            }
        }
    });
    forEachOwnChunk([&](const Chunk& chunk) {
        for (auto c = chunk.firstCorner; c < chunk.firstCorner + chunk.corners; ++c) {
            Corner& corner = shapes.corners[c];
            if (corner.owned == cornerOfHull) {
                corner.owned = 0;
                continue;
            }
            auto& spokes = ends[corner.particle];
            // What a joint to another body makes thicker than all of them is a disc by itself.
            if (corner.radius > thickest[corner.particle]) spokes.clear();
            corner.spokes = static_cast<std::uint32_t>(spokes.size());
            corner.firstSpoke = shapes.spokePool.allocate(corner.spokes);
            shapes.spokes.resize(shapes.spokePool.size());
            std::copy(spokes.begin(), spokes.end(), shapes.spokes.begin() + corner.firstSpoke);
            const bool first = owner.try_emplace(corner.particle, c).first->second == c;
            corner.owned = first && !isFlat(shapes, corner) ? 1 : 0;
        }
    });
}

}  // namespace sulfur::detail
