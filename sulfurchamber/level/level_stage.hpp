// A level in the drawing area: its picture, the marks over it, and the play-test.
#pragma once

#include <memory>
#include <optional>

#include "../view/level_painter.hpp"
#include "../view/scene_view.hpp"
#include "level_desk.hpp"
#include "level_picture.hpp"
#include "play_test.hpp"

namespace sulfurchamber {

/// What the drawing area shows of a level, and the desk behind it. Main thread.
class LevelStage {
public:
    /// Both must outlive the stage, which takes the view's places for others.
    LevelStage(Workbench& bench, SceneView& view);
    ~LevelStage();

    LevelDesk& desk() { return desk_; }
    const LevelDesk& desk() const { return desk_; }
    /// After each frame.
    void follow();
    /// After another document was opened.
    void opened();

    /// Bodies, ground and sky as the game draws them.
    void setPictured(bool on) { pictured_ = on; }
    bool pictured() const { return pictured_; }
    /// The way that the solver has found, and where it searches.
    void setWayShown(bool on) { wayShown_ = on; }
    bool wayShown() const { return wayShown_; }

    /// Plays the level in the drawing area, from the spawn or from a place. Throws
    /// sulfur::scene::ReadError where the game cannot read it.
    void play(const std::optional<sulfur::Point>& from = std::nullopt);
    /// Back to editing.
    void endPlay();
    bool playing() const { return test_ != nullptr; }
    /// Null while none is played.
    const PlayTest* test() const { return test_.get(); }
    /// Seconds from the last play() to its first picture; 0 before that.
    double firstPicture() const { return firstPicture_; }

    /// Selects what a problem is about and brings it into view.
    void goTo(std::size_t problem);
    void goTo(const LevelThing& thing);
    /// The problem after the one that was gone to last.
    void goToNext();

private:
    bool drawScenery(atlax::Canvas& canvas, const atlax::Camera& camera);
    void drawOverlay(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font);
    void drawSearch(atlax::Canvas& canvas, float pixel) const;
    void drawProblems(atlax::Canvas& canvas, float pixel) const;
    atlax::Application* makeTest(atlax::Canvas& canvas, std::shared_ptr<const quaoar::Level> level,
                                 bool fromSpawn);

    Workbench& bench_;
    SceneView& view_;
    LevelDesk desk_;
    LevelPicture picture_;
    LevelPainter marks_;
    std::unique_ptr<PlayTest> test_;
    bool pictured_ = true;
    bool wayShown_ = true;
    std::size_t nextProblem_ = 0;
    std::int64_t playedAtNs_ = 0;
    double firstPicture_ = 0;
};

}  // namespace sulfurchamber
