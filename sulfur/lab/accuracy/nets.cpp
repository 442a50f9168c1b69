#include "accuracy/nets.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/engine.hpp"
#include "references/linkage.hpp"

namespace sulfur::lab {

namespace {

constexpr double mesh = 0.1;   // m
constexpr double knot = 0.01;  // kg
constexpr double halfTurn = std::numbers::pi;

int sideOf(const SceneOptions& options) {
    return options.quick ? 10 : 20;
}

/// A net of side x side nodes, row by row from the upper left, and how it begins.
struct Net {
    int side = 0, loaded = 0;  // nodes in a row, the node with the load
    double lean = 0;           // rad, of the columns, to the right
    double speed = 0;          // m/s to the right, of the load before it is caught
    double load = 1;           // in masses of a node

    std::size_t nodes() const { return static_cast<std::size_t>(side * side); }
};

/// The first links lead along a row, the others down a column.
LinkagePlan linkageOf(const Net& net) {
    const int links = net.side - 1;
    LinkagePlan plan;
    plan.gravity = bench::gravity;
    plan.reach = Eigen::MatrixXd::Zero(net.side * net.side, 2 * links);
    plan.masses = Eigen::VectorXd::Constant(net.side * net.side, knot);
    plan.masses[net.loaded] *= net.load;
    plan.held = links;
    for (int i = 0; i < net.side * net.side; ++i) {
        plan.reach.row(i).head(i % net.side).setConstant(mesh);
        plan.reach.row(i).segment(links, i / net.side).setConstant(mesh);
    }
    return plan;
}

/// Rows as a V with its ends at nine tenths of their length, at rest.
LinkageState hung(const Net& net) {
    const int links = net.side - 1, left = net.side / 2;
    const double a = mesh * left, b = mesh * (links - left), span = 0.9 * mesh * links;
    const double x = (a * a - b * b + span * span) / (2 * span), depth = std::sqrt(a * a - x * x);
    LinkageState state{Eigen::VectorXd(2 * links), Eigen::VectorXd::Zero(2 * links)};
    state.angles.head(left).setConstant(-std::atan2(depth, x));
    state.angles.segment(left, links - left).setConstant(std::atan2(depth, span - x));
    state.angles.tail(links).setConstant(net.lean - halfTurn / 2);
    return state;
}

/// Everything but what people read.
AccuracyScene sceneOf(const Net& net, int intervals) {
    const LinkageReference linkage(linkageOf(net));
    LinkageState start = hung(net);
    const auto loaded = static_cast<std::size_t>(net.loaded);
    Vecs thrown(net.nodes(), Vec::Zero());
    thrown[loaded] = Vec(net.speed, 0);
    if (net.speed > 0) start.rates = linkage.struck(start.angles, thrown);

    AccuracyScene scene;
    scene.start = linkage.nodes(start);
    scene.gravity = bench::gravity;
    const auto side = static_cast<std::size_t>(net.side);
    for (std::size_t i = 0; i < net.nodes(); ++i) {
        scene.masses.push_back(i == 0 || i + 1 == side ? 0 : i == loaded ? net.load * knot : knot);
        if (i % side + 1 < side) scene.joints.push_back({i, i + 1, rigidStiffness, 0, mesh});
        if (i + side < net.nodes()) scene.joints.push_back({i, i + side, rigidStiffness, 0, mesh});
    }
    scene.watched = {loaded};
    // Three times the weight of all stretches one spring by 1e-3.
    scene.rigidStandIn =
        3e3 * (net.load + static_cast<double>(net.nodes())) * knot * bench::gravity / mesh;
    const LinkagePath path =
        convergedPath(linkage, start, scene.interval, intervals, loaded, 1e-9, 2048);
    for (const Vecs& places : path.places) scene.path.push_back({places[loaded]});
    scene.referenceError = path.error;
    scene.reference = fmt::format(
        "Lagrange's equations of rows and columns under RK4 in double, converged with "
        "steps of {:.2g} s",
        path.step);
    scene.error = "distance of the load";
    return scene;
}

}  // namespace

AccuracyScene swingingNet(const SceneOptions& options) {
    const int side = sideOf(options);
    const Net net{
        .side = side, .loaded = side / 2 * side + side / 2, .lean = 0.2, .load = options.load};
    AccuracyScene scene = sceneOf(net, 10);
    scene.title = fmt::format(
        "A net of {0} x {0} nodes of 10 g and rigid joints of 0.1 m, load {1:g} nodes, swings",
        side, options.load);
    return scene;
}

AccuracyScene strickenCloth(const SceneOptions& options) {
    const int side = sideOf(options);
    const Net net{
        .side = side, .loaded = side * (side - 1) + side / 2, .speed = 2, .load = options.load};
    AccuracyScene scene = sceneOf(net, 5);
    scene.title = fmt::format(
        "A cloth of {0} x {0} nodes of 10 g and rigid joints of 0.1 m, load {1:g} nodes, thrown "
        "at 2 m/s",
        side, options.load);
    return scene;
}

AccuracyScene pinnedGrid(const SceneOptions& options) {
    constexpr double tilt = halfTurn / 12, reach = std::numbers::sqrt2 / 2;
    constexpr std::size_t right = 0, upper = 1, left = 2, lower = 3;
    const int side = sideOf(options);
    const double apart = 2 * reach * std::cos(halfTurn / 4 - tilt);
    AccuracyScene scene;
    scene.title =
        fmt::format("A grid of {0} x {0} squares pinned to each other, load {1:g} squares, at rest",
                    side, options.load);
    scene.reference = "analytic, nothing moves";
    scene.error = "largest distance of any square";
    scene.gravity = bench::gravity;
    const auto add = [&](int column, int row, bench::Mover mover) {
        const double sign = (column + row) % 2 == 0 ? 1 : -1;
        bench::BodyPlan plan{.parts = {bench::rectangle(Point(0.5, 0.5))}};
        for (int corner = 0; corner < 4; ++corner) {
            // Which corner points where depends on which way the square is turned.
            const double angle = halfTurn / 2 * corner - sign * halfTurn / 4;
            plan.sockets.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
        }
        plan.mover = mover;
        plan.place = Point(apart * column, -apart * row);
        plan.angle = sign * tilt;
        plan.group = 1;
        if (column == side / 2 && row == side / 2) plan.density = options.load;
        scene.watched.push_back(scene.bodies.size());
        scene.bodies.push_back(std::move(plan));
    };
    for (int i = 0; i < side * side; ++i) {
        const auto here = static_cast<std::size_t>(i), row = static_cast<std::size_t>(side);
        add(i % side, i / side, bench::Mover::physics);
        if (i % side > 0) scene.pins.push_back({here - 1, right, here, left});
        if (i >= side) scene.pins.push_back({here - row, lower, here, upper});
    }
    for (const int column : {0, side - 1}) {
        scene.pins.push_back({static_cast<std::size_t>(column), upper, scene.bodies.size(), lower});
        add(column, -1, bench::Mover::nobody);
    }
    Vecs places;
    for (const bench::BodyPlan& plan : scene.bodies) places.push_back(plan.place);
    scene.path.assign(10, places);
    return scene;
}

}  // namespace sulfur::lab
