// Whatever a file contains, it is read or refused with a ReadError; nothing else happens.
#include <gtest/gtest.h>

#include <random>

#include "mutator.hpp"
#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;

TEST(Fuzz, MutatedScenesAreReadOrRefused) {
    Mutator mutator(20140601);
    int good = 0, bad = 0;
    for (int i = 0; i < 6000; ++i) {
        const std::string text = mutator.mutate(fullScene);
        try {
            const Scene scene = parse(text, "fuzz.json");
            ++good;
            // What was read can be written, read again, and lived in.
            ASSERT_EQ(format(parse(format(scene), "again")), format(scene)) << text;
            sulfur::World world(scene.settings);
            instantiate(scene, world);
            world.step();
            ASSERT_EQ(world.validate(), "") << text;
        } catch (const ReadError& error) {
            ++bad;
            ASSERT_GE(error.line(), 1);
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        } catch (const std::exception& error) {
            FAIL() << error.what() << " for\n" << text;
        }
    }
    // Both kinds must be well represented, or the test tests little.
    EXPECT_GT(good, 300);
    EXPECT_GT(bad, 3000);
}

TEST(Fuzz, MutatedBlueprintsAreReadOrRefused) {
    const Scene scene = parse(fullScene, "full.json");
    Mutator mutator(4);
    for (int i = 0; i < 2000; ++i) {
        const auto& prefab = scene.blueprints[static_cast<std::size_t>(i) % 8];
        const std::string text = mutator.mutate(format(prefab));
        try {
            parseBlueprint(text, "fuzz.json").blueprint.validate();
        } catch (const ReadError& error) {
            ASSERT_GE(error.line(), 1);
        } catch (const std::exception& error) {
            FAIL() << error.what() << " for\n" << text;
        }
    }
}

TEST(Fuzz, NoiseIsRefused) {
    std::mt19937_64 random(99);
    for (int i = 0; i < 500; ++i) {
        std::string noise(1 + random() % 300, '\0');
        for (char& c : noise) c = static_cast<char>(random());
        EXPECT_THROW(parse(noise, "noise"), ReadError);
    }
}

}  // namespace
