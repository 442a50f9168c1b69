// The equations of a network in one step: what its links ask for, and what they push with.
#pragma once

#include <cstdint>
#include <vector>

#include "model/state.hpp"
#include "trees/networks.hpp"

namespace sulfur::detail {

/// How a step is made: links pull along averages of their directions, or along those at the end, or
/// nodes that have flown are projected, each time along the directions that links have by then.
enum class Way : std::uint8_t { keeps, brakes, projects };

/// Works on the nodes, motions and links in the scratch of trees, where the stepper finds them.
class NetworkEquations {
public:
    using Motion = StepScratch::Motion;
    using Link = NetworkScratch::Link;

    NetworkEquations(State& state, const Tree& tree);

    /// When the step begins: nodes and links as they are, with velocities that are not kicked yet.
    void load();
    /// Whether a link is wrong by more than a step closes.
    bool isTorn() const { return torn_; }
    void begin(Way way);

    /// Links and residuals at the present displacements; the largest error, relative to lengths.
    double evaluate();
    /// Whether links have turned too far since the matrix was made.
    bool hasTurned() const;
    /// How a link enters the matrix.
    NetworkRow rowOf(std::size_t l) const;
    /// Changes of displacements and multipliers by one pass.
    void advance(const std::vector<Freedoms>& nodes,
                 const std::vector<std::array<double, 2>>& multipliers);
    /// What passes have led to can be kept, and later be settled on; without a solution everything
    /// flies freely, which throws nobody.
    void keepBest();
    void takeBest(bool useful);
    /// Displacements are what the multipliers give, so that no momentum is lost to the tolerance.
    void settle();

private:
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }
    const NetworkLink& link(std::size_t l) const { return state_.trees.links[tree_.firstLink + l]; }

    Point armOf(std::size_t i, const LinkEnd& end) const;
    void loadLink(std::size_t l);
    void loadJoint(std::uint32_t j, Link& data) const;
    double mobilityOf(std::size_t i, const Point& arm) const;
    void lookBack(const NetworkLink& n, Link& data) const;
    void limitPull(std::size_t l);

    double shareOf(double pushed, double mobility) const;
    Point average(const Point& before, const Point& start, const Point& now, double share) const;
    Freedoms along(std::size_t i, const Point& direction, const Point& arm) const;
    void updateLink(std::size_t l);
    void updateJoint(const NetworkLink& n, Link& data);
    void updateMeeting(const NetworkLink& n, Link& data);
    void setArms(Link& data, const Point& push);
    double coupleOf(std::size_t l, const NetworkRow& row,
                    const std::array<double, 2>& lambda) const;
    void turnBack();

    State& state_;
    const Tree& tree_;
    NetworkScratch& scratch_;
    const std::vector<StepScratch::Node>& nodes_;
    std::vector<Motion>& motion_;
    std::vector<Link>& links_;
    double step_;        // s
    double mass_ = 0;    // kg, of all that moves
    bool free_ = true;   // no node is held fast
    bool torn_ = false;  // isTorn()
    double couple_ = 0;  // kg m^2, of the pulls of passes so far
    double bestCouple_ = 0;
    Way way_ = Way::keeps;
};

}  // namespace sulfur::detail
