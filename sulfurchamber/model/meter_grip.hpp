// Moving meters with the mouse.
#pragma once

#include <optional>

#include "workbench.hpp"

namespace sulfurchamber {

/// A meter, or one end of it, that is dragged. Each drag is one step of the history.
class MeterGrip {
public:
    /// Takes what is under the pointer and selects it; nothing where there is no meter.
    static std::optional<MeterGrip> take(Workbench& bench, const Pointer& pointer);
    void moveTo(Workbench& bench, const Pointer& pointer);
    void release(Workbench& bench);
    void cancel(Workbench& bench);

private:
    MeterGrip(Meter meter, std::optional<std::size_t> end, const sulfur::Point& from)
        : meter_(std::move(meter)), end_(end), from_(from) {}

    Meter meter_;  ///< as it was when it was taken, with places of the world
    std::optional<std::size_t> end_;
    sulfur::Point from_{0, 0};
    bool moved_ = false;
};

}  // namespace sulfurchamber
