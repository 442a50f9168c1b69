// The sentences of a level, one at a time and only as long as they are of use.
#pragma once

#include <quaoar/session.hpp>
#include <string>
#include <vector>

#include "overlay.hpp"
#include "prompts.hpp"

namespace quaoar {

/// Shows the nearest of a level's hints while the hero is near its place. A hint that names actions
/// ("{reel_in} reels in") goes when the player has done them; others go after a while. What is done
/// does not come back when the attempt begins anew. One thread.
class Hints {
public:
    /// All must outlive the hints.
    Hints(const PlayerActions& actions, const Prompts& prompts, const Texts& texts)
        : actions_(actions), prompts_(prompts), texts_(texts) {}

    /// Another level.
    void start(const Level& level);
    /// Once in every tick of play.
    void tick(const Session& session, const atlax::ActionState& state);
    /// At the lower edge of the picture.
    void draw(const OverlayTools& tools) const;
    /// What is shown now, in the player's language; empty for nothing.
    std::string text() const;

private:
    struct Progress {
        bool done = false;
        int shown = 0;             ///< ticks
        std::vector<int> actions;  ///< ticks for which each named action was held
    };
    void choose(const Level& level, sulfur::Point hero);
    void learn(const Session& session, const atlax::ActionState& state);

    const PlayerActions& actions_;
    const Prompts& prompts_;
    const Texts& texts_;
    std::vector<Hint> hints_;
    std::vector<Progress> progress_;
    std::size_t current_ = 0;  ///< hints_.size(): none
    float visible_ = 0;        ///< 0..1
};

}  // namespace quaoar
