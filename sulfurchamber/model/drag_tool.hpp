// Tools that are dragged from one place to another, and what they say meanwhile.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tool.hpp"

namespace sulfurchamber {

// "1.20 m", for hints while one draws.
inline std::string metres(double length) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f m", length);
    return text.data();
}

inline std::string kilograms(double mass) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), mass < 10 ? "%.2f kg" : "%.0f kg", mass);
    return text.data();
}

inline std::string degreesOf(const sulfur::Point& way) {
    const double angle = std::atan2(way.y(), way.x()) * 180 / 3.14159265;
    return std::to_string(std::lround(angle)) + " degrees";
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
    static constexpr double smallest = 0.08;  ///< metres; a shorter drag is a click

    virtual void make(const Pointer& pointer) = 0;

    bool dragging() const { return dragging_; }
    const sulfur::Point& from() const { return from_; }
    const sulfur::Point& to() const { return to_; }
    double length() const { return (to_ - from_).norm(); }
    bool clicked() const { return length() < smallest; }
    void add(const std::string& name, const sulfur::scene::Generator& recipe,
             const sulfur::Point& position) {
        document().edit("Add " + name,
                        [&] { document().add(name, recipe, {.position = position}); });
    }

private:
    bool dragging_ = false;
    sulfur::Point from_{0, 0};
    sulfur::Point to_{0, 0};
};

// A drag from corner to corner.
class FrameTool : public DragTool {
public:
    using DragTool::DragTool;
    Preview preview() const override {
        if (!dragging() || clicked()) return {};
        return {Preview::Kind::rectangle, from(), to(), 0};
    }

protected:
    sulfur::Point size() const { return (to() - from()).cwiseAbs(); }
    sulfur::Point centre() const { return clicked() ? to() : sulfur::Point((from() + to()) / 2); }
    /// While it is drawn; else what a click does.
    std::string sizeOr(const char* click, double kilogramsPerArea) const {
        if (!dragging() || clicked()) return click;
        return metres(size().x()) + " wide, " + metres(size().y()) + " high, " +
               kilograms(size().x() * size().y() * kilogramsPerArea);
    }
};

}  // namespace sulfurchamber
