// What all readers of the game's part of a level file share. Private to the rules.
#pragma once

#include <initializer_list>
#include <quaoar/level.hpp>
#include <string>
#include <string_view>

namespace quaoar::reading {

inline constexpr double farthest = sulfur::scene::Limits::coordinate;

/// Typing mistakes in the game's own section would otherwise pass in silence.
void refuseUnknown(const sulfur::scene::Node& object,
                   std::initializer_list<std::string_view> known);

void requireInside(const sulfur::scene::Node& node, const Level& level, const sulfur::Point& place);

/// The name of a signal, which something must turn on: requireSignals() tells.
std::string signalName(const sulfur::scene::Node& node);

/// Checkpoints, pick-ups, zones, movers, switches, monsters and respawns; then the list of signals.
/// Everything that needs a signal, the exit too, must have been read into `level`, or be here.
void readMechanics(const sulfur::scene::Node& section, Level& level);

}  // namespace quaoar::reading
