// Pictures of the recorded past: which there are, and that they show what was.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>

#include "view/past_pictures.hpp"
#include "view/scene_view.hpp"

namespace sulfurchamber {
namespace {

constexpr double barWidth = 800;
constexpr int places = 10;

// A scene whose frames take pictures as those of a window do, a frame each 50 ms.
class Recorded {
public:
    Document& document() { return bench_.document(); }
    PastPictures& past() { return past_; }
    void letPass(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            bench_.tick();
            if (i % 25 == 24) look();
        }
    }
    bool look() {
        ns_ += 50'000'000;
        if (!past_.due(document(), ns_)) return false;
        past_.add(document(), atlax::Image(PastPictures::size), ns_, 0);
        return true;
    }
    std::vector<const PastPictures::Picture*> strip() const {
        const Document& document = bench_.document();
        const TimeBarLayout layout(document.timeline(),
                                   static_cast<double>(document.world().tickDuration()), barWidth);
        return past_.strip(document, layout, barWidth, places);
    }

private:
    Workbench bench_;
    PastPictures past_;
    std::int64_t ns_ = 0;
};

TEST(PastPictures, FitIntoTheMemoryOfTheRewindBesideItsKeys) {
    const std::size_t all = PastPictures::most * 4 *
                            static_cast<std::size_t>(PastPictures::size.width) *
                            static_cast<std::size_t>(PastPictures::size.height);
    EXPECT_LE(TimelineLimits{}.bytes + all, std::size_t{64} << 20);
    Recorded scene;
    EXPECT_FALSE(scene.look()) << "nothing is recorded";
    scene.letPass(500 * 200);
    EXPECT_LE(scene.past().count(), PastPictures::most);
    EXPECT_GT(scene.past().count(), PastPictures::most / 2);
}

TEST(PastPictures, EachPlaceOfTheStripShowsWhatWasThere) {
    Recorded scene;
    EXPECT_EQ(scene.strip(), std::vector<const PastPictures::Picture*>(places, nullptr));
    scene.letPass(500 * 40);
    const auto strip = scene.strip();
    ASSERT_EQ(strip.size(), std::size_t{places});
    for (std::size_t i = 0; i < strip.size(); ++i) {
        ASSERT_NE(strip[i], nullptr);
        const double seconds = static_cast<double>(strip[i]->moment.tick) / 500;
        EXPECT_NEAR(seconds, 4 * static_cast<double>(i) + 2, 1.5);
    }
}

TEST(PastPictures, WhereNothingIsRecordedThereAreNone) {
    Recorded scene;
    scene.letPass(250);  // of the second that the bar has at least
    const auto strip = scene.strip();
    EXPECT_NE(strip[1], nullptr);
    EXPECT_NE(strip[4], nullptr);
    EXPECT_EQ(strip[6], nullptr);
    EXPECT_EQ(strip[9], nullptr);
}

TEST(PastPictures, AreFewASecondAndCostATwentiethOfTheTime) {
    Workbench bench;
    PastPictures past;
    bench.tick();
    ASSERT_TRUE(past.due(bench.document(), 0));
    past.add(bench.document(), atlax::Image(PastPictures::size), 0, 50'000'000);
    for (int i = 0; i < 200; ++i) bench.tick();
    EXPECT_FALSE(past.due(bench.document(), 999'000'000));
    EXPECT_TRUE(past.due(bench.document(), 1'000'000'000));
    past.add(bench.document(), atlax::Image(PastPictures::size), 1'000'000'000, 1000);
    for (int i = 0; i < 200; ++i) bench.tick();
    EXPECT_FALSE(past.due(bench.document(), 1'000'000'000 + PastPictures::restNs - 1));
    EXPECT_TRUE(past.due(bench.document(), 1'000'000'000 + PastPictures::restNs));
}

TEST(PastPictures, ABranchHasThoseBeforeItPartedAndItsOwn) {
    Recorded scene;
    scene.letPass(5000);
    const std::uint32_t first = scene.document().timeline().line();
    scene.document().goTo({first, 2500});
    scene.letPass(2500);
    const std::uint32_t second = scene.document().timeline().line();
    ASSERT_NE(first, second);
    const auto branches = [&] {
        std::pair<int, int> count;
        for (const auto* one : scene.strip())
            if (one != nullptr) ++(one->moment.branch == first ? count.first : count.second);
        return count;
    };
    EXPECT_EQ(branches(), std::pair(5, 5));
    EXPECT_EQ(scene.past().near(scene.document(), {second, 4000})->moment.branch, second);
    scene.document().goTo({first, 5000});
    EXPECT_EQ(branches(), std::pair(10, 0));
    EXPECT_EQ(scene.past().near(scene.document(), {first, 4000})->moment.branch, first);
}

TEST(PastPictures, WhatIsForgottenIsDropped) {
    Recorded scene;
    scene.letPass(500 * 150);  // 120 s of them stay
    const Timeline& timeline = scene.document().timeline();
    const std::uint64_t begin = timeline.first(timeline.line());
    EXPECT_GT(begin, 500u * 20);
    for (const auto* one : scene.strip()) EXPECT_GE(one->moment.tick, begin);
    scene.document().clear();
    EXPECT_GT(scene.past().count(), 0u);
    scene.look();
    EXPECT_EQ(scene.past().count(), 0u);
}

TEST(PastPictures, AnEditMakesTheMomentsPictureAnew) {
    Recorded scene;
    scene.letPass(1000);
    Document& document = scene.document();
    const Moment now = *document.timeline().now();
    const auto before = scene.past().near(document, now)->serial;
    document.edit("Nudge", [&] {
        const auto bodies = document.world().bodies();
        document.translate({&bodies[0], 1}, {0, 1});
    });
    for (int i = 0; i < 10; ++i) scene.look();
    const auto* after = scene.past().near(document, now);
    ASSERT_NE(after, nullptr);
    EXPECT_GT(after->serial, before);
    EXPECT_EQ(after->moment.tick, now.tick);
}

// The view takes them while a ball falls, and shows one above the time bar.
class Watching final : public atlax::Application {
public:
    explicit Watching(Workbench& bench) : bench_(bench), view_(bench) {}
    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        view_.start(platform);
        view_.setSpeedPermille(250);
    }
    void event(const atlax::Event& event) override { view_.event(event); }
    void tick() override { view_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        view_.draw(canvas, alpha);
        if (view_.past().count() < 3 && view_.frames() < 20'000) return;
        if (bench_.document().playing()) {
            bench_.document().pause();
            const Timeline& timeline = bench_.document().timeline();
            plain = canvas.readFrame();
            view_.showPast(Moment{timeline.line(), timeline.first(timeline.line())}, 40);
            return;
        }
        withCard = canvas.readFrame();
        shown = view_.showsPast();
        platform_->quit();
    }
    void stop() override { view_.stop(); }
    const PastPictures& past() const { return view_.past(); }

    atlax::Image plain;
    atlax::Image withCard;
    bool shown = false;

private:
    Workbench& bench_;
    SceneView view_;
    atlax::Platform* platform_ = nullptr;
};

TEST(PastPictures, TheViewTakesThemWhileTimeRuns) {
    Workbench bench;
    bench.setTool(ToolKind::ball);
    bench.press({.position = {0, 4}});
    bench.release({.position = {0.8, 4}});
    bench.document().play();
    Watching app(bench);
    atlax::WindowOptions window;
    window.size = {640, 360};
    ASSERT_EQ(atlax::runOffscreen(app, window), 0);
    const auto& timeline = bench.document().timeline();
    const auto* first =
        app.past().near(bench.document(), {timeline.line(), timeline.first(timeline.line())});
    const auto* last =
        app.past().near(bench.document(), {timeline.line(), timeline.last(timeline.line())});
    ASSERT_NE(first, nullptr);
    ASSERT_NE(last, nullptr);
    const auto differing = [](const atlax::Image& a, const atlax::Image& b) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        return count;
    };
    EXPECT_GT(differing(first->image, last->image), 40) << "the ball has fallen";
    EXPECT_TRUE(app.shown);
    const int card = PastPictures::size.width * PastPictures::size.height;
    EXPECT_GT(differing(app.plain, app.withCard), card / 2);
}

}  // namespace
}  // namespace sulfurchamber
