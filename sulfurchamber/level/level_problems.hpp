// What is wrong with a level: all that its reader refuses, and what cannot be played.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <quaoar/session.hpp>
#include <string>
#include <vector>

#include "../model/level_things.hpp"

namespace sulfurchamber {

struct LevelProblem {
    std::string text;                         ///< one sentence: what is wrong and what is allowed
    bool grave = true;                        ///< it cannot be played so; else it is advice
    std::optional<LevelThing> thing;          ///< what it is about, if it is one
    std::string body;                         ///< or a body
    std::optional<sulfur::Point> place = {};  ///< metres: where to look
};

/// What was found out about a text.
struct LevelReport {
    std::vector<LevelProblem> problems;
    /// The level, if its reader takes it, and a session of it that has not begun.
    std::shared_ptr<const quaoar::Level> level;
    std::unique_ptr<quaoar::Session> session;
    /// No grave problem.
    bool playable() const;
};

/// Reads and checks the text of a file. Takes as long as making a session, and some tenths of a
/// second. Any thread. `file` names the level.
LevelReport checkLevelText(const std::string& text, const std::filesystem::path& file);

}  // namespace sulfurchamber
