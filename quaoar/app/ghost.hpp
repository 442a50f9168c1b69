// A recorded run that plays beside the player's own.
#pragma once

#include <atlax/canvas.hpp>
#include <memory>
#include <quaoar/recording.hpp>
#include <quaoar/session.hpp>

namespace quaoar {

/// A session of its own that follows a recording: it cannot touch the player's. It starts when the
/// player's clock does, at the moment at which its own did. One thread.
class Ghost {
public:
    /// Throws as requireMatch.
    Ghost(std::shared_ptr<const Level> level, std::shared_ptr<const Recording> recording);

    /// Back to the start, as after the player's restart.
    void restart();
    /// One tick, to be called while the player's clock runs.
    void tick();
    /// The hero and its rope, translucent; the canvas shows the world.
    void draw(atlax::Canvas& canvas, double alpha, atlax::Color color) const;

private:
    std::shared_ptr<const Recording> recording_;
    Session session_;
    Playback playback_;
    Playback playbackAtStart_;
    std::shared_ptr<const Session::Snapshot> start_;
};

}  // namespace quaoar
