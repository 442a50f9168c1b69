// Skins as they are drawn: where a picture lies, turned with its body, torn with it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atlax/offscreen.hpp>
#include <filesystem>
#include <string>

#include "model/skins.hpp"
#include "view/scene_painter.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

/// A picture whose left half is red and whose right half is green, on bodies before a camera of a
/// hundred pixels a metre.
class SkinPicture : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("sulfur-skin-picture-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
        atlax::Image halves({64, 64});
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                halves.setPixel(x, y,
                                x < 32 ? std::array<std::uint8_t, 4>{255, 0, 0, 255}
                                       : std::array<std::uint8_t, 4>{0, 255, 0, 255});
        atlax::savePng(halves, folder / "halves.png");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    BodyId add(const sulfur::scene::Generator& recipe, const sulfur::Pose& pose) {
        BodyId body;
        bench.document().edit("Add", [&] {
            auto prefab = sulfur::scene::makePrefab("body", recipe);
            wear(prefab, "halves.png");
            sulfur::scene::Placement placement;
            placement.pose = pose;
            body = bench.document().add(prefab, placement);
        });
        return bench.document().bodyOf("body");
    }
    /// 'r' or 'g' where the picture is, '-' elsewhere.
    char at(const Point& place) {
        if (image.empty()) draw();
        const int x = static_cast<int>(std::lround(200 + 100 * place.x()));
        const int y = static_cast<int>(std::lround(200 - 100 * (place.y() - 2)));
        const auto pixel = image.pixel(x, y);
        if (pixel[0] > 90 && pixel[1] < 60 && pixel[2] < 60) return 'r';
        if (pixel[1] > 90 && pixel[0] < 60 && pixel[2] < 60) return 'g';
        return '-';
    }
    void draw() {
        atlax::OffscreenCanvas offscreen({400, 400});
        SkinTextures textures(SkinStore(folder, {}));
        ScenePainter painter;
        painter.setTextures(&textures);
        atlax::Canvas& canvas = offscreen.begin();
        canvas.clear(atlax::Color::hex(0x000040));
        canvas.setCamera({{0, 2}, 100});
        ViewOptions options;
        painter.paint(canvas, bench, options, 1);
        offscreen.finish();
        image = offscreen.image();
    }

    std::filesystem::path folder;
    Workbench bench;
    atlax::Image image;
};

TEST_F(SkinPicture, LiesOnABoxAndTurnsWithIt) {
    add(sulfur::shapes::BoxOptions{.size = {1, 1}}, {.position = {0, 2}});
    EXPECT_EQ(at({-0.25, 2}), 'r');
    EXPECT_EQ(at({0.25, 2}), 'g');
    EXPECT_EQ(at({0.8, 2}), '-');
    const BodyId body = bench.document().bodyOf("body");
    bench.document().edit("Turn", [&] {
        bench.document().place(body, {.position = {0, 2}, .angle = 1.5707963});
    });
    image = {};
    EXPECT_EQ(at({0, 1.75}), 'r') << "left has become below";
    EXPECT_EQ(at({0, 2.25}), 'g');
}

TEST_F(SkinPicture, LiesOnADiscAndFollowsItsMapping) {
    add(sulfur::shapes::BallOptions{.radius = 0.5f}, {.position = {0, 2}});
    EXPECT_EQ(at({-0.25, 2}), 'r');
    EXPECT_EQ(at({0.25, 2}), 'g');
    EXPECT_EQ(at({-0.45, 2.45}), '-') << "outside of the disc";
}

TEST_F(SkinPicture, MovesWithItsMapping) {
    const BodyId body = add(sulfur::shapes::BoxOptions{.size = {1, 1}}, {.position = {0, 2}});
    bench.document().edit("Move", [&] {
        bench.document().change({&body, 1}, [](auto& prefab) {
            auto mapping = *mappingOf(prefab);
            mapping.centre.x() += 0.3;
            setMapping(prefab, mapping);
        });
    });
    EXPECT_EQ(at({0.2, 2}), 'r');
    EXPECT_EQ(at({0.4, 2}), 'g');
}

TEST_F(SkinPicture, TearsWhereJointsBreak) {
    const BodyId wall = add(sulfur::shapes::WallOptions{.size = {2, 2}, .columns = 4, .rows = 4},
                            {.position = {0, 2}});
    EXPECT_EQ(at({-0.1, 2}), 'r');
    sulfur::World& world = bench.document().world();
    bench.document().startTime();
    // The middle of three times three particles goes with all of its joints.
    const auto middle = world.particles(wall)[12];
    std::vector<sulfur::JointId> gone;
    for (const auto joint : world.joints(wall)) {
        const auto info = world.info(joint);
        if (info.a == middle || info.b == middle) gone.push_back(joint);
    }
    for (const auto joint : gone) world.remove(joint);
    image = {};
    EXPECT_EQ(at({-0.1, 2}), '-') << "a hole";
    EXPECT_EQ(at({-0.75, 2}), 'r') << "the rest keeps its picture";
    EXPECT_EQ(at({0.75, 2}), 'g');
}

}  // namespace
}  // namespace sulfurchamber
