// The course of the level of the day: pieces that are known to be good, strung together by a date.
#pragma once

#include <cstdint>
#include <quaoar/level.hpp>
#include <string>

namespace quaoar {

/// Times that earn medals in a level of the day are known after its proof: those here are wide.
inline constexpr MedalTimes unprovenMedals{60, 120, 240};

/// The text of a level. The same date ("2026-11-28") and plan (0, 1, ...) give the same bytes on
/// every machine; another plan is another course of the same day. Two checkpoints at least, four
/// pieces of gap, step, spikes, crates and jelly, in one of the four worlds.
std::string dailyCourse(const std::string& date, int plan,
                        const MedalTimes& medals = unprovenMedals);

/// "daily-2026-11-28": the id of the level, and the name of its file.
std::string dailyId(const std::string& date);
/// Today's date where the player is.
std::string today();

}  // namespace quaoar
