// What contacts push: rigid components and particles that move by themselves, in slots that stay.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "core/range_pool.hpp"
#include "core/slots.hpp"
#include "kernels/rows.hpp"

namespace sulfur::detail {

/// A velocity of a solver body, as a displacement in a step.
struct Motion3 {
    Real x = 0, y = 0, turn = 0;
};

inline Motion3 motionOf(const BodyWay& way) {
    return {way.x, way.y, way.turn};
}

/// Solver bodies and what belongs to them, by slot. Slot 0 is the world, which never moves.
///
/// An odometer adds up how far any point of its body can have gone; at its deadline the body is
/// looked at: whether it leaves a box of the broad phase, or its rows have to be refreshed.
struct Movers {
    std::vector<SolverBody> bodies;
    std::vector<Reference> references;    // where poses are counted from
    std::vector<Prediction> predictions;  // velocity without rows, of this step
    std::vector<Motion3> given;           // of what rows have given, what the state has taken up
    std::vector<double> odometer;         // m
    std::vector<double> deadline;         // m, on the odometer
    std::vector<double> refreshAt;        // m, on the odometer
    std::vector<Real> reach;              // m, from the centre to the farthest surface
    std::vector<Real> fineness;           // m, the least thickness of what it carries
    std::vector<std::uint64_t> colours;   // that its rows have
    /// Slot of the particle that it is, or of the first member of its rigid component; none for
    /// the ground of a fixed body and for what only has an odometer.
    std::vector<std::uint32_t> particle;
    std::vector<std::uint32_t> body;      // slot, or none where it is free
    std::vector<std::uint32_t> firstUse;  // the chunks that it carries, in Shapes::uses
    std::vector<std::uint32_t> free;

    Movers() { add(); }

    std::size_t size() const { return bodies.size(); }

    /// A slot without a mass that stands at the origin.
    std::uint32_t add() {
        if (!free.empty()) {
            const auto slot = free.back();
            free.pop_back();
            forEachArray([&](auto& list) { list[slot] = {}; });
            reset(slot);
            return slot;
        }
        forEachArray([&](auto& list) { list.emplace_back(); });
        const auto slot = static_cast<std::uint32_t>(size() - 1);
        reset(slot);
        return slot;
    }
    void remove(std::uint32_t slot) {
        body[slot] = none;
        bodies[slot] = {};
        free.push_back(slot);
    }

    /// m, where the pose of a body is counted from.
    Point placeAtReference(std::uint32_t m) const { return {references[m].x, references[m].y}; }
    Heading headingAtReference(std::uint32_t m) const {
        return {static_cast<Real>(references[m].cosine), static_cast<Real>(references[m].sine)};
    }

    template <class Function>
    void forEachArray(Function&& f) {
        visit(*this, f);
    }
    template <class Function>
    void forEachArray(Function&& f) const {
        visit(*this, f);
    }

    template <class Archive>
    void archive(Archive& a) {
        forEachArray(a);
        a(free);
    }

    /// How a body moves in this step, with what rows have given it.
    friend Motion3 motionNow(const Movers& movers, std::uint32_t m) {
        const Prediction& p = movers.predictions[m];
        const SolverBody& v = movers.bodies[m];
        return {p.vx + v.vx, p.vy + v.vy, p.spin + v.spin};
    }

    /// m, where a place in the frame of a body is when the step begins.
    friend Point placeOnMover(const Movers& movers, std::uint32_t m, Real x, Real y) {
        const SolverBody& b = movers.bodies[m];
        const Heading h = movers.headingAtReference(m);
        const Real cosine = h.cosine - h.sine * b.turn, sine = h.sine + h.cosine * b.turn;
        return movers.placeAtReference(m) +
               Vec2(b.x + cosine * x - sine * y, b.y + sine * x + cosine * y).cast<double>();
    }

private:
    template <class Self, class Function>
    static void visit(Self& self, Function& f) {
        f(self.bodies);
        f(self.references);
        f(self.predictions);
        f(self.given);
        f(self.odometer);
        f(self.deadline);
        f(self.refreshAt);
        f(self.reach);
        f(self.fineness);
        f(self.colours);
        f(self.particle);
        f(self.body);
        f(self.firstUse);
    }
    void reset(std::uint32_t slot) { particle[slot] = body[slot] = firstUse[slot] = none; }
};

}  // namespace sulfur::detail
