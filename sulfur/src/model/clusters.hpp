// Rigid components: particles that their rigid joints leave only three freedoms, moved as one.
#pragma once

#include <cstdint>
#include <memory>
#include <sulfur/math.hpp>
#include <vector>

#include "core/slots.hpp"
#include "core/trigonometry.hpp"

namespace sulfur::detail {

class Truss;

/// A rigid component. It turns about its centre of mass, or about its one pinned particle; with
/// two pinned particles it stays where it is. A disc is one of a single particle.
///
/// The spin is a number of its own, never recovered from positions: without torque it does not
/// change by a single bit.
///
/// What every step reads and writes comes first, in two cache lines.
struct alignas(64) Cluster {
    Point centre{0, 0};                        // m, what it turns about, at the start of the tick
    Point heading{1, 0};                       // (cos, sin) of its orientation
    Vec2 displacement{0, 0}, predicted{0, 0};  // m, of the centre, in this tick
    double angle = 0, predictedAngle = 0;      // rad, in this tick

    Point velocity{0, 0};                      // m/s of the centre
    double spin = 0;                           // rad/s
    Vec2 shift{0, 0};                          // m, correction that becomes no velocity
    double twist = 0;                          // rad, the same
    Real inverseMass = 0, inverseInertia = 0;  // 0 while asleep
    std::uint32_t first = 0, last = 0;         // its part of Clusters::members
    std::uint32_t body = none;                 // dense index
    std::uint8_t stirred = 1;                  // somebody changed the velocities of its particles
    std::uint8_t watched = 0;                  // has joints that may break

    Point massCentre{0, 0};         // m, from the centre, in its own frame
    double mass = 0;                // kg
    double reach = 0;               // m, from the centre to its farthest member
    double freeInverseMass = 0;     // 1/kg while awake; 0 with a pinned particle
    double freeInverseInertia = 0;  // 1/(kg m^2) while awake; 0 with two of them, and in a
                                    // body that does not turn
    // When the last step began; of discs, between ticks, when the last tick did. Only that of discs
    // is archived, with the bodies.
    Point centreBefore{0, 0}, headingBefore{1, 0};
    Real sine = 0, versine = 0;          // of angle; 1 - cos, which keeps small angles
    std::shared_ptr<const Truss> truss;  // of a watched one, once it was needed; never archived

    template <class Archive>
    void archive(Archive& a) {
        a(body);
        a(first);
        a(last);
        a(centre);
        a(heading);
        a(massCentre);
        a(spin);
        a(mass);
        a(reach);
        a(freeInverseMass);
        a(freeInverseInertia);
        a(inverseMass);
        a(inverseInertia);
        a(velocity);
        a(displacement);
        a(predicted);
        a(angle);
        a(predictedAngle);
        a(sine);
        a(versine);
        a(shift);
        a(twist);
        a(stirred);
        a(watched);
    }
};

/// A particle with a radius that is a component by itself.
inline bool isDisc(const Cluster& c) {
    return c.last - c.first == 1;
}

/// Unless its pins or its body forbid it.
inline bool canTurn(const Cluster& c) {
    return c.freeInverseInertia > 0;
}

/// Of a solid disc about its centre, kg m^2.
inline double discInertia(double mass, double radius) {
    return mass * radius * radius / 2;
}

/// A particle that two clusters share belongs to one of them and is the hinge of the other.
struct Hinge {
    std::uint32_t cluster = none;  // the other one
    std::uint32_t particle = none;
    Point place{0, 0};  // m, of the particle in the frame of `cluster`
    Vec2 force{0, 0};   // N on `cluster` in the last tick

    template <class Archive>
    void archive(Archive& a) {
        a(cluster);
        a(particle);
        a(place);
        a(force);
    }
};

struct Clusters {
    std::vector<Cluster> list;           // in the order of their bodies
    std::vector<std::uint32_t> members;  // particles, cluster by cluster
    std::vector<Point> places;           // m, of the members in the frame of their cluster
    std::vector<Hinge> hinges;

    template <class Archive>
    void archive(Archive& a) {
        a(list);
        a(members);
        a(places);
        a(hinges);
    }
};

/// Where a constraint takes hold: a particle that moves by itself, or a point of a cluster.
struct Grip {
    std::uint32_t particle = none;  // meaningful without a cluster
    std::uint32_t cluster = none;
    Vec2 arm{0, 0};  // m, from the cluster's centre, at the start of the tick
};

template <class Scalar>
Eigen::Matrix<Scalar, 2, 1, Eigen::DontAlign> perpendicular(
    const Eigen::Matrix<Scalar, 2, 1, Eigen::DontAlign>& v) {
    return {-v[1], v[0]};
}

}  // namespace sulfur::detail
