// Where the hero is and how he moves: what a player sees before he decides.
#pragma once

#include <algorithm>
#include <cstdint>
#include <quaoar/session.hpp>

namespace quaoar {

struct Situation {
    sulfur::Point place{0, 0};     ///< metres
    sulfur::Point velocity{0, 0};  ///< m/s
    bool tied = false;
    sulfur::Point anchor{0, 0};  ///< metres, if tied
    double length = 0;           ///< metres of rope at rest, if tied
    std::uint32_t signals = 0;   ///< bits of the level's signals that are on, of the first 32

    friend bool operator==(const Situation&, const Situation&) = default;
};

inline Situation situationOf(const Session& session) {
    Situation now;
    const std::size_t signals = std::min<std::size_t>(32, session.level().signals.size());
    for (std::size_t i = 0; i < signals; ++i) {
        if (session.workings().signals.on(i)) now.signals |= 1u << i;
    }
    now.place = session.heroPosition();
    now.velocity = session.heroVelocity().cast<double>();
    now.tied = session.rope().state() == Rope::State::attached;
    if (!now.tied) return now;
    now.anchor = session.rope().head(session.world());
    now.length = session.rope().restLength();
    return now;
}

inline int checkpointsReached(const Session& session) {
    int reached = 0;
    for (std::size_t i = 0; i < session.level().checkpoints.size(); ++i) {
        reached += session.reached(i) ? 1 : 0;
    }
    return reached;
}

}  // namespace quaoar
