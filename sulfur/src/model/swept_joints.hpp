// The swept joints of one kind, in batches that the kernels take as a whole.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// Neighbours in a list of swept joints that are solved in one way.
struct SweepBatch {
    std::uint32_t first = 0, last = 0;  // in the list
    std::uint32_t place = 0;            // of the first in the arrays, if `wide`
    bool wide = false;                  // they share no particle and hold no cluster
    std::uint32_t part = 0;

    std::size_t size() const { return last - first; }
};

/// The arrays that StartView and SweepView point into. Batches are derived with the work lists, and
/// with them all that does not change from tick to tick.
struct SweptJoints {
    std::vector<SweepBatch> batches;
    /// So many parts share no particle, whatever the colours: for threads. Batches of one colour
    /// come one after the other.
    std::uint32_t parts = 1;
    std::vector<std::uint32_t> joint, a, b;
    std::vector<Real> massA, massB, length;
    // Of implicit joints, for steps of h seconds in which a multiplier stands for so many newtons.
    std::vector<Real> hk, hb;
    Real h = 0, newtons = 0;
    // Found in every tick.
    std::vector<Real> startX, startY, directionX, directionY, whips, lambda, gain;
    std::vector<Real> rest;  // of rigid joints

    template <class Function>
    void forEachArray(Function&& f) {
        for (auto* list : {&joint, &a, &b}) f(*list);
        for (auto* list : {&massA, &massB, &length, &hk, &hb, &startX, &startY, &directionX,
                           &directionY, &whips, &lambda, &gain, &rest})
            f(*list);
    }
};

}  // namespace sulfur::detail
