#include "transform.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "stretch.hpp"

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
    Stretch stretch;

    // Of lengths that have no direction of their own.
    double factor() const { return std::sqrt(stretch.factors.x() * stretch.factors.y()); }
    // Of lengths along an axis.
    double factor(const Vec2& axis) const {
        const Point way = axis.cast<double>().normalized();
        return (stretch(stretch.about + way) - stretch.about).norm();
    }
    Point point(const Point& p) const { return stretch(p); }
    Vec2 direction(const Vec2& d) const {
        if (stretch.isUniform()) return d;
        const Point way = stretch(stretch.about + d.cast<double>()) - stretch.about;
        return way.normalized().cast<Real>();
    }
    double turn(double) const { return 0; }
    double value(bool isAngle) const { return isAngle ? 1 : factor(); }
    template <class Spec>
    void operator()(Spec& spec) const {
        const auto f = static_cast<Real>(factor());
        using namespace sulfur::scene;
        if constexpr (std::is_same_v<Spec, Slider>) {
            const double own = spec.rail.empty() ? factor(spec.axis) : factor();
            spec.options.value *= own;
            spec.options.drive = scaledDrive(spec.options.drive, static_cast<Real>(own));
        }
        if constexpr (std::is_same_v<Spec, Distance>)
            spec.options.drive = scaledDrive(spec.options.drive, f);
        if constexpr (std::is_same_v<Spec, Wheel>)
            spec.options.spring =
                scaledDrive(spec.options.spring, static_cast<Real>(factor(spec.axis)));
        if constexpr (std::is_same_v<Spec, Pulley>) {
            if (spec.options.length) *spec.options.length *= f;
            if (spec.drive) spec.drive = scaledDrive(*spec.drive, f);
        }
        if constexpr (requires { spec.axis; }) spec.axis = direction(spec.axis);
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
    if (!slider.rail.empty()) {  // which goes with a
        if (slider.b == id) slider.at = map.point(slider.at);
        return;
    }
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

// Bodies stand along the frame of a stretch, or across it: then its factors change places.
bool standsAcross(double angle, const Stretch& stretch) {
    return std::abs(std::cos(angle - stretch.angle)) < std::sqrt(0.5);
}

Point localFactors(double angle, const Stretch& stretch) {
    const Point& f = stretch.factors;
    return standsAcross(angle, stretch) ? Point(f.y(), f.x()) : f;
}

// Joints and axles between bodies that are scaled follow. `lengths` has what joints were long.
struct Tied {
    sulfur::JointId joint;
    Point a{0, 0};
    Point b{0, 0};
};

std::vector<Tied> tiesWithin(const Workbench& bench) {
    const auto& world = bench.document().world();
    std::vector<Tied> ties;
    for (const auto joint : world.connections()) {
        const auto info = world.info(joint);
        if (bench.selected(world.info(info.a).body) && bench.selected(world.info(info.b).body))
            ties.push_back({joint, world.position(info.a), world.position(info.b)});
    }
    return ties;
}

double lengthFactor(const Point& a, const Point& b, const Stretch& stretch) {
    const double before = (a - b).norm();
    if (stretch.isUniform() || !(before > 0)) return stretch.factors.x();
    return (stretch(a) - stretch(b)).norm() / before;
}

// In the world, which may be a moment of its own.
void scaleTies(Workbench& bench, const Stretch& stretch) {
    auto& world = bench.document().world();
    for (const Tied& tie : tiesWithin(bench)) {
        const auto rest = static_cast<double>(world.info(tie.joint).restLength);
        world.setRestLength(tie.joint,
                            static_cast<Real>(rest * lengthFactor(tie.a, tie.b, stretch)));
    }
}

// In the plan: bodies by id, with the angle of each.
void scaleTies(sulfur::scene::Scene& plan, const std::map<std::string, double>& angles,
               const Stretch& stretch) {
    const auto placeOf = [&](const sulfur::scene::ParticleRef& ref) -> Point {
        const auto& body = *plan.body(ref.body);
        return body.pose.position +
               Eigen::Rotation2Dd(body.pose.angle) * plan.prefab(body.blueprint)
                                                         ->blueprint.particles[ref.particle]
                                                         .position.cast<double>();
    };
    for (auto& connection : plan.connections)
        if (connection.options.restLength && angles.contains(connection.a.body) &&
            angles.contains(connection.b.body))
            *connection.options.restLength *= static_cast<Real>(
                lengthFactor(placeOf(connection.a), placeOf(connection.b), stretch));
    for (auto& attachment : plan.attachments)
        if (const auto body = angles.find(attachment.body); body != angles.end())
            attachment.point =
                attachment.point.cwiseProduct(localFactors(body->second, stretch).cast<Real>());
}

// Blueprints of those that stand along the frame, and of those across it.
void stretchPlans(Workbench& bench, const std::map<std::string, double>& angles,
                  const Stretch& stretch) {
    Document& document = bench.document();
    if (stretch.isUniform()) {
        document.change(document.withPegs(bench.selection()),
                        [&](Prefab& prefab) { stretchPlan(prefab, stretch.factors); });
        return;
    }
    for (const bool across : {false, true}) {
        std::vector<BodyId> bodies;
        for (const BodyId body : bench.selection())
            if (standsAcross(angles.at(document.idOf(body)), stretch) == across)
                bodies.push_back(body);
        if (bodies.empty()) continue;
        const Point& f = stretch.factors;
        const Point own = across ? Point(f.y(), f.x()) : f;
        document.change(bodies, [&](Prefab& prefab) { stretchPlan(prefab, own); });
    }
}

std::map<std::string, double> anglesOf(const Workbench& bench) {
    std::map<std::string, double> angles;
    const Document& document = bench.document();
    for (const BodyId body : bench.selection())
        if (std::string id = document.idOf(body); !id.empty())
            angles.emplace(std::move(id), document.world().pose(body).angle);
    return angles;
}

void forgetStates(Workbench& bench) {
    Document& document = bench.document();
    for (const BodyId body : bench.selection())
        if (const std::string id = document.idOf(body); !id.empty())
            document.placementForEditing(id).state.reset();
}

}  // namespace

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
    stretchSelection(bench, {about, {factor, factor}, 0});
}

bool canStretch(const Workbench& bench) {
    constexpr double aslant = 1e-3;  // radians
    const Document& document = bench.document();
    const auto frame = selectionFrame(bench);
    if (!frame) return false;
    std::set<std::string> seen;
    for (const BodyId body : bench.selection()) {
        const std::string id = document.idOf(body);
        if (id.empty()) return false;
        const double off = document.world().pose(body).angle - frame->angle;
        if (std::abs(std::remainder(off, pi / 2)) > aslant) return false;
        const std::string& blueprint = document.plan().body(id).blueprint;
        if (seen.insert(blueprint).second && !canStretch(document.plan().prefab(blueprint)))
            return false;
    }
    return true;
}

void stretchSelection(Workbench& bench, const Stretch& stretch) {
    if (!(stretch.factors.minCoeff() > 0)) throw std::runtime_error("a size must be above 0");
    Document& document = bench.document();
    const auto angles = anglesOf(bench);
    forgetStates(bench);
    scaleTies(bench, stretch);
    scaleTies(document.planForEditing(), angles, stretch);
    stretchPlans(bench, angles, stretch);
    mapThrusters(bench, [&](Thruster& thruster) {
        const auto angle = angles.find(thruster.body);
        if (angle == angles.end()) return;
        thruster.at = thruster.at.cwiseProduct(localFactors(angle->second, stretch).cast<Real>());
        thruster.force *= static_cast<Real>(stretch.factors.prod());
    });
    auto mechanisms = mapped(bench, Scaling{stretch});
    const auto bodies = document.withPegs(bench.selection());
    for (const BodyId body : bodies) {
        const Pose pose = document.world().pose(body);
        document.place(body, {stretch(pose.position), pose.angle});
    }
    if (!document.canReset()) document.planForEditing().mechanisms = std::move(mechanisms);
}

double massAfter(const Workbench& bench, const Stretch& stretch) {
    const Document& document = bench.document();
    std::map<std::pair<std::string, bool>, double> known;  // of blueprints
    double sum = 0;
    for (const BodyId body : bench.selection()) {
        if (document.world().kind(body) == sulfur::BodyKind::fixed) continue;
        const std::string id = document.idOf(body);
        if (id.empty()) {
            sum += static_cast<double>(document.world().mass(body)) * stretch.factors.prod();
            continue;
        }
        const double angle = document.world().pose(body).angle;
        const auto& name = document.plan().body(id).blueprint;
        const auto [found, isNew] = known.try_emplace({name, standsAcross(angle, stretch)}, 0);
        if (isNew) {
            Prefab prefab = document.plan().prefab(name);
            stretchPlan(prefab, localFactors(angle, stretch));
            found->second = static_cast<double>(prefab.blueprint.mass());
        }
        sum += found->second;
    }
    return sum;
}

void mirrorSelection(Workbench& bench, const Point& about) {
    Document& document = bench.document();
    forgetStates(bench);
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
