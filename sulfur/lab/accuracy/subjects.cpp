#include "accuracy/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sulfur/sulfur.hpp>

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
    Vec position(std::size_t particle) const override { return world_.position(body_[particle]); }

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
    Vec position(std::size_t particle) const override { return state_.x[particle]; }

private:
    SpringSystem system_;
    State state_;
    std::unique_ptr<Integrator> integrator_;
    double h_;
};

/// A chain of rigid links, a net of springs, or squares on a floor, as all engines know them.
class EngineRun final : public Run {
public:
    EngineRun(const AccuracyScene& scene, const bench::Setting& setting)
        : world_(bench::engineOf(setting.engine).make(setting)), squares_(!scene.squares.empty()) {
        if (squares_) {
            world_->addFixed(Point(0, -1), Point(20, 1));
            for (const Vec& centre : scene.squares) world_->addSquare(centre, 0, Point(0, 0));
            return;
        }
        std::vector<Point> points;
        for (const Vec& x : scene.start.x) points.emplace_back(x);
        if (scene.hasRigidJoints()) {
            world_->addRope({std::move(points), scene.masses});
            return;
        }
        bench::NetPlan net{std::move(points), scene.masses, {}};
        for (const SceneJoint& joint : scene.joints)
            net.springs.push_back(
                {joint.a, joint.b, joint.restLength, joint.stiffness, joint.damping});
        world_->addNet(net);
    }
    void advance(long ticks) override {
        for (long i = 0; i < ticks; ++i) world_->step();
    }
    Vec position(std::size_t i) const override {
        return squares_ ? world_->square(i).first : world_->rope(0)[i];
    }

private:
    std::unique_ptr<bench::EngineWorld> world_;
    bool squares_;
};

std::unique_ptr<Run> startWorld(const AccuracyScene& scene, int rate, int sweeps) {
    if (scene.squares.empty()) return std::make_unique<WorldRun>(scene, rate, sweeps);
    return std::make_unique<EngineRun>(
        scene, bench::Setting{.engine = "sulfur", .rate = rate, .iterations = sweeps});
}

/// Whether a scene begins as the other engines' worlds do.
bool startsAtRest(const AccuracyScene& scene) {
    return scene.gravity == bench::gravity &&
           std::all_of(scene.start.v.begin(), scene.start.v.end(),
                       [](const Vec& v) { return v.isZero(); });
}

/// Whether it has springs only.
bool isNet(const AccuracyScene& scene) {
    return startsAtRest(scene) && !scene.joints.empty() &&
           std::none_of(scene.joints.begin(), scene.joints.end(),
                        [](const SceneJoint& joint) { return std::isinf(joint.stiffness); });
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
        const auto plays = [nets](const AccuracyScene& scene) {
            return !scene.squares.empty() || isChain(scene) || (nets && isNet(scene));
        };
        subjects.push_back(
            {fmt::format("{}-{}{}", key, iterations, stiff ? "-stiff" : ""),
             fmt::format("{} x {}{}", engine.title, iterations, stiff ? ", stiff" : ""), false,
             rates, start, plays, bench::colourOf(key)});
    }
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
                            [](const AccuracyScene& scene) { return scene.squares.empty(); },
                            {}});
    addPeers(subjects, ours);
    return subjects;
}

}  // namespace sulfur::lab
