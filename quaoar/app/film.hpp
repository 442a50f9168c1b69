// A run as an animated picture.
#pragma once

#include <atlax/animated_png.hpp>
#include <atlax/canvas.hpp>
#include <filesystem>
#include <memory>
#include <quaoar/recording.hpp>
#include <quaoar/view/game_view.hpp>

namespace quaoar {

/// Draws the last seconds of a run bit by bit, so that nobody waits for it, and writes the film. It
/// plays the run in a session of its own. Needs the canvas's context; one thread.
class Film {
public:
    static constexpr atlax::PixelSize size{320, 180};
    static constexpr int framesPerSecond = 12;
    static constexpr double mostSeconds = 10;

    /// `art` must outlive the film.
    Film(Art& art, std::shared_ptr<const Level> level, std::shared_ptr<const Recording> recording,
         std::filesystem::path file);

    /// To be called in each frame: goes on for a few milliseconds. Whether it is done, and the file
    /// written. Throws atlax::Error when that fails.
    bool step(atlax::Canvas& canvas);
    /// 0..1
    double progress() const;
    const std::filesystem::path& file() const { return file_; }

private:
    void tick();

    std::shared_ptr<const Recording> recording_;
    Session session_;
    GameView view_;
    Playback playback_;
    std::filesystem::path file_;
    atlax::RenderTarget target_;
    atlax::AnimatedPng film_{1000 / framesPerSecond};
    std::uint64_t ticks_ = 0;
    std::uint64_t end_ = 0;    ///< tick of the last frame
    std::uint64_t first_ = 0;  ///< and of the first
};

}  // namespace quaoar
