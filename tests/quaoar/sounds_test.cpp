// What is heard: effects by what happens, music by the level's world.
#include <gtest/gtest.h>

#include <algorithm>
#include <atlax/audio.hpp>
#include <chrono>
#include <cmath>
#include <quaoar/view/sounds.hpp>
#include <sstream>
#include <string>
#include <thread>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

float peakOf(const std::vector<float>& samples) {
    float most = 0;
    for (const float s : samples) most = std::max(most, std::abs(s));
    return most;
}

void play(Session& session, Sounds& sounds, const TickInput& input, int ticks) {
    for (int n = 0; n < ticks; ++n) {
        session.tick(input);
        sounds.tick(session);
    }
}

TEST(Sounds, everyRecipeIsHeardAndStaysInRange) {
    for (std::size_t i = 0; i < effectCount; ++i) {
        const auto samples = recipeOf(static_cast<Effect>(i));
        ASSERT_GT(samples.size(), 1000u) << i;
        EXPECT_GT(peakOf(samples), 0.1f) << i;
        EXPECT_LE(peakOf(samples), 1) << i;
        EXPECT_NEAR(static_cast<double>(samples.back()), 0, 0.02) << i << " ends with a click";
        for (const float s : samples) ASSERT_TRUE(std::isfinite(s)) << i;
    }
    for (const auto& loop : {creakLoop(), humLoop()})
        EXPECT_NEAR(static_cast<double>(loop.front()), static_cast<double>(loop.back()), 0.1);
}

TEST(Sounds, aMissIsHeard) {
    atlax::Audio audio;
    Sounds sounds(audio);
    Session session(room(replaced(replaced(roomText, "[4, 3], [-4, 3]", "[4, 30], [-4, 30]"),
                                  "\"max\": [4, 4]", "\"max\": [4, 31]")));
    play(session, sounds, {}, 100);
    EXPECT_EQ(sounds.played(Effect::miss), 0);
    play(session, sounds, fireAt(0, 1), 120);
    EXPECT_EQ(sounds.played(Effect::miss), 1);
    EXPECT_EQ(sounds.played(Effect::shoot), 1);
    EXPECT_EQ(sounds.played(Effect::stickIce), 0);
}

TEST(Sounds, tellWhatTheRopeSticksIn) {
    const auto stick = [](const std::string& look, Effect effect) {
        atlax::Audio audio;
        Sounds sounds(audio);
        Session session(room(replaced(
            roomText, "\"killDepth\": -3,",
            "\"killDepth\": -3, \"surfaces\": {\"room\": {\"look\": \"" + look + "\"}},")));
        play(session, sounds, fireAt(0, 1), 100);
        return sounds.played(effect);
    };
    EXPECT_EQ(stick("ice", Effect::stickIce), 1);
    EXPECT_EQ(stick("metal", Effect::stickMetal), 1);
    EXPECT_EQ(stick("rock", Effect::stickRock), 1);
    EXPECT_EQ(stick("rock", Effect::stickIce), 0);
}

/// Whether a piece of the rope has come to touch something in this tick.
bool ropeTouches(const Session& session) {
    const sulfur::World& world = session.world();
    const auto& begun = world.events().contactsBegun;
    return std::any_of(begun.begin(), begun.end(), [&](const sulfur::ContactBegun& contact) {
        return world.filter(contact.a).category == Category::rope ||
               world.filter(contact.b).category == Category::rope;
    });
}

/// The rope goes when the hero arrives; the tick's events still tell of what it has touched.
TEST(Sounds, outliveTheRopeThatTouchesWhenTheLevelEnds) {
    TickInput pull = fireAt(1, 1.9);
    pull.reelIn = true;
    const std::string far = replaced(roomText, "[3.2, 0.3]", "[-3.5, 2.5]");
    Session search(room(far));
    sulfur::Point before = search.heroPosition();
    for (int n = 0; n < 3000 && !ropeTouches(search); ++n) {
        before = search.heroPosition();
        search.tick(pull);
    }
    ASSERT_TRUE(ropeTouches(search));
    // The edge of an exit lies in the middle of the hero's way in that tick.
    const sulfur::Point way = search.heroPosition() - before, middle = before + way / 2;
    const sulfur::Point exit = middle + way.normalized() * 0.1;
    std::ostringstream text;
    text.precision(17);
    text << "{\"position\": [" << exit.x() << ", " << exit.y() << "], \"radius\": 0.1}";
    Session session(
        room(replaced(roomText, "{\"position\": [3.2, 0.3], \"radius\": 0.4}", text.str())));
    atlax::Audio audio;
    Sounds sounds(audio);
    play(session, sounds, pull, static_cast<int>(search.ticks()));
    EXPECT_EQ(session.phase(), Session::Phase::finished);
    EXPECT_EQ(session.ticks(), search.ticks());
}

TEST(Music, everyWorldHasALoopOfItsOwnWithoutASeam) {
    std::vector<Score> scores;
    for (const auto world :
         {Theme::World::dawn, Theme::World::bog, Theme::World::machine, Theme::World::deep}) {
        const auto start = std::chrono::steady_clock::now();
        scores.push_back(compose(world, 11));
        RecordProperty(
            "seconds-" + std::to_string(scores.size()),
            std::to_string(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
        const Score& score = scores.back();
        ASSERT_EQ(score.calm.size(), score.danger.size());
        EXPECT_GT(score.calm.size(), static_cast<std::size_t>(15 * scoreRate));
        for (const auto* layer : {&score.calm, &score.danger}) {
            EXPECT_GT(peakOf(*layer), 0.4f);
            EXPECT_LE(peakOf(*layer), 0.8f);
            float step = 0;
            for (std::size_t i = 1; i < layer->size(); ++i)
                step = std::max(step, std::abs((*layer)[i] - (*layer)[i - 1]));
            EXPECT_LE(std::abs(layer->front() - layer->back()), step)
                << "no jump where it begins again";
        }
    }
    EXPECT_EQ(compose(Theme::World::bog, 11).calm, scores[1].calm) << "the same every time";
    for (std::size_t i = 1; i < scores.size(); ++i) EXPECT_NE(scores[i].calm, scores[0].calm);
}

TEST(Music, playsInALevelAndKeepsDownInMenus) {
    atlax::Audio audio;
    Sounds sounds(audio);
    Session session(room());
    for (int n = 0; n < 2000 && !sounds.musicPlays(); ++n) {
        play(session, sounds, {}, 5);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(sounds.musicPlays());
    play(session, sounds, {}, 3000);
    const float loud = sounds.musicLoudness();
    EXPECT_GT(loud, 0.9f);
    sounds.hush();
    EXPECT_LT(sounds.musicLoudness(), 0.5f * loud);
    EXPECT_TRUE(sounds.musicPlays()) << "it goes on below the menu";
    play(session, sounds, {}, 3000);
    EXPECT_GT(sounds.musicLoudness(), 0.9f);
}

}  // namespace
}  // namespace quaoar::test
