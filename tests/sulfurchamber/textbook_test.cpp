// The scenes of the textbook: what is measured is what the formula expects, within the bound that
// is stated beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

constexpr double g = 9.81;

struct Played {
    explicit Played(const char* scene) {
        bench.document().open(std::filesystem::path(SULFURCHAMBER_SCENES) /
                              ("textbook-" + std::string(scene) + ".json"));
        bench.documentChanged();
    }
    void run(double seconds) {
        const int ticks = static_cast<int>(std::lround(seconds * 500));
        for (int i = 0; i < ticks; ++i) bench.tick();
    }
    std::vector<Finding> findings() const { return bench.textbook().findings(); }

    Workbench bench;
};

// Nothing is measured before it has happened; then it is what is expected.
void expectFound(Played& played, double seconds, const std::vector<double>& expected) {
    ASSERT_EQ(played.bench.textbook().problem(), "");
    auto found = played.findings();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].expected, expected[i], 1e-3 * std::abs(expected[i])) << found[i].name;
        EXPECT_FALSE(found[i].measured) << found[i].name;
        EXPECT_FALSE(found[i].formula.empty());
    }
    played.run(seconds);
    found = played.findings();
    for (const Finding& one : found) {
        ASSERT_TRUE(one.measured) << one.name;
        EXPECT_GT(one.bound, 0);
        EXPECT_LE(std::abs(*one.difference()), one.bound)
            << one.name << ": measured " << *one.measured << ", expected " << one.expected;
        testing::Test::RecordProperty(one.name, std::to_string(*one.difference()));
    }
}

TEST(Textbook, Pendulum) {
    Played played("pendulum");
    // 30 degrees: 1.74 % longer than that of small ones.
    expectFound(played, 9, {2 * std::numbers::pi * std::sqrt(1 / g) * 1.017408798});
}

TEST(Textbook, FreeFall) {
    Played played("fall");
    expectFound(played, 1.2, {std::sqrt(8 / g), std::sqrt(8 * g)});
}

TEST(Textbook, Throw) {
    Played played("throw");
    expectFound(played, 1.4, {64 / g, 16 / g});
}

TEST(Textbook, Slope) {
    Played played("slope");
    expectFound(played, 8, {std::atan(0.5) * 180 / std::numbers::pi});
}

TEST(Textbook, Spring) {
    Played played("spring");
    expectFound(played, 8, {2 * std::numbers::pi * std::sqrt(1.0 / 40)});
}

TEST(Textbook, Collision) {
    Played played("collision");
    // (1 kg, 3 m/s) and (3 kg, -1 m/s): the sum of momenta is none, so both turn round.
    expectFound(played, 2, {-3, 1});
}

TEST(Textbook, Rolling) {
    Played played("rolling");
    expectFound(played, 2, {g * std::sin(15 * std::numbers::pi / 180) * 2 / 3});
}

TEST(Textbook, FollowsTheNumbersOfTheScene) {
    Played played("pendulum");
    played.run(9);
    ASSERT_TRUE(played.findings()[0].measured);
    Constants moon = played.bench.document().constants();
    moon.gravity = 1.62;
    played.bench.document().setConstants(moon);
    const double before = played.findings()[0].expected;
    EXPECT_GT(before, 4.9);
    EXPECT_FALSE(played.findings()[0].measured) << "of another gravity";
    played.run(20);
    ASSERT_TRUE(played.findings()[0].measured);
    EXPECT_LE(std::abs(*played.findings()[0].difference()), played.findings()[0].bound);
}

TEST(Textbook, ForgetsWhatIsRewound) {
    Played played("fall");
    played.run(1.2);
    ASSERT_TRUE(played.findings()[0].measured);
    Document& document = played.bench.document();
    ASSERT_TRUE(document.goTo({document.timeline().line(), 100}));
    EXPECT_FALSE(played.findings()[0].measured) << "it falls still";
    played.run(1);
    EXPECT_TRUE(played.findings()[0].measured);
    document.reset();
    EXPECT_FALSE(played.findings()[0].measured);
    played.run(1.2);
    EXPECT_LE(std::abs(*played.findings()[0].difference()), played.findings()[0].bound);
}

TEST(Textbook, TellsWhatAFormulaLacks) {
    Played played("pendulum");
    Constants none = played.bench.document().constants();
    none.gravity = 0;
    played.bench.document().setConstants(none);
    EXPECT_NE(played.bench.textbook().problem().find("gravity"), std::string::npos);
    EXPECT_TRUE(played.findings().empty());
    played.bench.selectAll();
    played.bench.deleteSelection();
    EXPECT_NE(played.bench.textbook().problem(), "");
    played.run(0.1);  // and nothing breaks
    Workbench plain;
    EXPECT_FALSE(plain.textbook().applies());
    EXPECT_EQ(plain.textbook().problem(), "");
    plain.document().adopt(sulfur::scene::parse(
        R"({"format": "sulfur-scene", "version": 1, "title": "x", "world": {}, "blueprints": {},
            "bodies": [], "textbook": {"law": "magic", "bodies": []}})",
        "x.json"));
    EXPECT_NE(plain.textbook().problem().find("magic"), std::string::npos);
}

TEST(StageTimes, AreThoseOfTheTicks) {
    Workbench bench;
    bench.dropBoxes(20);
    for (int i = 0; i < 50; ++i) bench.tick();
    EXPECT_EQ(bench.stageTimes().seconds(), 0) << "nobody asked";
    bench.setStageTimes(true);
    for (int i = 0; i < 300; ++i) bench.tick();
    EXPECT_GT(bench.stageTimes().seconds(), 0);
    EXPECT_GT(bench.stageTimes().seconds(sulfur::Stage::predict), 0);
    EXPECT_NEAR(bench.stageTimes().load(500), 500 * bench.stageTimes().seconds(), 1e-12);
    bench.document().reset();  // another world
    for (int i = 0; i < 10; ++i) bench.tick();
    EXPECT_GT(bench.document().world().statistics().seconds[0] +
                  bench.document().world().statistics().seconds[3],
              0);
}

TEST(CostSearch, FindsTheDearestObjectAndChangesNothing) {
    Workbench bench;
    // A cloth that flutters beside two crates.
    bench.document().adopt(sulfur::scene::parse(R"({
      "format": "sulfur-scene", "version": 1, "title": "costs", "world": {},
      "blueprints": {"sheet": {"shape": "jelly", "size": [4, 3], "columns": 24, "rows": 18, "mass": 4},
                     "crate": {"shape": "box", "size": [0.5, 0.5], "mass": 1}},
      "bodies": [{"id": "sheet", "blueprint": "sheet", "position": [0, 6]},
                 {"id": "one", "blueprint": "crate", "position": [5, 6]},
                 {"id": "two", "blueprint": "crate", "position": [7, 6]}]})",
                                                "costs"));
    bench.tick();
    const auto before = bench.document().world().hash();
    CostSearch search(bench.document());
    EXPECT_TRUE(search.costs().empty());
    int calls = 0;
    while (!search.goOn(2)) ++calls;
    EXPECT_EQ(search.progress(), 1);
    ASSERT_FALSE(search.costs().empty());
    EXPECT_EQ(search.costs()[0].name, "sheet");
    EXPECT_GT(search.costs()[0].share, 0.3);
    EXPECT_EQ(bench.document().world().hash(), before);
}

}  // namespace
}  // namespace sulfurchamber
