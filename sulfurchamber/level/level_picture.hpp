// A level as the game draws it at its start, for the editor's camera.
#pragma once

#include <memory>
#include <optional>
#include <quaoar/view/game_view.hpp>

namespace sulfurchamber {

/// Pictures and views of the game within the editor's canvas. What is drawn is kept, because
/// nothing moves in it: frames in which only marks change cost little. Main thread, while the
/// canvas lives.
class LevelPicture {
public:
    /// From now on this session is drawn, as it is.
    void show(std::unique_ptr<quaoar::Session> session);
    /// Nothing is drawn any more.
    void hide();
    bool shows() const { return session_ != nullptr; }
    /// The level that is shown; null when none is.
    const quaoar::Level* level() const { return session_ ? &session_->level() : nullptr; }
    /// Draws it through this camera; does nothing when nothing is shown.
    void draw(atlax::Canvas& canvas, const atlax::Camera& camera);
    /// The canvas is gone, with all that was made on it.
    void forgetGraphics();

    /// The game's pictures on this canvas, made when they are first asked for.
    quaoar::Art& art(atlax::Canvas& canvas);
    /// What has drawn the level last, whose grounds others may take; null before.
    const quaoar::GameView* view() const { return view_.get(); }

private:
    std::unique_ptr<quaoar::Art> art_;
    std::unique_ptr<quaoar::Session> session_;
    std::unique_ptr<quaoar::GameView> view_;
    std::unique_ptr<quaoar::Session> before_;   ///< what the view is of while another waits
    atlax::RenderTarget kept_;                  ///< the last picture
    std::optional<atlax::Camera> keptThrough_;  ///< the camera that it was taken with
    bool fresh_ = false;                        ///< another session waits for its view
};

}  // namespace sulfurchamber
