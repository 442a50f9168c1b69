// Films of what is recorded.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atlax/files.hpp>
#include <atlax/image.hpp>
#include <atlax/offscreen.hpp>
#include <filesystem>
#include <string>

#include "view/scene_view.hpp"

namespace sulfurchamber {
namespace {

std::size_t countIn(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

struct Filmed {
    std::string bytes;
    atlax::Image first;
    int steps = 0;
};

// `beside` is done before each step, as a person goes on working.
Filmed film(Workbench& bench, const std::function<void(int)>& beside = {}) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("sulfurchamber-film-test-" + std::to_string(getpid()) + ".png");
    std::filesystem::remove(file);
    atlax::OffscreenCanvas offscreen({64, 40});
    const SceneView view(bench);
    const atlax::Camera camera{{0, 2}, 100};
    SceneFilm made(view, bench.document(), camera, {960, 600}, file);
    Filmed filmed;
    for (bool done = false; !done && filmed.steps < 5000; ++filmed.steps) {
        if (beside) beside(filmed.steps);
        EXPECT_FALSE(std::filesystem::exists(file)) << "written when it is whole";
        done = made.step(offscreen.begin());
        offscreen.finish();
    }
    filmed.bytes = atlax::readFile(file, 1 << 28);
    filmed.first = atlax::loadImage(file);
    std::filesystem::remove(file);
    return filmed;
}

void dropABox(Workbench& bench) {
    bench.setTool(ToolKind::box);
    bench.press({.position = {0, 4}});
    bench.release({.position = {0, 4}});
}

TEST(SceneFilm, TheLastTenSecondsAreReplayed) {
    Workbench bench;
    dropABox(bench);
    for (int i = 0; i < 6000; ++i) bench.tick();
    const auto hash = bench.document().world().hash();
    const auto moment = bench.document().timeline().now();
    const Filmed filmed = film(bench);
    EXPECT_EQ(countIn(filmed.bytes, "acTL"), 1u);
    EXPECT_EQ(countIn(filmed.bytes, "fcTL"), 126u);  // 10 s, a picture each 80 ms
    EXPECT_EQ(filmed.first.size(), (atlax::PixelSize{480, 300}));
    EXPECT_EQ(bench.document().world().hash(), hash) << "the scene stays where it is";
    EXPECT_EQ(bench.document().timeline().now(), moment);
}

// The first picture shows the past: the box is up there.
TEST(SceneFilm, ItShowsWhatWasAndNotWhatIs) {
    Workbench bench;
    dropABox(bench);
    for (int i = 0; i < 1500; ++i) bench.tick();
    const Filmed filmed = film(bench);
    EXPECT_EQ(countIn(filmed.bytes, "fcTL"), 39u);  // 3 s
    // The box is at (0, 4): 2 m above the middle, at 50 pixels a metre. On the floor it is not.
    const auto light = [&](int x, int y) {
        const auto pixel = filmed.first.pixel(x, y);
        return pixel[0] + pixel[1] + pixel[2];
    };
    EXPECT_GT(light(240, 50), light(260, 75) + 40);
    EXPECT_LT(light(240, 150 + 85), light(240, 50));
}

// Whoever plays on, edits, or rewinds meanwhile gets the same film.
TEST(SceneFilm, WorkGoesOnBesideIt) {
    const auto played = [](Workbench& bench) {
        dropABox(bench);
        for (int i = 0; i < 1000; ++i) bench.tick();
    };
    Workbench quiet;
    played(quiet);
    Workbench busy;
    played(busy);
    const Filmed alone = film(quiet);
    const Filmed beside = film(busy, [&](int step) {
        Document& document = busy.document();
        if (step % 5 == 0) busy.tick();
        if (step == 7) document.goTo({document.timeline().line(), 200});
        if (step == 9) dropABox(busy);
        if (step == 12) document.undo();
    });
    EXPECT_EQ(alone.bytes, beside.bytes);
}

TEST(SceneFilm, WhatIsForgottenIsTold) {
    Workbench bench;
    dropABox(bench);
    for (int i = 0; i < 500; ++i) bench.tick();
    EXPECT_THROW(film(bench,
                      [&](int step) {
                          if (step == 3) bench.document().clear();
                      }),
                 std::runtime_error);
}

}  // namespace
}  // namespace sulfurchamber
