#include "battery/joints/subjects.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sulfur::lab {

using bench::EngineWorld;

std::string JointSubject::label() const {
    return ours ? fmt::format("{} Hz", setting.rate)
                : fmt::format("Box2D 3 at {} Hz x {}", setting.rate, setting.iterations);
}

std::unique_ptr<EngineWorld> JointSubject::world(bool weightless) const {
    bench::Setting own = setting;
    own.weightless = weightless;
    return bench::engineOf(setting.engine).make(own);
}

Row JointSubject::row(const std::string& what, double measured, double bound) const {
    const std::string name = label() + ": " + what;
    return ours && std::isfinite(bound) ? atMost(name, measured, bound) : reported(name, measured);
}

long JointSubject::ticks(double seconds) const {
    return std::lround(seconds * setting.rate);
}

double JointSubject::step() const {
    const int steps = ours ? (479 + setting.rate) / setting.rate : setting.iterations;
    return 1.0 / setting.rate / steps;
}

std::vector<int> jointRates() {
    return {500, 240, 120, 60};
}

std::vector<JointSubject> jointSubjects(const Setup& setup) {
    constexpr int substeps = 4;
    std::vector<JointSubject> all;
    for (const int rate : jointRates()) {
        all.push_back({{.engine = "sulfur", .rate = rate, .iterations = setup.sweeps}, true});
        if (bench::engineOf("box2d3").found())
            all.push_back({{.engine = "box2d3", .rate = rate, .iterations = substeps}, false});
    }
    return all;
}

}  // namespace sulfur::lab
