// What cannot be right about a level, although its file is well-formed.
#pragma once

#include <optional>
#include <quaoar/level.hpp>
#include <string>

namespace quaoar {

struct LevelProblem {
    std::string object;   ///< "spawn" or "exit"
    std::string problem;  ///< what is wrong and what is allowed, one sentence without an end
};

/// Finds a spawn or an exit inside of rock, and a closed outline of rock with only one of them
/// inside, which nobody can leave. Takes about as long as making a session. Throws what
/// sulfur::scene::instantiate throws.
std::optional<LevelProblem> checkLevel(const Level& level);

}  // namespace quaoar
