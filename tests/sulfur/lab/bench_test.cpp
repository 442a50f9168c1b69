// The comparison with other engines: its scenes, its measures and how it shows them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/clock.hpp"
#include "bench/history.hpp"
#include "bench/plots.hpp"
#include "bench/show.hpp"
#include "bench/squares.hpp"
#include "bench/ticks.hpp"
#include "figure_of.hpp"
#include "paper_tables.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;
using namespace sulfur::lab::bench;

/// Notes what a scene makes, and moves nothing.
class Notebook final : public EngineWorld {
public:
    void addFixed(const Point& centre, const Point& half) override {
        fixed.emplace_back(centre, half);
    }
    void addSquare(const Point& centre, double angle, const Point& velocity) override {
        squares.emplace_back(centre, angle);
        velocities.push_back(velocity);
    }
    void addRope(const RopePlan& plan) override { ropes.push_back(plan); }
    void addBlob(const Point& centre) override { blobs.push_back(centre); }
    void step() override { ++steps; }
    std::pair<Point, double> square(std::size_t i) const override { return squares[i]; }
    std::vector<Point> rope(std::size_t i) const override { return ropes[i].points; }
    std::vector<Point> blob(std::size_t i) const override {
        std::vector<Point> all = BlobPlan::places();
        for (Point& p : all) p += blobs[i];
        return all;
    }

    std::vector<std::pair<Point, Point>> fixed;
    std::vector<Square> squares;
    std::vector<Point> velocities, blobs;
    std::vector<RopePlan> ropes;
    long steps = 0;
};

/// An engine whose worlds are notebooks that outlive them.
Engine noting(std::vector<Notebook*>& made) {
    Engine engine{
        .key = "sulfur", .title = "Notes", .version = {}, .features = {}, .make = {}, .how = {}};
    engine.make = [&made](const Setting&) {
        auto world = std::make_unique<Notebook>();
        made.push_back(world.get());
        return world;
    };
    return engine;
}

TEST(BenchScenes, TheGeneratorIsTheOneThatIsMeant) {
    Lcg random(12345);
    // 12345 * 1664525 + 1013904223 modulo 2^32, without its last 8 bits.
    const std::uint32_t first = 12345U * 1664525U + 1013904223U;
    EXPECT_EQ(random.next(), (first >> 8) / 16777216.0);
    EXPECT_EQ(random.next(), ((first * 1664525U + 1013904223U) >> 8) / 16777216.0);
}

TEST(BenchScenes, BoxesDropInPairsIntoSlots) {
    // W = 50 m, 19 slots of 50/19 m; 0.618 * 19 = 11.74, so that the stride is 12.
    EXPECT_EQ(arenaWidth(100), 50);
    EXPECT_EQ(arenaWidth(20), 20);
    EXPECT_NEAR(pairPlace(100, 0), -25 + 0.5 * 50 / 19, 1e-12);
    EXPECT_NEAR(pairPlace(100, 1), -25 + 12.5 * 50 / 19, 1e-12);
    EXPECT_NEAR(pairPlace(100, 2), -25 + 5.5 * 50 / 19, 1e-12);
    Notebook world;
    const auto play = droppedBoxes(100).play();
    play->begin(world);
    ASSERT_EQ(world.fixed.size(), 3u);
    EXPECT_EQ(world.fixed[0].second, Point(27, 1));
    EXPECT_EQ(std::abs(world.fixed[1].first.x()), 26);
    play->before(world, 0);
    EXPECT_EQ(world.squares.size(), 2u);
    play->before(world, 0.0199);
    EXPECT_EQ(world.squares.size(), 2u);
    play->before(world, 0.02);
    ASSERT_EQ(world.squares.size(), 4u);
    EXPECT_NEAR(world.squares[1].first.x() - world.squares[0].first.x(), 1.3, 1e-12);
    EXPECT_EQ(world.squares[0].first.y(), 30);
    EXPECT_EQ(world.velocities[0], Point(0, -5));
    EXPECT_LE(std::abs(world.squares[0].second), 0.3);
    play->before(world, 100);
    EXPECT_EQ(world.squares.size(), 1000u);
}

TEST(BenchScenes, ThePyramidStandsAsItWasBuilt) {
    Notebook world;
    const auto play = pyramid(4).play();
    play->begin(world);
    ASSERT_EQ(world.squares.size(), 10u);
    EXPECT_NEAR(world.squares[0].first.x(), -1.575, 1e-12);
    EXPECT_EQ(world.squares[9].first, Point(0, 3.5));
    const Figures still = play->figures(world);
    EXPECT_EQ(figureOf(still, "stands"), 1);
    EXPECT_EQ(figureOf(still, "moved > 0.5 m"), 0);
    world.squares[9].first += Point(0, -1.5);
    const Figures fallen = play->figures(world);
    EXPECT_EQ(figureOf(fallen, "stands"), 0);
    EXPECT_NEAR(figureOf(fallen, "top sinks"), 1500, 1e-9);
    EXPECT_EQ(figureOf(fallen, "moved > 0.5 m"), 1);
    world.squares[0].first.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(figureOf(play->figures(world), "moved > 0.5 m"), 2);
}

TEST(BenchScenes, BlobsAreSixteenDiscsWithFortyTwoSprings) {
    EXPECT_EQ(BlobPlan::places().size(), 16u);
    const auto springs = BlobPlan::springs();
    ASSERT_EQ(springs.size(), 42u);
    const auto places = BlobPlan::places();
    const auto sides = std::count_if(springs.begin(), springs.end(), [&](const auto& s) {
        return (places[s.first] - places[s.second]).norm() < 0.34;
    });
    EXPECT_EQ(sides, 24);
    constexpr double pi = 3.141592653589793;
    EXPECT_NEAR(BlobPlan::stiffness, std::pow(2 * pi * 10, 2) / 32, 1e-4);
    EXPECT_NEAR(BlobPlan::damping, 2 * 0.5 * std::sqrt(BlobPlan::stiffness / 32), 1e-6);
    EXPECT_NEAR(blobPlace(100, 0).x(), -4.5 * 1.8 - 0.45, 1e-12);
    EXPECT_NEAR(blobPlace(100, 10).x(), -4.5 * 1.8 + 0.45, 1e-12);
    EXPECT_NEAR(blobPlace(1000, 41).y(), 3.3, 1e-12);
}

TEST(BenchScenes, RopesStretchByWhatTheirLinksDo) {
    Notebook world;
    const Scene scene = swingingRope(100);
    const auto play = scene.play();
    play->begin(world);
    ASSERT_EQ(world.ropes[0].points.size(), 41u);
    EXPECT_EQ(world.ropes[0].masses.back(), 100);
    EXPECT_EQ(world.ropes[0].points.back(), Point(10, 0));
    play->look(world, 1);
    world.ropes[0].points.back() += Point(0.5, 0);
    play->look(world, 9.5);
    EXPECT_NEAR(figureOf(play->figures(world), "max stretch"), 5, 1e-9);
    EXPECT_NEAR(figureOf(play->figures(world), "mean stretch in the last s"), 5, 1e-9);
}

TEST(BenchScenes, OursSwingsWithTheExactPeriod) {
    const Scene scene = pendulums(2, 3);
    const RunResult run =
        runOnce(scene, engineOf("sulfur"), {.engine = "sulfur", .rate = 500, .iterations = 4}, 60);
    EXPECT_LT(std::abs(figureOf(run.figures, "period error")), 1e-4);
    EXPECT_LT(figureOf(run.figures, "|energy change|"), 1e-3);
    EXPECT_GT(run.seconds, 0);
    EXPECT_EQ(run.simulated, 3);
}

TEST(BenchScenes, TheFirstTickAndTheLastAreTimedWithoutALookBetween) {
    std::vector<Notebook*> made;
    const Engine engine = noting(made);
    Scene scene = pyramid(2);
    scene.seconds = 1.5;
    const RunResult run = runOnce(scene, engine, {.engine = "sulfur", .rate = 60}, 60);
    EXPECT_EQ(run.simulated, 1.5);
    EXPECT_GT(run.lastSecond, 0);
    EXPECT_LE(run.lastSecond, run.seconds);
    EXPECT_EQ(runOnce(scene, engine, {.engine = "sulfur", .rate = 60}, 0).simulated, 0);
}

TEST(BenchSquares, OverlapsAreThoseOfRoundedSquares) {
    const auto found = overlaps({{Point(5, 0), 0}, {Point(0, 0), 0}, {Point(0.9, 0.2), 0}}, 0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], 0.1, 1e-12);
    // A corner that looks at a side: 0.5 + sqrt(1/2) - 1.1 for a sharp one.
    const double turned = std::acos(-1.0) / 4, sharp = 0.5 + std::sqrt(0.5) - 1.1;
    for (const double radius : {0.0, 0.1}) {
        const auto corner = overlaps({{Point(0, 0), 0}, {Point(1.1, 0), turned}}, radius);
        ASSERT_EQ(corner.size(), 1u);
        EXPECT_NEAR(corner[0], sharp - radius * (std::sqrt(2) - 1), 1e-12);
        EXPECT_NEAR(wallOverlap({{Point(0, 0.4), 0}}, 10, radius), 0.1, 1e-12);
        EXPECT_NEAR(wallOverlap({{Point(9.7, 5), 0}}, 10, radius), 0.2, 1e-12);
        EXPECT_EQ(wallOverlap({{Point(0, 5), 1}}, 10, radius), 0);
    }
}

TEST(BenchSpread, MediansPercentilesAndPowers) {
    const Spread spread = spreadOf({3, 1, 2, 10});
    EXPECT_EQ(spread.median, 2.5);
    EXPECT_EQ(spread.least, 1);
    EXPECT_EQ(spread.most, 10);
    EXPECT_EQ(spreadOf({7, 1, 3}).median, 3);
    EXPECT_EQ(spreadOf({}).count, 0u);
    EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2);
    EXPECT_EQ(percentile({4, 1, 3, 2}, 0.99), 4);
    EXPECT_EQ(percentile({4, 1, 3, 2}, 0), 1);
    const PowerLaw law = fitPowerLaw({{1, 3}, {10, 300}, {100, 30000}});
    EXPECT_NEAR(law.exponent, 2, 1e-12);
    EXPECT_NEAR(law.factor, 3, 1e-12);
}

TEST(BenchEngines, OursIsFirstAndTheMissingAreTold) {
    EXPECT_TRUE(engines().front().ours && engines().front().found());
    const std::string told = missingEngines();
    for (const Engine& engine : engines()) {
        const bool named = told.find("Missing: " + engine.title + ";") != std::string::npos;
        EXPECT_EQ(named, !engine.found()) << engine.title;
        if (!engine.found()) {
            EXPECT_NE(told.find(engine.how), std::string::npos);
        }
    }
    EXPECT_THROW(engineOf("nothing"), std::out_of_range);
}

/// A tiny comparison with a row of ours.
Comparison sample(double milliseconds) {
    Row row{.scene = pyramid(2),
            .setting = {.engine = "sulfur", .iterations = 4},
            .msPerSecond = spreadOf({milliseconds}),
            .lastSecond = {},
            .simulated = 10,
            .figures = {{"top sinks", "mm", 0.5},
                        {"a \"quoted\", name", "", std::numeric_limits<double>::infinity()}}};
    row.stages = {{"forces", 0.25}};
    return {.rows = {row}, .options = {}, .core = 0};
}

TEST(BenchShow, JsonIsJsonAndCsvHasItsFields) {
    const auto json = nlohmann::json::parse(asJson(sample(2)));
    const auto& row = json.at("rows").at(0);
    EXPECT_EQ(row.at("scene"), "S2");
    EXPECT_EQ(row.at("msPerSecond").at("median"), 2);
    EXPECT_TRUE(row.at("figures").at("a \"quoted\", name").at("value").is_null());
    EXPECT_EQ(row.at("stages").at("forces"), 25);
    std::istringstream csv(asCsv(sample(2)));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 14);
    int lines = 0;
    while (std::getline(csv, line)) {
        if (line.find('"') == std::string::npos) {
            EXPECT_EQ(std::count(line.begin(), line.end(), ','), 14) << line;
        } else {
            EXPECT_NE(line.find("\"a \"\"quoted\"\", name\""), std::string::npos) << line;
        }
        ++lines;
    }
    EXPECT_EQ(lines, 4);
    const std::string text = asText(sample(2));
    EXPECT_NE(text.find("exploded"), std::string::npos);
    EXPECT_NE(text.find("Sulfur, 500 Hz x 4"), std::string::npos);
}

TEST(BenchShow, PicturesFitWhatTheyShow) {
    const auto pictures = asSvg(sample(2));
    ASSERT_EQ(pictures.size(), 1u);
    EXPECT_EQ(pictures[0].first, "bench_S2_base-2.svg");
    EXPECT_NE(pictures[0].second.find("<circle"), std::string::npos);
    Plot plot;
    plot.series.push_back({.title = "", .colour = "", .points = {{3, 40}, {200, 0}, {50, 1e3}}});
    fitAxes(plot);
    EXPECT_EQ(plot.series[0].points.size(), 2u);
    EXPECT_NEAR(plot.xTicks.front(), 1, 1e-12);
    EXPECT_NEAR(plot.xTicks.back(), 100, 1e-9);
    EXPECT_NEAR(plot.yLow, 10, 1e-9);
    EXPECT_NEAR(plot.yHigh, 1000, 1e-9);
}

TEST(BenchHistory, TellsARegressionAndKeepsWhatWasThere) {
    const auto folder = std::filesystem::temp_directory_path() / "sulfur_bench_history_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "history.csv").string();
    const auto keep = [&](double ms, const char* date) {
        return keepHistory(file, date, sample(ms));
    };
    EXPECT_EQ(keep(2, "2026-01-01").find("REGRESSION"), std::string::npos);
    EXPECT_EQ(keep(2.2, "2026-01-02").find("REGRESSION"), std::string::npos);
    EXPECT_NE(keep(2.6, "2026-01-03").find("REGRESSION"), std::string::npos);
    EXPECT_NE(keep(1, "2026-01-04").find("faster"), std::string::npos);
    std::ifstream stream(file);
    EXPECT_EQ(std::count(std::istreambuf_iterator<char>(stream), {}, '\n'), 5);
    std::ofstream(file, std::ios::app) << "nonsense\n";
    const auto size = std::filesystem::file_size(file);
    EXPECT_THROW(keep(1, "2026-01-05"), std::runtime_error);
    EXPECT_EQ(std::filesystem::file_size(file), size);
    EXPECT_THROW(keepHistory((folder / "none" / "file").string(), "2026-01-05", sample(1)),
                 std::runtime_error);
    std::filesystem::remove_all(folder);
    EXPECT_THROW(checkDate("yesterday"), std::runtime_error);
    EXPECT_NO_THROW(checkDate(today()));
}

TEST(BenchClock, PinsAndGivesBack) {
    const auto before = allowedCores();
    ASSERT_FALSE(before.empty());
    {
        const Pinned pin;
        EXPECT_EQ(allowedCores(), std::vector<int>{pin.core()});
    }
    EXPECT_EQ(allowedCores(), before);
    EXPECT_EQ(Pinned(4095).core(), -1);
}

TEST(BenchTicks, EveryGrowthAndOptionMakesAWorldThatRuns) {
    for (const Growth& growth : growths(true)) {
        const auto world = growth.make(growth.sizes.front());
        EXPECT_GT(tickTime(*world, {.warmUp = 1, .ticks = 1, .repeats = 1}).median, 0)
            << growth.key;
    }
    for (const Option& option : options(10))
        for (const bool on : {false, true})
            EXPECT_EQ(option.make(on)->validate(), "") << option.name;
}

TEST(PaperTables, TableFourHasAFigureForEveryRate) {
    EXPECT_EQ(paperTable4().size(), 3u);
    for (const PaperMachine& machine : paperTable4())
        EXPECT_EQ(machine.percent.size(), paperBoxRates().size());
    EXPECT_EQ(paperTable4()[2].percent[5], 50);
}

}  // namespace
