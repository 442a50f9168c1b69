// Tools that fit something between bodies: hinges, motors, springs, ropes and their like. Where one
// end is on no moving body, a peg is put there: a fixed body that is but a point.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drag_tool.hpp"
#include "fitting_marks.hpp"
#include "geometry.hpp"
#include "rail.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Drive;
using sulfur::Point;
using sulfur::Real;
using sulfur::scene::SceneMechanism;

constexpr double earth = 9.81;           // m/s^2
constexpr double springFrequency = 1.5;  // Hz, of the lighter body on a new spring
constexpr double springDamping = 0.1;    // of critical
constexpr double axleFrequency = 1.7;
constexpr double axleDamping = 0.5;

// Two digits, as a person would choose it.
Real rounded(double value) {
    if (!(value > 0)) return 0;
    const double power = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return static_cast<Real>(std::round(value / power) * power);
}

// What tools say that make one of several kinds.
struct KindWords {
    ToolKind kind;
    const char* step;
    const char* hint;
};
constexpr KindWords kindWords[] = {
    {ToolKind::hinge, "Add hinge",
     "Click where two bodies overlap to hinge them, or a single body to hang it"},
    {ToolKind::motor, "Add motor",
     "Click where two bodies overlap to turn the upper one, or a single body"},
    {ToolKind::weld, "Add weld",
     "Click where two bodies overlap to weld them, or a single body to hold it"},
    {ToolKind::spring, "Add spring", "Drag a spring from body to body, or to the background"},
    {ToolKind::cable, "Add cable", "Drag a cable from body to body: it only pulls"},
    {ToolKind::winch, "Add winch",
     "Drag a winch from where it stands to its load: Up winds in, Down out"}};

const KindWords& kindWordsOf(ToolKind kind) {
    return *std::find_if(std::begin(kindWords), std::end(kindWords),
                         [kind](const KindWords& words) { return words.kind == kind; });
}

// What all of these do.
class FitTool : public DragTool {
public:
    using DragTool::DragTool;

protected:
    /// Where many overlap, what is selected comes first.
    std::vector<BodyId> bodiesUnder(const Point& point, double reach) const {
        auto bodies = movingBodiesAt(world(), point, std::min(reach, 0.1));
        std::stable_partition(bodies.begin(), bodies.end(),
                              [&](BodyId body) { return bench().selected(body); });
        return bodies;
    }
    double massOf(BodyId body) const { return static_cast<double>(world().mass(body)); }
    double radiusOf(BodyId body) const {
        const auto bounds = world().bounds(body);
        return (bounds.high - bounds.low).minCoeff() / 2;
    }
    std::string addPeg(const Point& at) { return addFixed("peg", at, {{0, 0}}); }
    /// A line without thickness that others slide along.
    std::string addRail(const Point& from, const Point& to) {
        const Point way = to - from;
        return addFixed("rail", from, {{0, 0}, way.cast<Real>()});
    }
    /// The id of a moving body under a point, or else of a new peg there.
    std::string endAt(const Point& at, BodyId body) {
        return body ? document().idOf(body) : addPeg(at);
    }
    /// Pieces that broke off are not in the plan, and nothing can be fitted to them.
    BodyId planned(const std::vector<BodyId>& bodies, std::size_t place) const {
        if (place >= bodies.size()) return {};
        if (document().idOf(bodies[place]).empty())
            throw std::runtime_error("nothing can be fitted to a piece; reset the scene first");
        return bodies[place];
    }
    /// One step, after which it is selected.
    void fit(const std::string& label, const std::function<SceneMechanism()>& make) {
        FittingRef made;
        document().edit(label, [&] { made = document().fit(make()); });
        bench().chooseFitting(made);
    }

private:
    std::string addFixed(const char* name, const Point& at, std::vector<sulfur::Vec2> points) {
        sulfur::scene::Prefab prefab;
        prefab.blueprint.name = name;
        prefab.blueprint.kind = sulfur::BodyKind::fixed;
        for (const auto& point : points) prefab.blueprint.particles.push_back({.position = point});
        if (points.size() == 2) prefab.blueprint.joints.push_back({.a = 0, .b = 1});
        sulfur::scene::Placement placement;
        placement.pose.position = at;
        return document().idOf(document().add(prefab, placement));
    }
};

// A click where two bodies overlap joins them; where there is one it is joined to the background.
class PinnedTool final : public FitTool {
public:
    PinnedTool(Workbench& bench, ToolKind kind) : FitTool(bench), kind_(kind) {}
    std::string hint() const override { return kindWordsOf(kind_).hint; }

private:
    void make(const Pointer& pointer) override {
        const auto bodies = bodiesUnder(to(), pointer.reach);
        const BodyId upper = planned(bodies, 0);
        const BodyId lower = planned(bodies, 1);
        if (!upper) return;
        fit(kindWordsOf(kind_).step, [&] {
            const Real torque = rounded(40 * massOf(upper) * radiusOf(upper));
            SceneMechanism made;
            const std::string b = document().idOf(upper);
            const std::string a = endAt(to(), lower);
            if (kind_ == ToolKind::weld) {
                made.spec = sulfur::scene::Weld{a, b, to(), {}, {}};
                return made;
            }
            sulfur::scene::Hinge hinge{a, b, to(), {}};
            if (kind_ == ToolKind::motor)
                hinge.options.drive = {.motorSpeed = 3, .motorMax = torque};
            made.spec = hinge;
            return made;
        });
    }

    ToolKind kind_;
};

// Springs, cables and winches between two points.
class StretchTool final : public FitTool {
public:
    StretchTool(Workbench& bench, ToolKind kind) : FitTool(bench), kind_(kind) {}
    Preview preview() const override {
        if (!dragging()) return {};
        return {Preview::Kind::line, from(), to(), length()};
    }
    std::string hint() const override {
        if (dragging() && !clicked())
            return tr("{}; release on another body", {metresText(length())});
        return kindWordsOf(kind_).hint;
    }

private:
    void make(const Pointer& pointer) override {
        if (clicked()) return;
        const BodyId a = planned(bodiesUnder(from(), pointer.reach), 0);
        const BodyId b = planned(bodiesUnder(to(), pointer.reach), 0);
        if (a == b)
            throw std::runtime_error(a ? "both ends are on one body; allowed are two"
                                       : "both ends are on the background; allowed is at most one");
        fit(kindWordsOf(kind_).step, [&] {
            sulfur::scene::Distance made;
            made.options.drive = drive(a, b);
            made.a = endAt(from(), a);
            made.b = endAt(to(), b);
            made.atA = from();
            made.atB = to();
            SceneMechanism mechanism;
            mechanism.spec = std::move(made);
            if (kind_ == ToolKind::winch) setKeys(mechanism, {"Up", "Down", 0});
            return mechanism;
        });
    }

    Drive drive(BodyId a, BodyId b) const {
        const double most = std::max(a ? massOf(a) : 0, b ? massOf(b) : 0);
        const double least = a && b ? std::min(massOf(a), massOf(b)) : most;
        const auto whole = static_cast<Real>(length());
        if (kind_ == ToolKind::cable) return {.upper = whole};
        if (kind_ == ToolKind::winch)
            return {.lower = std::min(Real(0.2), whole / 2),
                    .upper = whole,
                    .motorSpeed = Real(-0.6),
                    .motorMax = rounded(4 * most * earth)};
        const double w = 2 * std::numbers::pi * springFrequency;
        return {.stiffness = rounded(least * w * w),
                .damping = rounded(2 * springDamping * least * w),
                .rest = whole};
    }

    ToolKind kind_;
};

class SliderTool final : public FitTool {
public:
    using FitTool::FitTool;
    Preview preview() const override {
        if (!dragging()) return {};
        return {Preview::Kind::line, from(), to(), length()};
    }
    std::string hint() const override {
        if (dragging() && !clicked())
            return tr("A rail of {}, {}",
                      {metresText(length()), degreesText(directionOf(to() - from()))});
        return "Drag from a body along its rail, or click it where it is on a rope, hoop or line";
    }

private:
    void make(const Pointer& pointer) override {
        const auto bodies = bodiesUnder(from(), pointer.reach);
        if (bodies.empty()) return;
        if (clicked()) {
            putOnRail(bodies, pointer.reach);
            return;
        }
        const BodyId upper = planned(bodies, 0);
        const BodyId lower = planned(bodies, 1);
        sulfur::scene::Slider made;
        made.b = document().idOf(upper);
        made.at = from();
        made.axis = (to() - from()).normalized().cast<Real>();
        made.options.drive = {.lower = 0, .upper = static_cast<Real>(length())};
        made.options.turns = false;
        fit("Add slider", [&] {
            made.a = lower ? document().idOf(lower) : addRail(from(), to());
            return mechanismOf(made);
        });
    }

    // Of two lines the longer one bears: a bead may be a ring itself.
    void putOnRail(const std::vector<BodyId>& bodies, double reach) {
        for (const RailLine& rail : railsAt(world(), from(), reach)) {
            const auto rider = std::find_if(bodies.begin(), bodies.end(),
                                            [&](BodyId body) { return body != rail.body; });
            if (rider == bodies.end()) continue;
            sulfur::scene::Slider made;
            made.a = document().idOf(whole(rail.body));
            made.b = document().idOf(whole(*rider));
            // A disc is held at its middle.
            const bool disc = world().particles(*rider).size() == 1;
            made.at = disc ? world().centreOfMass(*rider) : rail.at;
            const auto joints = world().joints(rail.body);
            for (const sulfur::JointId link : rail.links)
                made.rail.push_back(static_cast<std::uint32_t>(
                    std::find(joints.begin(), joints.end(), link) - joints.begin()));
            fit("Add slider", [&] { return mechanismOf(made); });
            return;
        }
        throw std::runtime_error(
            "there is no rail here; drag along one, or click where the body is on a rope, hoop or "
            "line of another one");
    }

    // The plan names links by their places: none of them may have broken.
    BodyId whole(BodyId body) const {
        const BodyId found = planned({body}, 0);
        const auto& plan = document().plan().blueprint(document().idOf(found));
        if (plan.joints.size() != world().joints(found).size())
            throw std::runtime_error("nothing can be fitted to a piece; reset the scene first");
        return found;
    }

    static SceneMechanism mechanismOf(const sulfur::scene::Slider& slider) {
        SceneMechanism mechanism;
        mechanism.spec = slider;
        return mechanism;
    }
};

// A wheel below a body, on a spring, with a motor that keys drive.
class AxleTool final : public FitTool {
public:
    using FitTool::FitTool;
    Preview preview() const override {
        if (!dragging() || clicked()) return {};
        return {Preview::Kind::line, from(), to(), length()};
    }
    std::string hint() const override {
        return "Click a wheel's hub on a body, or drag from it to the body; arrows drive it";
    }

private:
    void make(const Pointer& pointer) override {
        auto under = bodiesUnder(from(), pointer.reach);
        if (under.empty()) return;
        // The wheel is what has its middle here.
        const auto off = [&](BodyId body) { return (world().centreOfMass(body) - from()).norm(); };
        std::stable_sort(under.begin(), under.end(),
                         [&](BodyId a, BodyId b) { return off(a) < off(b); });
        const BodyId wheel = planned(under, 0);
        BodyId rider = planned(under, 1);
        if (!clicked()) {
            auto over = bodiesUnder(to(), pointer.reach);
            std::erase(over, wheel);
            if (!over.empty()) rider = planned(over, 0);
        }
        if (!rider)
            throw std::runtime_error(
                "an axle needs a wheel and a body that rides on it; drag from the hub to the body");
        fit("Add axle", [&] { return axle(rider, wheel); });
    }

    SceneMechanism axle(BodyId rider, BodyId wheel) const {
        const double w = 2 * std::numbers::pi * axleFrequency;
        const double mass = massOf(rider) / 2;
        const double radius = radiusOf(wheel);
        const auto travel = static_cast<Real>(0.45 * radius);
        sulfur::scene::Wheel made;
        made.a = document().idOf(rider);
        made.b = document().idOf(wheel);
        made.at = world().centreOfMass(wheel);
        // It stands where it was drawn, once it bears its load.
        const double gravity = -static_cast<double>(document().scene().settings.gravity.y());
        made.options.spring = {.lower = -travel,
                               .upper = travel,
                               .stiffness = rounded(mass * w * w),
                               .damping = rounded(2 * axleDamping * mass * w),
                               .rest = static_cast<Real>(-gravity / (w * w))};
        made.options.motor = {.motorSpeed = -12, .motorMax = rounded(25 * mass * radius)};
        SceneMechanism mechanism;
        mechanism.spec = std::move(made);
        setKeys(mechanism, {"Right", "Left", 0});
        return mechanism;
    }
};

// Four clicks along a rope: a body, over two points, and another body.
class PulleyTool final : public FitTool {
public:
    using FitTool::FitTool;
    void press(const Pointer& pointer) override {
        DragTool::press(pointer);
        here_ = from();
    }
    void move(const Pointer& pointer) override { here_ = bench().snapped(pointer.position); }
    void cancel() override {
        DragTool::cancel();
        places_.clear();
    }
    Preview preview() const override {
        if (places_.empty()) return {};
        auto path = places_;
        path.push_back(here_);
        return {Preview::Kind::path, path.front(), path.back(), 0, path};
    }
    std::string hint() const override {
        static constexpr std::array hints{
            "Click the body at one end of the rope", "Click where the rope turns down",
            "Click where it turns down again; the same place is one wheel",
            "Click the body at the other end"};
        return hints.at(places_.size());
    }

private:
    void make(const Pointer& pointer) override {
        const auto under = bodiesUnder(from(), pointer.reach);
        const bool isEnd = places_.empty() || places_.size() == 3;
        if (isEnd && !planned(under, 0)) return;
        places_.push_back(from());
        if (places_.size() < 4) return;
        const auto places = std::exchange(places_, {});
        const BodyId a = planned(bodiesUnder(places[0], pointer.reach), 0);
        const BodyId b = planned(under, 0);
        if (a == b) throw std::runtime_error("both ends are on one body; allowed are two");
        fit("Add pulley", [&] {
            const bool single = (places[1] - places[2]).norm() <= pointer.reach;
            sulfur::scene::Pulley made;
            made.a = document().idOf(a);
            made.b = document().idOf(b);
            made.frame = single ? addPeg(places[1]) : addRail(places[1], places[2]);
            made.atA = places[0];
            made.atB = places[3];
            made.overA = places[1];
            made.overB = single ? places[1] : places[2];
            SceneMechanism mechanism;
            mechanism.spec = std::move(made);
            return mechanism;
        });
    }

    std::vector<Point> places_;
    Point here_{0, 0};
};

class GearTool final : public FitTool {
public:
    using FitTool::FitTool;
    Preview preview() const override {
        if (!dragging() || clicked()) return {};
        return {Preview::Kind::line, from(), to(), length()};
    }
    std::string hint() const override {
        return "Drag from one mark to another: both turn together";
    }

private:
    std::optional<FittingMark> partAt(const Point& point, double reach) const {
        std::optional<FittingMark> found;
        double nearest = 2 * reach;
        for (FittingMark& mark : fittingMarks(document())) {
            using Shape = FittingMark::Shape;
            const bool fits = mark.shape == Shape::hinge || mark.shape == Shape::motor ||
                              mark.shape == Shape::axle || mark.shape == Shape::slider;
            const double off = (mark.at - point).norm();
            if (!fits || off > nearest) continue;
            nearest = off;
            found = std::move(mark);
        }
        return found;
    }

    void make(const Pointer& pointer) override {
        const auto first = partAt(from(), pointer.reach);
        const auto second = partAt(to(), pointer.reach);
        if (!first || !second || first->ref == second->ref) return;
        fit("Add gear", [&] {
            sulfur::scene::Gear made;
            made.first = named(first->ref);
            made.second = named(second->ref);
            made.ratio = ratio(first->ref, second->ref);
            SceneMechanism mechanism;
            mechanism.spec = std::move(made);
            return mechanism;
        });
    }

    // Those of other programs may have no id.
    std::string named(const FittingRef& ref) {
        std::string id = document().scene().mechanisms[ref.index].id;
        if (!id.empty()) return id;
        id = "part" + std::to_string(ref.index + 1);
        document().refit(
            ref, [&](Fitting& f) { std::get<SceneMechanism>(f).id = id; }, true);
        return id;
    }

    // That of wheels which touch; else both turn alike.
    Real ratio(const FittingRef& first, const FittingRef& second) const {
        const auto radius = [&](const FittingRef& ref) {
            SceneMechanism one = document().scene().mechanisms[ref.index];
            if (std::holds_alternative<sulfur::scene::Slider>(one.spec)) return 1.0;
            const BodyId body = document().bodyOf(*bodiesOf(one).at(1));
            return body ? radiusOf(body) : 1.0;
        };
        return rounded(radius(second) / radius(first));
    }
};

}  // namespace

std::unique_ptr<Tool> makeMechanismTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::spring:
        case ToolKind::cable:
        case ToolKind::winch:
            return std::make_unique<StretchTool>(bench, kind);
        case ToolKind::slider:
            return std::make_unique<SliderTool>(bench);
        case ToolKind::axle:
            return std::make_unique<AxleTool>(bench);
        case ToolKind::pulley:
            return std::make_unique<PulleyTool>(bench);
        case ToolKind::gear:
            return std::make_unique<GearTool>(bench);
        default:
            return std::make_unique<PinnedTool>(bench, kind);
    }
}

}  // namespace sulfurchamber
