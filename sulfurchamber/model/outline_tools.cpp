// Tools that draw outlines: polygons corner by corner, soft bodies freehand.
#include <algorithm>
#include <cmath>

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

class PolygonTool final : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        const Point at = bench().snapped(pointer.position);
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
    void move(const Pointer& pointer) override { to_ = bench().snapped(pointer.position); }
    void cancel() override { corners_.clear(); }

    void finish() override {
        if (corners_.size() < 3) return;
        Outline outline = std::exchange(corners_, {});
        if (meetsItself(outline))
            throw std::runtime_error("this polygon crosses itself; go round it once");
        const double area = areaWithin(outline);
        if (area < leastArea) return;
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
        return shown;
    }
    std::string hint() const override {
        return corners_.size() < 3
                   ? "Click the corners of a polygon, one after the other"
                   : "Click the next corner, or the first one (or Enter) to close; Escape drops it";
    }

private:
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
        return {Preview::Kind::outline, line_.front(), line_.back(), 0, line_};
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
