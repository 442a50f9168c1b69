#include "load_watch.hpp"
#include "words.hpp"

#include <algorithm>

namespace sulfurchamber {
namespace {

constexpr std::uint64_t timedEvery = 16;       // ticks: taking times takes time
constexpr std::uint64_t timedToConclude = 12;  // of these

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
            cause_ = stiff > s.contacts ? trCount("{} stiff joint", "{} stiff joints", stiff)
                                        : trCount("{} contact", "{} contacts", s.contacts);
            break;
        case sulfur::Stage::predict:
            if (s.trees > 0)
                cause_ = trCount("{} linked line", "{} linked lines", s.trees);
            else
                cause_ = trCount("{} moving particle", "{} moving particles", s.awakeParticles);
            break;
        case sulfur::Stage::forces:
            cause_ = trCount("{} elastic joint", "{} elastic joints", s.explicitJoints);
            break;
        case sulfur::Stage::broadPhase:
        case sulfur::Stage::narrowPhase:
            cause_ = trCount("{} near pair", "{} near pairs", s.candidates);
            break;
        case sulfur::Stage::fields:
            cause_ = tr("fields");
            break;
        case sulfur::Stage::sensors:
            cause_ = tr("sensors");
            break;
        case sulfur::Stage::breakage:
            cause_ = trCount("{} breakable joint", "{} breakable joints", s.breakableJoints);
            break;
        default:
            cause_ = trCount("{} moving particle", "{} moving particles", s.awakeParticles);
    }
    seconds_ = {};
}

void LoadWatch::clear() {
    *this = {};
}

}  // namespace sulfurchamber
