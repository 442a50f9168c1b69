// What collides of a body goes with it.
#include "core/room.hpp"
#include "model/state.hpp"
#include "shape/make_shapes.hpp"

namespace sulfur::detail {

namespace {

/// Takes a chunk off the list of a mover; one that carries nothing more goes.
void endUse(State& state, std::uint32_t use, std::uint32_t mover) {
    Shapes& shapes = state.core.shapes;
    Movers& movers = state.core.movers;
    auto* link = &movers.firstUse[mover];
    while (*link != use) link = &shapes.uses[*link].next;
    *link = shapes.uses[use].next;
    shapes.uses[use] = {};
    if (movers.firstUse[mover] != none) return;
    if (const auto particle = movers.particle[mover]; particle != none)
        shapes.moverOfParticle[particle] = none;
    if (const auto body = state.bodySlots.denseOf(movers.body[mover]);
        body != none && state.bodies[body].frame == mover)
        state.bodies[body].frame = none;
    movers.remove(mover);
}

}  // namespace

void makeRoomToDrop(State& state, std::uint32_t bodySlot) {
    Shapes& shapes = state.core.shapes;
    makeRoomFor(state.core.movers.free, state.core.movers.size());
    makeRoomFor(shapes.freeChunks, shapes.chunks.size());
    if (bodySlot >= shapes.firstChunk.size()) return;
    // As if all ranges of a kind were of one length.
    std::size_t chunks = 0, corners = 0;
    for (auto c = shapes.firstChunk[bodySlot]; c != none; c = shapes.chunks[c].nextOfBody) {
        ++chunks;
        corners += shapes.chunks[c].corners;
    }
    for (auto c = shapes.firstChunk[bodySlot]; c != none; c = shapes.chunks[c].nextOfBody) {
        const Chunk& chunk = shapes.chunks[c];
        for (auto k = chunk.firstCorner; k < chunk.firstCorner + chunk.corners; ++k)
            shapes.spokePool.makeRoomToRelease(shapes.corners[k].spokes, corners);
        shapes.cornerPool.makeRoomToRelease(chunk.corners + arcsOf(shapes.sides, chunk), chunks);
        shapes.sidePool.makeRoomToRelease(chunk.sides, chunks);
        shapes.usePool.makeRoomToRelease(chunk.uses, chunks);
    }
}

void dropShape(State& state, std::uint32_t bodySlot) {
    Shapes& shapes = state.core.shapes;
    if (bodySlot >= shapes.firstChunk.size()) return;
    for (auto c = shapes.firstChunk[bodySlot]; c != none;) {
        const Chunk chunk = shapes.chunks[c];
        for (auto k = chunk.firstCorner; k < chunk.firstCorner + chunk.corners; ++k)
            shapes.spokePool.release(shapes.corners[k].firstSpoke, shapes.corners[k].spokes);
        if (chunk.uses > 1) state.core.movers.remove(chunk.frame);
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            endUse(state, u, shapes.uses[u].mover);
        shapes.cornerPool.release(chunk.firstCorner, chunk.corners + arcsOf(shapes.sides, chunk));
        shapes.sidePool.release(chunk.firstSide, chunk.sides);
        shapes.usePool.release(chunk.firstUse, chunk.uses);
        shapes.chunks[c] = {};
        shapes.freeChunks.push_back(c);
        c = chunk.nextOfBody;
    }
    shapes.firstChunk[bodySlot] = none;
}

}  // namespace sulfur::detail
