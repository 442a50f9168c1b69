// Mechanisms: hinges, sliders, distances, pulleys and gears, as rows on a coordinate.
//
// Like grabs they keep handles, not indices: they are looked up once a step, and whatever is
// removed from the world needs to know nothing of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <sulfur/ids.hpp>
#include <sulfur/mechanisms.hpp>
#include <vector>

#include "core/slots.hpp"
#include "model/clusters.hpp"

namespace sulfur::detail {

/// A point of a body: a weighted mean of its particles.
struct MechanismPoint {
    std::uint32_t count = 0;  // of supports
    std::array<ParticleId, 3> support{};
    std::array<Real, 3> weight{0, 0, 0};

    template <class Archive>
    void archive(Archive& a) {
        a(count);
        a(support);
        a(weight);
    }
};

/// What shows the angle of a body: the line between two particles. Where both are of one rigid
/// component, it is that component; a disc has one particle twice.
struct MechanismArm {
    ParticleId from{}, to{};
    double angle = 0;  // rad, with whole turns, when the last step began

    template <class Archive>
    void archive(Archive& a) {
        a(from);
        a(to);
        a(angle);
    }
};

/// N or N m that a row gave in the last step, with which the next one begins.
struct RowForces {
    Real spring = 0, motor = 0, lower = 0, upper = 0;

    Real sum() const { return spring + motor + lower + upper; }

    template <class Archive>
    void archive(Archive& a) {
        a(spring);
        a(motor);
        a(lower);
        a(upper);
    }
};

/// The links of a body along which a slider's point goes, in order. The points of its line are the
/// ends of the link that it is on.
struct Rail {
    std::vector<JointId> links;
    std::uint32_t link = 0;   // on which it is
    std::uint8_t closed = 0;  // the last one ends where the first one begins
    double begin = 0;         // m, from the rail's begin to where its link begins

    bool isNothing() const { return links.empty(); }

    template <class Archive>
    void archive(Archive& a) {
        a(links);
        a(link);
        a(closed);
        a(begin);
    }
};

struct Mechanism {
    MechanismId id;
    MechanismKind kind = MechanismKind::hinge;
    BodyId a, b;    // of an angular joint the same
    AngleId angle;  // the angular joint that it is, or null
    Drive drive;
    Real ratio = 1;        // of a pulley or gear
    double zero = 0;       // rad or m, of the coordinate where the caller's begins
    double zeroAngle = 0;  // rad, that a slider which does not turn keeps
    /// Distance: of a and b. Pulley: the same, then of the other side. Slider: of b, then two of
    /// the line. Others: none.
    std::array<MechanismPoint, 4> points;
    std::array<MechanismArm, 2> arms;  // of a and b; of a hinge, and of a slider that does not turn
    std::array<MechanismId, 2> parts;  // of a gear
    std::array<AttachmentId, 2> pins;  // of a hinge or weld
    std::array<BodyId, 2> own;         // bodies of a particle: a pin, or places of fixed bodies
    BodyId frame;                      // of a pulley
    Rail rail;                         // of a slider, or nothing
    Real pinStrength = infinite;       // N
    std::uint8_t turns = 1;            // a slider's b
    std::uint8_t apart = 0;            // its bodies are not to collide
    std::uint8_t vetoes = 0;           // its bodies collide again when it is gone
    std::uint8_t atLower = 0, atUpper = 0;  // in the last step
    std::array<std::uint8_t, 3> vain{};     // rows that begin the next step without these
    std::array<RowForces, 3> forces;        // of the drive, across a line, and of a slider's angle

    template <class Archive>
    void archive(Archive& archive) {
        archive(id);
        archive(kind);
        archive(a);
        archive(b);
        archive(drive.lower);
        archive(drive.upper);
        archive(drive.stiffness);
        archive(drive.damping);
        archive(drive.rest);
        archive(drive.motorSpeed);
        archive(drive.motorMax);
        archive(drive.motorTarget);
        archive(drive.strength);
        archive(ratio);
        archive(zero);
        archive(zeroAngle);
        for (auto& point : points) archive(point);
        for (auto& arm : arms) archive(arm);
        archive(parts);
        archive(pins);
        archive(own);
        archive(frame);
        archive(pinStrength);
        archive(turns);
        archive(apart);
        archive(vetoes);
        archive(atLower);
        archive(atUpper);
        archive(vain);
        for (auto& row : forces) archive(row);
        if (a == b) archive(angle);
        if (kind == MechanismKind::slider) archive(rail);
    }
};

/// How a coordinate changes with what moves: the particles and rigid components, each once.
struct CoordinateSlopes {
    static constexpr std::size_t most = 12;  // a pulley has four points of three particles

    std::array<TurnedMover, most> movers;
    std::size_t count = 0;

    TurnedMover* begin() { return movers.data(); }
    TurnedMover* end() { return movers.data() + count; }
    const TurnedMover* begin() const { return movers.data(); }
    const TurnedMover* end() const { return movers.data() + count; }
};

/// How a tree that moves alone answers a unit of a row: all of its nodes, so that it holds.
struct TreeAnswer {
    std::uint32_t tree = none;
    std::uint32_t first = 0;  // place of its first node in MechanismWork::answers
};

struct MechanismRow;
/// What holds a row: one of its multipliers, or nothing.
struct RowHold {
    double MechanismRow::*multiplier = nullptr;
    double goal = 0, compliance = 0;  // rad or m; 1/kg
};

/// What the sweeps of a step need of a row.
struct MechanismRow {
    std::uint32_t mechanism = 0, number = 0;      // which of its rows
    std::uint32_t group = 0;                      // the first row of its own
    std::uint32_t firstMover = 0, lastMover = 0;  // in Mechanisms::movers
    /// Where its coordinate is how far one rigid component is turned more than another: these.
    std::array<std::uint32_t, 2> turning{none, none};
    std::array<TreeAnswer, 4> answers;
    double start = 0;                       // rad or m, when the step began
    double mobility = 0;                    // of the coordinate, for a unit of the multiplier
    double lower = 0, upper = 0, rest = 0;  // what it may reach and wants in this step
    double hk = 0, hb = 0;                  // kg (m^2), of the spring and its damper
    double way = 0;                         // rad or m, that the motor wants in this step
    double most = 0;                        // kg m (m), that it gives
    double bound = 0;                       // the same, that anything gives
    bool rigid = false;                     // the spring is
    /// kg m (m), multipliers so far.
    double spring = 0, motor = 0, low = 0, high = 0;
    double now = 0;     // rad or m, in this sweep
    double change = 0;  // of the multipliers, in this sweep
    RowHold hold;       // with which it has been eliminated
    bool vain = false;  // it has pushed against what gives as little as it does

    double sum() const { return spring + motor + low + high; }
};

/// Rows that push each other, also through a tree: neighbours in the list, solved together.
struct MechanismGroup {
    std::uint32_t first = 0, last = 0;
    /// Places of a square matrix each: how far a unit of one row moves the coordinate of another,
    /// and the factor of what of it is held.
    std::uint32_t matrix = 0, factor = 0;
    std::uint32_t firstTree = 0, lastTree = 0;  // that it moves, in Mechanisms::trees
};

struct Mechanisms {
    std::vector<Mechanism> list;
    Slots<MechanismId> slots;

    // Of the present step only.
    std::vector<MechanismRow> rows;        // that act
    std::vector<TurnedMover> movers;       // of rows: their slopes when the step began
    std::vector<std::uint32_t> nodes;      // of each, in a tree that takes part in the sweeps
    std::vector<Eigen::Vector3d> answers;  // displacement and turn of nodes
    std::vector<MechanismGroup> groups;
    std::vector<double> numbers;       // of their matrices
    std::vector<std::uint32_t> trees;  // that groups move

    bool empty() const { return list.empty(); }
    std::span<const TurnedMover> moversOf(const MechanismRow& row) const {
        return std::span(movers).subspan(row.firstMover, row.lastMover - row.firstMover);
    }
    /// Of its movers, or none.
    std::span<const std::uint32_t> nodesOf(const MechanismRow& row) const {
        return std::span(nodes).subspan(row.firstMover, row.lastMover - row.firstMover);
    }

    template <class Archive>
    void archive(Archive& a) {
        a(list);
        a(slots);
    }
};

}  // namespace sulfur::detail
