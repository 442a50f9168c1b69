// Bodies and joints of a scene, with what tells how well each joint holds.
#pragma once

#include <vector>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

/// Where a joint holds each of its bodies, in their frames.
struct Anchors {
    std::size_t a = 0, b = 0;
    Point onA{0, 0}, onB{0, 0};  ///< m
    double angle = 0;            ///< rad, of b against a, when it was made
    Point axis{0, 0};            ///< of what slides: its line in the frame of a, 1 long

    /// m, how far apart both places are now.
    Point gap(const EngineWorld& world) const;
    /// m, how far they are apart as they must not be: for what slides, across its line.
    double opening(const EngineWorld& world) const;
    /// m, how far b has slid along the line.
    double slid(const EngineWorld& world) const;
    /// rad, of b against a now; within half a turn where an engine does not count turns.
    double value(const EngineWorld& world) const;
};

/// Bodies and joints in one world of an engine, with their plans.
class Workshop {
public:
    explicit Workshop(EngineWorld& world) : world_(world) {}

    std::size_t add(const BodyPlan& plan);
    /// Something fixed that touches nothing.
    std::size_t addNail(const Point& place);
    std::size_t join(const JointPlan& plan);

    std::size_t bodies() const { return plans_.size(); }
    std::size_t joints() const { return joints_.size(); }
    const BodyPlan& plan(std::size_t body) const { return plans_[body]; }
    const JointPlan& joint(std::size_t i) const { return joints_[i]; }
    const Anchors& anchors(std::size_t joint) const { return anchors_[joint]; }

private:
    EngineWorld& world_;
    std::vector<BodyPlan> plans_;
    std::vector<JointPlan> joints_;
    std::vector<Anchors> anchors_;
};

}  // namespace sulfur::lab::bench
