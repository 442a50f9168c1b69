// What a player may think of doing next.
#pragma once

#include <quaoar/session.hpp>
#include <random>
#include <vector>

#include "distance_field.hpp"
#include "intention.hpp"

namespace quaoar {

/// In [0, 1). Not std::uniform_real_distribution, whose results differ between libraries.
inline double unit(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// 0 to below - 1.
inline int whole(std::mt19937_64& random, int below) {
    return static_cast<int>(unit(random) * below);
}

/// A place where the rope would hold if it were fired now, one nearer to the exit rather than
/// another; false if there is none.
bool pickAnchor(const Session& session, const DistanceField& field, std::mt19937_64& random,
                sulfur::Point& anchor);

/// Something that can be done in the session's present state; it ends after a time. `shots` is the
/// share of shots, in per cent, while the rope is tied.
Intention randomIdea(const Session& session, const DistanceField& field, std::mt19937_64& random,
                     int shots = 45);

/// The same, and then one waits until nothing swings, pushing against the swing.
Intention steadily(Intention idea);

/// Somewhat other than before, as one varies what did not quite work.
Intention varied(Intention idea, std::mt19937_64& random);

/// The same intention, ended by what can be seen (a line that the hero passes) rather than by a
/// clock, where that means the same tick. `trace` holds the hero's places after each of its ticks.
Intention endedBySight(Intention intention, const std::vector<sulfur::Point>& trace);

}  // namespace quaoar
