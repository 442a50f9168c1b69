// Where the hero is and how he moves: what a player sees before he decides.
#pragma once

#include <quaoar/session.hpp>

namespace quaoar {

struct Situation {
    sulfur::Point place{0, 0};     ///< metres
    sulfur::Point velocity{0, 0};  ///< m/s
    bool tied = false;
    sulfur::Point anchor{0, 0};  ///< metres, if tied
    double length = 0;           ///< metres of rope at rest, if tied

    friend bool operator==(const Situation&, const Situation&) = default;
};

inline Situation situationOf(const Session& session) {
    Situation now;
    now.place = session.heroPosition();
    now.velocity = session.heroVelocity().cast<double>();
    now.tied = session.rope().state() == Rope::State::attached;
    if (!now.tied) return now;
    now.anchor = session.rope().head(session.world());
    now.length = session.rope().restLength();
    return now;
}

}  // namespace quaoar
