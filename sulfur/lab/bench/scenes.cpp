// Which scenes there are, and in which settings each engine plays them.
#include "bench/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/crowd.hpp"
#include "bench/mechanisms.hpp"

namespace sulfur::lab::bench {

namespace {

std::string partOfS8(const std::string& name) {
    return fmt::format("S8:{}", name);
}

std::string partOfS9(const std::string& name) {
    return fmt::format("S9:{}", name);
}

std::vector<Scene> sizesOf(const std::string& name, Extent extent) {
    std::vector<Scene> all;
    const auto sizes = [&](std::vector<int> quick, std::vector<int> usual, std::vector<int> large) {
        return extent == Extent::quick ? quick : extent == Extent::usual ? usual : large;
    };
    if (name == "S1")
        for (const int n : sizes({40, 100}, {20, 40, 60, 80, 100, 150, 200, 400},
                                 {20, 40, 60, 80, 100, 150, 200, 400, 800, 1600}))
            all.push_back(droppedBoxes(n));
    if (name == "S2")
        for (const int base : sizes({40}, {40, 100}, {40, 100})) all.push_back(pyramid(base));
    if (name == "S3")
        for (const int n : sizes({100}, {100, 1000}, {100, 1000})) all.push_back(softBlobs(n));
    if (name == "S4")
        for (const double load : {1.0, 100.0, 1000.0}) {
            all.push_back(swingingRope(load));
            all.push_back(hangingRope(load));
        }
    if (name == "S5") all.push_back(pendulums(1000, extent == Extent::quick ? 10 : 60));
    if (name == "S7")
        for (const int base : sizes({40}, {100}, {100})) all.push_back(pyramid(base, true));
    for (const std::string& part : crowdNames())
        if (name == partOfS8(part)) all.push_back(crowd(part, extent));
    for (const std::string& part : mechanismNames())
        if (name == partOfS9(part)) all.push_back(mechanism(part, extent));
    return all;
}

struct Choice {
    int rate, iterations;
    bool stiff = false;
};

std::vector<Choice> ropeChoices(const std::string& engine) {
    if (engine == "sulfur") return {{500, 4}, {240, 4}, {60, 4}};
    if (engine == "box2d3") return {{60, 4}, {60, 64, true}, {500, 1}};
    if (engine == "box2d2" || engine == "liquidfun") return {{60, 8}, {500, 1}};
    if (engine == "chipmunk") return {{60, 10}, {500, 10}, {500, 40}};
    return {{60, 10}, {60, 100}, {500, 1}};
}

std::vector<Choice> choices(const std::string& engine, const Scene& scene) {
    if (scene.needs == Feature::ropes && scene.key == "S4") return ropeChoices(engine);
    if (engine == "sulfur") return {{500, 4}, {240, 4}};
    if (engine == "box2d3") return {{60, 4}, {500, 1}};
    if (engine == "box2d2" || engine == "liquidfun")
        return scene.key == "S3" ? std::vector<Choice>{{60, 8}, {500, 1}}
                                 : std::vector<Choice>{{60, 8}};
    if (engine == "chipmunk" && scene.key == "S5") return {{60, 10}, {500, 1}};
    return {{60, 10}};
}

}  // namespace

const std::vector<std::string>& sceneNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"S1", "S2", "S3", "S4", "S5", "S7", "S8"};
        for (const std::string& part : crowdNames()) all.push_back(partOfS8(part));
        all.emplace_back("S9");
        for (const std::string& part : mechanismNames()) all.push_back(partOfS9(part));
        return all;
    }();
    return names;
}

std::vector<Scene> scenes(const std::vector<std::string>& names, Extent extent) {
    const auto named = [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<Scene> all;
    for (const std::string& name : sceneNames()) {
        const bool part = name.find(':') != std::string::npos;
        const std::string whole = name.substr(0, name.find(':'));
        if (!named(name) && !(part ? named(whole) : names.empty())) continue;
        for (Scene& scene : sizesOf(name, extent)) all.push_back(std::move(scene));
    }
    return all;
}

std::vector<Setting> settingsFor(const Engine& engine, const Scene& scene) {
    const bool threaded = scene.needs == Feature::threads;
    if (!engine.offers(scene.needs)) return {};
    std::vector<Setting> all;
    const int most = threaded && engine.offers(Feature::threads) ? 2 : 1;
    for (const Choice& choice : choices(engine.key, scene))
        for (int threads = 1; threads <= most; ++threads)
            all.push_back({.engine = engine.key,
                           .rate = choice.rate,
                           .iterations = choice.iterations,
                           .threads = threads,
                           .stiffJoints = choice.stiff,
                           .sleeping = scene.sleeping,
                           .weightless = scene.weightless});
    return all;
}

}  // namespace sulfur::lab::bench
