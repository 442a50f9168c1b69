// The camera that follows the hero: where it looks, and how much of the level it shows.
#pragma once

#include <atlax/camera.hpp>
#include <optional>
#include <quaoar/session.hpp>
#include <quaoar/view/open_space.hpp>

namespace quaoar {

/// Looks ahead to where the hero moves and aims, prefers open space to rock and the level to what
/// lies outside of it, and opens with speed. At rest the hero is 7 to 9 % as high as the picture;
/// at every tick all of him is within the middle 80 % of its width and height. Sees the session
/// from outside and changes nothing. Metres; one thread.
class FollowCamera {
public:
    FollowCamera(const Session& session, OpenSpace space);

    /// Call once after every tick of the session.
    void tick();
    /// To where it would come to rest, at once: after restarts.
    void cut();
    /// Goes on where another camera of the same session is.
    void resume(const FollowCamera& before);
    /// Width over height of the picture, of which the choice of the view depends; 16:9 at first.
    void setAspect(float aspect);
    /// From 0 to 1, how much the picture trembles now.
    void shake(float strength);
    /// Whether it trembles at all.
    void setTrembling(bool on) { trembles_ = on; }

    atlax::Camera camera(atlax::PixelSize size) const;

    /// What it shows, when it has come to rest at a hero who rests there and aims so.
    atlax::Rect restingView(atlax::Vec2 hero, atlax::Vec2 aim) const;
    const OpenSpace& space() const { return space_; }

private:
    struct Goal {
        atlax::Vec2 offset;  ///< of the view's middle from the hero
        float height = 3;    ///< of the view when the hero rests
    };

    Goal choose(atlax::Vec2 hero, atlax::Vec2 wanted, const std::optional<Goal>& before) const;
    atlax::Vec2 interest() const;
    atlax::Vec2 wanted(atlax::Vec2 aim, atlax::Vec2 velocity) const;
    /// The middle of a view of this size that is nearest to `centre` and holds the hero.
    atlax::Vec2 holding(atlax::Vec2 centre, atlax::Vec2 view) const;

    /// What moves.
    struct State {
        Goal goal;
        atlax::Vec2 centre, velocity;
        atlax::Vec2 heroVelocity;  ///< smoothed
        float height = 3;
        float speed = 0;  ///< smoothed: rises soon, falls late
        float shake = 0;
        std::uint64_t ticks = 0;
    };

    const Session& session_;
    OpenSpace space_;
    float aspect_ = 16.0f / 9;
    State now_;
    bool trembles_ = true;
};

}  // namespace quaoar
