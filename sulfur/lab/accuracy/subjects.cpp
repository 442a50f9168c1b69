#include "accuracy/subjects.hpp"

#include <fmt/format.h>

#include <sulfur/sulfur.hpp>

#include "battery/scenes.hpp"
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
                            fmt::format("World, {} sweep{}", sweeps, sweeps == 1 ? "" : "s"), true,
                            ours, [sweeps](const AccuracyScene& scene, int rate) {
                                return std::make_unique<WorldRun>(scene, rate, sweeps);
                            }});
    for (const IntegratorEntry& entry : integrators())
        subjects.push_back({entry.key, entry.title, false, theirs,
                            [make = entry.make](const AccuracyScene& scene, int rate) {
                                return std::make_unique<IntegratorRun>(scene, rate, make());
                            }});
    return subjects;
}

}  // namespace sulfur::lab
