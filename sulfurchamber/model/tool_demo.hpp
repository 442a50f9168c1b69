// What a tool does, shown in three seconds by a hand in a scene of its own.
#pragma once

#include "hand.hpp"

namespace sulfurchamber {

/// A film of a tool: nothing of it is stored, a hand works in a scratch scene with the tool itself.
/// What there is lies within toolDemoFrame().
class ToolDemo {
public:
    static constexpr double seconds = 3;  ///< after which it begins again

    explicit ToolDemo(ToolKind tool);

    ToolKind tool() const { return tool_; }
    const Workbench& bench() const { return *bench_; }
    const Hand& hand() const { return *hand_; }
    double time() const { return time_; }
    /// Goes on by so many seconds, at most half of the film.
    void advance(double seconds);

private:
    void restart();

    ToolKind tool_;
    std::unique_ptr<Workbench> bench_;
    std::unique_ptr<Hand> hand_;
    double time_ = 0;
    double ticksDue_ = 0;
};

/// The part of the scratch scene that a film shows, metres.
Bounds toolDemoFrame();

}  // namespace sulfurchamber
