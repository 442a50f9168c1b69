// What the caller wants to be asked.
#pragma once

#include <exception>
#include <sulfur/callbacks.hpp>
#include <sulfur/error.hpp>
#include <utility>

namespace sulfur::detail {

/// No part of what a world is: neither hash nor snapshot knows of it.
struct Callbacks {
    ShouldCollide shouldCollide;
    PreSolve preSolve;
    bool asking = false;         // the caller is being asked
    std::exception_ptr failure;  // what he has thrown in this tick; he is not asked again

    /// Makes calls of the caller's. Returns whether they went well.
    template <class Function>
    bool ask(Function&& calls) {
        if (failure) return false;
        asking = true;
        try {
            calls();
        } catch (...) {
            failure = std::current_exception();
        }
        asking = false;
        return !failure;
    }

    /// Throws what the caller has thrown in this tick.
    void passOn() {
        if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
    }
};

/// Throws Error{inCallback} while the caller is being asked.
inline void requireOutside(const Callbacks& callbacks) {
    if (!callbacks.asking) return;
    throw Error(ErrorCode::inCallback,
                "a callback of a world calls what changes or queries that world; allowed is "
                "looking at bodies, particles and joints, and all else when World::step is over");
}

}  // namespace sulfur::detail
