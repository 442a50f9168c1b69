/// \file
/// Grabbing things, as with a mouse: a soft spring from a body to a target that the caller moves.
#pragma once

#include <optional>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>

namespace sulfur {

/// How firmly World::grab holds. The spring's constants follow from the mass of the grabbed body,
/// so that light and heavy things feel alike; it is solved implicitly and is stable with any value.
struct GrabOptions {
    Real frequency = 5;     ///< Hz, above 0 up to 1000: of the body swinging on the spring
    Real dampingRatio = 1;  ///< 0 to 100; 1 is critical: it comes to rest without swinging
    /// Newtons, > 0, at most what it pulls with; a hundred times the body's weight on Earth where
    /// none is given. `infinite` is allowed.
    std::optional<Real> maxForce = std::nullopt;
};

/// What a grab is at the moment.
struct GrabInfo {
    BodyId body = {};    ///< the grabbed body
    Point point{0, 0};   ///< metres: where it is held now
    Point target{0, 0};  ///< metres: where it is pulled to
    Vec2 force{0, 0};    ///< newtons on the body in the last tick
};

}  // namespace sulfur
