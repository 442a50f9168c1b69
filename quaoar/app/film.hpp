// A run as an animated picture.
#pragma once

#include <atlax/canvas.hpp>
#include <filesystem>
#include <memory>
#include <quaoar/recording.hpp>
#include <quaoar/view/game_view.hpp>
#include <vector>

namespace quaoar {

/// Animated PNG: puts frames of one size together. Browsers show the file as they show any picture.
class AnimatedPng {
public:
    /// `delay` of each frame in milliseconds, 1 to 65535.
    explicit AnimatedPng(int delay) : delay_(delay) {}
    /// Throws atlax::Error for a picture of another size than the first.
    void add(const atlax::Image& frame);
    int frames() const { return frames_; }
    /// The bytes of the file, with at least one frame.
    std::vector<std::byte> bytes() const;

private:
    int delay_;
    int frames_ = 0;
    std::uint32_t sequence_ = 0;
    atlax::PixelSize size_;
    std::vector<std::byte> header_;  ///< the chunk IHDR
    std::vector<std::byte> body_;    ///< what stands between acTL and IEND
};

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
    AnimatedPng film_{1000 / framesPerSecond};
    std::uint64_t ticks_ = 0;
    std::uint64_t end_ = 0;    ///< tick of the last frame
    std::uint64_t first_ = 0;  ///< and of the first
};

}  // namespace quaoar
