// Tools that are dragged from one place to another, and what they say meanwhile.
#pragma once

#include <optional>
#include <string>

#include "tool.hpp"
#include "words.hpp"

namespace sulfurchamber {

// Press, drag, release between two points.
class DragTool : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        from_ = to_ = bench().snapped(pointer);
        dragging_ = true;
    }
    void move(const Pointer& pointer) override {
        const sulfur::Point at = bench().snapped(
            pointer, dragging_ && isLine() ? std::optional<sulfur::Point>(from_) : std::nullopt);
        if (dragging_) to_ = at;
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
    /// Whether the direction matters, which then snaps to angles.
    virtual bool isLine() const { return false; }

    bool dragging() const { return dragging_; }
    const sulfur::Point& from() const { return from_; }
    const sulfur::Point& to() const { return to_; }
    double length() const { return (to_ - from_).norm(); }
    bool clicked() const { return length() < smallest; }
    void add(const char* label, const std::string& name, const sulfur::scene::Generator& recipe,
             const sulfur::Point& position) {
        document().edit(label, [&] { document().add(name, recipe, {.position = position}); });
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
        Preview shown{Preview::Kind::rectangle, from(), to(), 0};
        const sulfur::Point low = from().cwiseMin(to());
        const sulfur::Point high = from().cwiseMax(to());
        const std::optional<double> density = massOfArea();
        shown.labels = sizeLabels({low, {high.x(), low.y()}, high, {low.x(), high.y()}},
                                  density ? std::optional(size().prod() * *density) : density);
        return shown;
    }

protected:
    /// kg/m^2 of what will be made; nothing where it has no mass.
    virtual std::optional<double> massOfArea() const { return std::nullopt; }
    sulfur::Point size() const { return (to() - from()).cwiseAbs(); }
    sulfur::Point centre() const { return clicked() ? to() : sulfur::Point((from() + to()) / 2); }
    /// While it is drawn; else what a click does.
    std::string sizeOr(const char* click) const {
        if (!dragging() || clicked()) return click;
        const std::string wide = metresText(size().x());
        const std::string high = metresText(size().y());
        const auto density = massOfArea();
        return density ? tr("{} wide, {} high, {}",
                            {wide, high, kilogramsText(size().prod() * *density)})
                       : tr("{} wide, {} high", {wide, high});
    }
};

}  // namespace sulfurchamber
