// Boxes follow what moves; pairs come and go with them.
#include <algorithm>
#include <array>
#include <cstdint>

#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

bool isFixedChunk(const State& state, const Chunk& chunk) {
    return state.bodies[state.bodySlots.denseOf(chunk.body)].kind == BodyKind::fixed;
}

}  // namespace

void updateBoxes(State& state) {
    ContactCore& core = state.core;
    const auto renew = [&](std::uint32_t index) {
        Chunk& chunk = core.shapes.chunks[index];
        const double step = core.ahead[chunk.frame] - core.movers.odometer[chunk.frame];
        std::array<double, 2> low{1e300, 1e300}, high{-1e300, -1e300};
        for (auto k = chunk.firstCorner; k < chunk.firstCorner + chunk.corners; ++k) {
            const Corner& corner = core.shapes.corners[k];
            const SolverBody& body = core.movers.bodies[corner.mover];
            const Heading h = core.movers.headingAtReference(corner.mover);
            const Real cosine = h.cosine - h.sine * body.turn, sine = h.sine + h.cosine * body.turn;
            const Point from = core.movers.placeAtReference(corner.mover);
            const double at[2] = {
                from[0] + static_cast<double>(body.x + cosine * corner.x - sine * corner.y),
                from[1] + static_cast<double>(body.y + sine * corner.x + cosine * corner.y)};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                low[axis] = std::min(low[axis], at[axis]);
                high[axis] = std::max(high[axis], at[axis]);
            }
        }
        // The turn to first order is wrong by half its square times the reach: a hundredth of it.
        const double extent =
            std::max(high[0] - low[0], high[1] - low[1]) + 2 * static_cast<double>(chunk.radius);
        const double room = isFixedChunk(state, chunk) ? 0 : 0.1 * extent + 6 * step;
        const double around = static_cast<double>(chunk.radius) + room + 0.01 * extent;
        ++state.statistics.boxes;
        core.grid.remove(core.shapes.chunks, index);
        chunk.low = {low[0] - around, low[1] - around};
        chunk.high = {high[0] + around, high[1] + around};
        chunk.leaveAt = core.movers.odometer[chunk.frame] + room;
        core.grid.insert(core.shapes.chunks, index);
        updatePairs(state, index);
    };
    for (const auto c : core.newChunks) renew(c);
    core.newChunks.clear();
    // Who waits for room asks now and then, because all around him do.
    const auto asks = [&](std::uint32_t c, const Chunk& chunk) {
        return chunk.crowded != 0 && chunk.owned < tuned::mostPairs &&
               (stepNumber(state) + c) % tuned::rounds == 0;
    };
    const Chunk* const chunks = core.shapes.chunks.data();
    const double *const ahead = core.ahead.data(), *const odometer = core.movers.odometer.data();
    // Sleepers wake a step before they are touched, so that they must be met by then.
    const double early = state.work.sleepers > 0 ? 1 : 0;
    for (const auto c : core.awakeChunks) {
        const auto frame = chunks[c].frame;
        const double reached = ahead[frame] + early * (ahead[frame] - odometer[frame]);
        if (reached >= chunks[c].leaveAt || asks(c, chunks[c])) renew(c);
    }
}

}  // namespace sulfur::detail
