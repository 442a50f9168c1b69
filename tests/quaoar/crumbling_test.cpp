// What comes loose, breaks and comes back, and what becomes of a rope that is tied to it.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

const std::string shelf =
    withBody(roomWith(R"("surfaces": {"shelf": {"crumbles": 0.5}})"), "shelf",
             R"("shape": "box", "size": [1, 0.2], "mass": 3, "kind": "fixed")", "[0, 2]");

TEST(Crumbling, WhatIsHookedComesLooseAfterItsTime) {
    Session session(room(shelf));
    play(session, fireAt(0, 1), 60);
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
    const sulfur::BodyId body = session.instance().body("shelf");
    EXPECT_EQ(session.rope().hooked(session.world()), body);
    play(session, fireAt(0, 1), 150);
    EXPECT_NEAR(placeOf(session, "shelf").y(), 2, 1e-6);
    EXPECT_GT(session.workings().crumbling.worn(body), 0.5);
    EXPECT_LT(session.workings().crumbling.worn(body), 1);
    bool crumbled = false;
    for (int n = 0; n < 200; ++n) {
        session.tick(fireAt(0, 1));
        crumbled = crumbled || session.events().crumbled;
    }
    EXPECT_TRUE(crumbled);
    EXPECT_EQ(session.workings().crumbling.worn(body), 1);
    EXPECT_LT(placeOf(session, "shelf").y(), 1.9);
    EXPECT_EQ(session.rope().state(), Rope::State::attached);  // it follows what it is tied to
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Crumbling, TimeCountsOnlyWhileItIsTouched) {
    Session session(room(shelf));
    play(session, fireAt(0, 1), 130);
    play(session, {}, 1000);
    EXPECT_NEAR(placeOf(session, "shelf").y(), 2, 1e-6);
    put(session, 0, 2.23);
    play(session, {}, 400);
    EXPECT_LT(placeOf(session, "shelf").y(), 1.9);
}

TEST(Crumbling, APinnedWallFallsToPieces) {
    const std::string wall =
        withBody(roomWith(R"("surfaces": {"wall": {"crumbles": 0.1}})"), "wall",
                 R"("shape": "wall", "size": [0.8, 0.4], "columns": 4, "rows": 2, "mass": 4,
           "strength": 60, "kind": "fixed")",
                 "[0, 2]");
    Session session(room(wall));
    play(session, fireAt(0, 1), 60);
    std::size_t broken = 0;
    for (int n = 0; n < 800; ++n) {
        session.tick(fireAt(0, 1));
        broken += session.world().events().jointsBroken.size();
        ASSERT_EQ(session.world().validate(), "") << "tick " << n;
    }
    EXPECT_GT(broken, 4u);
}

TEST(Crumbling, ARopeFollowsThePieceOrLetsGo) {
    // An icicle on a weak neck, of which the upper end is held: the load of the hero breaks it.
    const std::string icicle =
        withBody(roomText, "icicle",
                 R"("particles": [{"position": [0, 0], "mass": 1, "pinned": true},
                         {"position": [0, -0.3], "mass": 1}, {"position": [0, -0.8], "mass": 1}],
           "joints": [{"a": 0, "b": 1, "radius": 0.05, "strength": 35},
                      {"a": 1, "b": 2, "radius": 0.05}])",
                 "[0, 2.7]");
    Session session(room(icicle));
    put(session, 0.05, 0.9);
    std::size_t broken = 0;
    bool hooked = false;
    for (int n = 0; n < 700; ++n) {
        session.tick(fireAt(0, 1));
        hooked =
            hooked || session.rope().hooked(session.world()) == session.instance().body("icicle");
        broken += session.world().events().jointsBroken.size();
        ASSERT_EQ(session.world().validate(), "");
        if (session.rope().state() != Rope::State::attached) continue;
        EXPECT_TRUE(session.world().contains(session.rope().hooked(session.world())));
    }
    EXPECT_TRUE(hooked);
    EXPECT_EQ(broken, 1u);
    EXPECT_LT(session.heroPosition().y(), 0.5);  // fallen, with the ice or without
}

TEST(Crumbling, RespawnsComeBackInTime) {
    Session session(room(roomWith(R"("respawns": [{"body": "box-1", "every": 1, "phase": 0.5}])",
                                  replaced(roomText, "[-2, 0.3]", "[-2, 2.5]"))));
    const sulfur::BodyId box = session.instance().body("box-1");
    EXPECT_FALSE(session.world().isEnabled(box));
    play(session, {}, 250);
    EXPECT_FALSE(session.world().isEnabled(box));
    session.tick({});
    EXPECT_TRUE(session.events().respawned);
    EXPECT_TRUE(session.world().isEnabled(box));
    play(session, {}, 490);
    EXPECT_LT(placeOf(session, "box-1").y(), 0.4);
    play(session, {}, 10);
    EXPECT_GT(placeOf(session, "box-1").y(), 2.4);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Crumbling, ARopeOnWhatComesBackIsLetGo) {
    Session session(room(roomWith(R"("respawns": [{"body": "box-1", "every": 2}])",
                                  replaced(roomText, "[-2, 0.3]", "[1.5, 1.5]"))));
    play(session, {}, 600);
    put(session, 0.7, 0.25);
    play(session, fireAt(1, 0), 60);
    ASSERT_EQ(session.rope().hooked(session.world()), session.instance().body("box-1"));
    play(session, fireAt(1, 0), 400);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Crumbling, HashesAndSnapshots) {
    const auto hashes = threeWays(room(shelf), [](Session& session) {
        play(session, fireAt(0, 1), 500);
        play(session, {}, 200);
    });
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace quaoar::test
