// Tools that put meters into the scene.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tool.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

// "1.204 m at 30.0 degrees", for hints while one draws.
std::string wayText(const Point& way) {
    return tr(
        "{} m at {} degrees: {} m to the right, {} m up",
        {fixed(way.norm(), 3), fixed(std::atan2(way.y(), way.x()) * 180 / std::numbers::pi, 1),
         fixed(way.x(), 3), fixed(way.y(), 3)});
}

class MeterTool : public Tool {
public:
    MeterTool(Workbench& bench, MeterKind kind) : Tool(bench), kind_(kind) {}

protected:
    // Ends go to particles and bodies, else to the grid.
    MeterEnd endOf(const Pointer& pointer) const {
        MeterEnd end = endAt(document(), pointer.position, pointer.reach);
        if (end.body.empty() && end.at == pointer.position) end.at = bench().snapped(end.at);
        return end;
    }
    Point placeOf(const MeterEnd& end) const {
        const sulfur::BodyId body = document().bodyOf(end.body);
        if (!body) return end.at;
        if (end.particle) return world().position(world().particles(body)[*end.particle]);
        return world().toWorld(body, end.at);
    }
    void add(std::vector<MeterEnd> ends) {
        std::string id;
        document().edit(tr("Add {}", {tr(std::string(meterName(kind_)))}), [&] {
            id = addMeter(document().planForEditing(), {"", kind_, std::move(ends)});
        });
        bench().selectMeters({id});
    }
    MeterKind kind() const { return kind_; }

private:
    MeterKind kind_;
};

// Press, drag, release; a protractor has one more leg, which is clicked.
class LineMeterTool final : public MeterTool {
public:
    using MeterTool::MeterTool;

    void press(const Pointer& pointer) override {
        to_ = pointer.position;
        if (legs_) return;
        from_ = kind() == MeterKind::gun ? MeterEnd{bench().snapped(pointer.position), {}, {}}
                                         : endOf(pointer);
        dragging_ = true;
    }
    void move(const Pointer& pointer) override {
        if (dragging_ || legs_) to_ = placeOf(lastEnd(pointer));
    }
    void release(const Pointer& pointer) override {
        move(pointer);
        if (legs_) {
            // The release of the drag that made the first leg is none.
            if ((to_ - placeOf(*legs_)).norm() < pointer.reach) return;
            const MeterEnd first = *legs_;
            legs_.reset();
            add({from_, first, lastEnd(pointer)});
            return;
        }
        if (!dragging_) return;
        dragging_ = false;
        if ((to_ - placeOf(from_)).norm() < pointer.reach) return;
        if (kind() == MeterKind::protractor)
            legs_ = lastEnd(pointer);
        else
            add({from_, lastEnd(pointer)});
    }
    void cancel() override {
        dragging_ = false;
        legs_.reset();
    }
    Preview preview() const override {
        if (!dragging_ && !legs_) return {};
        const Point from = placeOf(from_);
        return {Preview::Kind::ruler, from, to_, (to_ - from).norm()};
    }
    std::string hint() const override {
        if (legs_) return "Click where the second leg of the angle goes; Escape drops it";
        if (dragging_) return wayText(to_ - placeOf(from_));
        switch (kind()) {
            case MeterKind::protractor:
                return "Drag from the corner of an angle along its first leg, then click the "
                       "second";
            case MeterKind::gun:
                return "Drag a beam: the speed of what passes it is told";
            default:
                return "Drag to place a ruler; ends hold on to particles and bodies";
        }
    }

private:
    // The beam of a gun stands in the world.
    MeterEnd lastEnd(const Pointer& pointer) const {
        if (kind() == MeterKind::gun) return {bench().snapped(pointer.position), {}, {}};
        return endOf(pointer);
    }

    MeterEnd from_;
    Point to_{0, 0};
    bool dragging_ = false;
    std::optional<MeterEnd> legs_;  // the first leg of a protractor
};

// A click on what is measured.
class PointMeterTool final : public MeterTool {
public:
    using MeterTool::MeterTool;

    void press(const Pointer&) override { pressed_ = true; }
    void cancel() override { pressed_ = false; }
    void release(const Pointer& pointer) override {
        if (!pressed_) return;
        pressed_ = false;
        auto ends = kind() == MeterKind::gauge
                        ? gaugeAt(document(), pointer.position, pointer.reach)
                        : std::vector<MeterEnd>{endOf(pointer)};
        const bool holds = !ends.empty() && !ends.front().body.empty();
        if (!holds) {
            missed_ = true;
            return;
        }
        missed_ = false;
        add(std::move(ends));
    }
    std::string hint() const override {
        if (kind() == MeterKind::gauge)
            return missed_ ? "There is neither a joint nor a body of the scene"
                           : "Click a joint or mechanism for its force, a body for that of its "
                             "contacts";
        return missed_ ? "There is no body of the scene"
                       : "Click a point of a body: it leaves a trail";
    }

private:
    bool pressed_ = false;
    bool missed_ = false;
};

}  // namespace

std::unique_ptr<Tool> makeMeterTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::protractor:
            return std::make_unique<LineMeterTool>(bench, MeterKind::protractor);
        case ToolKind::tracer:
            return std::make_unique<PointMeterTool>(bench, MeterKind::tracer);
        case ToolKind::gauge:
            return std::make_unique<PointMeterTool>(bench, MeterKind::gauge);
        case ToolKind::gun:
            return std::make_unique<LineMeterTool>(bench, MeterKind::gun);
        default:
            return std::make_unique<LineMeterTool>(bench, MeterKind::ruler);
    }
}

}  // namespace sulfurchamber
