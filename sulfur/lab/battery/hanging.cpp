#include "battery/hanging.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr int links = 40;
constexpr double length = 0.05, mass = 0.05;  // m, kg: the game's rope

/// Where the last particle of the discrete catenary is, with the horizontal force `h` and the
/// vertical force `v` (N) in the first link, both in terms of one particle's weight.
Vecs catenary(double h, double v) {
    Vecs places{Vec(0, 0)};
    for (int i = 0; i < links; ++i)
        places.push_back(places.back() + length * Vec(h, -v + i).normalized());
    return places;
}

/// The catenary whose last particle is `span` metres right of its first: symmetric, so the weights
/// of the links - 1 free particles are shared by both ends, and only h has to be found.
Vecs catenaryOver(double span) {
    const double v = (links - 1) / 2.0;
    double low = 1e-6, high = 1e6;
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(low * high);
        (catenary(middle, v).back().x() < span ? low : high) = middle;
    }
    return catenary(low, v);
}

WorldSettings braked(const Setup& setup, double airFriction) {
    WorldSettings settings = still(setup, standardGravity);
    settings.airFriction = real(airFriction);
    return settings;
}

double largestDistance(const World& world, Body body, const Vecs& places) {
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        largest = worst(largest, (world.position(body[i]) - places[i]).norm());
    return largest;
}

}  // namespace

Row hangingBetweenPins(const Setup& setup) {
    constexpr double span = 1.2;
    World world(braked(setup, 2));
    // It starts as two straight halves.
    const double half = links * length / 2;
    const double depth = std::sqrt(half * half - span * span / 4);
    Vecs places;
    for (int i = 0; i <= links; ++i) {
        const double along = 2.0 * i / links;
        places.emplace_back(span / 2 * along, -depth * (1 - std::abs(1 - along)));
    }
    const Body body = world.add(chain({.places = places,
                                       .masses = std::vector<double>(links + 1, mass),
                                       .lengths = std::vector<double>(links, length),
                                       .pinLast = true}));
    run(world, 20);
    return atMost(
        "rope of 40 links between two pins: distance from the discrete catenary (share "
        "of its length)",
        largestDistance(world, body, catenaryOver(span)) / (links * length), 1e-3);
}

Row hangingStretched(double stiffness, const Setup& setup) {
    World world(braked(setup, 2));
    Vecs start{Vec(0, 0)}, rest{Vec(0, 0)};
    for (int i = 0; i < links; ++i) {
        start.emplace_back(0, start.back().y() - length);
        const double weight = mass * standardGravity * (links - i);
        rest.emplace_back(0, rest.back().y() - length - weight / stiffness);
    }
    const Body body = world.add(chain({.places = start,
                                       .masses = std::vector<double>(links + 1, mass),
                                       .lengths = std::vector<double>(links, length),
                                       .stiffness = std::vector<double>(links, stiffness)}));
    run(world, 20);
    return atMost(fmt::format("hanging rope of 40 links, k = {:g} N/m: distance from its "
                              "equilibrium (share of its length)",
                              stiffness),
                  largestDistance(world, body, rest) / -rest.back().y(), 1e-3);
}

// Small sideways displacements u of a straight hanging chain feel the tension T_i of link i (the
// weight below it) as a spring T_i / l between its ends: m u'' = -K u, K tridiagonal.
Row swingFrequency(int mode, const Setup& setup) {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(links, links);
    for (int i = 0; i < links; ++i) {
        const double spring = mass * standardGravity * (links - i) / length;
        stiffness(i, i) += spring;
        if (i == 0) continue;
        stiffness(i - 1, i - 1) += spring;
        stiffness(i, i - 1) = stiffness(i - 1, i) = -spring;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness / mass);
    const double omega = std::sqrt(modes.eigenvalues()[mode - 1]);
    Eigen::VectorXd shape = modes.eigenvectors().col(mode - 1);
    shape *= 1e-3 * links * length / shape.cwiseAbs().maxCoeff();

    World world(still(setup, standardGravity));
    Vecs places{Vec(0, 0)};
    for (int i = 0; i < links; ++i) {
        const double dx = shape[i] - places.back().x();
        places.emplace_back(shape[i], places.back().y() - std::sqrt(length * length - dx * dx));
    }
    const Body body = world.add(chain({.places = places,
                                       .masses = std::vector<double>(links + 1, mass),
                                       .lengths = std::vector<double>(links, length)}));
    Crossings crossings;
    const auto ticks = std::lround(12 * 2 * std::numbers::pi / omega * setup.tickRate);
    for (long tick = 0; tick < ticks; ++tick) {
        world.step();
        double along = 0;
        for (int i = 0; i < links; ++i)
            along += shape[i] * world.position(body[static_cast<std::size_t>(i + 1)]).x();
        crossings.add(world.time(), along);
    }
    return atMost(
        fmt::format("hanging rope of 40 links: error of swing frequency {} (share)", mode),
        std::abs(2 * std::numbers::pi / crossings.period() / omega - 1), 5e-3);
}

Row alternatingSprings(const Setup& setup) {
    constexpr int count = 20;
    constexpr double particle = 1e-3;
    World world(braked(setup, 3));
    ChainOptions options{.places = {Vec(0, 0)}, .masses = {1}, .lengths = {}};
    for (int i = 0; i < count; ++i) {
        options.places.emplace_back(0, -0.1 * (i + 1));
        options.masses.push_back(particle);
        options.lengths.push_back(0.1);
        options.stiffness.push_back(i % 2 == 0 ? 1 : 1e6);
    }
    const Body body = world.add(chain(options));
    run(world, 60);
    double largest = 0;
    for (int i = 0; i < count; ++i) {
        const double weight = particle * standardGravity * (count - i);
        const auto force = world.info(body.joints()[static_cast<std::size_t>(i)]).force;
        largest = worst(largest, std::abs(static_cast<double>(force) / weight - 1));
    }
    return atMost("20 springs of 1 and 1e6 N/m in turn: error of a static force (share)", largest,
                  0.01);
}

}  // namespace sulfur::lab
