// Which engines there are.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <sulfur/version.hpp>

#include "bench/engine.hpp"
#include "bench/threads.hpp"

namespace sulfur::lab::bench {

namespace {

using enum Feature;

Engine box2dV3() {
    Engine engine{.key = "box2d3",
                  .title = "Box2D 3",
                  .version = {},
                  .features = {squares, ropes, blobs, nets, bodies, joints, threads},
                  .make = {},
                  .how = "build and install it, then configure with -DSULFUR_BOX2D_V3=PREFIX"};
#ifdef SULFUR_BENCH_BOX2D_V3
    engine.make = makeBox2dV3;
    engine.version = box2dV3Version();
#endif
    return engine;
}

Engine box2dV2() {
    Engine engine{.key = "box2d2",
                  .title = "Box2D 2.4",
                  .version = {},
                  .features = {squares, ropes, blobs, nets, bodies},
                  .make = {},
                  .how = "install the package libbox2d-dev and configure again"};
#ifdef SULFUR_BENCH_BOX2D_V2
    engine.make = makeBox2dV2;
    engine.version = box2dV2Version();
#endif
    return engine;
}

Engine chipmunk() {
    Engine engine{.key = "chipmunk",
                  .title = "Chipmunk",
                  .version = {},
                  .features = {squares, ropes, blobs, nets, bodies},
                  .make = {},
                  .how = "install the package libchipmunk-dev and configure again"};
#ifdef SULFUR_BENCH_CHIPMUNK
    engine.make = makeChipmunk;
    engine.version = chipmunkVersion();
#endif
    return engine;
}

Engine bullet() {
    Engine engine{.key = "bullet",
                  .title = "Bullet",
                  .version = {},
                  .features = {squares, ropes},
                  .make = {},
                  .how = "install the package libbullet-dev and configure again"};
#ifdef SULFUR_BENCH_BULLET
    engine.make = makeBullet;
    engine.version = bulletVersion();
#endif
    return engine;
}

Engine liquidFun() {
    Engine engine{.key = "liquidfun",
                  .title = "LiquidFun",
                  .version = {},
                  .features = {squares, ropes, blobs, bodies},
                  .make = {},
                  .how = "build and install it, then configure with -DSULFUR_LIQUIDFUN=PREFIX"};
#ifdef SULFUR_BENCH_LIQUIDFUN
    engine.make = makeLiquidFun;
    engine.version = liquidFunVersion();
#endif
    return engine;
}

}  // namespace

std::string Setting::label() const {
    std::string text = fmt::format("{} Hz x {}", rate, iterations);
    if (stiffJoints) text += ", stiff joints";
    if (contactHertz > 0) text += fmt::format(", contacts {:g} Hz", contactHertz);
    if (threads > 1) text += fmt::format(", {} threads", threads);
    return text;
}

double NetPlan::reducedMass(const Spring& spring) const {
    const double a = masses[spring.a], b = masses[spring.b];
    if (a == 0 || b == 0) return a + b;
    return a * b / (a + b);
}

std::vector<Point> BlobPlan::places() {
    std::vector<Point> all;
    for (int i = 0; i < side * side; ++i)
        all.emplace_back((i % side - (side - 1) / 2.0) * spacing,
                         (i / side - (side - 1) / 2.0) * spacing);
    return all;
}

std::vector<std::pair<std::size_t, std::size_t>> BlobPlan::springs() {
    constexpr std::size_t n = side;
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t i = 0; i < n * n; ++i) {
        if (i % n + 1 < n) all.emplace_back(i, i + 1);
        if (i / n + 1 < n) all.emplace_back(i, i + n);
    }
    for (std::size_t i = 0; i < n * (n - 1); ++i) {
        if (i % n + 1 == n) continue;
        all.emplace_back(i, i + n + 1);
        all.emplace_back(i + 1, i + n);
    }
    return all;
}

bool Engine::offers(Feature feature) const {
    return std::find(features.begin(), features.end(), feature) != features.end();
}

namespace {

Engine ours() {
    return {.key = "sulfur",
            .title = "Sulfur",
            .ours = true,
            .version = version(),
            .features = {squares, ropes, blobs, bodies, joints, threads},
            .make = makeSulfur,
            .how = {}};
}

}  // namespace

const std::vector<Engine>& engines() {
    static const std::vector<Engine> all{ours(),     box2dV3(), box2dV2(),
                                         chipmunk(), bullet(),  liquidFun()};
    return all;
}

const Engine& engineOf(const std::string& key) {
    for (const Engine& engine : engines())
        if (engine.key == key) return engine;
    throw std::out_of_range("there is no engine " + key);
}

std::string missingEngines() {
    std::string text;
    for (const Engine& engine : engines())
        if (!engine.found()) text += fmt::format("Missing: {}; {}.\n", engine.title, engine.how);
    return text;
}

}  // namespace sulfur::lab::bench
