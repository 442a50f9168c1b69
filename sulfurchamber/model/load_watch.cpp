#include "load_watch.hpp"

#include <algorithm>

namespace sulfurchamber {
namespace {

constexpr std::uint64_t timedEvery = 16;       // ticks: taking times takes time
constexpr std::uint64_t timedToConclude = 12;  // of these

std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

void LoadWatch::beforeTick(sulfur::World& world) {
    world.setProfiling(ticks_ % timedEvery == 0);
}

void LoadWatch::afterTick(const sulfur::World& world) {
    if (ticks_++ % timedEvery != 0) return;
    const auto& seconds = world.statistics().seconds;
    for (std::size_t i = 0; i < seconds.size(); ++i) seconds_[i] += seconds[i];
    if (++timed_ % timedToConclude == 0) conclude(world);
}

// In the words of who builds, not of who solves.
void LoadWatch::conclude(const sulfur::World& world) {
    const auto most = std::max_element(seconds_.begin(), seconds_.end());
    const sulfur::Statistics& s = world.statistics();
    const std::size_t stiff = s.implicitJoints + s.rigidJoints;
    switch (static_cast<sulfur::Stage>(most - seconds_.begin())) {
        case sulfur::Stage::constraints:
            cause_ =
                stiff > s.contacts ? counted(stiff, "stiff joint") : counted(s.contacts, "contact");
            break;
        case sulfur::Stage::predict:
            if (s.trees > 0)
                cause_ = counted(s.trees, "linked line");
            else
                cause_ = counted(s.awakeParticles, "moving particle");
            break;
        case sulfur::Stage::forces:
            cause_ = counted(s.explicitJoints, "elastic joint");
            break;
        case sulfur::Stage::broadPhase:
        case sulfur::Stage::narrowPhase:
            cause_ = counted(s.candidates, "near pair");
            break;
        case sulfur::Stage::fields:
            cause_ = "fields";
            break;
        case sulfur::Stage::sensors:
            cause_ = "sensors";
            break;
        case sulfur::Stage::breakage:
            cause_ = counted(s.breakableJoints, "breakable joint");
            break;
        default:
            cause_ = counted(s.awakeParticles, "moving particle");
    }
    seconds_ = {};
}

void LoadWatch::clear() {
    *this = {};
}

}  // namespace sulfurchamber
