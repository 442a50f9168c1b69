// What a window shows of a scene, without a window.
#include <gtest/gtest.h>

#include <array>
#include <atlax/backend.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <set>

#include "view/grid_painter.hpp"
#include "view/scene_painter.hpp"
#include "view/scene_view.hpp"

namespace sulfurchamber {
namespace {

// Runs `look` once the view has drawn its first frame.
class OneFrame final : public atlax::Application {
public:
    OneFrame(Workbench& bench, std::function<void(const SceneView&)> look)
        : view_(bench), look_(std::move(look)) {}
    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        view_.start(platform);
    }
    void event(const atlax::Event& event) override { view_.event(event); }
    void tick() override { view_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        view_.draw(canvas, alpha);
        look_(view_);
        platform_->quit();
    }
    void stop() override { view_.stop(); }

private:
    SceneView view_;
    std::function<void(const SceneView&)> look_;
    atlax::Platform* platform_ = nullptr;
};

void look(Workbench& bench, atlax::PixelSize size, std::function<void(const SceneView&)> with) {
    OneFrame app(bench, std::move(with));
    atlax::WindowOptions window;
    window.size = size;
    ASSERT_EQ(atlax::runOffscreen(app, window), 0);
}

TEST(SceneView, AnEmptySceneIsTwelveMetresWideWithTheFloorInTheLowerFifth) {
    for (const atlax::PixelSize size :
         {atlax::PixelSize{640, 400}, atlax::PixelSize{1280, 800}, atlax::PixelSize{3840, 2160}}) {
        Workbench bench;
        look(bench, size, [&](const SceneView& view) {
            const auto width = static_cast<float>(size.width);
            const auto height = static_cast<float>(size.height);
            const auto left = view.toWorld({0, 0});
            const auto right = view.toWorld({width, 0});
            EXPECT_NEAR(right.x() - left.x(), 12, 1.2) << "rulers take a little of it";
            const float floor = view.toPixels({0, 0.05}).y;
            EXPECT_GT(floor, 0.75f * height);
            EXPECT_LT(floor, 0.85f * height);
        });
    }
}

TEST(SceneView, KeysDoWhatTheMouseDoes) {
    Workbench bench;
    bench.setTool(ToolKind::box);
    look(bench, {1280, 800}, [&](const SceneView& constView) {
        auto& view = const_cast<SceneView&>(constView);
        view.movePointer({0, 1});
        const auto from = *view.pointer();
        const double step = view.fineStep();
        EXPECT_NEAR(std::remainder(from.x(), step), 0, 1e-3) << "it begins on the grid";
        EXPECT_NEAR(std::remainder(from.y(), step), 0, 1e-3);
        view.switchButton();
        view.movePointer({1.5, 0});
        view.movePointer({0, 0.75});
        view.switchButton();
        ASSERT_EQ(bench.document().scene().bodies.size(), 2u);
        const auto& box = std::get<sulfur::shapes::BoxOptions>(
            bench.document().scene().blueprints.back().generator);
        EXPECT_NEAR(box.size[0], 1.5, 0.06);
        EXPECT_NEAR(box.size[1], 0.75, 0.06);
        // Over it, two clicks at one place take a part of it.
        bench.setTool(ToolKind::select);
        bench.select({});
        view.movePointer(from - *view.pointer());
        for (int i = 0; i < 4; ++i) view.switchButton();
        ASSERT_TRUE(bench.fitting());
        EXPECT_TRUE(bench.fitting()->isPart());
        // Held with Alt it drags a copy, with Shift it takes more.
        const std::size_t bodies = bench.document().scene().bodies.size();
        bench.select({});
        view.movePointer({0.4, 0.4});
        view.switchButton(atlax::Modifiers::Alt);
        view.movePointer({2, 1});
        view.movePointer({1, 0});
        view.switchButton();
        EXPECT_EQ(bench.document().scene().bodies.size(), bodies + 1);
        EXPECT_EQ(bench.selection().size(), 1u);
        view.movePointer({-3, -1});
        view.switchButton(atlax::Modifiers::Shift);
        view.switchButton();
        EXPECT_EQ(bench.selection().size(), 2u);
        // It stays in the window, which follows it.
        const auto before = *view.pointer();
        view.movePointer({1000, -1000});
        EXPECT_LT(view.mousePixels()->x, 1280);
        EXPECT_LT(view.mousePixels()->y, 800);
        EXPECT_NEAR((*view.pointer() - before - sulfur::Point(1000, -1000)).norm(), 0, 0.01);
    });
}

TEST(SceneView, TheStepOfTheGridIsChosenOrFollowsTheZoom) {
    for (const float zoom : {3.0f, 20.0f, 90.0f, 700.0f}) {
        const GridSteps free = gridSteps(zoom, 1);
        EXPECT_GE(free.labelled * static_cast<double>(zoom), 72);
        for (const double chosen : gridStepChoices) {
            const GridSteps steps = gridSteps(zoom, 1, chosen);
            EXPECT_EQ(steps.fine, chosen);
            EXPECT_GE(steps.labelled * static_cast<double>(zoom), 72);
            EXPECT_GE(steps.labelled, free.labelled);
            EXPECT_NEAR(std::remainder(steps.labelled, chosen), 0, 1e-9) << "labels are on lines";
        }
    }
    // What is built goes to the lines.
    Workbench bench;
    SceneView view(bench);
    view.snapping() = {.grid = true};
    view.options().gridStep = 0.25;
    EXPECT_EQ(view.fineStep(), 0.25);
    const auto click = [&](atlax::Vec2 at) {
        for (const bool down : {true, false})
            view.event(atlax::MouseButtonEvent{
                .button = atlax::MouseButton::Left, .down = down, .position = at, .clicks = 1});
    };
    EXPECT_EQ(bench.snap(), 0);
    click({10, 10});
    EXPECT_EQ(bench.snap(), 0.25);
    view.options().gridStep = 0;
    click({10, 10});
    EXPECT_NEAR(bench.snap(), 0.2, 1e-9);
}

TEST(SceneView, AllThatMovesIsInViewAtFirst) {
    Workbench bench;
    bench.dropBoxes(30);
    look(bench, {640, 400}, [&](const SceneView& view) {
        const auto& world = bench.document().world();
        for (const auto body : world.bodies()) {
            if (world.kind(body) == sulfur::BodyKind::fixed) continue;
            const auto at = view.toPixels(world.centreOfMass(body));
            EXPECT_GT(at.x, 0);
            EXPECT_LT(at.x, 640);
            EXPECT_GT(at.y, 0);
            EXPECT_LT(at.y, 400);
        }
    });
}

// From afar a cloth of thousands of threads is a sheet without gaps, from near a net.
TEST(ScenePainter, ShowsALargeClothAsASheetFromAfar) {
    Workbench bench;
    bench.document().world().add(
        sulfur::shapes::cloth({.size = {2, 2}, .columns = 40, .rows = 40, .radius = 0.001f}));
    const auto darkPixels = [&](float pixelsPerMetre) {
        atlax::OffscreenCanvas offscreen({60, 60});
        atlax::Canvas& canvas = offscreen.begin();
        canvas.clear(atlax::colors::black);
        canvas.setCamera({.centre = {0.1f, 0.1f}, .pixelsPerMetre = pixelsPerMetre});
        ScenePainter painter;
        painter.paint(canvas, bench, {}, 1);
        offscreen.finish();
        const atlax::Image image = offscreen.image();
        int dark = 0;
        for (int x = 0; x < 60; ++x)
            for (int y = 0; y < 60; ++y) dark += image.pixel(x, y)[0] < 40 ? 1 : 0;
        return dark;
    };
    EXPECT_EQ(darkPixels(70), 0);  // 3.6 pixels a mesh
    EXPECT_GT(darkPixels(400), 60 * 60 / 2);
}

// With a rim and a mark that turns from near, as a spot from afar.
TEST(ScenePainter, ShowsSmallDiscsAsSpots) {
    Workbench bench;
    bench.document().world().add(sulfur::shapes::ball({.radius = 0.5f}), {.position = {0, 2}});
    const auto colours = [&](float pixelsPerMetre) {
        atlax::OffscreenCanvas offscreen({64, 64});
        atlax::Canvas& canvas = offscreen.begin();
        canvas.clear(atlax::colors::black);
        canvas.setCamera({.centre = {0, 2}, .pixelsPerMetre = pixelsPerMetre});
        ScenePainter painter;
        painter.paint(canvas, bench, {}, 1);
        offscreen.finish();
        const atlax::Image image = offscreen.image();
        std::set<std::array<std::uint8_t, 4>> found;
        const int half = static_cast<int>(0.3f * pixelsPerMetre);
        for (int x = 32 - half; x < 32 + half; ++x)
            for (int y = 32 - half; y < 32 + half; ++y) found.insert(image.pixel(x, y));
        return found;
    };
    const auto spot = colours(12);
    ASSERT_EQ(spot.size(), 1u);
    EXPECT_GT((*spot.begin())[2], 60);
    EXPECT_GT(colours(60).size(), 3u);
}

TEST(ScenePainter, ShowsMechanisms) {
    const auto picture = [](sulfur::MechanismKind kind) {
        Workbench bench;
        auto& world = bench.document().world();
        const auto box = [&](double x) {
            return world.add(sulfur::shapes::box({.size = {1, 1}}), {.position = {x, 2}}).id();
        };
        const auto a = box(-1), b = box(1);
        if (kind == sulfur::MechanismKind::hinge) world.hinge(a, b, {0, 2});
        if (kind == sulfur::MechanismKind::weld) world.weld(a, b, {0, 2});
        if (kind == sulfur::MechanismKind::distance) world.distance(a, {-1, 2}, b, {1, 2});
        atlax::OffscreenCanvas offscreen({240, 240});
        atlax::Canvas& canvas = offscreen.begin();
        canvas.clear(atlax::colors::black);
        canvas.setCamera({.centre = {0, 2}, .pixelsPerMetre = 50});
        ScenePainter painter;
        painter.paint(canvas, bench, {}, 1);
        offscreen.finish();
        return offscreen.image();
    };
    const auto count = [](const atlax::Image& image, int x, int half) {
        int lit = 0;
        for (int i = x - half; i < x + half; ++i)
            for (int j = 120 - half; j < 120 + half; ++j) lit += image.pixel(i, j)[0] > 150 ? 1 : 0;
        return lit;
    };
    const auto none = picture(sulfur::MechanismKind::gear);
    const int before = count(none, 120, 12), dots = count(none, 70, 12);
    EXPECT_GT(count(picture(sulfur::MechanismKind::hinge), 120, 12), before + 10);
    EXPECT_GT(count(picture(sulfur::MechanismKind::weld), 120, 12), before + 10);
    const auto rope = picture(sulfur::MechanismKind::distance);
    EXPECT_GT(count(rope, 70, 12), dots + 10);
    EXPECT_GT(count(rope, 120, 12), before + 3);
}

}  // namespace
}  // namespace sulfurchamber
