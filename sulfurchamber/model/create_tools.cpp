// Tools that make bodies: a click makes one of the usual size, a drag says how large.
#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

constexpr double massPerArea = 4;     // kg/m^2: half a metre of box weighs a kilogram
constexpr double massPerMetre = 0.4;  // kg/m of rope
constexpr double smallest = 0.08;     // metres; a shorter drag is a click

Real real(double value) {
    return static_cast<Real>(value);
}

// Press, drag, release between two points.
class DragTool : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        from_ = to_ = bench().snapped(pointer.position);
        dragging_ = true;
    }
    void move(const Pointer& pointer) override {
        if (dragging_) to_ = bench().snapped(pointer.position);
    }
    void release(const Pointer& pointer) override {
        if (!dragging_) return;
        move(pointer);
        dragging_ = false;
        make(pointer);
    }
    void cancel() override { dragging_ = false; }

protected:
    virtual void make(const Pointer& pointer) = 0;

    bool dragging() const { return dragging_; }
    const Point& from() const { return from_; }
    const Point& to() const { return to_; }
    double length() const { return (to_ - from_).norm(); }
    bool clicked() const { return length() < smallest; }
    void add(const std::string& name, const sulfur::scene::Generator& recipe,
             const Point& position) {
        document().edit("Add " + name,
                        [&] { document().add(name, recipe, {.position = position}); });
    }

private:
    bool dragging_ = false;
    Point from_{0, 0};
    Point to_{0, 0};
};

// Rectangles: boxes and jellies.
class RectangleTool final : public DragTool {
public:
    RectangleTool(Workbench& bench, bool soft) : DragTool(bench), soft_(soft) {}

    Preview preview() const override {
        if (!dragging() || clicked()) return {};
        return {Preview::Kind::rectangle, from(), to(), 0};
    }
    std::string hint() const override {
        return soft_ ? "Click to drop a jelly, or drag its size"
                     : "Click to drop a box, or drag its size";
    }

private:
    void make(const Pointer&) override {
        const double usual = soft_ ? 0.8 : 0.5;
        Point size = (to() - from()).cwiseAbs();
        const Point centre = clicked() ? to() : Point((from() + to()) / 2);
        if (clicked()) size = {usual, usual};
        size = size.cwiseMax(smallest).cwiseMin(100.0);
        const double mass = size.x() * size.y() * massPerArea;
        if (soft_)
            add("jelly", jelly(size, mass), centre);
        else
            add("box", sulfur::shapes::BoxOptions{.size = size.cast<Real>(), .mass = real(mass)},
                centre);
    }

    // Springs that let the body sag by two parts in a hundred under its weight, and large ones,
    // which fall faster, by less.
    static sulfur::shapes::JellyOptions jelly(const Point& size, double mass) {
        const auto cells = [](double side) {
            return std::clamp(static_cast<int>(std::lround(side / 0.2)) + 1, 3, 12);
        };
        sulfur::shapes::JellyOptions options;
        options.size = size.cast<Real>();
        options.columns = cells(size.x());
        options.rows = cells(size.y());
        options.mass = real(mass);
        options.radius = real(std::min(0.03, size.minCoeff() / 8));
        options.stiffness = real(260 * mass * std::max(size.y(), 1 / size.y()));
        options.damping = real(1.2 * mass);
        return options;
    }

    bool soft_;
};

class BallTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        if (!dragging() || clicked()) return {};
        return {Preview::Kind::circle, from(), to(), length()};
    }
    std::string hint() const override {
        return "Click to drop a ball, or drag from its centre to its rim";
    }

private:
    void make(const Pointer&) override {
        const double radius = clicked() ? 0.25 : std::min(length(), 50.0);
        const double mass = 3.14159265 * radius * radius * massPerArea;
        sulfur::shapes::BallOptions options{
            .radius = real(radius), .mass = real(mass), .material = {}};
        options.material.restitution = Real(0.4);
        add("ball", options, from());
    }
};

class RopeTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        if (!dragging()) return {};
        return {Preview::Kind::line, from(), to(), length()};
    }
    std::string hint() const override {
        return dragging() ? "Release where the rope ends; with Shift both free ends are pinned"
                          : "Drag to span a rope: it ties itself to what its ends touch, a free "
                            "start is pinned";
    }

private:
    // A rope's end is tied by one more link to a particle near it, if there is one.
    struct Tie {
        std::optional<ParticlePick> pick;
        Point point{0, 0};
    };

    Tie tieAt(const Point& point, double reach) const {
        auto pick = particleAt(world(), point, std::max(reach, 0.06));
        if (!pick) return {std::nullopt, point};
        return {pick, world().position(pick->particle)};
    }

    void make(const Pointer& pointer) override {
        const Tie start = tieAt(from(), pointer.reach);
        const Tie end = tieAt(to(), pointer.reach);
        const Point span = end.point - start.point;
        const double whole = span.norm();
        if (whole < 2 * smallest) return;
        const double link = std::min(0.08, whole / 4);
        const Point along = span / whole;
        const Point first = start.pick ? Point(start.point + link * along) : start.point;
        const Point last = end.pick ? Point(end.point - link * along) : end.point;
        sulfur::shapes::RopeOptions options;
        options.from = {0, 0};
        options.to = (last - first).cast<Real>();
        options.links =
            std::clamp(static_cast<int>(std::lround((last - first).norm() / 0.08)), 1, 400);
        options.mass = real(whole * massPerMetre);
        options.pinFirst = !start.pick;
        options.pinLast = !end.pick && pointer.shift;
        // Between two things it hangs as between two pins. A single link cannot.
        if (end.pick && options.links > 1) options.slack = sulfur::Real(0.02);
        document().edit("Add rope", [&] {
            const BodyId rope = document().add("rope", options, {.position = first});
            const auto particles = world().particles(rope);
            if (start.pick) document().connect(particles.front(), start.pick->particle);
            if (end.pick) document().connect(particles.back(), end.pick->particle);
        });
    }
};

class GroundTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        if (!dragging()) return {};
        return {Preview::Kind::line, from(), to(), length()};
    }
    std::string hint() const override { return "Drag a line of fixed ground"; }

private:
    void make(const Pointer&) override {
        if (clicked()) return;
        sulfur::shapes::GroundOptions options;
        options.points = {Vec2(0, 0), (to() - from()).cast<Real>()};
        add("ground", options, from());
    }
};

}  // namespace

std::unique_ptr<Tool> makeCreateTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::ball:
            return std::make_unique<BallTool>(bench);
        case ToolKind::jelly:
            return std::make_unique<RectangleTool>(bench, true);
        case ToolKind::rope:
            return std::make_unique<RopeTool>(bench);
        case ToolKind::ground:
            return std::make_unique<GroundTool>(bench);
        default:
            return std::make_unique<RectangleTool>(bench, false);
    }
}

}  // namespace sulfurchamber
