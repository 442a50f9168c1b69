// Every example can be read and played.
#include <gtest/gtest.h>

#include <algorithm>
#include <atlax/files.hpp>
#include <cmath>
#include <filesystem>

#include "model/document.hpp"

namespace sulfurchamber {
namespace {

class Gallery : public testing::TestWithParam<const char*> {};

TEST_P(Gallery, ReadsAndPlaysTwoSeconds) {
    Document document;
    document.open(std::filesystem::path(SULFURCHAMBER_SCENES) /
                  (std::string(GetParam()) + ".json"));
    EXPECT_FALSE(document.scene().title.empty());
    EXPECT_FALSE(document.scene().description.empty());
    // The sandbox's own: colours of bodies, and keys that drive things.
    for (const std::string& note : sulfur::scene::unknownKeys(document.scene()))
        EXPECT_TRUE(note.find("\"color\"") != std::string::npos ||
                    note.find("\"keys\"") != std::string::npos)
            << note;
    const auto before = document.world().hash();
    const int ticks = 2 * document.world().settings().tickRate;
    for (int i = 0; i < ticks; ++i) document.tick();
    EXPECT_EQ(document.world().validate(), "");
    EXPECT_TRUE(std::isfinite(document.world().energy()));
    EXPECT_NE(document.world().hash(), before);
    // What is on screen at the start is still about there.
    for (const auto body : document.world().bodies())
        EXPECT_LT(document.world().centreOfMass(body).norm(), 60) << document.world().name(body);
}

// Byte for byte: examples are what the program makes.
TEST_P(Gallery, IsAsTheProgramSavesIt) {
    const auto file =
        std::filesystem::path(SULFURCHAMBER_SCENES) / (std::string(GetParam()) + ".json");
    Document document;
    document.open(file);
    EXPECT_EQ(document.text(), atlax::readFile(file, 1 << 22));
}

INSTANTIATE_TEST_SUITE_P(
    All, Gallery,
    testing::Values("arch", "atwood", "beam-strength", "billiards", "bouncing-balls", "boxes",
                    "bridge", "car", "catapult", "cloth", "conveyors", "crane", "crank",
                    "crate-cradle", "crumbling-wall", "dominoes", "flag", "friction-slope", "gears",
                    "hookes-law", "jelly-to-rigid", "jelly-tower", "lever", "mass-ratio",
                    "newtons-cradle", "orbits", "paper-4-rope", "paper-5-rope", "paper-6-squares",
                    "paper-9-bodies", "pendulum", "pendulum-clock", "pendulum-lengths",
                    "projectiles", "rolling-race", "rope", "rope-bridge", "spring-periods",
                    "textbook-collision", "textbook-fall", "textbook-pendulum", "textbook-rolling",
                    "textbook-slope", "textbook-spring", "textbook-throw", "torn-cloth",
                    "trebuchet", "walker", "wind", "wrecking-ball"),
    [](const auto& scene) {
        std::string name = scene.param;
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    });

/// Free ropes swing as ropes do, and come to rest.
TEST(GalleryScenes, RopesCalmDown) {
    Document document;
    document.open(std::filesystem::path(SULFURCHAMBER_SCENES) / "rope.json");
    const auto fastest = [&] {
        double most = 0;
        for (const auto body : document.world().bodies())
            for (const auto particle : document.world().particles(body))
                most =
                    std::max(most, static_cast<double>(document.world().velocity(particle).norm()));
        return most;
    };
    for (int i = 0; i < 500 * 2; ++i) document.tick();
    EXPECT_GT(fastest(), 0.5);
    for (int i = 0; i < 500 * 38; ++i) document.tick();
    EXPECT_LT(fastest(), 0.25);
}

TEST(GalleryFolder, HasOnlyTheseScenes) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SULFURCHAMBER_SCENES))
        if (entry.path().extension() == ".json") ++files;
    EXPECT_EQ(files, 50u) << "a new example belongs into the list above";
}

}  // namespace
}  // namespace sulfurchamber
