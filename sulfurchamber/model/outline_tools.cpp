// Tools that draw outlines: polygons corner by corner, soft bodies freehand.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lattice.hpp"
#include "plate.hpp"
#include "region.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;

constexpr double leastArea = 0.002;  // m^2; what is smaller was no outline

// About its own middle, which becomes the origin of its frame.
Point centred(Outline& outline) {
    Point middle(0, 0);
    for (const Point& point : outline) middle += point;
    middle /= static_cast<double>(outline.size());
    for (Point& point : outline) point -= middle;
    return middle;
}

// What an outline will weigh, in its middle.
Label massLabel(Outline outline) {
    const double mass = areaWithin(outline) * outlineMassPerArea;
    return {centred(outline), kilogramsText(mass)};
}

class PolygonTool final : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        const Point at = placeOf(pointer);
        if (corners_.size() > 2 && (at - corners_.front()).norm() <= pointer.reach) {
            finish();
            return;
        }
        // A double click is a click on the last corner.
        if (!corners_.empty() && (at - corners_.back()).norm() <= pointer.reach / 2) {
            finish();
            return;
        }
        corners_.push_back(at);
        to_ = at;
    }
    void move(const Pointer& pointer) override { to_ = placeOf(pointer); }
    void cancel() override { corners_.clear(); }

    void finish() override {
        if (corners_.size() < 3) return;
        Outline outline = std::exchange(corners_, {});
        if (meetsItself(outline))
            throw std::runtime_error("this polygon crosses itself; go round it once");
        const double area = areaWithin(outline);
        if (area < leastArea || cutHole(outline)) return;
        const Point middle = centred(outline);
        sulfur::shapes::PolygonOptions options;
        for (const Point& point : outline) options.points.push_back(point.cast<Real>());
        options.mass = static_cast<Real>(area * outlineMassPerArea);
        options.radius = static_cast<Real>(std::min(0.02, std::sqrt(area) / 20));
        document().edit("Add polygon",
                        [&] { document().add("polygon", options, {.position = middle}); });
    }

    Preview preview() const override {
        if (corners_.empty()) return {};
        Preview shown{Preview::Kind::outline, corners_.front(), to_, 0, corners_};
        shown.points.push_back(to_);
        if (to_ != corners_.back()) shown.labels = lineLabels(corners_.back(), to_);
        if (corners_.size() > 1) shown.labels.push_back(massLabel(shown.points));
        return shown;
    }
    std::string hint() const override {
        return corners_.size() < 3
                   ? "Click corner by corner; inside of a selected body it is a hole"
                   : "Click the next corner, or the first one (or Enter) to close; Escape drops it";
    }

private:
    // What is drawn inside of the one selected body becomes its hole.
    bool cutHole(Outline outline) {
        const auto& chosen = bench().selection();
        if (chosen.size() != 1 || document().idOf(chosen[0]).empty()) return false;
        const auto& prefab = document().plan().dressed(document().idOf(chosen[0]));
        auto plate = plateOf(prefab);
        if (!plate) return false;
        const sulfur::Pose pose = world().pose(chosen[0]);
        const Eigen::Rotation2Dd back(-pose.angle);
        for (Point& point : outline) point = back * (point - pose.position);
        const double room = 2.5 * static_cast<double>(prefab.blueprint.joints[0].radius);
        if (!fits(*plate, outline, room)) return false;
        plate->holes.push_back(outline);
        document().edit("Cut a hole", [&] {
            document().change(chosen, [&](sulfur::scene::Prefab& own) { setPlate(own, *plate); });
        });
        return true;
    }

    Point placeOf(const Pointer& pointer) {
        return bench().snapped(pointer,
                               corners_.empty() ? std::nullopt : std::optional(corners_.back()));
    }

    Outline corners_;
    Point to_{0, 0};
};

class DrawTool final : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        line_ = {pointer.position};
        drawing_ = true;
    }
    void move(const Pointer& pointer) override {
        if (drawing_ && (pointer.position - line_.back()).norm() > pointer.reach / 4)
            line_.push_back(pointer.position);
    }
    void cancel() override { drawing_ = false; }

    void release(const Pointer& pointer) override {
        if (!drawing_) return;
        move(pointer);
        drawing_ = false;
        Outline outline = simplified(line_, pointer.reach / 6, true);
        if (outline.size() < 3) return;
        if (meetsItself(outline))
            throw std::runtime_error("this outline crosses itself; draw it round once");
        if (areaWithin(outline) < leastArea) return;
        const double area = areaWithin(outline);
        const double mass = area * outlineMassPerArea;
        // Some hundred particles at most, some dozen at least.
        const double spacing = std::clamp(std::sqrt(area / 40), 0.02, 2.0);
        const Point middle = centred(outline);
        sulfur::scene::Prefab prefab;
        prefab.blueprint = lattice(outline, spacing, mass, 700 * mass, 1.5 * mass);
        prefab.blueprint.name = "drawing";
        sulfur::scene::Placement placement;
        placement.pose.position = middle;
        document().edit("Draw", [&] { document().add(prefab, placement); });
    }

    Preview preview() const override {
        if (!drawing_) return {};
        Preview shown{Preview::Kind::outline, line_.front(), line_.back(), 0, line_};
        if (line_.size() > 2) shown.labels = {massLabel(line_)};
        return shown;
    }
    std::string hint() const override {
        return drawing_ ? "Go round once; let go where you began"
                        : "Draw an outline: it is filled with a soft body";
    }

private:
    Outline line_;
    bool drawing_ = false;
};

}  // namespace

std::unique_ptr<Tool> makeOutlineTool(Workbench& bench, ToolKind kind) {
    if (kind == ToolKind::draw) return std::make_unique<DrawTool>(bench);
    return std::make_unique<PolygonTool>(bench);
}

}  // namespace sulfurchamber
