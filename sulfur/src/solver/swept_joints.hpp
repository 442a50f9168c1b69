// The swept joints of one kind, in batches that the kernels take as a whole.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

struct State;

/// Neighbours in a list of swept joints that are solved in one way.
struct SweepBatch {
    std::uint32_t first = 0, last = 0;  // in the list
    std::uint32_t place = 0;            // of the first in the arrays, if `wide`
    bool wide = false;                  // they share no particle and hold no cluster
    std::uint32_t part = 0;

    std::size_t size() const { return last - first; }
};

/// The arrays that SweepView points into. Batches are derived with the work lists, the numbers in
/// every tick.
struct SweptJoints {
    std::vector<SweepBatch> batches;
    /// So many parts share no particle, whatever the colours: for threads. Batches of one colour
    /// come one after the other.
    std::uint32_t parts = 1;
    std::vector<std::uint32_t> a, b;
    std::vector<Real> startX, startY, massA, massB, rest, lambda;
    std::vector<Real> hk, hb, gain;
    std::vector<Real> directionX, directionY, scale, whips;

    template <class Function>
    void forEachReal(Function&& f) {
        for (auto* list : {&startX, &startY, &massA, &massB, &rest, &lambda, &hk, &hb, &gain,
                           &directionX, &directionY, &scale, &whips})
            f(*list);
    }
};

/// Divides a list, which stands in the order of its joints' colours, into batches.
void batchJoints(const State& state, const std::vector<std::uint32_t>& list, SweptJoints& swept);

}  // namespace sulfur::detail
