// Looking at a world as a person does: what is under the pointer, what lies in a rectangle, what
// does a body look like from outside.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfurchamber {

/// An axis-aligned rectangle in metres.
struct Bounds {
    sulfur::Point low{0, 0};
    sulfur::Point high{0, 0};

    void include(const sulfur::Point& point);
    sulfur::Point centre() const { return (low + high) / 2; }
    sulfur::Point size() const { return high - low; }
};

struct ParticlePick {
    sulfur::ParticleId particle;
    sulfur::BodyId body;
    double distance = 0;  ///< from the particle's centre, metres
};

struct JointPick {
    sulfur::JointId joint;
    sulfur::BodyId body;  ///< null for a joint between bodies
    double along = 0;     ///< 0 at the joint's a, 1 at its b
    double distance = 0;  ///< from the joint's surface (its axis when it has no radius), metres
};

/// The particle nearest to `point` whose disc, or centre, is within `reach`.
std::optional<ParticlePick> particleAt(const sulfur::World& world, const sulfur::Point& point,
                                       double reach);
/// The joint nearest to `point` within `reach`.
std::optional<JointPick> jointAt(const sulfur::World& world, const sulfur::Point& point,
                                 double reach);
/// Which bodies are looked for, and which of them are in front. Nothing: all, and the newer ones.
struct Picking {
    std::function<bool(sulfur::BodyId)> counts = {};
    std::function<int(sulfur::BodyId)> order = {};  ///< higher is in front
};
/// The body whose surface is within `reach` of `point`, or else inside of which the point lies; the
/// one in front where several do. The inside of a fixed body does not count: it may be the cave in
/// which everything happens, and neither does a hole. Null when there is none.
sulfur::BodyId bodyAt(const sulfur::World& world, const sulfur::Point& point, double reach,
                      const Picking& picking = {});
/// Dynamic bodies whose surface is within `reach` of `point`, or inside of which it lies; the
/// newest first.
std::vector<sulfur::BodyId> movingBodiesAt(const sulfur::World& world, const sulfur::Point& point,
                                           double reach);
/// Bodies that lie wholly in a rectangle given by two corners.
std::vector<sulfur::BodyId> bodiesIn(const sulfur::World& world, const sulfur::Point& a,
                                     const sulfur::Point& b);
/// Joints that the line from `a` to `b` crosses, except for those of fixed bodies.
std::vector<sulfur::JointId> jointsCrossing(const sulfur::World& world, const sulfur::Point& a,
                                            const sulfur::Point& b);

/// Closed outlines of a body, made of the capsules that collide, as indices of its particles.
/// Complexity: linear in the joints.
std::vector<std::vector<std::uint32_t>> outlines(const sulfur::World& world, sulfur::BodyId body);
/// The same of a plan.
std::vector<std::vector<std::uint32_t>> outlines(const sulfur::Blueprint& blueprint);
/// Whether a point lies inside a closed polygon.
bool inside(const std::vector<sulfur::Point>& polygon, const sulfur::Point& point);

/// Bodies that mechanisms have made for themselves: their pins.
std::set<sulfur::BodyId> pinsOf(const sulfur::World& world);

/// How much there is, also before the first tick. Pins are parts of their mechanisms.
struct Totals {
    std::size_t bodies = 0;
    std::size_t particles = 0;
    std::size_t awakeParticles = 0;  ///< of bodies that are neither fixed nor asleep
    std::size_t rigidJoints = 0;
    std::size_t elasticJoints = 0;
};
Totals totals(const sulfur::World& world);

/// All that one wants to see: everything that moves, and the ground below and near it; all of what
/// is fixed where nothing moves. Nothing for an empty world, and for one that has but a floor.
std::optional<Bounds> interestingBounds(const sulfur::World& world);
/// How high the floor of such a world is, metres.
double floorHeight(const sulfur::World& world);

}  // namespace sulfurchamber
