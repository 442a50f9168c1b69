// Large scenes and long histories: what they cost is printed, and only memory and results can fail.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atlax/backend.hpp>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "view/scene_view.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

double processorMs() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The median of several runs, in milliseconds of processor time.
double cost(int runs, const std::function<void()>& body) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const double before = processorMs();
        body();
        times.push_back(processorMs() - before);
    }
    std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
    return times[static_cast<std::size_t>(runs / 2)];
}

void tell(const char* what, double ms) {
    std::printf("  %-52s %8.1f ms of processor time\n", what, ms);
}

// MiB that are the process's own.
double memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("RssAnon:")) return std::stod(line.substr(8)) / 1024;
    return 0;
}

// 4,000 boxes of five particles.
std::filesystem::path largeScene() {
    const auto file = std::filesystem::temp_directory_path() /
                      ("sulfurchamber-scale-test-" + std::to_string(getpid()) + ".json");
    if (std::filesystem::exists(file)) return file;
    Workbench bench;
    bench.dropBoxes(4000);
    bench.document().save(file);
    return file;
}

TEST(Scale, TwentyThousandParticlesAreEdited) {
    const auto file = largeScene();
    Workbench bench;
    Document& document = bench.document();
    tell("open 20,000 particles", cost(3, [&] { document.open(file); }));
    ASSERT_EQ(document.world().bodies().size(), 4001u);
    tell("select all of them", cost(5, [&] {
             bench.select({});
             bench.selectAll();
         }));
    tell("nudge all of them", cost(5, [&] { bench.nudge({0.1, 0}); }));
    tell("undo that", cost(5, [&] { document.undo(); }));
    const auto box = document.bodyOf("box2000");
    bench.select({box});
    tell("nudge one of them", cost(5, [&] { bench.nudge({0.1, 0}); }));
    tell("undo that", cost(5, [&] { document.undo(); }));
    bench.setTool(ToolKind::select);
    const Point at = document.world().centreOfMass(box);
    bench.press({.position = at});
    double x = 0;
    tell("a move of the mouse that drags one",
         cost(20, [&] { bench.move({.position = at + Point(x += 0.05, 0)}); }));
    bench.release({.position = at + Point(x, 0)});
    EXPECT_NEAR(document.world().centreOfMass(document.bodyOf("box2000")).x(), at.x() + x, 1e-3);
    document.undo();
    EXPECT_NEAR(document.world().centreOfMass(document.bodyOf("box2000")).x(), at.x(), 1e-3);
    bench.setTool(ToolKind::box);
    tell("a click that adds a box", cost(5, [&] {
             bench.press({.position = {0, 80}});
             bench.release({.position = {0, 80}});
         }));
    tell("undo that", cost(5, [&] { document.undo(); }));
    std::filesystem::remove(file);
}

// Draws frames offscreen; before each the mouse does something.
class Frames final : public atlax::Application {
public:
    static constexpr int count = 30;
    Frames(Workbench& bench, std::function<void(SceneView&, int)> beside)
        : view_(bench), beside_(std::move(beside)) {}
    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        view_.start(platform);
    }
    void tick() override { view_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        if (frame_ > 0) beside_(view_, frame_);
        view_.draw(canvas, alpha);
        const double now = processorMs();
        if (frame_ > 2) times_.push_back(now - last_);
        last_ = now;
        if (++frame_ == count) platform_->quit();
    }
    void stop() override { view_.stop(); }
    double median() {
        std::nth_element(times_.begin(), times_.begin() + count / 3, times_.end());
        return times_[count / 3];
    }

private:
    SceneView view_;
    std::function<void(SceneView&, int)> beside_;
    atlax::Platform* platform_ = nullptr;
    std::vector<double> times_;
    double last_ = 0;
    int frame_ = 0;
};

double frameCost(Workbench& bench, std::function<void(SceneView&, int)> beside) {
    Frames frames(bench, std::move(beside));
    atlax::WindowOptions window;
    window.size = {960, 700};
    EXPECT_EQ(atlax::runOffscreen(frames, window), 0);
    return frames.median();
}

TEST(Scale, TwentyThousandParticlesAreShown) {
    const auto file = largeScene();
    Workbench bench;
    bench.document().open(file);
    const auto at = [](int frame) {
        return atlax::Vec2{400.0f + 2.0f * static_cast<float>(frame), 350};
    };
    tell("a frame at rest", frameCost(bench, [](SceneView&, int) {}));
    const auto pan = [&](SceneView& view, int frame) {
        if (frame == 1) view.event(atlax::MouseButtonEvent{atlax::MouseButton::Right, true, at(1)});
        view.event(atlax::MouseMoved{at(frame)});
    };
    tell("a frame while panning", frameCost(bench, pan));
    bench.selectAll();
    tell("a frame while panning, all selected", frameCost(bench, pan));
    bench.select({bench.document().bodyOf("box2000")});
    const Point box = bench.document().world().centreOfMass(bench.document().bodyOf("box2000"));
    tell("a frame while dragging one", frameCost(bench, [&](SceneView& view, int frame) {
             if (frame == 1)
                 view.event(
                     atlax::MouseButtonEvent{atlax::MouseButton::Left, true, view.toPixels(box)});
             view.event(atlax::MouseMoved{view.toPixels(box + Point(0.1 * frame, 0))});
         }));
    std::filesystem::remove(file);
}

TEST(Scale, LargeClothsAndManyBallsAreShown) {
    Workbench cloth;
    cloth.document().world().add(
        sulfur::shapes::cloth({.size = {14, 14}, .columns = 140, .rows = 140}),
        {.position = {0, 8}});
    tell("a frame of a cloth of 19,600 particles", frameCost(cloth, [](SceneView&, int) {}));
    Workbench balls;
    const auto ball = sulfur::shapes::ball({.radius = 0.2f});
    for (int i = 0; i < 20'000; ++i)
        balls.document().world().add(ball, {.position = {i % 141 * 0.5 - 35, i / 141 * 0.5}});
    tell("a frame of 20,000 balls", frameCost(balls, [](SceneView&, int) {}));
    EXPECT_EQ(balls.document().world().bodies().size(), 20'001u);
}

// Two grounds, a rope from one to the other, five crates on it.
TEST(Scale, ARopeBridgeBearsCratesAtASmallPrice) {
    Workbench bench;
    const auto drag = [&](ToolKind tool, const Point& from, const Point& to) {
        bench.setTool(tool);
        bench.press({.position = from});
        bench.move({.position = to});
        bench.release({.position = to});
    };
    drag(ToolKind::ground, {-6, 3}, {-3, 3});
    drag(ToolKind::ground, {3, 3}, {6, 3});
    drag(ToolKind::rope, {-3, 3}, {3, 3});
    const auto rope = bench.document().bodyOf("rope");
    for (const double x : {-1.5, -0.75, 0.0, 0.75, 1.5}) drag(ToolKind::box, {x, 3.6}, {x, 3.6});
    const double ms = processorMs();
    constexpr int seconds = 10;
    const sulfur::World& world = bench.document().world();
    for (int i = 0; i < seconds * world.settings().tickRate; ++i) bench.tick();
    std::printf("  a rope bridge with five crates: %.1f %% of a core\n",
                (processorMs() - ms) / (10.0 * seconds));
    double lowest = 3;
    for (const auto particle : world.particles(rope))
        lowest = std::min(lowest, world.position(particle).y());
    EXPECT_GT(3 - lowest, 0.3) << "it sags";
    EXPECT_LT(3 - lowest, 1.5);
    EXPECT_LE(world.joints(rope).size(), 30u);
    int borne = 0;
    for (const auto body : world.bodies())
        if (world.name(body) == "box" && world.centreOfMass(body).y() > 1.5) ++borne;
    EXPECT_EQ(borne, 5);
}

TEST(Scale, TenThousandStepsFitIntoMemory) {
    Workbench bench;
    bench.dropBoxes(100);
    bench.selectAll();
    bench.nudge({0.1, 0});
    const double before = memory();
    const double ms = processorMs();
    for (int i = 0; i < 10'000; ++i) bench.nudge({i % 2 == 0 ? 0.1 : -0.1, 0});
    const double grown = memory() - before;
    std::printf("  10,000 steps of a scene of 100 bodies: %.1f MiB, %.2f ms each\n", grown,
                (processorMs() - ms) / 10'000);
    EXPECT_EQ(bench.document().historyPlace(), 10'002u);
    EXPECT_LT(grown, 200);
    const std::string text = bench.document().text();
    for (int i = 0; i < 100; ++i) bench.document().undo();
    for (int i = 0; i < 100; ++i) bench.document().redo();
    EXPECT_EQ(bench.document().text(), text);
}

}  // namespace
}  // namespace sulfurchamber
