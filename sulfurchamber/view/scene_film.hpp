// The last seconds of a scene as an animated picture.
#pragma once

#include <atlax/animated_png.hpp>
#include <atlax/canvas.hpp>
#include <filesystem>
#include <memory>

#include "../model/document.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {

class SceneView;

/// Replays what is recorded in a world of its own, a few milliseconds with each frame of the
/// window, and draws it as the scene was seen when the film began. Whoever goes on playing or
/// editing does not disturb it, unless so much is recorded meanwhile that the moments are
/// forgotten. Needs the canvas's context; one thread.
class SceneFilm {
public:
    static constexpr double mostSeconds = 10;
    static constexpr int delay = 80;       ///< milliseconds between two pictures
    static constexpr int mostSide = 480;   ///< pixels of the longer side
    static constexpr double patience = 8;  ///< milliseconds of a frame of the window

    /// Of the recorded line up to its present moment. `view` and `document` must outlive it; `size`
    /// is that of the drawing area. Precondition: something is recorded.
    SceneFilm(const SceneView& view, Document& document, const atlax::Camera& camera,
              atlax::PixelSize size, std::filesystem::path file);

    /// To be called in each frame. Whether it is done, and the file written. Throws atlax::Error
    /// when that fails, std::runtime_error when what it shows is no longer recorded.
    bool step(atlax::Canvas& canvas);
    /// 0..1
    double progress() const;
    const std::filesystem::path& file() const { return file_; }
    int frames() const { return film_.frames(); }

private:
    const SceneView& view_;
    Document& document_;
    atlax::Camera camera_;
    atlax::PixelSize size_;
    ViewOptions options_;
    ScenePainter painter_;
    std::filesystem::path file_;
    std::unique_ptr<sulfur::World> world_;
    atlax::RenderTarget target_;
    atlax::AnimatedPng film_{delay};
    Moment next_;  ///< of the next picture
    std::uint64_t first_ = 0;
    std::uint64_t last_ = 0;
    std::uint64_t ticksPerPicture_ = 1;
};

}  // namespace sulfurchamber
