// The scenes of the work-precision diagrams, with their references.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "accuracy/nets.hpp"
#include "accuracy/scene.hpp"
#include "integrators/integrator.hpp"
#include "references/chain.hpp"

namespace sulfur::lab {

namespace {

constexpr double g = 9.81;

/// Samples a path that is known in closed form.
template <class Path>
void sample(AccuracyScene& scene, double seconds, Path&& at) {
    const auto count = std::lround(seconds / scene.interval);
    for (long n = 1; n <= count; ++n)
        scene.path.push_back(at(scene.interval * static_cast<double>(n)));
}

AccuracyScene fall(const SceneOptions&) {
    AccuracyScene scene;
    scene.title = "A stone thrown at (3, 4) m/s, 1 s";
    scene.reference = "analytic, x = v t - g t^2 / 2";
    scene.error = "distance of the stone";
    scene.start = {{Vec(0, 0)}, {Vec(3, 4)}};
    scene.masses = {1};
    scene.gravity = g;
    scene.watched = {0};
    sample(scene, 1, [](double t) { return Vecs{Vec(3 * t, 4 * t - g * t * t / 2)}; });
    return scene;
}

AccuracyScene spring(const SceneOptions&) {
    constexpr double mass = 1, k = 100, b = 1, length = 1, stretch = 0.1;
    AccuracyScene scene;
    scene.title = "A damped spring (1 kg, 100 N/m, 1 N s/m), stretched by 0.1 m, 2 s";
    scene.reference = "analytic, the damped oscillator";
    scene.error = "distance of the particle";
    scene.start = {{Vec(0, 0), Vec(length + stretch, 0)}, {Vec(0, 0), Vec(0, 0)}};
    scene.masses = {0, mass};
    scene.joints = {{0, 1, k, b, length}};
    scene.watched = {1};
    const double decay = b / (2 * mass), omega = std::sqrt(k / mass - decay * decay);
    sample(scene, 2, [=](double t) {
        const double swing = std::cos(omega * t) + decay / omega * std::sin(omega * t);
        return Vecs{Vec(length + stretch * std::exp(-decay * t) * swing, 0)};
    });
    return scene;
}

/// A chain of rigid links that hangs from particle 0; the last particle is watched.
AccuracyScene linked(const Vecs& places, const std::vector<double>& masses, double length) {
    AccuracyScene scene;
    scene.gravity = g;
    scene.masses = {0};
    scene.masses.insert(scene.masses.end(), masses.begin(), masses.end());
    scene.start = {places, Vecs(places.size(), Vec::Zero())};
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        scene.joints.push_back({i, i + 1, rigidStiffness, 0, length});
    scene.watched = {places.size() - 1};
    return scene;
}

void followChain(AccuracyScene& scene, std::size_t samples, double tolerance) {
    ChainPlan plan;
    plan.gravity = g;
    plan.masses.assign(scene.masses.begin() + 1, scene.masses.end());
    for (const SceneJoint& joint : scene.joints) plan.lengths.push_back(joint.restLength);
    const State start{{scene.start.x.begin() + 1, scene.start.x.end()},
                      {scene.start.v.begin() + 1, scene.start.v.end()}};
    const ChainPath path = convergedPath(plan, start, scene.interval, samples, tolerance, 32768);
    for (std::size_t n = 1; n < path.states.size(); ++n)
        scene.path.push_back({path.states[n].x.back()});
    scene.referenceError = path.error;
    scene.reference =
        fmt::format("exact rods under RK4 in double, converged with steps of {:.2g} s", path.step);
}

AccuracyScene pendulum(const SceneOptions&) {
    AccuracyScene scene = linked({Vec(0, 0), Vec(1, 0)}, {1}, 1);
    scene.title = "A pendulum of 1 m released at 90 degrees, 5 s";
    scene.error = "distance of the bob";
    scene.rigidStandIn = 1e6;  // stretched by up to 3e-5
    followChain(scene, 50, 1e-10);
    return scene;
}

AccuracyScene doublePendulum(const SceneOptions&) {
    AccuracyScene scene = linked({Vec(0, 0), Vec(1, 0), Vec(2, 0)}, {1, 1}, 1);
    scene.title = "A double pendulum (1 m, 1 kg each) released at 90 degrees, 2 s: before chaos";
    scene.error = "distance of the lower bob";
    scene.rigidStandIn = 1e6;
    followChain(scene, 20, 1e-10);
    return scene;
}

AccuracyScene rope(const SceneOptions& options) {
    constexpr std::size_t links = 40;
    constexpr double length = 0.05, mass = 0.05;
    Vecs places;
    for (std::size_t i = 0; i <= links; ++i)
        places.emplace_back(length * static_cast<double>(i), 0);
    std::vector<double> masses(links, mass);
    masses.back() = options.load * mass;
    AccuracyScene scene = linked(places, masses, length);
    scene.title = fmt::format(
        "A rope of 40 links of 0.05 m and 0.05 kg, load {:g} links, released horizontally: the "
        "first swing",
        options.load);
    scene.error = "distance of the load";
    // At the lowest point the tension is three times the load's weight: stretched by 1e-3.
    scene.rigidStandIn = 3e3 * (options.load + links) * mass * g / length;
    followChain(scene, 25, 1e-7);
    // The first swing ends where the load turns back.
    for (std::size_t n = 1; n < scene.path.size(); ++n) {
        const double before = scene.path[n - 1].front().x(), now = scene.path[n].front().x();
        if (!(now > before && now < 0)) continue;
        scene.path.resize(n);
        break;
    }
    return scene;
}

AccuracyScene lattice(const SceneOptions&) {
    constexpr std::size_t side = 4;
    constexpr double cell = 0.25, k = 400;
    AccuracyScene scene;
    scene.title =
        "A soft lattice of 4 x 4 particles (0.1 kg, 400 N/m), its upper corners held, 1 s";
    scene.error = "largest distance of any particle";
    scene.gravity = g;
    for (std::size_t i = 0; i < side * side; ++i) {
        const auto column = i % side, row = i / side;
        scene.start.x.emplace_back(cell * static_cast<double>(column),
                                   cell * static_cast<double>(row));
        scene.start.v.emplace_back(0, 0);
        const bool held = row + 1 == side && (column == 0 || column + 1 == side);
        scene.masses.push_back(held ? 0 : 0.1);
        scene.watched.push_back(i);
    }
    const auto join = [&](std::size_t a, std::size_t b) {
        scene.joints.push_back({a, b, k, 0, (scene.start.x[a] - scene.start.x[b]).norm()});
    };
    for (std::size_t i = 0; i < side * side; ++i) {
        const bool right = i % side + 1 < side, up = i / side + 1 < side;
        if (right) join(i, i + 1);
        if (up) join(i, i + side);
        if (right && up) join(i, i + side + 1);
        if (right && up) join(i + 1, i + side);
    }
    const SpringSystem system = scene.springs();
    const auto follow = [&](int steps) {
        std::vector<Vecs> path;
        State state = scene.start;
        const auto method = makeRungeKutta4(Stages::coupled);
        for (int n = 0; n < 10; ++n) {
            for (int s = 0; s < steps; ++s) method->step(system, state, scene.interval / steps);
            path.push_back(state.x);
        }
        return path;
    };
    constexpr int steps = 2000;
    const auto coarse = follow(steps / 2);
    scene.path = follow(steps);
    for (std::size_t i = 0; i < side * side; ++i)
        scene.referenceError =
            std::max(scene.referenceError, (coarse.back()[i] - scene.path.back()[i]).norm());
    scene.reference = fmt::format("the laboratory's RK4 in double with steps of {:.2g} s",
                                  scene.interval / steps);
    return scene;
}

AccuracyScene crate(const SceneOptions&) {
    constexpr double omega = 4 * std::numbers::pi, half = 0.5, mass = 0.25;
    AccuracyScene scene;
    scene.title = "A crate of 4 particles and 6 joints, 2 turns/s in free flight, 2 s";
    scene.reference = "analytic, uniform rotation";
    scene.error = "largest distance of any particle";
    const std::array<Vec, 4> corners{Vec(-half, -half), Vec(half, -half), Vec(half, half),
                                     Vec(-half, half)};
    for (std::size_t i = 0; i < 4; ++i) {
        scene.start.x.push_back(corners[i]);
        scene.start.v.emplace_back(-omega * corners[i].y(), omega * corners[i].x());
        scene.masses.push_back(mass);
        scene.watched.push_back(i);
        for (std::size_t j = 0; j < i; ++j)
            scene.joints.push_back({j, i, rigidStiffness, 0, (corners[i] - corners[j]).norm()});
    }
    scene.rigidStandIn = 1e6;  // stretched by some 1e-5
    sample(scene, 2, [=](double t) {
        Vecs places;
        const double c = std::cos(omega * t), s = std::sin(omega * t);
        for (const Vec& r : corners)
            places.emplace_back(c * r.x() - s * r.y(), s * r.x() + c * r.y());
        return places;
    });
    return scene;
}

/// A stack in which each square lies exactly on the one below: nothing may move.
AccuracyScene stack(const SceneOptions&) {
    constexpr std::size_t squares = 10;
    AccuracyScene scene;
    scene.title = "A stack of 10 squares of 1 m and 1 kg that begins at rest, 5 s";
    scene.reference = "analytic, nothing moves";
    scene.error = "largest distance of any square";
    scene.gravity = g;
    for (std::size_t i = 0; i < squares; ++i) {
        scene.squares.emplace_back(0, 0.5 + static_cast<double>(i));
        scene.watched.push_back(i);
    }
    sample(scene, 5, [&](double) { return scene.squares; });
    return scene;
}

struct Entry {
    std::string key;
    AccuracyScene (*make)(const SceneOptions&);
    bool loaded = false;
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{{"fall", fall},
                                        {"spring", spring},
                                        {"pendulum", pendulum},
                                        {"rope", rope, true},
                                        {"double", doublePendulum},
                                        {"lattice", lattice},
                                        {"crate", crate},
                                        {"stack", stack},
                                        {"net", swingingNet, true},
                                        {"cloth", strickenCloth, true},
                                        {"grid", pinnedGrid, true}};
    return all;
}

const Entry& entryOf(const std::string& key) {
    for (const Entry& entry : entries())
        if (entry.key == key) return entry;
    throw std::out_of_range("there is no scene " + key);
}

}  // namespace

const std::vector<std::string>& sceneKeys() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> names;
        for (const Entry& entry : entries()) names.push_back(entry.key);
        return names;
    }();
    return keys;
}

bool isLoaded(const std::string& key) {
    return entryOf(key).loaded;
}

AccuracyScene makeScene(const std::string& key, const SceneOptions& options) {
    AccuracyScene scene = entryOf(key).make(options);
    scene.key = key;
    return scene;
}

}  // namespace sulfur::lab
