// What the scenes with contacts are built from and watched with.
#pragma once

#include <string>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "battery/contacts/overlap.hpp"
#include "battery/row.hpp"

namespace sulfur::lab {

/// A square crate.
struct CrateOptions {
    double size = 1;       ///< m
    double mass = 1;       ///< kg
    double radius = 0.02;  ///< m
    Material material = {};
};
Blueprint crate(const CrateOptions& options = {});

/// A square jelly of 4 x 4 particles that hardly gives way.
Blueprint firmJelly(double size, double mass, double stiffness = 1e5, double damping = 20);

/// A fixed floor with its surface at y = 0, `reach` metres to both sides.
Body addFloor(World& world, double reach, const Material& material = {});

/// Particles that are watched for the speed at which they really move: the way that each makes in
/// a tick, corrections of its place included, over the tick.
class SpeedMeter {
public:
    /// Begins with the places of now. `bodies` must outlive this.
    SpeedMeter(const World& world, const std::vector<Body>& bodies);
    /// Call after every tick. Returns the largest speed, m/s; NaN when a place is not finite.
    double add();

private:
    const World& world_;
    const std::vector<Body>& bodies_;
    std::vector<Point> before_;
};

/// The centres of mass of bodies, and how far they went.
class Places {
public:
    Places(const World& world, const std::vector<Body>& bodies);
    double sideways() const;  ///< m, the largest way along x that any went either way
    double sunk() const;      ///< m, the largest way down
    double farthest() const;  ///< m, the largest way
    /// Bodies that went more than `reach` m.
    int moved(double reach) const;

private:
    Point way(std::size_t i) const;

    const World& world_;
    const std::vector<Body>& bodies_;
    std::vector<Point> start_;
};

/// Puts the picture of a scene into the album, if there is one.
void keepPicture(const Setup& setup, const std::string& name, const World& world);

}  // namespace sulfur::lab
