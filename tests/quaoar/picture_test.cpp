// What a picture costs and shows.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <atlax/offscreen.hpp>
#include <cmath>
#include <ctime>
#include <quaoar/view/game_view.hpp>

#include "../../quaoar/game/view/body_shape.hpp"
#include "helpers.hpp"

namespace quaoar::test {
namespace {

/// A session, its view and a canvas without a window.
struct Scene {
    explicit Scene(std::shared_ptr<const Level> level, atlax::PixelSize size = {1280, 720})
        : session(std::move(level)), offscreen(size), art(offscreen.canvas()), view(art, session) {}

    void play(const TickInput& input, int ticks) {
        for (int n = 0; n < ticks; ++n) {
            session.tick(input);
            view.tick();
        }
    }
    atlax::CanvasStatistics draw(const Quality& quality = {}) {
        atlax::Canvas& canvas = offscreen.begin();
        ViewOptions options;
        options.quality = quality;
        view.draw(canvas, 1, options);
        offscreen.finish();
        return canvas.statistics();
    }
    /// Milliseconds of processor time of a frame, all threads together.
    double cost(const Quality& quality) {
        play({}, 8);
        draw(quality);  // makes its targets
        glFinish();
        const std::clock_t start = std::clock();
        draw(quality);
        glFinish();
        return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }

    Session session;
    atlax::OffscreenCanvas offscreen;
    Art art;
    GameView view;
};

/// On the software renderer; a graphics card makes nothing of any of it.
TEST(Picture, costsLessAtEveryStepOfTheQuality) {
    Scene scene(firstLevel());
    scene.play(fireAt(0, 1), 200);
    scene.draw();
    // The cheapest of some frames, in turns: so what else the machine does counts least, and alike.
    std::vector<double> costs(std::size(qualities), 1e9);
    for (int round = 0; round < 12; ++round)
        for (std::size_t q = 0; q < costs.size(); ++q)
            costs[q] = std::min(costs[q], scene.cost(qualities[q]));
    for (std::size_t q = 0; q < costs.size(); ++q) {
        RecordProperty("cost-" + std::to_string(q), std::to_string(costs[q]));
        std::printf("quality %zu: %.1f ms of processor time a frame\n", q, costs[q]);
    }
    EXPECT_LT(costs[2], costs[0]);
    EXPECT_LT(costs.back(), costs[0] * 0.4);
}

/// Plays for so many seconds on a machine whose frames take these times; the level at the end.
template <class Cost>
int settle(FrameGovernor& governor, double seconds, double refresh, Cost cost) {
    for (double t = 0; t < seconds;) {
        const double frame = std::max(refresh, cost(governor.level()));
        governor.frame(frame);
        t += frame;
    }
    return governor.level();
}

TEST(FrameGovernor, findsTheBestThatIsQuickEnough) {
    const double slow[] = {0.110, 0.068, 0.034, 0.019, 0.012};
    FrameGovernor governor;
    EXPECT_EQ(settle(governor, 4, 0, [&](int q) { return slow[q]; }), 3);
    // It looks up now and then whether more is possible, and more and more rarely.
    int spoilt = 0;
    for (int n = 0; n < 120; ++n)
        spoilt += settle(governor, 1, 0, [&](int q) { return slow[q]; }) != 3 ? 1 : 0;
    EXPECT_LE(spoilt, 12);
}

TEST(FrameGovernor, goesUpToTheBestWhereThereIsRoom) {
    FrameGovernor governor;
    EXPECT_EQ(settle(governor, 20, 1 / 144.0, [](int) { return 0.002; }), 0);
    EXPECT_EQ(settle(governor, 60, 1 / 60.0, [](int) { return 0.002; }), 0);
}

TEST(FrameGovernor, doesNotSpoilThePictureForASlowDisplay) {
    FrameGovernor governor;
    const int first = governor.level();
    EXPECT_EQ(settle(governor, 30, 1 / 30.0, [](int) { return 0.002; }), first);
}

TEST(FrameGovernor, ignoresASingleHiccupAndRubbish) {
    FrameGovernor governor;
    settle(governor, 20, 1 / 60.0, [](int) { return 0.002; });
    for (const double odd : {0.4, 5.0, -1.0, 0.0, std::nan("")}) {
        governor.frame(odd);
        settle(governor, 1, 1 / 60.0, [](int) { return 0.002; });
    }
    EXPECT_LE(governor.level(), 1);
}

TEST(Picture, showsThatAShotHasMissed) {
    Scene scene(room(replaced(replaced(roomText, "[4, 3], [-4, 3]", "[4, 30], [-4, 30]"),
                              "\"max\": [4, 4]", "\"max\": [4, 31]")));
    scene.play({}, 100);
    EXPECT_EQ(scene.view.looseRopes(), 0u);
    int missed = 0;
    for (int n = 0; n < 100; ++n) {
        scene.play(fireAt(0, 1), 1);
        missed += scene.session.events().missed ? 1 : 0;
        if (missed > 0) break;
    }
    ASSERT_EQ(missed, 1) << "nothing is in reach above";
    EXPECT_EQ(scene.view.looseRopes(), 1u) << "the rope falls";
    EXPECT_GT(scene.view.reachFlash(), 0.9f) << "and its reach lights up";
    scene.draw();
    scene.play(fireAt(0, 1), 600);
    EXPECT_EQ(scene.view.looseRopes(), 0u);
    EXPECT_EQ(scene.view.reachFlash(), 0);
}

TEST(Picture, showsHowTheRopeStrains) {
    Scene scene(room());
    scene.play(fireAt(0, 1), 100);
    ASSERT_EQ(scene.session.rope().state(), Rope::State::attached);
    const TickInput hang = fireAt(0, 1);
    TickInput reel = hang;
    reel.reelIn = true;
    scene.play(reel, 500);
    scene.play(hang, 2000);
    const float hanging = scene.view.strain();
    EXPECT_GT(hanging, 0.08f);
    EXPECT_LT(hanging, 0.35f) << "room to show more";
    // A pull as at the lowest point of a fast swing.
    for (int n = 0; n < 60; ++n) {
        for (const sulfur::ParticleId particle :
             scene.session.world().particles(scene.session.hero()))
            scene.session.world().setVelocity(particle, {0, -6});
        scene.play(hang, 1);
    }
    EXPECT_GT(scene.view.strain(), hanging + 0.2f);
}

/// Mean difference of a colour's part, 0..255.
double apart(const atlax::Image& a, const atlax::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes().size(); ++i)
        sum += std::abs(static_cast<double>(a.bytes()[i]) - static_cast<double>(b.bytes()[i]));
    return sum / static_cast<double>(a.bytes().size());
}

TEST(Picture, tellsTheFourWorldsApart) {
    std::vector<atlax::Image> pictures;
    for (const char* world : {"dawn", "bog", "machine", "deep"}) {
        Scene scene(room(replaced(roomText, "\"killDepth\": -3,",
                                  "\"killDepth\": -3, \"theme\": {\"world\": \"" +
                                      std::string(world) + "\"},")),
                    {320, 180});
        scene.play({}, 10);
        scene.draw();
        pictures.push_back(scene.offscreen.image());
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t k = i + 1; k < pictures.size(); ++k)
            EXPECT_GT(apart(pictures[i], pictures[k]), 8) << i << " and " << k;
    }
}

TEST(Picture, dimsTheSceneryForHighContrast) {
    Scene scene(firstLevel(), {320, 180});
    scene.play({}, 200);
    scene.draw();
    const atlax::Image usual = scene.offscreen.image();
    ViewOptions options;
    options.highContrast = true;
    scene.view.draw(scene.offscreen.begin(), 1, options);
    scene.offscreen.finish();
    EXPECT_GT(apart(usual, scene.offscreen.image()), 12);
}

TEST(Picture, tearsSkinsWhereJointsBreak) {
    std::string text =
        replaced(roomText, "\"shape\": \"box\", \"size\": [0.4, 0.4], \"mass\": 1",
                 "\"shape\": \"wall\", \"size\": [0.8, 0.8], \"columns\": 4, \"rows\": 4, "
                 "\"mass\": 4, \"skin\": {\"texture\": \"crate.svg\"}");
    text = replaced(text, "\"position\": [-2, 0.3]", "\"position\": [-2, 0.5]");
    Session session(room(text));
    const sulfur::BodyId wall = session.instance().body("box-1");
    const BodyShape whole = shapeOf(session, wall);
    EXPECT_EQ(whole.texture, "crate.svg");
    EXPECT_GE(whole.triangles.size(), 32u) << "two at least in each of 16 cells";
    EXPECT_EQ(whole.border.size(), 16u);
    EXPECT_TRUE(whole.loose.empty());
    EXPECT_TRUE(whole.fits(session.world(), wall));
    // All joints of one particle in the middle go.
    const sulfur::ParticleId middle = session.world().particles(wall)[12];
    std::vector<sulfur::JointId> doomed;
    for (const sulfur::JointId joint : session.world().joints(wall)) {
        const sulfur::JointInfo info = session.world().info(joint);
        if (info.a == middle || info.b == middle) doomed.push_back(joint);
    }
    ASSERT_GE(doomed.size(), 4u);
    for (const sulfur::JointId joint : doomed) session.world().remove(joint);
    session.tick({});
    EXPECT_FALSE(whole.fits(session.world(), wall));
    const BodyShape torn = shapeOf(session, wall);
    EXPECT_LT(torn.triangles.size(), whole.triangles.size());
    EXPECT_GT(torn.border.size(), whole.border.size()) << "the hole has a border of its own";
    EXPECT_EQ(torn.uv.size(), torn.particles) << "and the rest keeps its picture";
}

TEST(Picture, isTheSameWorldAtEveryQuality) {
    Scene scene(firstLevel());
    scene.play(fireAt(0.3, 1), 400);
    const std::uint64_t hash = scene.session.hash();
    for (const Quality& quality : qualities) scene.draw(quality);
    EXPECT_EQ(scene.session.hash(), hash);
}

}  // namespace
}  // namespace quaoar::test
