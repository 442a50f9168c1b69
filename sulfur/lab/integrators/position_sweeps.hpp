// Extended position-based dynamics (XPBD) with compliance 0: Gauss-Seidel sweeps over places.
#pragma once

#include <vector>

#include "integrators/system.hpp"

namespace sulfur::lab {

/// A rigid body, or a particle, which does not turn.
struct SweptBody {
    Vec place = Vec::Zero();     ///< m, of the centre of mass
    Vec velocity = Vec::Zero();  ///< m/s
    Vec turn = Vec(1, 0);        ///< where its x axis points, of length 1
    double spin = 0;             ///< rad/s
    double inverseMass = 0;      ///< 1/kg; 0: it stays where it is
    double inverseInertia = 0;   ///< 1/(kg m^2); 0: it does not turn

    /// Where a point of it is, m.
    Vec at(const Vec& local) const {
        return place + Vec(turn.x() * local.x() - turn.y() * local.y(),
                           turn.y() * local.x() + turn.x() * local.y());
    }
};

/// Holds a point of a body at a distance from a point of another one; at 0 it is a pin.
struct SweptLink {
    std::size_t a = 0, b = 0;
    Vec onA = Vec::Zero(), onB = Vec::Zero();  ///< m, in the bodies' own frames
    double length = 0;                         ///< m
};

/// A step predicts places, moves them so that one link after the other holds, `sweeps` times over
/// all links and back again, and takes velocities from how far everything has come (M. Macklin et
/// al., "XPBD", 2016; M. Mueller et al., "Detailed rigid body simulation with extended position
/// based dynamics", 2020). One sweep in n times as many steps is what the latter call n substeps.
/// Without the way back, what sweeps leave of an error turns as it shrinks (their matrix has
/// complex eigenvalues where there are loops), and a grid of pinned bodies gains energy until it
/// explodes.
class PositionSweeps {
public:
    PositionSweeps(std::vector<SweptBody> bodies, std::vector<SweptLink> links, double gravity,
                   int sweeps);

    /// Advances by `h` seconds.
    void step(double h);
    const std::vector<SweptBody>& bodies() const { return bodies_; }

private:
    void hold(const SweptLink& link);

    std::vector<SweptBody> bodies_, before_;
    std::vector<SweptLink> links_;
    double gravity_;  ///< m/s^2, downwards
    int sweeps_;
};

}  // namespace sulfur::lab
