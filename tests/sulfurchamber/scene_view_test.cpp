// What a window shows of a scene, without a window.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>

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

}  // namespace
}  // namespace sulfurchamber
