// What collides: corners and sides of bodies, in chunks that the broad phase keeps apart.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "core/range_pool.hpp"
#include "model/movers.hpp"

namespace sulfur::detail {

/// A particle at which colliders end.
struct Corner {
    std::uint32_t particle = none;
    std::uint32_t mover = 0;
    Real x = 0, y = 0;             // m, in the frame of the mover
    Real radius = 0;               // m, of the thickest collider that ends there
    std::uint32_t surface = none;  // the joint whose surface it shows, or none: its body's
    std::uint32_t firstSpoke = 0, spokes = 0;  // corners at the other ends of its capsules
    std::uint32_t owned = 0;  // 1: of all corners of its particle this one is held off others
};

/// A capsule between two corners; a disc where both are the same.
struct Side {
    std::uint32_t a = 0, b = 0;
    std::uint32_t joint = none;  // or none for a disc
    std::int32_t outward = 0;    // +1: outside is to the right of the way from a to b, -1: to the
                                 // left, 0: on both sides
    Real radius = 0;             // m
    // Where it has one mover, in its frame: the line that it is on, and what part of that. Of an
    // arc the outward normal of its circle in its middle, where that is, and minus the circle's
    // radius.
    Real outX = 0, outY = 0, offset = 0, middle = 0, half = 0;
};

/// m, of the circle on which the axis of a side is; 0: it is straight.
inline Real arcRadius(const Side& side) {
    return side.half < 0 ? -side.half : Real(0);
}

/// What one mover carries of a chunk; those of one mover are a list.
struct ChunkUse {
    std::uint32_t chunk = none, mover = none, next = none;
};

enum class ChunkKind : std::uint32_t {
    convex,  // a convex outline of one mover, or a lone capsule or disc of one: corners in order
    loose,   // up to a few sides, whose corners may move by themselves
};

/// Colliders of one body that the broad phase holds in one box.
struct Chunk {
    std::uint32_t body = none;  // dense index, or none where the slot is free
    ChunkKind kind = ChunkKind::loose;
    std::uint32_t frame = 0;  // mover whose odometer counts
    // Its own; those of its sides may be others'. Behind them come the centres of its arcs.
    std::uint32_t firstCorner = 0, corners = 0;
    std::uint32_t firstSide = 0, sides = 0;
    std::uint32_t firstUse = 0, uses = 0;
    std::uint32_t nextOfBody = none;
    double leaveAt = 0;                         // m, of its frame's odometer, when it may leave
                                                // its box of the broad phase
    Real radius = 0;                            // m, the largest
    Real fineness = 0;                          // m, the least radius
    std::uint32_t firstPair = none, pairs = 0;  // in the pair table
    std::uint32_t owned = 0;    // of these, those with larger ones: they count as its own
    std::uint32_t crowded = 0;  // 1: it may be near more of them than it may have pairs with
    // In the broad phase.
    std::array<double, 2> low{0, 0}, high{0, 0};  // m, the box that it stays in
    std::uint32_t cell = none, nextInCell = none, previousInCell = none;
    std::uint32_t level = 0;
};

/// How many sides of a chunk are arcs.
inline std::uint32_t arcsOf(const std::vector<Side>& sides, const Chunk& chunk) {
    std::uint32_t count = 0;
    for (auto s = chunk.firstSide; s < chunk.firstSide + chunk.sides; ++s)
        count += arcRadius(sides[s]) > 0 ? 1 : 0;
    return count;
}

/// All colliders of a world. What is derived of one body comes and goes with it.
struct Shapes {
    std::vector<Corner> corners;
    std::vector<Side> sides;
    std::vector<ChunkUse> uses;
    std::vector<std::uint32_t> spokes;
    std::vector<Chunk> chunks;
    std::vector<std::uint32_t> freeChunks;
    RangePool cornerPool, sidePool, usePool, spokePool;
    std::vector<std::uint32_t> firstChunk;  // by body slot, or none
    /// By slot of a particle that moves by itself, or of the first of a rigid component; or none.
    std::vector<std::uint32_t> moverOfParticle;

    template <class Archive>
    void archive(Archive& a) {
        a(corners);
        a(sides);
        a(uses);
        a(spokes);
        a(chunks);
        a(freeChunks);
        a(cornerPool);
        a(sidePool);
        a(usePool);
        a(spokePool);
        a(firstChunk);
        a(moverOfParticle);
    }
};

}  // namespace sulfur::detail
