// The game within the editor: its session, camera, skins, keys and sounds.
#pragma once

#include <atlax/application.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <quaoar/recording.hpp>
#include <quaoar/view/controls.hpp>
#include <quaoar/view/game_view.hpp>
#include <quaoar/view/sounds.hpp>

namespace sulfurchamber {

/// A copy of a level that begins somewhere else: what is played from the mouse.
std::shared_ptr<const quaoar::Level> startingAt(const quaoar::Level& level,
                                                const sulfur::Point& place);

/// One test of a level. An application of its own that takes the editor's drawing area over while
/// it lives. Keys are those that the player has chosen in the game. Main thread.
class PlayTest final : public atlax::Application {
public:
    /// `art` must outlive it; `like` is a view whose grounds are taken, or null. The platform's
    /// clock must run at the game's rate.
    PlayTest(std::shared_ptr<const quaoar::Level> level, quaoar::Art& art,
             const quaoar::GameView* like);

    void start(atlax::Platform& platform) override;
    void tick() override;
    void draw(atlax::Canvas& canvas, double alpha) override;
    void stop() override;

    /// Called once when the hero has come to the exit.
    std::function<void(const quaoar::Recording&)> onFinish;
    /// Where a place of the level is seen, pixels of the drawing area. While it has that.
    atlax::Vec2 pixelsOf(const sulfur::Point& place) const;
    const quaoar::Session& session() const { return session_; }
    /// The inputs since the spawn.
    const quaoar::Recording& recording() const { return recording_; }
    std::uint64_t frames() const { return frames_; }

private:
    quaoar::TickInput input(const atlax::ActionState& state);
    void remember(const quaoar::TickInput& input);
    void drawStatus(atlax::Canvas& canvas) const;

    quaoar::Art& art_;
    quaoar::Session session_;
    quaoar::GameView view_;
    quaoar::PlayerActions actions_;
    quaoar::Controls controls_{actions_};
    quaoar::FrameGovernor governor_;
    std::unique_ptr<quaoar::Sounds> sounds_;
    quaoar::Recording recording_;
    atlax::Platform* platform_ = nullptr;
    std::uint64_t frames_ = 0;
    std::int64_t lastFrameNs_ = 0;
    bool told_ = false;  ///< the finish
};

}  // namespace sulfurchamber
