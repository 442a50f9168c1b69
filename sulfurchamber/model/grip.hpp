// Holding a body with the mouse while the simulation runs.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <sulfur/world.hpp>
#include <vector>

#include "timeline.hpp"

namespace sulfurchamber {

/// A spring with damping between the pointer and a place on a body: a particle, or a point between
/// the two ends of a joint. Its strength follows the mass of the body, so that a feather
/// and a crate are led alike, and it is limited to what one tick can integrate.
class Grip {
public:
    /// Takes hold of what is at `point`, or within `reach` metres of it; nothing where there is
    /// nothing that moves.
    /// `counts` says which bodies do; nothing: all.
    static std::optional<Grip> take(const sulfur::World& world, const sulfur::Point& point,
                                    double reach,
                                    const std::function<bool(sulfur::BodyId)>& counts = {});

    void moveTo(const sulfur::Point& target) { target_ = target; }
    /// The forces of the next tick.
    std::vector<Push> pushes(const sulfur::World& world) const;
    /// False once what was held is gone.
    bool holds(const sulfur::World& world) const;
    /// Where the spring is tied to the body, and where it pulls to; for drawing.
    sulfur::Point anchor(const sulfur::World& world) const;
    const sulfur::Point& target() const { return target_; }

private:
    struct End {
        sulfur::ParticleId particle;
        double weight = 0;
    };
    std::array<End, 2> ends_;
    std::size_t count_ = 0;
    sulfur::Point offset_{0, 0};  // from the held place to the pointer when it was taken
    sulfur::Point target_{0, 0};
};

}  // namespace sulfurchamber
