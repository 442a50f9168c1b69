// How it began: four pictures without a word, once before the first level and from the credits.
#include <gtest/gtest.h>

#include <atlax/offscreen.hpp>
#include <cmath>
#include <set>

#include "helpers.hpp"
#include "played.hpp"
#include "story.hpp"

namespace quaoar::test {
namespace {

using Screen = Game::Screen;
using atlax::Key;

/// Ticks until the next picture, with what is looked at in each.
template <class Look>
void watchPicture(Story& story, const Look& look) {
    const std::size_t picture = story.picture();
    for (int tick = 0; tick < 20 * Session::tickRate && story.picture() == picture; ++tick) {
        look();
        story.tick();
    }
}

TEST(Story, SomethingHappensInEachPicture) {
    atlax::OffscreenCanvas offscreen({320, 180});
    Art art(offscreen.canvas());
    Story story(art, Story::levels());
    const auto heroHeight = [&] { return story.session().heroPosition().y(); };
    double high = -100, low = 100;
    const auto look = [&] {
        high = std::max(high, heroHeight());
        low = std::min(low, heroHeight());
    };
    const auto again = [&] {
        high = -100;
        low = 100;
    };
    watchPicture(story, look);
    EXPECT_EQ(story.picture(), 1u);
    EXPECT_GT(low, 0.1) << "at home he stands";
    again();
    watchPicture(story, look);
    EXPECT_EQ(story.picture(), 2u);
    EXPECT_LT(low, -3) << "the ice breaks under him";
    again();
    watchPicture(story, look);
    EXPECT_GT(low, 0.1) << "at the bottom";
    again();
    bool tied = false;
    watchPicture(story, [&] {
        look();
        tied = tied || story.session().rope().state() == Rope::State::attached;
    });
    EXPECT_TRUE(tied);
    EXPECT_GT(high, 0.8) << "and up he goes";
    EXPECT_TRUE(story.over());
}

TEST(Story, PicturesAreLitAndDiffer) {
    atlax::OffscreenCanvas offscreen({320, 180});
    Art art(offscreen.canvas());
    Story story(art, Story::levels());
    std::set<std::vector<std::uint8_t>> seen;
    for (std::size_t i = 0; i < Story::pictures; ++i) {
        for (int tick = 0; tick < Session::tickRate; ++tick) story.tick();
        atlax::Canvas& canvas = offscreen.begin();
        canvas.recordTexts(true);
        story.draw(canvas, 1, {});
        EXPECT_TRUE(canvas.recordedTexts().empty()) << "without words";
        offscreen.finish();
        const atlax::Image image = offscreen.image();
        std::vector<std::uint8_t> middle;
        int lit = 0;
        for (int x = 0; x < 320; ++x) {
            const auto pixel = image.pixel(x, 90);
            lit += pixel[0] + pixel[1] + pixel[2] > 60 ? 1 : 0;
            middle.insert(middle.end(), pixel.begin(), pixel.end());
        }
        EXPECT_GT(lit, 160) << i;
        EXPECT_EQ(image.pixel(160, 5)[2], 0) << "the bar above";
        EXPECT_TRUE(seen.insert(middle).second) << i;
        story.next();
    }
    EXPECT_TRUE(story.over());
}

TEST(Story, IsToldOnceBeforeTheFirstLevelAndFromTheCredits) {
    const Folder folder("story");
    writeEasyLevels(folder, 2);
    Preferences preferences(folder / "settings.json");
    const auto options = [&] {
        return GameOptions{.levels = LevelList::ofFolder(folder.path()),
                           .progress = folder / "data",
                           .story = true};
    };
    {
        Game game(options(), preferences);
        Script script;
        script.keys({Key::Enter});
        script.then([&](atlax::Platform&) {
            EXPECT_EQ(game.screen(), Screen::story);
            ASSERT_NE(game.story(), nullptr);
            EXPECT_EQ(game.story()->picture(), 0u);
        });
        script.keys({Key::Enter});
        script.then([&](atlax::Platform&) { EXPECT_EQ(game.story()->picture(), 1u); });
        script.keys({Key::Enter, Key::Enter, Key::Enter});
        script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::playing); });
        Played played(game, script);
        EXPECT_EQ(play(played), 9);
    }
    Game game(options(), preferences);
    Script script;
    script.keys({Key::Enter});
    script.then(
        [&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::playing) << "told before"; });
    script.keys({Key::Escape, Key::Up, Key::Up, Key::Enter});  // to the title
    script.keys({Key::Down, Key::Down, Key::Down, Key::Down, Key::Enter, Key::Enter});
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::story); });
    script.keys({Key::Escape});
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::credits); });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

}  // namespace
}  // namespace quaoar::test
