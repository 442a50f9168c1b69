// Ways as text, beside their levels.
#pragma once

#include <filesystem>

#include "bot.hpp"
#include "policy.hpp"

namespace quaoar {

/// What a file "NN-name.way" holds: what a player does where, and how well the robust bot gets
/// through with that. The proof beside it holds the ticks of the fastest way that is known.
///
/// The file is text, version 1: a line "quaoar-way 1", lines "key value" (level, level-hash,
/// searched, survival in per cent, games, tries, seconds), and two lines for each place: "at X Y VX
/// VY"
/// ("tied AX AY LENGTH" follows if the rope is, "signals BITS" if some are on), "worth VALUE: " and
/// the intention; a line "end".
struct WayFile {
    std::string levelId;
    std::uint64_t levelHash = 0;
    double searched = 0;  ///< simulated seconds to the first way
    Survival survival;
    Policy policy;

    std::string format() const;
    /// Throws WayError with file and line.
    static WayFile parse(const std::string& text, const std::string& file);
    static WayFile read(const std::filesystem::path& file);
    /// Writes to a new file and renames it.
    void write(const std::filesystem::path& file) const;
};

/// Where the way through a level lies: beside it, with the extension ".way".
std::filesystem::path wayOf(const std::filesystem::path& levelFile);

}  // namespace quaoar
