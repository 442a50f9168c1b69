// S9: the scenes with which Box2D 3 shows its joints, rebuilt for every engine that has joints.
// Sizes, densities, motors and springs are its own; gravity is this comparison's, and nothing
// resists rolling. Rods are rectangles where something slides along them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/scenes.hpp"
#include "bench/variants.hpp"
#include "bench/workshop.hpp"

namespace sulfur::lab::bench {

/// What the scenes of S9 have in common: joints, which are looked at after every tick.
class Contraption : public Play {
public:
    void begin(EngineWorld& world) final;
    void look(const EngineWorld& world, double time) final;
    Figures figures(const EngineWorld& world) final;

protected:
    virtual void build(Workshop& workshop) = 0;
    /// After each tick.
    virtual void note(const EngineWorld&, double /*time*/) {}
    /// m/s^2, downwards.
    virtual double weight() const { return gravity; }
    /// What this scene has to tell beside openings and energy.
    virtual Figures more(const EngineWorld&) { return {}; }

    const Workshop& workshop() const { return *workshop_; }

private:
    double energy(const EngineWorld& world) const;

    std::optional<Workshop> workshop_;
    double opening_ = 0, beyondAngle_ = 0, beyondWay_ = 0;  // m, rad, m
    double openings_ = 0, looks_ = 0;                       // m, their sum and how many
    double energy_ = 0;                                     // J, at the start
};

/// How far a value is beyond the limits of a joint; 0 within them.
double beyond(const JointPlan& plan, double value);
/// The larger one; what is no number stays.
double worse(double sofar, double now);

/// A fixed body of capsules from each point to the next, whose upper edge is the line.
BodyPlan road(const std::vector<Point>& line, double friction);
/// A convex or cut outline moved so that its centre of mass is at the origin; returns where that
/// was.
Point centre(std::vector<Point>& corners);

/// A car of 3 m on two driven wheels with springs.
struct Car {
    std::size_t chassis = 0;
    std::vector<std::size_t> wheels, axles;  ///< bodies, joints

    static constexpr double wheelRadius = 0.4, speed = 35;  ///< m, rad/s
};
/// `foot` is below its middle, where the wheels stand. A torque in N m; a speed of 0 brakes.
Car addCar(Workshop& workshop, const Point& foot, int group, double hertz, double torque,
           double speed);
/// m/s^2, of a car on a level road, whose wheels do not slip.
double carAcceleration(const Workshop& workshop, const Car& car, double torque);

/// Names of the scenes of S9: "car", "doohickey" and so on.
const std::vector<std::string>& mechanismNames();
/// `name` must be one of them. With Extent::quick there are fewer of them.
Scene mechanism(const std::string& name, Extent extent);

VariantScene cars(Extent extent);
VariantScene driving(Extent extent);
VariantScene doohickeys(Extent extent);
VariantScene ragdollHeap(Extent extent);
VariantScene doors(Extent extent);
VariantScene scissorLift(Extent extent);
VariantScene gearLift(Extent extent);

}  // namespace sulfur::lab::bench
