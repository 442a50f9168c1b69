// What the caller asks of how discs turn.
#pragma once

#include <sulfur/ids.hpp>

namespace sulfur::detail {

/// Arrays of particles have no spins and no torques, and whether a particle is a disc is found when
/// a tick begins. So this waits for the next one.
struct DiscTurn {
    ParticleId disc;
    double spin = 0;    // rad/s, that it is to have
    double torque = 0;  // N m, that acts during the next tick
    bool spun = false;  // it is to have that spin

    template <class Archive>
    void archive(Archive& a) {
        a(disc);
        a(spin);
        a(torque);
        a(spun);
    }
};

}  // namespace sulfur::detail
