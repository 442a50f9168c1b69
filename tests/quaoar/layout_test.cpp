// No text runs through another, on any screen, in any language.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "game.hpp"
#include "helpers.hpp"
#include "played.hpp"

namespace quaoar::test {
namespace {

using atlax::Key;

/// Of all texts that can be read, those that overlap or leave the picture.
std::vector<std::string> textFaults(const atlax::Canvas& canvas) {
    std::vector<std::string> faults;
    std::vector<atlax::DrawnText> seen;
    const atlax::Vec2 screen = canvas.size().toVec();
    for (const atlax::DrawnText& text : canvas.recordedTexts()) {
        constexpr float invisible = 0.1f;
        if (text.alpha < invisible || text.text.empty()) continue;
        const atlax::Vec2 low = text.box.min, high = text.box.max();
        if (low.x < -1 || low.y < -1 || high.x > screen.x + 1 || high.y > screen.y + 1)
            faults.push_back("\"" + text.text + "\" leaves the picture");
        bool shadow = false;
        for (const atlax::DrawnText& other : seen) {
            const atlax::Vec2 a = other.box.min, b = other.box.max();
            const float width = std::min(high.x, b.x) - std::max(low.x, a.x);
            const float height = std::min(high.y, b.y) - std::max(low.y, a.y);
            if (other.text == text.text && width > 0 && height > 0)
                shadow = true;
            else if (width > 1 && height > 1)
                faults.push_back("\"" + text.text + "\" runs through \"" + other.text + "\"");
        }
        if (!shadow) seen.push_back(text);
    }
    return faults;
}

/// Walks through all screens and looks at each in all sizes.
void lookAtAllTexts(const std::string& language) {
    const Folder folder("texts-" + language);
    writeEasyLevels(folder, 26);
    Preferences preferences(folder / "settings.json");
    LevelList levels = LevelList::ofFolder(folder.path());
    std::filesystem::copy_file(levelsFolder() / "01-cold-wake.json", folder / "room-1.json",
                               std::filesystem::copy_options::overwrite_existing);
    Game game({.levels = LevelList::ofFolder(folder.path()),
               .language = language,
               .progress = folder / "data",
               .unlockAll = true},
              preferences);
    // What counts is the shape: 1280 x 540 is 2560 x 1080, 1920 x 540 is 3840 x 1080.
    std::vector<atlax::PixelSize> sizes{{500, 700}, {640, 360}, {1280, 540}, {1920, 540}};
    if (language == "en") sizes.push_back({3840, 1080});
    std::string place;
    bool looking = false;
    int looks = 0;
    Script script;
    const auto look = [&](const std::string& name) {
        for (const atlax::PixelSize size : sizes) {
            script.next([&, name, size](atlax::Platform& platform) {
                place = name + " in " + language + " at " + std::to_string(size.width) + "x" +
                        std::to_string(size.height);
                platform.setWindowSize(size);
            });
            script.next([&](atlax::Platform& platform) {
                looking = true;
                if (const char* pictures = std::getenv("QUAOAR_TEST_PICTURES"))
                    platform.requestScreenshot(std::filesystem::path(pictures) / (place + ".png"));
            });
        }
        script.next([](atlax::Platform& platform) { platform.setWindowSize({320, 180}); });
    };
    look("title");
    script.keys({Key::Down, Key::Enter}).wait(40);
    look("levels");
    script.keys({Key::Escape, Key::Down, Key::Down, Key::Enter});
    look("statistics");
    script.keys({Key::Enter});
    look("statistics with news");
    script.keys({Key::Escape, Key::Down, Key::Enter});
    look("credits");
    script.keys({Key::Escape, Key::Up, Key::Up, Key::Enter});
    look("options");
    for (const char* page : {"sound", "picture", "play", "controls"}) {
        script.keys({Key::Down, Key::Enter});
        look(page);
        if (page != std::string("controls")) script.keys({Key::Escape});
    }
    script.keys({Key::Enter});
    look("bindings");
    script.keys({Key::Enter});
    look("capture");
    script.keys({Key::W});
    look("conflict");
    script.keys({Key::Escape, Key::Escape, Key::Escape, Key::Escape});
    script.keys({Key::Up, Key::Up, Key::Enter}).wait(30);
    look("playing");
    script.keys({Key::Escape});
    look("paused");
    script.keys({Key::Enter});
    look("count-in");
    script
        .keys({Key::Escape, Key::Up, Key::Up, Key::Enter, Key::Down, Key::Enter, Key::Right,
               Key::Enter})
        .wait(80);
    look("finished");
    script.keys({Key::Down, Key::Down, Key::Enter});
    look("watching");
    Played played(game, script, [&](atlax::Canvas& canvas) {
        if (!looking) return;
        looking = false;
        ++looks;
        for (const std::string& fault : textFaults(canvas)) ADD_FAILURE() << place << ": " << fault;
    });
    EXPECT_EQ(play(played), 9);
    EXPECT_EQ(looks, 18 * static_cast<int>(sizes.size())) << "18 screens";
}

TEST(Texts, doNotOverlapOnAnyScreenInEnglish) {
    lookAtAllTexts("en");
}
TEST(Texts, doNotOverlapOnAnyScreenInGerman) {
    lookAtAllTexts("de");
}
TEST(Texts, doNotOverlapOnAnyScreenInItalian) {
    lookAtAllTexts("it");
}

}  // namespace
}  // namespace quaoar::test
