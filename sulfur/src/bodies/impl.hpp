// What World hides.
#pragma once

#include <sulfur/error.hpp>
#include <sulfur/world.hpp>

#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"

namespace sulfur {

/// Whoever asks for the state finds members of rigid components where these are. What asks for
/// nothing of particles takes `known()`, and what is no part of the state `data`.
struct World::Impl {
    detail::State data;
    bool torn = false;  // there was no memory in the middle of a tick

    detail::State& known() {
        if (torn) refuseTorn();
        return data;
    }
    detail::State& state() {
        detail::bringMembers(known());
        return data;
    }
    /// The same for a call that no callback may make.
    detail::State& outside() {
        detail::requireOutside(data.callbacks);
        return state();
    }
    /// The same for one that is about to change it, with room for what any such call notes: who
    /// wakes, whose shape is stale, who was placed.
    detail::State& changing();
    /// The same for one that asks for nothing of particles that are awake.
    detail::State& changingKnown();
    [[noreturn]] static void refuseTorn();
};

}  // namespace sulfur
