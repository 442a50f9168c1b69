#include "accuracy/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sulfur/sulfur.hpp>

#include "accuracy/swept_run.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"
#include "bench/engine.hpp"
#include "bench/show.hpp"
#include "integrators/integrator.hpp"

namespace sulfur::lab {

namespace {

class WorldRun final : public Run {
public:
    WorldRun(const AccuracyScene& scene, int rate, int sweeps)
        : world_(still({rate, sweeps}, scene.gravity)), body_(world_.add(scene.blueprint())) {
        for (std::size_t i = 0; i < scene.masses.size(); ++i)
            if (scene.masses[i] > 0) world_.setVelocity(body_[i], scene.start.v[i].cast<Real>());
    }
    void advance(long ticks) override {
        for (long i = 0; i < ticks; ++i) world_.step();
    }
    Vecs places() const override {
        Vecs all;
        for (const ParticleId particle : body_.particles())
            all.push_back(world_.position(particle));
        return all;
    }

private:
    World world_;
    Body body_;
};

class IntegratorRun final : public Run {
public:
    IntegratorRun(const AccuracyScene& scene, int rate, std::unique_ptr<Integrator> integrator)
        : system_(scene.springs()),
          state_(scene.start),
          integrator_(std::move(integrator)),
          h_(1.0 / rate) {
        integrator_->begin(system_, state_, h_);
    }
    void advance(long ticks) override {
        for (long i = 0; i < ticks; ++i) integrator_->step(system_, state_, h_);
    }
    Vecs places() const override { return state_.x; }

private:
    SpringSystem system_;
    State state_;
    std::unique_ptr<Integrator> integrator_;
    double h_;
};

/// Whether a scene begins as the other engines' chains do.
bool startsAtRest(const AccuracyScene& scene) {
    return scene.gravity == bench::gravity &&
           std::all_of(scene.start.v.begin(), scene.start.v.end(),
                       [](const Vec& v) { return v.isZero(); });
}

/// Whether it is a chain of rigid links that hangs from particle 0.
bool isChain(const AccuracyScene& scene) {
    if (scene.joints.size() + 1 != scene.masses.size() || scene.joints.empty()) return false;
    if (!startsAtRest(scene) || scene.masses[0] != 0) return false;
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        if (scene.joints[i].a != i || scene.joints[i].b != i + 1 ||
            !std::isinf(scene.joints[i].stiffness))
            return false;
    return true;
}

/// Whether the other engines know it as a net.
bool isNet(const AccuracyScene& scene) {
    return scene.gravity == bench::gravity && !scene.joints.empty() && !isChain(scene);
}

/// A chain of rigid links, a net, pinned bodies, or squares on a floor, as all engines know them.
class EngineRun final : public Run {
public:
    EngineRun(const AccuracyScene& scene, const bench::Setting& setting)
        : world_(bench::engineOf(setting.engine).make(setting)),
          squares_(scene.squares.size()),
          bodies_(scene.bodies.size()) {
        if (squares_ > 0) world_->addFixed(Point(0, -1), Point(20, 1));
        for (const Vec& centre : scene.squares) world_->addSquare(centre, 0, Point(0, 0));
        for (const bench::BodyPlan& plan : scene.bodies) world_->addBody(plan);
        for (const bench::PinPlan& pin : scene.pins) world_->addPin(pin);
        if (scene.masses.empty()) return;
        if (isChain(scene))
            world_->addRope({{scene.start.x.begin(), scene.start.x.end()}, scene.masses});
        else
            addNet(scene);
    }
    void advance(long ticks) override {
        for (long i = 0; i < ticks; ++i) world_->step();
    }
    Vecs places() const override {
        Vecs all;
        for (std::size_t i = 0; i < squares_; ++i) all.push_back(world_->square(i).first);
        for (std::size_t i = 0; i < bodies_; ++i) all.push_back(world_->body(i).place);
        if (!all.empty()) return all;
        const std::vector<Point> points = world_->rope(0);
        return {points.begin(), points.end()};
    }
    double strain(const AccuracyScene& scene) const override {
        if (scene.pins.empty()) return Run::strain(scene);
        double largest = 0;
        for (std::size_t i = 0; i < scene.pins.size(); ++i) {
            const auto [a, b] = world_->pin(i);
            largest = worst(largest, (b - a).norm());
        }
        return largest;
    }

private:
    void addNet(const AccuracyScene& scene) {
        bench::NetPlan net{{scene.start.x.begin(), scene.start.x.end()},
                           {scene.start.v.begin(), scene.start.v.end()},
                           scene.masses,
                           {}};
        for (const SceneJoint& joint : scene.joints)
            net.springs.push_back(
                {joint.a, joint.b, joint.restLength, joint.stiffness, joint.damping});
        world_->addNet(net);
    }

    std::unique_ptr<bench::EngineWorld> world_;
    std::size_t squares_, bodies_;
};

std::unique_ptr<Run> startWorld(const AccuracyScene& scene, int rate, int sweeps) {
    if (!scene.masses.empty()) return std::make_unique<WorldRun>(scene, rate, sweeps);
    return std::make_unique<EngineRun>(
        scene, bench::Setting{.engine = "sulfur", .rate = rate, .iterations = sweeps});
}

void addPeers(std::vector<Subject>& subjects, const std::vector<int>& rates) {
    struct Choice {
        const char* engine;
        int iterations;
        bool stiff;
    };
    for (const auto& [key, iterations, stiff] :
         {Choice{"box2d3", 4, false}, Choice{"box2d3", 4, true}, Choice{"box2d2", 8, false},
          Choice{"chipmunk", 10, false}, Choice{"bullet", 10, false}}) {
        const bench::Engine& engine = bench::engineOf(key);
        if (!engine.found()) continue;
        const bench::Setting setting{.engine = key, .iterations = iterations, .stiffJoints = stiff};
        const auto start = [setting](const AccuracyScene& scene, int rate) {
            bench::Setting at = setting;
            at.rate = rate;
            return std::make_unique<EngineRun>(scene, at);
        };
        const bool nets = engine.offers(bench::Feature::nets);
        const bool bodies = engine.offers(bench::Feature::bodies);
        const auto plays = [nets, bodies](const AccuracyScene& scene) {
            return !scene.squares.empty() || isChain(scene) || (nets && isNet(scene)) ||
                   (bodies && !scene.bodies.empty());
        };
        subjects.push_back(
            {fmt::format("{}-{}{}", key, iterations, stiff ? "-stiff" : ""),
             fmt::format("{} x {}{}", engine.title, iterations, stiff ? ", stiff" : ""), false,
             rates, start, plays, bench::colourOf(key)});
    }
}

void addSweeps(std::vector<Subject>& subjects, const std::vector<int>& rates) {
    for (const auto& [sweeps, colour] :
         {std::pair{1, "#f06292"}, std::pair{10, "#c2185b"}, std::pair{100, "#880e4f"}})
        subjects.push_back({fmt::format("xpbd-{}", sweeps),
                            fmt::format("XPBD, {} sweep{}", sweeps, sweeps == 1 ? "" : "s"), false,
                            rates,
                            [sweeps](const AccuracyScene& scene, int rate) {
                                return makeSweptRun(scene, rate, sweeps);
                            },
                            canBeSwept, colour});
}

}  // namespace

std::vector<Subject> accuracySubjects(bool quick) {
    const std::vector<int> ours = quick ? std::vector{60, 500, 10000}
                                        : std::vector{60, 120, 250, 500, 1000, 2000, 5000, 10000};
    std::vector<int> theirs = ours;
    for (const int rate : {20000, 50000, 100000, 200000})
        if (!quick || rate == 50000) theirs.push_back(rate);
    std::vector<Subject> subjects;
    for (const int sweeps : {1, 4, 16})
        subjects.push_back({fmt::format("world-{}", sweeps),
                            fmt::format("World, {} sweep{}", sweeps, sweeps == 1 ? "" : "s"),
                            true,
                            ours,
                            [sweeps](const AccuracyScene& scene, int rate) {
                                return startWorld(scene, rate, sweeps);
                            },
                            {},
                            {}});
    for (const IntegratorEntry& entry : integrators())
        subjects.push_back({entry.key,
                            entry.title,
                            false,
                            theirs,
                            [make = entry.make](const AccuracyScene& scene, int rate) {
                                return std::make_unique<IntegratorRun>(scene, rate, make());
                            },
                            [](const AccuracyScene& scene) { return !scene.masses.empty(); },
                            {}});
    addSweeps(subjects, theirs);
    addPeers(subjects, ours);
    return subjects;
}

}  // namespace sulfur::lab
