// A ruler between two points, which tells the angle too.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "geometry.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

class MeasureTool final : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        from_ = to_ = placeOf(pointer);
        dragging_ = shown_ = true;
    }
    void move(const Pointer& pointer) override {
        if (dragging_) to_ = placeOf(pointer);
    }
    void release(const Pointer& pointer) override {
        move(pointer);
        dragging_ = false;
        if (length() == 0) shown_ = false;
    }
    void cancel() override { dragging_ = shown_ = false; }

    Preview preview() const override {
        if (!shown_) return {};
        return {Preview::Kind::ruler, from_, to_, length()};
    }

    std::string hint() const override {
        if (!shown_) return "Drag to measure a length and an angle; ends go to particles";
        const Point by = to_ - from_;
        std::array<char, 128> text{};
        std::snprintf(
            text.data(), text.size(),
            "%.3f m at %.1f degrees: %.3f m to the right, %.3f m up; Escape takes it away",
            length(), std::atan2(by.y(), by.x()) * 180 / std::numbers::pi, by.x(), by.y());
        return text.data();
    }

private:
    double length() const { return (to_ - from_).norm(); }

    Point placeOf(const Pointer& pointer) const {
        const auto pick = particleAt(world(), pointer.position, pointer.reach);
        return pick ? world().position(pick->particle) : bench().snapped(pointer.position);
    }

    bool dragging_ = false;
    bool shown_ = false;  // it stays after the drag
    Point from_{0, 0};
    Point to_{0, 0};
};

}  // namespace

std::unique_ptr<Tool> makeMeasureTool(Workbench& bench) {
    return std::make_unique<MeasureTool>(bench);
}

}  // namespace sulfurchamber
