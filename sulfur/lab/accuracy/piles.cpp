#include "accuracy/piles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bench/compare.hpp"

namespace sulfur::lab {

namespace {

constexpr double millimetre = 1e-3;

struct Contender {
    std::string engine;
    int iterations = 1;
    double contactHertz = 0;
    std::string colour;
};

std::vector<Contender> contenders() {
    return {{"sulfur", 1, 0, "#7dcea0"},    {"sulfur", 2, 0, "#27ae60"},
            {"sulfur", 4, 0, "#117a65"},    {"sulfur", 8, 0, "#0b3d2e"},
            {"box2d3", 1, 0, "#f1948a"},    {"box2d3", 2, 0, "#e74c3c"},
            {"box2d3", 4, 0, "#c0392b"},    {"box2d3", 8, 0, "#78281f"},
            {"box2d3", 4, 120, "#d7bde2"},  {"box2d3", 4, 1000, "#9b59b6"},
            {"box2d3", 8, 1000, "#5b2c6f"}, {"box2d2", 8, 0, "#d68910"},
            {"chipmunk", 1, 0, "#85c1e9"},  {"chipmunk", 10, 0, "#2471a3"}};
}

/// What is compared is at the end, so that there is one sample; 0 is exact.
AccuracyScene sceneOf(const bench::Scene& pile, const std::string& error) {
    AccuracyScene scene;
    scene.key = pile.key;
    scene.title = pile.title;
    scene.reference = "analytic, 0; every run is measured once";
    scene.error = error;
    scene.interval = pile.seconds;
    scene.path = {{Vec(0, 0)}};
    return scene;
}

WorkPoint measure(const bench::Scene& pile, const bench::Setting& setting, double limit) {
    const bench::RunResult run =
        bench::runOnce(pile, bench::engineOf(setting.engine), setting, limit);
    WorkPoint point{.rate = setting.rate, .error = std::numeric_limits<double>::infinity()};
    for (const bench::Figure& figure : run.figures)
        if (figure.name == pile.error) point.error = std::abs(figure.value) * millimetre;
    // A run that the limit stopped says nothing about the end.
    if (run.simulated < pile.seconds || !(point.error < explosion))
        point.error = std::numeric_limits<double>::infinity();
    else
        point.cost = run.seconds;
    return point;
}

std::string titleOf(const Contender& contender) {
    std::string title =
        fmt::format("{} x {}", bench::engineOf(contender.engine).title, contender.iterations);
    if (contender.contactHertz > 0) title += fmt::format(", {:g} Hz", contender.contactHertz);
    return title;
}

}  // namespace

const std::vector<std::string>& pileKeys() {
    static const std::vector<std::string> keys{"S1", "S2"};
    return keys;
}

WorkPrecision measurePile(const std::string& key, bool quick) {
    const bool drops = key == "S1";
    bench::Scene pile = drops   ? bench::droppedBoxes(quick ? 20 : 100, quick ? 4 : 10)
                        : quick ? bench::pyramid(12)
                                : bench::pyramid(40);
    if (quick && !drops) {
        pile.seconds = 3;
        pile.title = "a pyramid, base 12, 3 s";
    }
    if (drops) pile.error = "mean overlap";
    const std::vector<int> rates = quick ? std::vector{240, 500} : std::vector{60, 120, 240, 500};
    const double limit = quick ? 10 : 60;  // s
    WorkPrecision work{
        sceneOf(pile, drops ? "mean overlap of two boxes at the end" : "sinking of the top"), {}};
    for (const Contender& contender : contenders()) {
        const bench::Engine& engine = bench::engineOf(contender.engine);
        if (!engine.found()) continue;
        WorkCurve curve{fmt::format("{}-{}-{:g}", contender.engine, contender.iterations,
                                    contender.contactHertz),
                        titleOf(contender),
                        engine.ours,
                        {},
                        contender.colour};
        for (const int rate : rates)
            curve.points.push_back(measure(pile,
                                           {.engine = contender.engine,
                                            .rate = rate,
                                            .iterations = contender.iterations,
                                            .contactHertz = contender.contactHertz},
                                           limit));
        work.curves.push_back(std::move(curve));
    }
    return work;
}

}  // namespace sulfur::lab
