// Monsters: what they see, how they move, what they do to the rope, how they end.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

using Mood = Monsters::Mood;

const std::string slugBody =
    R"("shape": "jelly", "size": [0.6, 0.3], "columns": 5, "rows": 3, "mass": 3, "stiffness": 900,
       "damping": 2)";

std::string withSlug(const std::string& text = roomText, const std::string& at = "[2, 0.25]") {
    return withBody(text, "slug", slugBody, at);
}

std::shared_ptr<const Level> monstrous(const std::string& members, const std::string& text,
                                       const std::string& more = "") {
    return room(roomWith("\"monsters\": [{\"body\": \"slug\", " + members + "}]" + more, text));
}

Mood mood(const Session& session) {
    return session.workings().monsters.mood(0);
}

TEST(Monsters, APatrolCrawlsToAndFro) {
    Session session(
        monstrous(R"("behaviour": "patrol", "between": [1, 3], "speed": 0.8)", withSlug()));
    put(session, -3, 0.3);
    double least = 9, most = -9;
    int turns = 0, facing = 1;
    for (int n = 0; n < 6000; ++n) {
        session.tick({});
        least = std::min(least, placeOf(session, "slug").x());
        most = std::max(most, placeOf(session, "slug").x());
        turns += session.workings().monsters.facing(0) != facing ? 1 : 0;
        facing = session.workings().monsters.facing(0);
    }
    EXPECT_NEAR(least, 1, 0.15);
    EXPECT_NEAR(most, 3, 0.15);
    EXPECT_GE(turns, 3);
    EXPECT_LE(turns, 8);
    EXPECT_LT(placeOf(session, "slug").y(), 0.3);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Monsters, ItTurnsRoundWhereItDoesNotGetOn) {
    Session session(
        monstrous(R"("behaviour": "patrol", "between": [-9, 9])",
                  withBody(withSlug(), "wall",
                           R"("shape": "box", "size": [0.2, 2], "kind": "fixed")", "[3, 1]")));
    put(session, 3.5, 0.3);
    play(session, {}, 2500);
    EXPECT_EQ(session.workings().monsters.facing(0), -1);
}

TEST(Monsters, ASlugTowsTheHero) {
    Session session(monstrous(R"("behaviour": "patrol", "between": [-9, 2.6], "speed": 0.8)",
                              replaced(withSlug(), "[3.2, 0.3]", "[3.5, 2.5]")));
    put(session, 0.8, 0.3);
    play(session, fireAt(1, 0), 40);
    ASSERT_EQ(session.rope().hooked(session.world()), session.instance().body("slug"));
    for (int n = 0; n < 2000 && session.workings().monsters.facing(0) > 0; ++n) {
        session.tick(fireAt(1, 0));
    }
    put(session, 3.5, 0.2);  // behind it
    const double start = session.heroPosition().x();
    play(session, fireAt(1, 0), 1500);
    EXPECT_LT(session.heroPosition().x(), start - 0.5);
}

TEST(Monsters, NothingIsSeenThroughWalls) {
    const std::string watcher = R"("behaviour": "chase", "range": 3)";
    Session open(monstrous(watcher, withSlug()));
    put(open, 0, 0.3);
    play(open, {}, 30);
    EXPECT_EQ(mood(open), Mood::angry);
    Session behind(monstrous(
        watcher, withBody(withSlug(), "wall",
                          R"("shape": "box", "size": [0.2, 2], "kind": "fixed")", "[1, 1]")));
    put(behind, 0, 0.3);
    play(behind, {}, 30);
    EXPECT_EQ(mood(behind), Mood::idle);
    Session far(monstrous(watcher, withSlug()));
    put(far, -3, 0.3);
    play(far, {}, 30);
    EXPECT_EQ(mood(far), Mood::idle);
}

TEST(Monsters, OneChasesAndOneFlees) {
    for (const bool flees : {false, true}) {
        Session session(monstrous(std::string(R"("speed": 1, "range": 9, "behaviour": )") +
                                      (flees ? R"("flee")" : R"("chase")"),
                                  withSlug()));
        put(session, 0, 0.3);
        play(session, {}, 500);
        const double x = placeOf(session, "slug").x();
        EXPECT_TRUE(flees ? x > 2.5 : x < 1.5) << x;
    }
}

TEST(Monsters, OneThatFliesHasNoWeight) {
    Session session(monstrous(R"("speed": 1, "range": 3, "behaviour": "chase", "flies": true)",
                              withSlug(roomText, "[2, 2]")));
    put(session, -2, 0.3);
    play(session, {}, 1000);
    EXPECT_NEAR((placeOf(session, "slug") - sulfur::Point(2, 2)).norm(), 0, 0.05);
    put(session, 0.8, 1.2);
    play(session, {}, 250);
    EXPECT_GT((placeOf(session, "slug") - sulfur::Point(2, 2)).norm(), 0.2);  // on its way
    put(session, -2, 0.3);
    play(session, {}, 3000);
    EXPECT_NEAR((placeOf(session, "slug") - sulfur::Point(2, 2)).norm(), 0, 0.1);  // home again
}

TEST(Monsters, ALungeIsAnnouncedAndReachesTheHero) {
    Session session(monstrous(R"("behaviour": "lunge", "range": 4, "speed": 5)", withSlug(),
                              R"(, "surfaces": {"slug": {"deadly": true}})"));
    play(session, {}, 20);
    EXPECT_EQ(mood(session), Mood::alert);
    const double start = placeOf(session, "slug").x();
    play(session, {}, 180);
    EXPECT_EQ(mood(session), Mood::alert);
    EXPECT_NEAR(placeOf(session, "slug").x(), start, 0.05);
    bool died = false;
    for (int n = 0; n < 300 && !died; ++n) {
        session.tick({});
        died = session.events().died;
    }
    EXPECT_TRUE(died);
}

TEST(Monsters, ALeechCutsTheRope) {
    Session session(monstrous(R"("behaviour": "lunge", "target": "rope", "range": 4, "speed": 7,
                                "flies": true)",
                              withSlug(roomText, "[2, 1.8]"),
                              R"(, "surfaces": {"slug": {"cuts": true}})"));
    put(session, 0, 0.6);
    play(session, {}, 100);
    EXPECT_EQ(mood(session), Mood::idle);  // there is no rope
    bool cut = false;
    for (int n = 0; n < 600 && !cut; ++n) {
        session.tick(fireAt(0, 1));
        cut = session.events().cut;
    }
    EXPECT_TRUE(cut);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    EXPECT_EQ(session.restarts(), 0);
}

TEST(Monsters, OneThatHangsSwingsAtTheHero) {
    const std::string hung =
        replaced(withBody(withSlug(roomText, "[1, 1.2]"), "hook",
                          R"("shape": "ball", "radius": 0.05, "kind": "fixed")", "[1, 2.6]"),
                 "\"bodies\": [",
                 R"("connections": [{"a": ["slug", 12], "b": ["hook", 0],
                             "restLength": 1.3}],
  "bodies": [)");
    Session session(monstrous(R"("behaviour": "hang", "range": 5, "speed": 2)", hung));
    play(session, {}, 10);
    put(session, -1, 0.3);
    double least = 9;
    for (int n = 0; n < 1500; ++n) {
        session.tick({});
        least = std::min(least, placeOf(session, "slug").x());
    }
    EXPECT_LT(least, 0.7);
    EXPECT_EQ(mood(session), Mood::angry);
}

TEST(Monsters, ABlowDefeatsAndSignals) {
    const std::string text = withBody(
        withSlug(), "hammer", R"("shape": "box", "size": [0.3, 0.3], "mass": 8)", "[2, 2.5]");
    const std::string more = R"(, "surfaces": {"slug": {"deadly": true}})";
    Session tough(
        monstrous(R"("behaviour": "lunge", "toughness": 1000, "onDefeat": "won")", text, more));
    Session weak(
        monstrous(R"("behaviour": "lunge", "toughness": 6, "onDefeat": "won")", text, more));
    put(tough, -3, 0.3);
    put(weak, -3, 0.3);
    bool defeated = false;
    for (int n = 0; n < 600; ++n) {
        tough.tick({});
        weak.tick({});
        defeated = defeated || weak.events().defeated;
    }
    EXPECT_NE(mood(tough), Mood::defeated);
    EXPECT_FALSE(tough.workings().signals.on(0));
    EXPECT_TRUE(defeated);
    EXPECT_EQ(mood(weak), Mood::defeated);
    EXPECT_TRUE(weak.workings().signals.on(0));
    put(weak, 1.45, 0.2);
    play(weak, {}, 300);
    EXPECT_EQ(weak.restarts(), 0);  // it is harmless now
}

TEST(Monsters, DeadlyZonesAndTheDepthDefeat) {
    Session session(monstrous(R"("behaviour": "lunge", "onDefeat": "won")", withSlug(),
                              R"(, "zones": [{"id": "z", "min": [1, -1], "max": [3, 1],
                                   "deadly": true}])"));
    put(session, -3, 0.3);
    session.tick({});
    EXPECT_EQ(mood(session), Mood::defeated);
}

TEST(Monsters, HashesAndSnapshots) {
    const auto level = monstrous(R"("behaviour": "lunge", "range": 6, "speed": 4)", withSlug());
    const auto hashes = threeWays(level, [](Session& session) {
        play(session, fireAt(1, 1), 500);
        play(session, {}, 700);
    });
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace quaoar::test
