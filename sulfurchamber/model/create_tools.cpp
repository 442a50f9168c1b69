// Tools that make bodies: a click makes one of the usual size, a drag says how large.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "drag_tool.hpp"
#include "geometry.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

constexpr double massPerArea = 4;     // kg/m^2: half a metre of box weighs a kilogram
constexpr double massPerMetre = 0.4;  // kg/m of rope
constexpr double leastSpan = 3;       // metres from which a rope between two ends is a bridge
constexpr double chainMassPerMetre = 3;
constexpr double bridgeMassPerMetre = 3;
constexpr double clothMassPerArea = 0.3;
constexpr double wallMassPerArea = 15;
constexpr double wallStrength = 200;  // N for each kilogram

Real real(double value) {
    return static_cast<Real>(value);
}

double discMass(double radius) {
    return std::numbers::pi * radius * radius * massPerArea;
}

// A ball or a wheel while it is drawn.
Preview circleOf(const Point& middle, const Point& rim) {
    const double radius = (rim - middle).norm();
    Preview shown{Preview::Kind::circle, middle, rim, radius};
    shown.labels = {{(middle + rim) / 2, tr("radius {}", {metresText(radius)})},
                    {middle - Point(0, radius), kilogramsText(discMass(radius))}};
    return shown;
}

// Boxes and jellies.
class RectangleTool final : public FrameTool {
public:
    RectangleTool(Workbench& bench, bool soft) : FrameTool(bench), soft_(soft) {}

    std::string hint() const override {
        return sizeOr(soft_ ? "Click to drop a jelly, or drag its size"
                            : "Click to drop a box, or drag its size");
    }

private:
    std::optional<double> massOfArea() const override { return massPerArea; }
    void make(const Pointer&) override {
        const double usual = soft_ ? 0.8 : 0.5;
        Point drawn = clicked() ? Point(usual, usual) : size();
        drawn = drawn.cwiseMax(smallest).cwiseMin(100.0);
        const double mass = drawn.x() * drawn.y() * massPerArea;
        if (soft_)
            add("Add jelly", "jelly", jelly(drawn, mass), centre());
        else
            add("Add box", "box",
                sulfur::shapes::BoxOptions{.size = drawn.cast<Real>(), .mass = real(mass)},
                centre());
    }

    // Springs that let the body sag by two parts in a hundred under its weight, and large ones,
    // which fall faster, by less. A strip bends with the square of its slenderness, and has springs
    // that are as much stiffer. A narrow one is one cell wide: pressed together, rows of three
    // particles would fold over the middle one and lock, as triangles on both sides of a row are
    // turned over the other way. So would long cells.
    static sulfur::shapes::JellyOptions jelly(const Point& size, double mass) {
        const double slender = std::max(1.0, size.maxCoeff() / size.minCoeff() / 2);
        const auto cells = [&](double side) {
            const int wanted = static_cast<int>(std::lround(side / 0.2));
            return slender > 1 && wanted < 3 ? 1 : std::clamp(wanted, 2, 11);
        };
        const auto along = [&](double side, double other) {
            const double longest = 1.5 * other / cells(other);
            return std::max(cells(side), static_cast<int>(std::ceil(side / longest)));
        };
        sulfur::shapes::JellyOptions options;
        options.size = size.cast<Real>();
        options.columns = along(size.x(), size.y()) + 1;
        options.rows = along(size.y(), size.x()) + 1;
        options.mass = real(mass);
        options.radius = real(std::min(0.03, size.minCoeff() / 8));
        options.stiffness = real(260 * mass * std::max(size.y(), 1 / size.y()) * slender * slender);
        options.damping = real(1.2 * mass);
        return options;
    }

    bool soft_;
};

class BallTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        return dragging() && !clicked() ? circleOf(from(), to()) : Preview{};
    }
    std::string hint() const override {
        if (dragging() && !clicked())
            return tr("Radius {}, {}", {metresText(length()), kilogramsText(discMass(length()))});
        return "Click to drop a ball, or drag from its centre to its rim";
    }

private:
    void make(const Pointer&) override {
        const double radius = clicked() ? 0.25 : std::min(length(), 50.0);
        const double mass = discMass(radius);
        sulfur::shapes::BallOptions options{
            .radius = real(radius), .mass = real(mass), .material = {}};
        options.material.restitution = Real(0.4);
        add("Add ball", "ball", options, from());
    }
};

class RopeTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        if (!dragging()) return {};
        Preview shown{Preview::Kind::line, from(), to(), length()};
        shown.labels = lineLabels(from(), to(), length() * massPerMetre);
        return shown;
    }
    std::string hint() const override {
        return dragging()
                   ? tr("{} of rope; release where it ends, with Shift both free ends are pinned",
                        {metresText(length())})
                   : "Drag a rope: its ends tie to what they touch, a free start is pinned";
    }

private:
    bool isLine() const override { return true; }

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
        if ((end.pick || options.pinLast) && whole > leastSpan) makeSpan(options);
        const sulfur::ConnectOptions tie{.stiffness = options.stiffness,
                                         .damping = options.damping};
        document().edit("Add rope", [&] {
            const BodyId rope = document().add("rope", options, {.position = first});
            const auto particles = world().particles(rope);
            if (start.pick) document().connect(particles.front(), start.pick->particle, tie);
            if (end.pick) document().connect(particles.back(), end.pick->particle, tie);
        });
    }

    // What bears loads between two ends gives, damps, is rough, and has few links: a load across
    // many rigid ones costs a tenth of a core. What damps bending calms it, the more the longer
    // links are: the links' own damping does nothing against swinging. From end to end all of them
    // are one spring, so that a longer rope is a thicker one and does not swing more slowly.
    static void makeSpan(sulfur::shapes::RopeOptions& options) {
        constexpr double link = 0.375;  // metres
        constexpr int mostLinks = 24;
        constexpr double endToEnd = 940;   // N/m
        constexpr double dampedFor = 0.2;  // s, damping over stiffness
        const auto span = static_cast<double>(options.to.norm());
        options.links = std::clamp(static_cast<int>(std::lround(span / link)), 2, mostLinks);
        options.slack = sulfur::Real(0.02);
        options.stiffness = real(endToEnd * options.links);
        options.damping = real(dampedFor * static_cast<double>(options.stiffness));
        options.bending = Real(0.35);
        options.bendingDamping = 30;
        options.material.staticFriction = Real(1.5);
        options.material.kineticFriction = Real(1.3);
    }
};

// Lines: chains, bridges and ground.
class LineTool final : public DragTool {
public:
    LineTool(Workbench& bench, ToolKind kind) : DragTool(bench), kind_(kind) {}
    Preview preview() const override {
        if (!dragging()) return {};
        Preview shown{Preview::Kind::line, from(), to(), length()};
        std::optional<double> mass;
        if (kind_ == ToolKind::chain) mass = length() * chainMassPerMetre;
        if (kind_ == ToolKind::bridge) mass = length() * bridgeMassPerMetre;
        shown.labels = lineLabels(from(), to(), mass);
        return shown;
    }
    std::string hint() const override {
        if (dragging() && !clicked())
            return metresText(length()) + ", " + degreesText(directionOf(to() - from()));
        if (kind_ == ToolKind::chain) return "Drag a chain of rigid links; its start is pinned";
        if (kind_ == ToolKind::bridge) return "Drag a bridge of planks between two pins";
        return "Drag a line of fixed ground";
    }

private:
    bool isLine() const override { return true; }
    void make(const Pointer& pointer) override {
        if (clicked()) return;
        const Vec2 span = (to() - from()).cast<Real>();
        if (kind_ == ToolKind::chain) {
            sulfur::shapes::ChainOptions options;
            options.from = {0, 0};
            options.to = span;
            options.mass = real(length() * chainMassPerMetre);
            options.pinFirst = true;
            options.pinLast = pointer.shift;
            add("Add chain", "chain", options, from());
        } else if (kind_ == ToolKind::bridge) {
            sulfur::shapes::BridgeOptions options;
            options.from = {0, 0};
            options.to = span;
            options.planks = std::clamp(static_cast<int>(std::lround(length() / 0.4)), 2, 200);
            options.sag = real(0.06 * length());
            options.mass = real(length() * bridgeMassPerMetre);
            add("Add bridge", "bridge", options, from());
        } else {
            sulfur::shapes::GroundOptions options;
            options.points = {Vec2(0, 0), span};
            add("Add ground", "ground", options, from());
        }
    }

    ToolKind kind_;
};

// Rectangles of many cells: cloth and walls.
class GridTool final : public FrameTool {
public:
    GridTool(Workbench& bench, bool cloth) : FrameTool(bench), cloth_(cloth) {}
    std::string hint() const override {
        return sizeOr(cloth_ ? "Click to hang a cloth by its corners, or drag its size"
                             : "Click to build a wall that crumbles, or drag its size");
    }

private:
    std::optional<double> massOfArea() const override {
        return cloth_ ? clothMassPerArea : wallMassPerArea;
    }
    void make(const Pointer&) override {
        Point drawn = !clicked() ? size() : cloth_ ? Point(1.5, 1.5) : Point(2, 1.5);
        drawn = drawn.cwiseMax(4 * smallest).cwiseMin(20.0);
        const auto cells = [&](double side, double cell, int least, int most) {
            return std::clamp(static_cast<int>(std::lround(side / cell)), least, most);
        };
        const double area = drawn.x() * drawn.y();
        if (cloth_) {
            sulfur::shapes::ClothOptions options;
            options.size = drawn.cast<Real>();
            options.columns = cells(drawn.x(), 0.13, 4, 24);
            options.rows = cells(drawn.y(), 0.13, 4, 24);
            options.mass = real(area * clothMassPerArea);
            add("Add cloth", "cloth", options, centre());
        } else {
            sulfur::shapes::WallOptions options;
            options.size = drawn.cast<Real>();
            options.columns = cells(drawn.x(), 0.4, 1, 20);
            options.rows = cells(drawn.y(), 0.4, 1, 20);
            options.mass = real(area * wallMassPerArea);
            // It stands, and bears being put down from a hand's breadth.
            options.strength = real(std::max(1500.0, wallStrength * area * wallMassPerArea));
            add("Add wall", "wall", options, centre());
        }
    }

    bool cloth_;
};

class WheelTool final : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        return dragging() && !clicked() ? circleOf(from(), to()) : Preview{};
    }
    std::string hint() const override {
        if (dragging() && !clicked())
            return tr("Radius {}, {}", {metresText(length()), kilogramsText(discMass(length()))});
        return "Click to put a wheel, or drag hub to rim; on a body the hub is an axle";
    }

private:
    void make(const Pointer& pointer) override {
        sulfur::shapes::WheelOptions options;
        const double radius = clicked() ? 0.4 : std::clamp(length(), 0.08, 50.0);
        options.radius = real(radius);
        options.rimRadius = real(std::min(0.03, radius / 4));
        options.segments = std::clamp(static_cast<int>(std::lround(radius * 40)), 12, 48);
        options.mass = real(discMass(radius));
        // The body under the hub bears it.
        const BodyId under = bodyAt(world(), from(), pointer.reach);
        document().edit("Add wheel", [&] {
            const BodyId wheel = document().add("wheel", options, {.position = from()});
            if (!under || world().kind(under) != sulfur::BodyKind::dynamic) return;
            document().attach(world().particles(wheel).back(), under);
            document().letPass(wheel, under);
        });
    }
};

}  // namespace

std::unique_ptr<Tool> makeCreateTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::ball:
            return std::make_unique<BallTool>(bench);
        case ToolKind::jelly:
            return std::make_unique<RectangleTool>(bench, true);
        case ToolKind::wheel:
            return std::make_unique<WheelTool>(bench);
        case ToolKind::rope:
            return std::make_unique<RopeTool>(bench);
        case ToolKind::cloth:
        case ToolKind::wall:
            return std::make_unique<GridTool>(bench, kind == ToolKind::cloth);
        case ToolKind::chain:
        case ToolKind::bridge:
        case ToolKind::ground:
            return std::make_unique<LineTool>(bench, kind);
        default:
            return std::make_unique<RectangleTool>(bench, false);
    }
}

}  // namespace sulfurchamber
