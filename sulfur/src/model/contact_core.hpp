// What touches: movers, shapes, the pairs of chunks that are near each other, and their rows.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>
#include <utility>
#include <vector>

#include "core/pieces.hpp"
#include "model/box_grid.hpp"
#include "model/look_results.hpp"
#include "model/movers.hpp"
#include "model/row_graph.hpp"
#include "model/shapes.hpp"

namespace sulfur::detail {

/// Two chunks whose boxes meet. It lives until the boxes part.
struct Pair {
    std::uint32_t a = none, b = none;  // chunks; none where the slot is free
    std::uint32_t isManifold = 0;      // both are convex, and nothing forbids corners
    /// Neighbours in the lists of pairs of a and b: the pair's number twice, plus 1 for its b.
    std::array<std::uint32_t, 2> next{none, none}, previous{none, none};
    std::uint32_t watch = none;       // its place among the watches, or none while all sleeps
    RowPlace row;                     // of a manifold that is near
    std::uint32_t firstTouch = none;  // of others
    std::uint32_t encounter = none;
    /// Of its points: the particles (slots) of corner and side, or none.
    std::array<std::array<std::uint32_t, 3>, 2> features{{{none, none, none}, {none, none, none}}};
    // While its row sleeps: kg m, impulses of its points and its friction, and its normals.
    std::array<Real, 3> kept{};
    std::array<Real, 4> keptNormal{};  // x and y of each
    Real restitution = 0;
    Real drag = 0;                   // kg/s, with Friction::sliding: force per speed of a point
    Real blow = 0, approach = 0;     // N s by impacts of this step, and m/s before them
    std::uint32_t keptPressing = 0;  // 1: the row that sleeps pressed
    std::uint32_t nextOfEncounter = none, previousOfEncounter = none;
    std::uint32_t owner = 0;  // 0: it counts as a's own, 1: as b's, 2: as nobody's
};

/// Whether two chunks are near enough to have rows, asleep or not.
inline bool isNear(const Pair& pair) {
    return pair.firstTouch != none || pair.features[0][0] != none || pair.features[1][0] != none;
}

/// A corner that is near a side.
struct Touch {
    std::uint32_t pair = none;  // none where the slot is free
    std::uint32_t corner = none, side = none;
    std::uint32_t end = 0;           // 0: the side between its ends, 1: its end a, 2: its end b
    std::uint32_t next = none;       // of the pair
    std::int32_t outward = 0;        // which way the side pushes
    RowPlace row;                    // none while it sleeps
    std::uint32_t seen = 0;          // by the last look
    std::uint32_t keptPressing = 0;  // 1: the row that sleeps pressed
    Real pressing = 0, rubbing = 0;  // kg m, while it sleeps
    Real normalX = 0, normalY = 0;
};

/// Two bodies some of whose chunks are near each other: who touches whom is told of bodies.
struct Encounter {
    static constexpr std::uint32_t ledApart = 1;  // they were made in each other
    static constexpr std::uint32_t letPass = 2;   // the caller has said that they do not collide

    BodyId a, b;                     // a < b; null where the slot is free
    std::uint32_t firstPair = none;  // of chunks; see Pair
    std::uint32_t pressing = 0;      // rows that press, asleep or not
    std::uint32_t struck = 0;        // 1: by an impact of this step
    std::uint32_t touching = 0;      // 1: they did when rows were last asked
    std::uint32_t changed = 0;       // 1: it is in the list of those that may have changed
    // While it is in that list:
    std::uint32_t touched = 0;   // 1: they did when the tick began
    std::uint32_t begun = none;  // its event in Events::contactsBegun, or none
    std::uint32_t rowless = 0;   // why it may have no rows: 0 (it may), or one of those above
    std::uint32_t entwined = 0;  // 1: they were in each other when they were last looked at
    std::uint32_t nextInBucket = none;
};

/// What an impact gave to a mover; when the step ends, with what the rows have answered.
struct Blow {
    std::uint32_t mover = 0;
    Vec2 velocity{0, 0};  // m in a step
    Real spin = 0;        // rad in a step
    Motion3 late;         // of these, what was over before: it does not go so far in this step
    Motion3 before;       // as it would have gone
};

/// The impulse of an impact, beside those of the rows.
struct Knock {
    std::array<std::uint32_t, 3> particles{none, none, none};  // slots: corner, side
    Vec2 normal{0, 0};                                         // from the side towards the corner
    Real pressing = 0, rubbing = 0;                            // kg m

    template <class Archive>
    void archive(Archive& a) {
        a(particles);
        a(normal);
        a(pressing);
        a(rubbing);
    }
};

/// What the surface of a row was before the caller changed it for a step, and that of its pair.
struct Resurfaced {
    std::uint32_t pair = none, touch = none;  // no touch: the manifold of the pair
    Real staticFriction = 0, kineticFriction = 0, slip = 0;
    Real restitution = 0, drag = 0;
};

/// Where a body as a whole goes when the step ends.
struct Lead {
    std::uint32_t body = 0;  // dense index
    Vec2 way{0, 0};          // m
};

/// When a pair has to be looked at: when the odometers of both frames together reach a limit.
struct PairWatch {
    /// The limit of a manifold that has a row: the refresh tells.
    static constexpr double never = 1e300;
    /// That of two that do not collide: no odometer comes so far.
    static constexpr double farAway = 1e299;

    std::uint32_t pair = 0, a = 0, b = 0;  // a, b: movers
    float fineness = 0;                    // m, of both chunks together
    double limit = 0;                      // m
    std::uint32_t isManifold = 0;          // as in Pair
    std::uint32_t unused = 0;              // no padding, because its bytes are hashed
};

/// Where b was from a when a pair was last found apart, how both were turned, and how far they
/// could move against each other from there.
struct PairRoom {
    Real apartX = 0, apartY = 0;  // m
    Heading headA, headB;
    Real room = 0;    // m; 0: nobody knows
    Real unused = 0;  // no padding, because its bytes are hashed
};

/// Impulses of a row that went, for whoever comes to stand for the same particles.
struct Heir {
    std::array<std::uint32_t, 3> particles{none, none, none};  // slots: corner, side
    Real pressing = 0, rubbing = 0;                            // kg m
};

/// A joint between bodies that collides: a capsule of one of them, with corners of both.
struct TiedCapsule {
    JointId joint;
    std::uint32_t a = none, b = none;  // bodies by slot

    friend auto operator<=>(const TiedCapsule&, const TiedCapsule&) = default;
};

struct ContactCore {
    Movers movers;
    Shapes shapes;
    BoxGrid grid;
    RowGraph rows;
    std::vector<Pair> pairs;
    std::vector<std::uint32_t> freePairs;
    std::vector<Touch> touches;
    std::vector<std::uint32_t> freeTouches;
    std::vector<Encounter> encounters;
    std::vector<std::uint32_t> freeEncounters, buckets, changedEncounters;
    std::vector<PairWatch> watches;      // of pairs of which something is awake
    std::vector<PairRoom> rooms;         // of these, in the same order
    std::vector<std::uint32_t> leading;  // encounters of bodies that are led apart
    double lastStep = 0;                 // s, of the step for which the rows have impulses
    std::uint32_t loadsAgain = 0;        // 1: stacks are loaded in the next step, too

    // Derived when bodies change or fall asleep.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> linked;        // (particle, body), slots
    std::vector<std::pair<std::uint32_t, std::uint32_t>> linkedBodies;  // slots, both ways
    std::vector<std::uint32_t> staleShapes;                             // bodies by slot
    std::vector<TiedCapsule> tiedCapsules;                              // in the order of joints
    std::vector<std::uint32_t> awakeMovers, awakeDense;  // and what they are, dense index
    std::vector<std::uint8_t> awakeIsCluster;
    std::vector<std::uint32_t> denseOfMover;  // the same by mover; none where it sleeps
    std::vector<std::uint8_t> moverIsCluster;
    std::uint32_t bouncingPairs = 0;    // 0: nothing has restitution
    std::uint32_t rollingSurfaces = 0;  // 0: nothing resists rolling
    std::vector<std::uint32_t> awakeChunks, awakeStrips;
    std::vector<std::uint32_t> newChunks;  // in no grid yet

    // Scratch of a tick, but the next one compares the ways.
    std::vector<double> ahead;        // m, odometers at the end of this step as predicted; by mover
    std::vector<std::uint8_t> moved;  // by mover, 1: its rows are refreshed in this step
    std::vector<std::uint8_t> stirred;  // by mover, the last sweep that has stirred it
    std::uint8_t sweep = 0;             // number of the present one
    std::vector<std::uint32_t> tied;    // movers that other constraints hold in this step, too
    std::vector<Motion3> placed;  // by mover: where it was from its reference before the sweeps
    std::vector<std::uint32_t> again;
    FoundInPieces findInPieces;
    std::vector<Heir> heirs;
    std::vector<Lead> leads;
    LooseLook looseLook;
    std::vector<KnownSide> knownSides;
    std::vector<Passing> passings;
    std::vector<BodyWay> ways;           // by mover: how it goes in this step
    std::vector<Real> lengths;           // m, by mover: how far any of its surface goes at most
    Real farthest = 0;                   // m, of all movers, as far as they go without rows
    std::uint32_t newRows = 0;           // manifolds, in this step
    std::vector<Resurfaced> resurfaced;  // rows that the caller has changed in this step
    bool answersBounce = false;          // some of them bounce
    // Bodies, slots, with contacts that did not act in the last step.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> passedBy;
    std::vector<Blow> blows;
    std::vector<Knock> knocks;          // of this step
    std::vector<Real> impulses;         // N s, of this tick, by encounters, where all are told
    std::vector<std::uint32_t> struck;  // pairs with impacts in this step
    std::vector<std::uint32_t> held;    // pairs that continuous collision has moved apart in it
    std::vector<Point> places;          // m, by particle that moves by itself: before constraints
    std::vector<std::uint32_t> struckEncounters;
    std::vector<std::uint32_t> toWake;  // bodies by slot
    bool listsStale = true;
    bool listsHaveGaps = false;      // chunks and movers that are gone are still in them
    std::uint32_t listedBodies = 0;  // the first so many are in the lists, if these are not stale
    bool keepsHeirs = false;

    template <class Archive>
    void archive(Archive& a) {
        a(movers);
        a(shapes);
        a(grid);
        a(rows);
        a(pairs);
        a(freePairs);
        a(touches);
        a(freeTouches);
        a(watches);
        a(rooms);
        a(encounters);
        a(freeEncounters);
        a(buckets);
        a(changedEncounters);
        a(leading);
        a(struck);
        a(struckEncounters);
        a(knocks);
        a(tiedCapsules);
        a(linked);
        a(linkedBodies);
        a(staleShapes);
        a(lastStep);
        a(loadsAgain);
        a(ways);
    }
};

}  // namespace sulfur::detail
