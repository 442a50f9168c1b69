#include "battery/springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double springLength = 1, stretch = 0.0099;  // m

/// A particle of 1 kg on a spring.
Blueprint spring(double stiffness, double damping) {
    return chain({.places = {Vec(0, 0), Vec(springLength + stretch, 0)},
                  .masses = {1, 1},
                  .lengths = {springLength},
                  .stiffness = {stiffness},
                  .damping = damping});
}

/// How much longer than its rest length the spring is after each tick, from its release on.
std::vector<double> release(double stiffness, double damping, long ticks, const Setup& setup) {
    World world(still(setup, 0));
    const Body body = world.add(spring(stiffness, damping));
    std::vector<double> samples;
    for (long i = 0; i <= ticks; ++i) {
        samples.push_back(world.position(body.back()).x() - springLength);
        world.step();
    }
    return samples;
}

/// Amplitude of x(n) = A cos(n angle + phase) from two neighbouring samples.
double amplitude(double x, double next, double angle) {
    const double sine = std::sin(angle);
    return std::sqrt(x * x + next * next - 2 * x * next * std::cos(angle)) / sine;
}

}  // namespace

double explicitRange(const Setup& setup) {
    const double h = 1.0 / setup.tickRate;
    const auto isExplicit = [&](double angle) {
        World world(still(setup, 0));
        world.add(spring(angle * angle / (h * h), 0));
        world.step();
        return world.statistics().explicitJoints == 1 && world.statistics().implicitJoints == 0;
    };
    double low = 0, high = 2;
    for (int i = 0; i < 20; ++i) {
        const double middle = (low + high) / 2;
        (isExplicit(middle) ? low : high) = middle;
    }
    return low;
}

Rows undampedSpring(double angle, int periods, const Setup& setup) {
    const double h = 1.0 / setup.tickRate;
    const double theory = 2 * std::asin(angle / 2);
    const auto ticks = std::lround(periods * 2 * std::numbers::pi / theory);
    const auto x = release(angle * angle / (h * h), 0, ticks, setup);
    const auto found = fitOscillation(x, 0);
    const double first = amplitude(x[0], x[1], theory);
    const double last = amplitude(x[x.size() - 2], x.back(), theory);
    const std::string name = fmt::format("undamped spring, omega h = {:.3g}: ", angle);
    return {atMost(name + fmt::format("change of amplitude in {} periods (share)", periods),
                   std::abs(last / first - 1), 1e-3),
            atMost(name + "error of 2 asin(omega h / 2) / h (share)",
                   std::abs(found.angle / theory - 1), 1e-3)};
}

Row dampedSpring(double stiffness, double damping, const Setup& setup) {
    const double h = 1.0 / setup.tickRate;
    const double rate = damping / 2;
    const auto ticks = std::lround(std::min(20.0, 6 / rate) / h);
    // The first tick starts from rest and not from the middle of a tick before.
    auto x = release(stiffness, damping, ticks, setup);
    const auto found = fitOscillation(std::span(x).subspan(1), 1e-3 * stretch);
    // A force with damping takes 1 - h c of the energy in a tick: h c / 2 more than it should, to
    // first order.
    const double hc = h * damping, inTicks = -std::log1p(-hc) / hc - 1;
    return atMost(fmt::format("damped spring, k = {:g} N/m, b = {:g} N s/m: error of the decay "
                              "rate (share)",
                              stiffness, damping),
                  std::abs(-std::log(found.factor) / h / rate - 1), 0.0094 + inTicks);
}

Rows seamlessStiffness(double damping, int steps, const Setup& setup) {
    struct Root {
        double factor;
        std::optional<double> angle;
    };
    std::vector<Root> roots;
    const double lowest = std::max(0.0, 2 * std::log10(damping));  // decades
    for (int i = 0; i <= steps; ++i) {
        const double k = i == steps ? static_cast<double>(infinite)
                                    : std::pow(10, lowest + (10 - lowest) * i / (steps - 1));
        const auto x = release(k, damping, 200, setup);
        const auto found = fitOscillation(std::span(x).subspan(1), 2e-5 * stretch);
        if (found.measured)
            roots.push_back({found.factor, found.angle});
        else  // It is gone too soon for a fit: what two ticks left is what there is to see.
            roots.push_back({std::sqrt(std::abs(x[2] / x[0])), std::nullopt});
    }
    double factorJump = 0, angleJump = 0;
    for (std::size_t i = 2; i < roots.size(); ++i) {
        const Root &a = roots[i - 2], &b = roots[i - 1], &c = roots[i];
        factorJump = worst(factorJump, std::abs(c.factor - 2 * b.factor + a.factor));
        const bool swings = a.angle.value_or(0) > 0 && b.angle.value_or(0) > 0 &&
                            c.angle.value_or(0) > 0 && c.factor >= 0.05;
        if (swings)
            angleJump =
                worst(angleJump, std::abs(std::log(*c.angle * *a.angle / (*b.angle * *b.angle))));
    }
    const std::string name =
        fmt::format("k from 1 to 1e10 N/m and rigid in {} steps, b = {:g}: ", steps, damping);
    return {atMost(name + "largest jump of a tick's amplitude factor", factorJump, 0.1),
            atMost(name + "largest jump of the frequency (share)", angleJump, 0.1)};
}

}  // namespace sulfur::lab
