// The angular joints of a world as a structure of arrays.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>
#include <vector>

#include "model/clusters.hpp"

namespace sulfur::detail {

/// How an angular joint is solved. Derived by classifyAngles(), never chosen.
enum class AngleKind : std::uint8_t {
    held,             // by a rigid component, so never solved
    explicitElastic,  // as forces
    implicitElastic,  // partly as forces, the rest as a compliant constraint
    driven,           // as a row of a mechanism
};

/// Angles at a particle b, between its neighbours a and c. They stand in the order of their bodies.
/// Those with limits or a motor are rows of mechanisms, of which each has one of its own.
struct Angles {
    std::vector<std::uint32_t> a, b, c;     // particles, dense indices
    std::vector<Real> restAngle;            // rad, of the turn from b - a to c - b
    std::vector<Real> stiffness;            // N m/rad
    std::vector<Real> damping;              // N m s/rad
    std::vector<Real> explicitStiffness;    // N m/rad, the part of the stiffness that is a force
    std::vector<Real> explicitDamping;      // N m s/rad, the same of the damping
    std::vector<Real> armBefore, armAfter;  // m, from b to a and c, as the blueprint has them
    std::vector<Real> torque;               // N m in the last step, positive turns anticlockwise
    std::vector<AngleKind> kind;
    std::vector<JointId> before, after;  // from a to b and from b to c, or null
    std::vector<std::uint32_t> body;     // dense index
    std::vector<Real> strength;          // N m
    std::vector<MechanismId> drive;      // whose row it is, or null
    std::vector<AngleId> id;

    std::size_t size() const { return a.size(); }

    template <class Function>
    void forEachArray(Function&& f) {
        forEachMoving(f);
        f(strength);
        f(drive);
        f(id);
    }
    /// Those that say how elastic ones move.
    template <class Function>
    void forEachMoving(Function&& f) {
        f(a);
        f(b);
        f(c);
        f(restAngle);
        f(stiffness);
        f(damping);
        f(explicitStiffness);
        f(explicitDamping);
        f(armBefore);
        f(armAfter);
        f(torque);
        f(kind);
        f(before);
        f(after);
        f(body);
    }

    template <class Archive>
    void archive(Archive& archive) {
        forEachArray(archive);
    }
};

/// How far an angle is from its rest, and how that changes with the places of a, b and c.
struct Turn {
    double bend = 0;                                                     // rad, -pi to pi
    std::array<Point, 3> slopes{Point(0, 0), Point(0, 0), Point(0, 0)};  // rad/m; their sum is 0
};

/// What an angular joint turns: a particle or a rigid component, which all of its members push.
struct TurnedMover {
    std::uint32_t particle = none, cluster = none;  // at most one of them
    Point force{0, 0};                              // rad/m
    double turning = 0;                             // rad/rad, about the component's centre
    double inverseMass = 0, inverseInertia = 0;     // 1/kg, 1/(kg m^2)
};

/// What the sweeps of a step need of an angular joint that is a constraint.
struct SweptAngle {
    std::array<Grip, 3> grips;
    Point before{0, 0}, after{0, 0};  // m, from a to b and from b to c when the step began
    Turn start, present;              // when the step began, and in this sweep
    std::array<TurnedMover, 3> movers;
    double hk = 0, hb = 0;  // kg m^2, of the parts that are no force
    double lambda = 0;      // kg m^2, the multiplier
    double change = 0;      // of that in this sweep
    bool whips = false;     // pulls along its present slopes
    bool inert = false;     // has no angle, or nothing that moves
};

/// Neighbours in the list of such joints, all of one body, that are solved as a whole: joints that
/// push the same thing are at most `width` apart. 0: they are too far, and it is one by one.
struct AngleGroup {
    std::uint32_t first = 0, last = 0;
    std::uint32_t width = 0;
    std::uint32_t factor = 0;  // the place of its factors
};

/// Those that are awake.
struct SweptAngles {
    std::vector<SweptAngle> list;
    std::vector<AngleGroup> groups;
    /// Of each joint of a group the pivot, and what it takes from the `width` before it.
    std::vector<double> factors;
};

}  // namespace sulfur::detail
