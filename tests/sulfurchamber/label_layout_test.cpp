// Texts beside their marks: none covers another.
#include <gtest/gtest.h>

#include <atlax/offscreen.hpp>
#include <filesystem>

#include "view/fitting_camera.hpp"
#include "view/label_layout.hpp"
#include "view/level_painter.hpp"

namespace sulfurchamber {
namespace {

using atlax::Rect;

constexpr Rect sheet{{0, 0}, {300, 200}};

bool cover(const Rect& a, const Rect& b) {
    return a.min.x < b.max().x && b.min.x < a.max().x && a.min.y < b.max().y && b.min.y < a.max().y;
}

LabelWish wishAt(atlax::Vec2 mark) {
    return {mark, {100, 40}, {50, 20}};
}

TEST(LabelLayout, StandsAtTheRightWhereThatIsFree) {
    const LabelWish wish = wishAt({50, 100});
    const auto places = placeLabels({&wish, 1}, sheet, {});
    ASSERT_TRUE(places.at(0));
    EXPECT_GT(places[0]->plate.min.x, 50);
    EXPECT_EQ(places[0]->plate.centre().y, 100);
    EXPECT_FALSE(places[0]->isShort);
}

TEST(LabelLayout, GoesToTheLeftAtTheRightEdge) {
    const LabelWish wish = wishAt({290, 100});
    const auto places = placeLabels({&wish, 1}, sheet, {});
    ASSERT_TRUE(places.at(0));
    EXPECT_LT(places[0]->plate.max().x, 290);
}

TEST(LabelLayout, NoneCoversAnotherOrWhatIsTaken) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 12; ++i)
        wishes.push_back(
            wishAt({25.0f * static_cast<float>(i), 100 + 20.0f * static_cast<float>(i % 3)}));
    const std::vector<Rect> taken{{{0, 0}, {120, 80}}};
    const auto places = placeLabels(wishes, sheet, taken);
    std::vector<Rect> plates = taken;
    int shortened = 0;
    for (const auto& place : places) {
        if (!place) continue;
        for (const Rect& other : plates) EXPECT_FALSE(cover(place->plate, other));
        plates.push_back(place->plate);
        shortened += place->isShort ? 1 : 0;
    }
    EXPECT_GT(plates.size(), 4u);
    EXPECT_GT(shortened, 0) << "rather a part of a text than none";
}

TEST(LabelLayout, WhatIsOutOfViewHasNoneAndWhatIsNeededAlwaysHasOne) {
    const LabelWish out = wishAt({-20, 100});
    EXPECT_FALSE(placeLabels({&out, 1}, sheet, {}).at(0));
    LabelWish needed = wishAt({290, 195});
    const std::vector<Rect> all{sheet};
    EXPECT_FALSE(placeLabels({&needed, 1}, sheet, all).at(0));
    needed.needed = true;
    const auto place = placeLabels({&needed, 1}, sheet, all).at(0);
    ASSERT_TRUE(place);
    EXPECT_LE(place->plate.max().x, 300);
    EXPECT_LE(place->plate.max().y, 200);
}

// The drawing area of a window of 640 x 480, and that of a large one.
TEST(LevelPainter, TextsOfNoLevelCoverEachOther) {
    const atlax::Font font = atlax::Font::standard();
    std::size_t texts = 0;
    for (const auto& entry : std::filesystem::directory_iterator(QUAOAR_LEVELS)) {
        if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".schema")
            continue;
        Workbench bench;
        bench.document().open(entry.path());
        for (const atlax::PixelSize size :
             {atlax::PixelSize{332, 315}, atlax::PixelSize{900, 620}}) {
            atlax::OffscreenCanvas offscreen(size);
            atlax::Canvas& canvas = offscreen.begin();
            canvas.recordTexts(true);
            LevelPainter painter;
            painter.paint(canvas, fittingCamera(bench.document(), size, {}), font, bench);
            const auto drawn = canvas.recordedTexts();
            offscreen.finish();
            texts += drawn.size();
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                EXPECT_TRUE(drawn[i].box.min.x >= 0 &&
                            drawn[i].box.max().x <= static_cast<float>(size.width))
                    << drawn[i].text;
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_FALSE(cover(drawn[i].box, drawn[k].box))
                        << entry.path() << ": " << drawn[i].text << " / " << drawn[k].text;
            }
        }
    }
    EXPECT_GT(texts, 30u);
}

}  // namespace
}  // namespace sulfurchamber
