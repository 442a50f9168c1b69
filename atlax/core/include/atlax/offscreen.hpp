#pragma once

#include <filesystem>
#include <memory>

#include <atlax/canvas.hpp>

namespace atlax {

/// An OpenGL 3.3 core context without a window and without a display (EGL surfaceless; Mesa's
/// software renderer suffices). Current in the creating thread. For programs without a window:
/// where a window's context is current, draw into a target of its canvas instead.
class OffscreenContext {
public:
    /// Throws Error that says what is missing on this machine.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    void makeCurrent();

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

/// A canvas whose frames become pictures: for screenshots, tests and machines without display. Owns
/// its context, its canvas and its target. The thread that made it; what throws is said.
///
///     OffscreenCanvas offscreen({1280, 720});
///     Canvas& canvas = offscreen.begin();
///     canvas.circle({640, 360}, 50, colors::white);
///     offscreen.finish(); savePng(offscreen.image(), "circle.png");
class OffscreenCanvas {
public:
    /// Throws Error as OffscreenContext, Canvas and Canvas::createTarget do.
    explicit OffscreenCanvas(PixelSize size, float scaleFactor = 1);
    ~OffscreenCanvas();

    /// For loading textures between frames.
    Canvas& canvas() { return *canvas_; }
    /// Starts a frame; what the last one drew is cleared to transparent.
    Canvas& begin();
    /// Ends the frame.
    void finish();
    /// The last finished frame.
    Image image();

    /// What frames are drawn into; for Canvas::beginFrame.
    const RenderTarget& target() const { return target_; }
    PixelSize size() const { return target_.size(); }
    void resize(PixelSize size);

private:
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Canvas> canvas_;
    RenderTarget target_;
    float scaleFactor_;
};

}  // namespace atlax
