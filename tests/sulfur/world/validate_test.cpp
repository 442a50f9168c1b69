// What a snapshot that somebody has forged may say in its lists.
#include "world/validate.hpp"

#include <gtest/gtest.h>

namespace sulfur::detail {
namespace {

/// An empty world, as an archive would have read it.
State emptyState() {
    State state;
    state.h = 1;
    state.lastStep = 1;
    return state;
}

TEST(Validate, AnEmptyWorldIsSound) {
    EXPECT_EQ(findBroken(emptyState()), "");
}

TEST(Validate, ListsNameNoBodiesThatThereAreNot) {
    const char* const refusal = "a list of bodies that there are not";
    for (auto list : {&ContactCore::passedBy, &ContactCore::linked, &ContactCore::linkedBodies}) {
        State state = emptyState();
        (state.core.*list).emplace_back(0, 0);
        EXPECT_EQ(findBroken(state), refusal);
    }
    for (auto list : {&State::placed, &State::turned}) {
        State state = emptyState();
        (state.*list).push_back(0);
        EXPECT_EQ(findBroken(state), refusal);
    }
    State state = emptyState();
    state.core.staleShapes.push_back(0);
    EXPECT_EQ(findBroken(state), refusal);
}

TEST(Validate, MoversAndShapesAreOfBodiesThatThereAre) {
    State state = emptyState();
    state.core.movers.body[0] = 0;
    EXPECT_EQ(findBroken(state), "mover of a body that there is not (index 0)");
    state = emptyState();
    state.core.movers.free.push_back(1);
    EXPECT_EQ(findBroken(state), "arrays of movers of different lengths");
    state = emptyState();
    state.core.shapes.chunks.emplace_back().body = 0;
    EXPECT_EQ(findBroken(state), "shape of a body that there is not (index 0)");
}

TEST(Validate, ListsNameNoContactsThatThereAreNot) {
    for (auto list : {&ContactCore::freePairs, &ContactCore::struck, &ContactCore::freeTouches,
                      &ContactCore::freeEncounters, &ContactCore::changedEncounters,
                      &ContactCore::struckEncounters, &ContactCore::leading}) {
        State state = emptyState();
        (state.core.*list).push_back(0);
        EXPECT_EQ(findBroken(state), "a list of contacts that there are not");
    }
    State state = emptyState();
    state.core.watches.emplace_back();
    EXPECT_EQ(findBroken(state), "rooms of other pairs");
    state.core.rooms.emplace_back();
    EXPECT_EQ(findBroken(state), "watch over a pair that there is not (index 0)");
    state = emptyState();
    state.core.pairs.emplace_back().a = 0;
    EXPECT_EQ(findBroken(state), "pair of shapes that there are not (index 0)");
}

/// Found by the fuzz target snapshots: what solves them is made in their order.
TEST(Validate, NetworksAreNumberedInTheirOrder) {
    for (const std::uint32_t number : {1u, 0x7fffffffu}) {
        State state = emptyState();
        Tree tree;
        tree.last = 1;
        tree.steps = 1;
        tree.network = number;
        state.trees.list.push_back(tree);
        state.trees.nodes.emplace_back();
        EXPECT_EQ(findBroken(state), "network under another number (index 0)");
    }
}

}  // namespace
}  // namespace sulfur::detail
