// A physics engine as the comparison knows it: what the scenes ask of every engine alike.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <sulfur/math.hpp>
#include <utility>
#include <vector>

#include "bench/bodies.hpp"
#include "bench/joints.hpp"

namespace sulfur::lab::bench {

/// How an engine is run.
struct Setting {
    std::string engine;        ///< key of the engine
    int rate = 500;            ///< Hz
    int iterations = 1;        ///< substeps, iterations or sweeps in a tick, whichever it has
    int threads = 1;           ///< that it may use
    bool stiffJoints = false;  ///< joints stiffer than the engine's default, where it has a choice
    bool sleeping = false;     ///< whether what rests may fall asleep
    bool weightless = false;   ///< without gravity
    double contactHertz = 0;   ///< stiffness of contacts, where an engine has a choice; 0: its own

    /// For people: "500 Hz x 4".
    std::string label() const;
};

/// A line of points of which the first is held, with rigid links from each to the next.
struct RopePlan {
    std::vector<Point> points;   ///< metres
    std::vector<double> masses;  ///< kg, of each point; that of the first means nothing
};

/// Points and springs between them that touch nothing.
struct NetPlan {
    struct Spring {
        std::size_t a = 0, b = 0;
        double length = 0, stiffness = 0, damping = 0;  ///< m, N/m, N s/m

        /// An infinite stiffness is a rigid link.
        bool isRigid() const { return std::isinf(stiffness); }
    };
    std::vector<Point> points;      ///< metres
    std::vector<Point> velocities;  ///< m/s, of each point
    std::vector<double> masses;     ///< kg; 0: held where it is
    std::vector<Spring> springs;

    /// The mass with which the ends of a spring swing against each other, kg.
    double reducedMass(const Spring& spring) const;
};

/// Springs along the sides and diagonals of a square of 4 x 4 discs: the blob of the comparison.
struct BlobPlan {
    static constexpr int side = 4;                   ///< discs in a row
    static constexpr double spacing = 1.0 / 3;       ///< metres
    static constexpr double radius = 1.0 / 6;        ///< metres, of a disc
    static constexpr double mass = 1;                ///< kg in all
    static constexpr double hertz = 10;              ///< of two discs on one spring
    static constexpr double dampingRatio = 0.5;      ///< of the same
    static constexpr double stiffness = 123.370055;  ///< N/m: (2 pi hertz)^2 times mass / 32
    static constexpr double damping = 1.96349541;    ///< N s/m: the ratio times that of critical

    /// Places of the discs about the centre, row by row from the lower left, metres.
    static std::vector<Point> places();
    /// Pairs of discs with a spring between them: 24 along the sides, then 18 diagonals.
    static std::vector<std::pair<std::size_t, std::size_t>> springs();
};

/// Friction of all surfaces of all scenes.
inline constexpr double friction = 0.5;
/// m/s^2 downwards.
inline constexpr double gravity = 9.81;

/// Seconds in each stage of an engine's tick, as the engine itself tells them.
using StageTimes = std::vector<std::pair<std::string, double>>;

/// One world of one engine. Nothing rebounds in it but bodies that say so. Places are in metres.
/// Everything is numbered in the order in which it was made. What an engine does not offer is
/// never asked of it (see Engine).
class EngineWorld {
public:
    EngineWorld() = default;
    virtual ~EngineWorld() = default;
    EngineWorld(EngineWorld&&) = delete;
    EngineWorld& operator=(EngineWorld&&) = delete;

    /// A fixed upright rectangle.
    virtual void addFixed(const Point& centre, const Point& half) = 0;
    /// A square of 1 m and 1 kg with the inertia of a solid; `angle` in radians, `velocity` in m/s.
    virtual void addSquare(const Point& centre, double angle, const Point& velocity) = 0;
    virtual void addRope(const RopePlan& plan) = 0;
    /// Numbered with the ropes.
    virtual void addNet(const NetPlan&) {}
    /// A soft body at rest of about the size of the plan.
    virtual void addBlob(const Point& centre) = 0;
    /// Numbered by themselves, whatever moves them.
    virtual void addBody(const BodyPlan&) {}
    virtual void addPin(const PinPlan&) {}
    /// Between bodies whose plans these are; numbered by themselves.
    virtual void addJoint(const JointPlan&, const BodyPlan& /*a*/, const BodyPlan& /*b*/) {}
    /// N m, for the next tick.
    virtual void applyTorque(std::size_t /*body*/, double /*torque*/) {}
    /// N s, at a place in the world; at once.
    virtual void applyImpulse(std::size_t /*body*/, const Point& /*impulse*/, const Point& /*at*/) {
    }
    /// Its number stays its own.
    virtual void removeBody(std::size_t) {}

    /// Advances by one tick of the setting's rate.
    virtual void step() = 0;

    /// Where a square is now, and its angle.
    virtual std::pair<Point, double> square(std::size_t i) const = 0;
    /// m, of its corners, which are round within the square.
    virtual double cornerRadius() const { return 0; }
    /// Where the points of a rope are now.
    virtual std::vector<Point> rope(std::size_t i) const = 0;
    /// Where the particles of a blob are now.
    virtual std::vector<Point> blob(std::size_t i) const = 0;
    /// How a body moves now.
    virtual Motion body(std::size_t) const { return {}; }
    /// kg m^2 about its centre, as the engine has it; `plan` is what it was made of.
    virtual double inertia(std::size_t /*body*/, const BodyPlan& plan) const {
        return plan.inertia();
    }
    /// N m or N, of the motor of a joint in the last tick.
    virtual double motorForce(std::size_t /*joint*/) const { return 0; }
    /// Where the two sockets of a pin are now.
    virtual std::pair<Point, Point> pin(std::size_t) const { return {}; }

    /// Whether stages() sums up from now on.
    virtual void setProfiling(bool) {}
    /// Empty for an engine that tells nothing.
    virtual StageTimes stages() const { return {}; }
};

/// What a scene needs.
enum class Feature { squares, ropes, blobs, nets, bodies, joints, threads };

struct Engine {
    std::string key, title;
    bool ours = false;
    std::string version;            ///< as the library tells it, or empty
    std::vector<Feature> features;  ///< what it offers
    /// Throws sulfur::Error or std::exception when the setting cannot be obeyed.
    std::function<std::unique_ptr<EngineWorld>(const Setting&)> make;  ///< empty: not built in
    std::string how;  ///< for one that is not built in: how to get it

    bool found() const { return static_cast<bool>(make); }
    bool offers(Feature feature) const;
};

/// All engines that the comparison knows, ours first, found or not.
const std::vector<Engine>& engines();
/// `key` must be one of them.
const Engine& engineOf(const std::string& key);
/// "Missing: ..." with what to install, one line each; empty when none is.
std::string missingEngines();

/// Adaptors; each is linked only where its library was found.
std::unique_ptr<EngineWorld> makeSulfur(const Setting& setting);
std::unique_ptr<EngineWorld> makeBox2dV3(const Setting& setting);
std::unique_ptr<EngineWorld> makeBox2dV2(const Setting& setting);
std::unique_ptr<EngineWorld> makeChipmunk(const Setting& setting);
std::unique_ptr<EngineWorld> makeBullet(const Setting& setting);
std::unique_ptr<EngineWorld> makeLiquidFun(const Setting& setting);
std::string box2dV3Version();
std::string box2dV2Version();
std::string chipmunkVersion();
std::string bulletVersion();
std::string liquidFunVersion();

}  // namespace sulfur::lab::bench
