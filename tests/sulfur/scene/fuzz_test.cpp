// Whatever a file contains, it is read or refused with a ReadError; nothing else happens.
#include <gtest/gtest.h>

#include <random>

#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;

class Mutator {
public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    std::string mutate(std::string text) {
        const auto changes = 1 + below(4);
        for (std::size_t i = 0; i < changes && !text.empty(); ++i) change(text);
        return text;
    }

private:
    std::size_t below(std::size_t limit) { return random_() % limit; }

    void change(std::string& text) {
        static const std::vector<std::string> tokens{"null",        "true",
                                                     "-1",          "0",
                                                     "1e308",       "1e-320",
                                                     "4294967296",  "\"\"",
                                                     "{}",          "[]",
                                                     "[[]]",        "\"rigid\"",
                                                     "\"box\"",     "NaN",
                                                     ",",           "}",
                                                     "]",           "\"a\":",
                                                     "-0",          "0.5",
                                                     "\"\\ud800\"", "99999999999999999999"};
        const auto at = below(text.size());
        switch (below(12)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1 + below(20));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), below(40)));
                break;
            case 3:
                text.resize(at);
                break;
            case 4:
            case 5:
            case 6:
                replaceValue(text, at, tokens[below(tokens.size())]);
                break;
            default:
                changeDigit(text, at);
        }
    }

    void changeDigit(std::string& text, std::size_t at) {
        const auto digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
    }

    /// Puts a token in the place of what is there up to the next separator, so that most texts
    /// stay JSON.
    static void replaceValue(std::string& text, std::size_t at, const std::string& token) {
        const auto begin = text.find_first_of(":[,", at);
        if (begin == std::string::npos) return;
        const auto end = text.find_first_of(",]}", begin + 1);
        if (end == std::string::npos) return;
        text.replace(begin + 1, end - begin - 1, token);
    }

    std::mt19937_64 random_;
};

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
