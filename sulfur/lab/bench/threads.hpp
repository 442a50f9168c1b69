// Threads for our worlds.
#pragma once

#include <cstddef>
#include <sulfur/tasks.hpp>

namespace sulfur::lab::bench {

/// Tasks for so many threads, which live as long as the program; null for one.
Tasks* tasksFor(std::size_t threads);

}  // namespace sulfur::lab::bench
