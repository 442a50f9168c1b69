/// \file
/// How a host lends threads to a world.
#pragma once

#include <cstddef>

namespace sulfur {

/// Threads that a host lends: derive from it over the job system that the program has already, or
/// take ThreadPool (sulfur/thread_pool.hpp) or TbbTasks (sulfur/tbb_tasks.hpp). One object may
/// serve several worlds, as long as it allows run() to be called by as many threads as step them.
///
/// What a world computes never depends on how many threads there are, nor on which of them takes
/// which piece.
class Tasks {
public:
    virtual ~Tasks() = default;

    /// How many threads may work at once, the caller's included; at least 1. A world divides its
    /// work into about so many pieces.
    virtual std::size_t threads() const = 0;

    /// Calls task(context, i) once for each i in [0, count), in any order and at once, and returns
    /// when all calls have returned. A task throws nothing, waits for no other and calls no run().
    virtual void run(std::size_t count, void (*task)(void* context, std::size_t i),
                     void* context) = 0;

    /// Microseconds that it takes to hand work over and to wait for its end, beside the work
    /// itself, while threads are awake. What takes not much longer a world does alone.
    virtual double overhead() const { return 5; }

    /// The tick in which run() was called is over; nothing is run until the next one. For threads
    /// that stay awake within a tick.
    virtual void rest() {}
};

}  // namespace sulfur
