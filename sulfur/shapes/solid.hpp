// The solid that a shape stands for, and how its mass is shared among particles.
//
// Particles at the outline alone would have up to three times the moment of inertia of the solid.
// A share of the mass is therefore given to one more particle inside, the core; how large it is
// and where the core is follow from mass, centre and inertia, which then are the solid's exactly.
#pragma once

#include <optional>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::detail {

/// A uniform solid. What it is made of reaches to the outer side of the collision capsules; corners
/// are sharp, although the capsules round them by their radius, unless it is rounded.
struct Solid {
    double mass = 0;     // kg
    Point centre{0, 0};  // m, of mass
    double inertia = 0;  // kg m^2, about the centre
    /// Radius of gyration squared, m^2.
    double gyration2() const { return inertia / mass; }
};

Solid solidRectangle(Vec2 size, Real mass);
Solid solidDisc(Real radius, Real mass);
/// `corners` in either sense of rotation; their area is not 0.
Solid solidPolygon(const std::vector<Point>& corners, Real mass);

/// The same with corners that are bent outwards rounded by `radius`. `inner`: the centres of their
/// arcs, corner by corner.
Solid solidRounded(const std::vector<Point>& corners, const std::vector<Point>& inner,
                   double radius, Real mass);

struct Shares {
    std::vector<Real> outline;  // kg
    Real core = 0;              // kg
    Vec2 corePlace{0, 0};       // m
};

/// The outline's particles keep the ratios of `weights` (all > 0, their sum 1), the core has the
/// rest. Nothing when the outline is too near to the centre to have the inertia of the solid, or
/// so nearly that the core would be left with less than a fiftieth of the mass.
std::optional<Shares> shareWithCore(const Solid& solid, const std::vector<Point>& outline,
                                    const std::vector<double>& weights);

/// The outermost points of round corners.
std::vector<Point> lobesOf(const std::vector<Point>& corners, const std::vector<Point>& inner,
                           double radius);
/// The same as shareWithCore() where thick capsules keep the outline too near to the centre:
/// `lobes` carry nine tenths of what is outside. The outline's shares are those of `inner`, then of
/// them.
std::optional<Shares> shareWithLobes(const Solid& solid, const std::vector<Point>& inner,
                                     const std::vector<Point>& lobes,
                                     const std::vector<double>& weights);

}  // namespace sulfur::detail
