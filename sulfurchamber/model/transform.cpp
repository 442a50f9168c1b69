#include "transform.hpp"

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Pose;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::Prefab;

constexpr double pi = 3.14159265358979;

double wrapped(double angle) {
    return std::remainder(angle, 2 * pi);
}

// Every length of a recipe. Its mass goes with the area.
template <class Options>
void scaleRecipe(Options& o, Real f) {
    if constexpr (requires { o.size; }) o.size *= f;
    if constexpr (requires { o.from; }) o.from *= f;
    if constexpr (requires { o.to; }) o.to *= f;
    if constexpr (requires { o.radius; }) o.radius *= f;
    if constexpr (requires { o.rimRadius; }) o.rimRadius *= f;
    if constexpr (requires { o.skinRadius; }) o.skinRadius *= f;
    if constexpr (requires { o.sag; }) o.sag *= f;
    if constexpr (requires { o.points; })
        for (Vec2& point : o.points) point *= f;
    if constexpr (requires { o.mass; }) o.mass *= f * f;
}

void scalePlan(Prefab& prefab, double factor) {
    const auto f = static_cast<Real>(factor);
    if (prefab.generator.index() != 0) {
        std::visit([f](auto& options) { scaleRecipe(options, f); }, prefab.generator);
        rebuild(prefab);
        return;
    }
    for (auto& particle : prefab.blueprint.particles) {
        particle.position *= f;
        particle.radius *= f;
        particle.mass *= f * f;
    }
    for (auto& joint : prefab.blueprint.joints) {
        joint.radius *= f;
        if (joint.restLength) *joint.restLength *= f;
    }
}

// What looks the same from both sides needs no change.
bool isSymmetric(const Prefab& prefab) {
    using namespace sulfur::shapes;
    const auto& g = prefab.generator;
    return std::holds_alternative<BoxOptions>(g) || std::holds_alternative<BallOptions>(g) ||
           std::holds_alternative<JellyOptions>(g) || std::holds_alternative<ClothOptions>(g) ||
           std::holds_alternative<WallOptions>(g) || std::holds_alternative<BlobOptions>(g);
}

void mirrorPlan(Prefab& prefab) {
    auto& plan = prefab.blueprint;
    if (plan.material.surfaceSpeed == 0 && isSymmetric(prefab)) return;
    prefab.generator = {};
    plan.material.surfaceSpeed = -plan.material.surfaceSpeed;
    for (auto& particle : plan.particles) particle.position.x() = -particle.position.x();
    for (auto& joint : plan.joints) std::swap(joint.a, joint.b);  // the outside stays outside
    for (auto& angle : plan.angles)
        if (angle.restAngle) angle.restAngle = -*angle.restAngle;
}

void placeAll(Workbench& bench, Pose (*where)(const Pose&, const Point&, double),
              const Point& about, double value) {
    Document& document = bench.document();
    const auto bodies = bench.selection();
    for (const BodyId body : bodies)
        document.place(body, where(document.world().pose(body), about, value));
}

// Joints between bodies that are scaled are scaled too.
void scaleTies(Workbench& bench, double factor) {
    Document& document = bench.document();
    auto& world = document.world();
    for (const auto joint : world.connections()) {
        const auto info = world.info(joint);
        if (bench.selected(world.info(info.a).body) && bench.selected(world.info(info.b).body))
            world.setRestLength(joint,
                                static_cast<Real>(static_cast<double>(info.restLength) * factor));
    }
    std::vector<std::string> ids;
    for (const BodyId body : bench.selection()) ids.push_back(document.idOf(body));
    const auto chosen = [&](const std::string& id) {
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    for (auto& connection : document.planForEditing().connections)
        if (connection.options.restLength && chosen(connection.a.body) && chosen(connection.b.body))
            *connection.options.restLength *= static_cast<Real>(factor);
}

}  // namespace

std::optional<Bounds> selectionBounds(const Workbench& bench) {
    std::optional<Bounds> all;
    for (const BodyId body : bench.selection()) {
        const auto own = bench.document().world().bounds(body);
        if (!all) all = Bounds{own.low, own.high};
        all->include(own.low);
        all->include(own.high);
    }
    return all;
}

Handles handlesOf(const Bounds& bounds, double reach) {
    const Point room(reach, reach);
    const Point low = bounds.low - room;
    const Point high = bounds.high + room;
    Handles handles;
    handles.corners = {low, Point(high.x(), low.y()), high, Point(low.x(), high.y())};
    handles.middle = bounds.centre();
    handles.turn = {handles.middle.x(), high.y() + 2.2 * reach};
    return handles;
}

void turnSelection(Workbench& bench, const Point& about, double angle) {
    placeAll(
        bench,
        [](const Pose& pose, const Point& around, double turn) {
            const Point off = pose.position - around;
            const double c = std::cos(turn);
            const double s = std::sin(turn);
            return Pose{around + Point(c * off.x() - s * off.y(), s * off.x() + c * off.y()),
                        wrapped(pose.angle + turn)};
        },
        about, angle);
}

void scaleSelection(Workbench& bench, const Point& about, double factor) {
    if (!(factor > 0)) throw std::runtime_error("a size must be above 0");
    Document& document = bench.document();
    for (const BodyId body : bench.selection())
        if (const std::string id = document.idOf(body); !id.empty())
            document.placementForEditing(id).state.reset();
    document.change(bench.selection(), [&](Prefab& prefab) { scalePlan(prefab, factor); });
    scaleTies(bench, factor);
    placeAll(
        bench,
        [](const Pose& pose, const Point& around, double f) {
            return Pose{around + f * (pose.position - around), pose.angle};
        },
        about, factor);
}

void mirrorSelection(Workbench& bench, const Point& about) {
    Document& document = bench.document();
    for (const BodyId body : bench.selection())
        if (const std::string id = document.idOf(body); !id.empty())
            document.placementForEditing(id).state.reset();
    document.change(bench.selection(), mirrorPlan);
    placeAll(
        bench,
        [](const Pose& pose, const Point& around, double) {
            return Pose{Point(2 * around.x() - pose.position.x(), pose.position.y()),
                        wrapped(-pose.angle)};
        },
        about, 0);
}

}  // namespace sulfurchamber
