#include "transform.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Drive;
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

void mirrorAngle(sulfur::AngularJointSpec& angle) {
    if (angle.restAngle) angle.restAngle = -*angle.restAngle;
    angle.lower = -std::exchange(angle.upper, -angle.lower);
    angle.motorSpeed = -angle.motorSpeed;
    if (angle.motorTarget) angle.motorTarget = -*angle.motorTarget;
}

void mirrorPlan(Prefab& prefab) {
    auto& plan = prefab.blueprint;
    if (plan.material.surfaceSpeed == 0 && isSymmetric(prefab)) return;
    prefab.generator = {};
    plan.material.surfaceSpeed = -plan.material.surfaceSpeed;
    for (auto& particle : plan.particles) particle.position.x() = -particle.position.x();
    for (auto& joint : plan.joints) std::swap(joint.a, joint.b);  // the outside stays outside
    for (auto& angle : plan.angles) mirrorAngle(angle);
}

Drive scaledDrive(Drive drive, Real f) {
    drive.lower *= f;
    drive.upper *= f;
    drive.rest *= f;
    drive.motorSpeed *= f;
    if (drive.motorTarget) *drive.motorTarget *= f;
    return drive;
}

// Of an angle that is seen from the other side.
Drive mirroredDrive(Drive drive) {
    drive = scaledDrive(drive, -1);
    std::swap(drive.lower, drive.upper);
    return drive;
}

struct Scaling {
    Point about;
    double factor;

    Point point(const Point& p) const { return about + factor * (p - about); }
    Vec2 direction(const Vec2& d) const { return d; }
    double turn(double) const { return 0; }
    double value(bool isAngle) const { return isAngle ? 1 : factor; }
    template <class Spec>
    void operator()(Spec& spec) const {
        const auto f = static_cast<Real>(factor);
        using namespace sulfur::scene;
        if constexpr (std::is_same_v<Spec, Slider>) {
            spec.options.value *= factor;
            spec.options.drive = scaledDrive(spec.options.drive, f);
        }
        if constexpr (std::is_same_v<Spec, Distance>)
            spec.options.drive = scaledDrive(spec.options.drive, f);
        if constexpr (std::is_same_v<Spec, Wheel>)
            spec.options.spring = scaledDrive(spec.options.spring, f);
        if constexpr (std::is_same_v<Spec, Pulley>) {
            if (spec.options.length) *spec.options.length *= f;
            if (spec.drive) spec.drive = scaledDrive(*spec.drive, f);
        }
    }
};

struct Mirroring {
    Point about;

    Point point(const Point& p) const { return {2 * about.x() - p.x(), p.y()}; }
    Vec2 direction(const Vec2& d) const { return {-d.x(), d.y()}; }
    // By which the frame of a body at an angle turns, rad.
    double turn(double angle) const { return wrapped(-2 * angle); }
    // By what the value of a mechanism is multiplied.
    double value(bool isAngle) const { return isAngle ? -1 : 1; }
    template <class Spec>
    void operator()(Spec& spec) const {
        using namespace sulfur::scene;
        if constexpr (requires { spec.axis; }) spec.axis = direction(spec.axis);
        if constexpr (std::is_same_v<Spec, Hinge>)
            spec.options.drive = mirroredDrive(spec.options.drive);
        if constexpr (std::is_same_v<Spec, Hinge> || std::is_same_v<Spec, Weld>)
            spec.options.value = -spec.options.value;
        if constexpr (std::is_same_v<Spec, Weld>)
            if (spec.drive) spec.drive = mirroredDrive(*spec.drive);
        if constexpr (std::is_same_v<Spec, Wheel>)
            spec.options.motor = mirroredDrive(spec.options.motor);
    }
};

using sulfur::scene::SceneMechanism;

// Maps one of the two bodies of a slider. The zero of its line goes with a, its point with b.
template <class Map>
void mapEnd(sulfur::scene::Slider& slider, const std::string& id, const Map& map) {
    if (slider.a != id && slider.b != id) return;
    const Point axis = slider.axis.template cast<double>().normalized();
    Point zero = slider.at - slider.options.value * axis;
    if (slider.a == id) {
        zero = map.point(zero);
        slider.axis = map.direction(slider.axis);
    }
    if (slider.b == id) slider.at = map.point(slider.at);
    const Point now = slider.axis.template cast<double>().normalized();
    slider.options.value = now.dot(slider.at - zero);
}

// Maps one body, at an angle, of a mechanism whose other one stays: the limits stay where they are.
template <class Map>
void mapEnd(SceneMechanism& mechanism, const std::string& id, double angle, const Map& map) {
    if (auto* slider = std::get_if<sulfur::scene::Slider>(&mechanism.spec)) {
        mapEnd(*slider, id, map);
        return;
    }
    const auto carry = [&](auto& spec) {
        if constexpr (requires { spec.axis; }) {
            if (spec.a == id) spec.axis = map.direction(spec.axis);
        } else if constexpr (requires { spec.options.value; }) {
            if (spec.b == id) spec.options.value += map.turn(angle);
            if (spec.a == id) spec.options.value -= map.turn(angle);
        }
    };
    std::visit(carry, mechanism.spec);
    for (Point* point : pointsOf(mechanism, id)) *point = map.point(*point);
}

// A gear goes on to join both of its parts, of which each counts in another way than before.
void mapGear(sulfur::scene::Gear& gear, double first, double second) {
    using sulfur::scene::Limits;
    const double ratio = static_cast<double>(gear.ratio) * first / second;
    const double size = std::clamp(std::abs(ratio), Limits::leastRatio, Limits::ratio);
    gear.ratio = static_cast<Real>(std::copysign(size, ratio));
    if (!gear.drive) return;
    gear.drive =
        first < 0 ? mirroredDrive(*gear.drive) : scaledDrive(*gear.drive, static_cast<Real>(first));
}

// The mechanisms of the plan with the ends of what is selected mapped, and all else of those
// between what is selected.
template <class Map>
std::vector<SceneMechanism> mapped(const Workbench& bench, const Map& map) {
    using namespace sulfur::scene;
    const Document& document = bench.document();
    std::map<std::string, double> angles;  // of what is selected, rad
    for (const BodyId body : document.withPegs(bench.selection()))
        angles.emplace(document.idOf(body), document.world().pose(body).angle);
    std::map<std::string, double> values;  // by what those between what is selected are multiplied
    auto mechanisms = document.scene().mechanisms;
    for (auto& mechanism : mechanisms) {
        if (auto* gear = std::get_if<Gear>(&mechanism.spec)) {
            const auto first = values.find(gear->first), second = values.find(gear->second);
            if (first != values.end() && second != values.end())
                mapGear(*gear, first->second, second->second);
            continue;
        }
        const auto names = bodiesOf(mechanism);
        const bool isWhole = std::all_of(names.begin(), names.end(),
                                         [&](const auto* name) { return angles.contains(*name); });
        if (!isWhole) {
            for (const auto& [id, angle] : angles) mapEnd(mechanism, id, angle, map);
            continue;
        }
        for (const auto& [id, angle] : angles)
            for (Point* point : pointsOf(mechanism, id)) *point = map.point(*point);
        std::visit(map, mechanism.spec);
        const auto& spec = mechanism.spec;
        values.emplace(mechanism.id, map.value(std::holds_alternative<Hinge>(spec) ||
                                               std::holds_alternative<Weld>(spec) ||
                                               std::holds_alternative<Wheel>(spec)));
    }
    return mechanisms;
}

// Those of what is selected, in the frames of their bodies.
template <class Map>
void mapThrusters(Workbench& bench, const Map& map) {
    auto thrusters = bench.document().thrusters();
    for (Thruster& thruster : thrusters)
        if (const BodyId body = bench.document().bodyOf(thruster.body);
            body && bench.selected(body))
            map(thruster);
    setThrusters(bench.document().planForEditing(), thrusters);
}

void placeAll(Workbench& bench, Pose (*where)(const Pose&, const Point&, double),
              const Point& about, double value) {
    Document& document = bench.document();
    const auto bodies = document.withPegs(bench.selection());
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
    const auto pegs = document.withPegs(bench.selection());
    document.change(pegs, [&](Prefab& prefab) { scalePlan(prefab, factor); });
    scaleTies(bench, factor);
    mapThrusters(bench, [&](Thruster& thruster) {
        thruster.at *= static_cast<Real>(factor);
        thruster.force *= static_cast<Real>(factor * factor);
    });
    auto mechanisms = mapped(bench, Scaling{about, factor});
    placeAll(
        bench,
        [](const Pose& pose, const Point& around, double f) {
            return Pose{around + f * (pose.position - around), pose.angle};
        },
        about, factor);
    if (!document.canReset()) document.planForEditing().mechanisms = std::move(mechanisms);
}

void mirrorSelection(Workbench& bench, const Point& about) {
    Document& document = bench.document();
    for (const BodyId body : bench.selection())
        if (const std::string id = document.idOf(body); !id.empty())
            document.placementForEditing(id).state.reset();
    document.change(document.withPegs(bench.selection()), mirrorPlan);
    mapThrusters(bench, [](Thruster& thruster) {
        thruster.at.x() = -thruster.at.x();
        thruster.force.x() = -thruster.force.x();
    });
    auto mechanisms = mapped(bench, Mirroring{about});
    placeAll(
        bench,
        [](const Pose& pose, const Point& around, double) {
            return Pose{Point(2 * around.x() - pose.position.x(), pose.position.y()),
                        wrapped(-pose.angle)};
        },
        about, 0);
    if (!document.canReset()) document.planForEditing().mechanisms = std::move(mechanisms);
}

}  // namespace sulfurchamber
