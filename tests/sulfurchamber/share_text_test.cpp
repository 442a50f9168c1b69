// Scenes as text.
#include <gtest/gtest.h>

#include <string>

#include "model/share_text.hpp"

namespace sulfurchamber {
namespace {

sulfur::scene::Scene example(const char* name = "bridge") {
    return sulfur::scene::read(std::string(SULFURCHAMBER_SCENES) + "/" + name + ".json");
}

std::string reason(const std::string& text) {
    try {
        parseShareText(text);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(ShareText, AWholeSceneComesBack) {
    for (const char* name : {"bridge", "crumbling-wall", "newtons-cradle", "mass-ratio"}) {
        const auto scene = example(name);
        const std::string text = shareText(scene);
        EXPECT_EQ(text.find_first_of(" \n\""), std::string::npos);
        EXPECT_LT(text.size(), 4096u) << name;  // a few kB
        EXPECT_EQ(sulfur::scene::format(parseShareText(text)), sulfur::scene::format(scene));
    }
}

TEST(ShareText, ItMayStandInAMessageAndBeBrokenIntoLines) {
    const auto scene = example();
    std::string text = shareText(scene);
    for (std::size_t at = 76; at < text.size(); at += 77) text.insert(at, "\n");
    const std::string mail = "Hello!\n\nLook: " + text + "\n\nSee you, sulfur-scene-lovers.\n";
    EXPECT_TRUE(isShareText(mail));
    EXPECT_EQ(sulfur::scene::format(parseShareText(mail)), sulfur::scene::format(scene));
    EXPECT_FALSE(isShareText("sulfur-scene-1"));
    EXPECT_FALSE(isShareText("{\"format\": \"sulfur-scene\", \"version\": 1}"));
}

TEST(ShareText, ADamagedTextIsRefusedWithItsReason) {
    const std::string text = shareText(example());
    EXPECT_NE(reason("hello").find("is missing at its beginning"), std::string::npos);
    EXPECT_NE(reason("sulfur-scene-2:" + text.substr(15)).find("version 2"), std::string::npos);
    EXPECT_NE(reason("sulfur-scene-1:x").find("its length is missing"), std::string::npos);
    EXPECT_NE(reason(text.substr(0, text.size() / 2)).find("it is cut short"), std::string::npos);
    EXPECT_EQ(reason("sulfur-scene-1:0:"),
              "the text holds no scene that can be used: it was changed on its way");
}

// Whatever letter is another: it is refused, never another scene.
TEST(ShareText, NoChangedLetterGoesUnnoticed) {
    const std::string text = shareText(example());
    const std::string whole = sulfur::scene::format(example());
    const std::size_t begin = text.rfind(':') + 1;
    for (std::size_t at = begin; at < text.size(); at += 7) {
        std::string other = text;
        other[at] = other[at] == 'A' ? 'B' : 'A';
        const std::string why = reason(other);
        // The last letter has bits that mean nothing.
        if (why.empty())
            EXPECT_EQ(sulfur::scene::format(parseShareText(other)), whole) << at;
        else
            EXPECT_NE(why.find("changed"), std::string::npos) << why;
    }
}

TEST(ShareText, AHugeTextIsRefused) {
    EXPECT_NE(reason("sulfur-scene-1:99999999999999999999:AAAA").find("its length is missing"),
              std::string::npos);
    EXPECT_NE(reason("sulfur-scene-1:1000000000:AAAA").find("cut short"), std::string::npos);
}

}  // namespace
}  // namespace sulfurchamber
