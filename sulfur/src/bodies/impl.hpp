// What World hides.
#pragma once

#include <sulfur/world.hpp>

#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"

namespace sulfur {

/// Whoever asks for the state finds members of rigid components where these are. What asks for
/// nothing of particles takes `data`.
struct World::Impl {
    detail::State data;

    detail::State& state() {
        detail::bringMembers(data);
        return data;
    }
};

}  // namespace sulfur
