// Random play from anywhere on a way that is known to finish, which looks for what must never be.
#pragma once

#include <quaoar/recording.hpp>
#include <string>
#include <vector>

#include "search.hpp"

namespace quaoar {

struct WanderOptions {
    double seconds = 3600;  ///< to be simulated
    double trip = 20;       ///< seconds of each piece of play
    std::uint64_t seed = 1;
    int jobs = 1;
};

/// Something that must never be, with the inputs from the spawn that lead there.
struct WanderFault {
    std::string what;     ///< "the hero is at nan nan"
    Recording recording;  ///< its last tick is the one after which it was seen
};

struct WanderReport {
    int trips = 0;
    double simulated = 0;  ///< seconds, without those on the way to where trips begin
    int deaths = 0;
    int finishes = 0;
    std::vector<WanderFault> faults;  ///< one of a trip at most
};

/// What is wrong with a session, "" when nothing: a place or velocity that is no number, a hero out
/// of the world who does not die, a hero who is torn apart, a world that contradicts itself (the
/// last costs much and is asked for with `all`).
std::string faultOf(const Session& session, bool all);

/// Plays trips until the time is spent: each begins at a moment of the proof, and goes on as a
/// child with the controls would. The same for every number of threads. Throws as requireMatch.
WanderReport wander(const std::shared_ptr<const Level>& level, const Recording& proof,
                    const WanderOptions& options);

}  // namespace quaoar
