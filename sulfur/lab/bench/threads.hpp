// Threads for our worlds, where the laboratory is built with oneTBB.
#pragma once

#include <cstddef>
#include <sulfur/tasks.hpp>

namespace sulfur::lab::bench {

/// Whether there are any.
bool hasThreads();

/// Tasks for so many threads, which live as long as the program; null for one, or without oneTBB.
Tasks* tasksFor(std::size_t threads);

}  // namespace sulfur::lab::bench
