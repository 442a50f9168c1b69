// The sounds of the game, made from recipes: no recordings, no files.
#pragma once

#include <atlax/audio.hpp>
#include <quaoar/session.hpp>

namespace quaoar {

/// Follows a session and plays what happens. Silent where there is no sound device.
class Sounds {
public:
    explicit Sounds(atlax::Audio& audio);

    /// Call once after every tick of the session.
    void tick(const Session& session);
    /// Stops the sounds that go on, for pauses and menus.
    void hush();
    /// A menu's click.
    void click();

private:
    void follow(const Session& session);

    atlax::Audio& audio_;
    atlax::Sound shoot_, stick_, slip_, release_, bump_, finish_, creak_, click_, restart_;
    atlax::Voice creakVoice_;
    double lastTension_ = 0;
    float strain_ = 0;
    int bumpRest_ = 0;  ///< ticks until the next bump may sound
    int followRest_ = 0;
};

}  // namespace quaoar
