// Tools for what pushes without touching, and for what runs and flows: thrusters, wind, gravity,
// conveyors, liquid.
#include <algorithm>
#include <cmath>

#include "drag_tool.hpp"
#include "geometry.hpp"
#include "properties.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::scene::SceneField;

constexpr double thrustPerMetre = 20;  // N for each kilogram and metre that is drawn
constexpr double windSpeed = 6;        // m/s
constexpr double beltSpeed = 1.5;      // m/s
constexpr double dropRadius = 0.06;    // metres
constexpr double dropDensity = 4;      // kg/m^2
constexpr std::size_t mostDrops = 600;

std::string newtons(double force) {
    return fixed(force, force < 100 ? 1 : 0) + " N";
}

class ThrusterTool final : public DragTool {
public:
    using DragTool::DragTool;
    void press(const Pointer& pointer) override {
        DragTool::press(pointer);
        const auto under = movingBodiesAt(world(), from(), pointer.reach);
        body_ = under.empty() ? BodyId{} : under.front();
    }
    Preview preview() const override {
        if (!dragging() || !body_) return {};
        return {Preview::Kind::arrow, from(), to(), length()};
    }
    std::string hint() const override {
        if (dragging() && body_ && !clicked())
            return newtons(force().norm()) + ", " + degreesText(directionOf(to() - from()));
        return "Drag from a body in the direction in which it is pushed; Up switches it on";
    }

private:
    Point force() const {
        const double mass = static_cast<double>(world().mass(body_));
        return thrustPerMetre * mass * (clicked() ? Point(0, 1) : Point(to() - from()));
    }
    void make(const Pointer&) override {
        if (!body_ || !world().contains(body_)) return;
        Thruster made;
        made.body = document().idOf(body_);
        if (made.body.empty())
            throw std::runtime_error("nothing can be fitted to a piece; reset the scene first");
        made.at = world().toBody(body_, from()).cast<Real>();
        made.force = world().vectorToBody(body_, force().cast<Real>());
        made.keys.forward = "Up";
        FittingRef ref;
        document().edit("Add thruster", [&] { ref = document().fit(made); });
        bench().chooseFitting(ref);
    }

    BodyId body_;
};

class ZoneTool final : public FrameTool {
public:
    ZoneTool(Workbench& bench, bool wind) : FrameTool(bench), wind_(wind) {}
    std::string hint() const override {
        if (dragging() && !clicked())
            return tr("{} wide, {} high", {metresText(size().x()), metresText(size().y())});
        return wind_ ? "Drag a zone in which wind blows to the right"
                     : "Drag a zone without weight; its properties make it pull anywhere";
    }

private:
    void make(const Pointer&) override {
        const Point half = (clicked() ? Point(3, 2) : Point(size().cwiseMax(0.1))) / 2;
        const sulfur::BoxZone box{centre() - half, centre() + half};
        SceneField made;
        if (wind_)
            made.field = sulfur::WindField{box, {Real(windSpeed), 0}, 1};
        else
            made.field = sulfur::UniformField{box, -document().scene().settings.gravity};
        FittingRef ref;
        document().edit(wind_ ? "Add wind" : "Add gravity zone",
                        [&] { ref = document().fit(made); });
        bench().chooseFitting(ref);
    }

    bool wind_;
};

class ConveyorTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        if (!dragging() || clicked()) return {};
        return {Preview::Kind::arrow, from(), to(), length()};
    }
    std::string hint() const override {
        if (dragging() && !clicked())
            return tr("A belt of {} that runs at 1.5 m/s", {metresText(length())});
        return "Drag a belt the way it runs, or click a body whose surface shall run";
    }

private:
    void make(const Pointer& pointer) override {
        if (clicked()) {
            runSurface(bodyAt(world(), to(), pointer.reach));
            return;
        }
        // What lies on a line from left to right goes along with it.
        sulfur::shapes::GroundOptions options;
        options.points = {sulfur::Vec2(0, 0), (to() - from()).cast<Real>()};
        options.material.surfaceSpeed = Real(beltSpeed);
        const bool back = to().x() < from().x();
        if (back) {
            options.points = {(to() - from()).cast<Real>(), sulfur::Vec2(0, 0)};
            options.material.surfaceSpeed = -Real(beltSpeed);
        }
        add("Add conveyor", "conveyor", options, from());
    }

    void runSurface(BodyId body) {
        if (!body || document().idOf(body).empty()) return;
        const NumberProperty& speed = *numberProperty("surface-speed");
        const double now = common(document(), {&body, 1}, speed).value.value_or(0);
        document().edit("Run a surface", [&] {
            setProperty(document(), {&body, 1}, speed, now == 0 ? beltSpeed : -now);
        });
    }
};

// Many small slippery drops in a hexagonal packing.
class LiquidTool final : public FrameTool {
public:
    using FrameTool::FrameTool;
    std::string hint() const override {
        if (dragging() && !clicked()) {
            const auto count = places(from(), to()).size();
            if (count == mostDrops)
                return tr("{} drops, which is the most at once", {std::to_string(count)});
            return trCount("{} drop", "{} drops", count);
        }
        return "Drag a frame: it is filled with drops";
    }

private:
    static std::vector<Point> places(const Point& a, const Point& b) {
        const Point low = a.cwiseMin(b), high = a.cwiseMax(b);
        const double step = 2.02 * dropRadius, rise = step * 0.8660254;
        std::vector<Point> found;
        int row = 0;
        for (double y = low.y() + dropRadius; y <= high.y() - dropRadius; y += rise, ++row)
            for (double x = low.x() + dropRadius * (row % 2 == 0 ? 1 : 2);
                 x <= high.x() - dropRadius; x += step)
                if (found.size() < mostDrops) found.emplace_back(x, y);
        return found;
    }

    void make(const Pointer&) override {
        const Point half(0.5, 0.3);
        const auto all = clicked() ? places(to() - half, to() + half) : places(from(), to());
        if (all.empty()) return;
        sulfur::shapes::BallOptions drop{
            .radius = Real(dropRadius),
            .mass = Real(3.14159265 * dropRadius * dropRadius * dropDensity),
            .material = {}};
        drop.material.staticFriction = Real(0.02);
        drop.material.kineticFriction = Real(0.01);
        const auto prefab = sulfur::scene::makePrefab("drop", drop);
        document().edit("Add liquid", [&] {
            for (const Point& place : all) {
                sulfur::scene::Placement placement;
                placement.pose.position = place;
                sulfur::scene::setExtra(placement.extra[""], "color", "\"#3fa7ff\"");
                document().add(prefab, placement);
            }
        });
    }
};

}  // namespace

std::unique_ptr<Tool> makeZoneTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::thruster:
            return std::make_unique<ThrusterTool>(bench);
        case ToolKind::conveyor:
            return std::make_unique<ConveyorTool>(bench);
        case ToolKind::liquid:
            return std::make_unique<LiquidTool>(bench);
        default:
            return std::make_unique<ZoneTool>(bench, kind == ToolKind::wind);
    }
}

}  // namespace sulfurchamber
