// The drawing area as an atlax application: camera, pointer, time. The same with a window and
// without one.
#pragma once

#include <atlax/application.hpp>
#include <atlax/image.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "../model/load_watch.hpp"
#include "../model/workbench.hpp"
#include "guide_overlay.hpp"
#include "past_card.hpp"
#include "past_pictures.hpp"
#include "scene_film.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {

/// To what things snap: the fine grid of the view, corners, centres, angles.
struct SnapSwitches {
    bool grid = false;
    bool corners = false;
    bool centres = false;
    bool angles = false;
};

class SceneView final : public atlax::Application {
public:
    /// `bench` must outlive the view.
    explicit SceneView(Workbench& bench) : bench_(bench) {}

    // -- atlax --
    void start(atlax::Platform& platform) override;
    void event(const atlax::Event& event) override;
    void tick() override;
    void draw(atlax::Canvas& canvas, double alpha) override;
    /// Nothing plays, no film, and nobody is busy.
    bool atRest() const override;
    /// Nothing here is kept on the graphics card; onGraphicsLost tells others.
    bool restoreGraphics() override;
    void stop() override;

    /// Where bodies have their skins from; without it they are drawn without.
    void setSkins(SkinStore store);
    SkinTextures* textures() { return textures_ ? &*textures_ : nullptr; }

    // -- looking --
    ViewOptions& options() { return options_; }
    const ViewOptions& options() const { return options_; }
    /// Distance of the fine lines of the grid, metres.
    double fineStep() const;
    /// What things snap to.
    SnapSwitches& snapping() { return snapping_; }
    const SnapSwitches& snapping() const { return snapping_; }
    /// Shows all that is interesting, with the next frame, and again where the drawing area gets
    /// another size before anybody has touched it or time has run.
    void zoomToFit() { fitted_ = atlax::PixelSize{}; }
    /// Shows a rectangle with some room around it, with the next frame.
    void zoomTo(const Bounds& bounds) { wantedBounds_ = bounds; }
    void zoom(float factor);
    double metresPerPixel() const { return 1 / static_cast<double>(camera_.pixelsPerMetre); }
    /// Pixels of the drawing area for a place in the world, and back.
    atlax::Vec2 toPixels(const sulfur::Point& point) const;
    sulfur::Point toWorld(atlax::Vec2 pixels) const;
    /// Metres within which the pointer hits.
    double reach() const;
    /// Where the pointer is, metres; nothing until it was seen.
    std::optional<sulfur::Point> pointer() const;
    /// The same, nothing where it is not over the drawing area.
    std::optional<sulfur::Point> pointerInView() const;

    /// As the mouse: moves the pointer by metres, and presses the left button or lets it go. Twice
    /// at one place, within a second, is a double click. What is held with the press is held until
    /// the button goes up.
    void movePointer(const sulfur::Point& by);
    void switchButton(atlax::Modifiers held = atlax::Modifiers::None);
    /// Forgets a button that keys hold down; its tool must have been cancelled.
    void letGoOfKeys() { keyDown_ = false, keyClicks_ = 0, keysHeld_ = atlax::Modifiers::None; }

    /// Buttons of the mouse that went down or up so far; for scripts that wait for their clicks.
    std::uint64_t buttonEvents() const { return buttonEvents_; }
    std::optional<atlax::Vec2> mousePixels() const { return mouse_; }
    /// Films, the hand of a lesson.
    GuideOverlay& guide() { return guide_; }
    /// Frames that were drawn so far.
    std::uint64_t frames() const { return frames_; }

    // -- time --
    void setSpeedPermille(int permille);
    int speedPermille() const { return speedPermille_; }
    /// One tick with the next frame, pausing before it.
    void singleTick();
    /// Pauses at this simulated time, to the tick; while playing only.
    void pauseAt(double seconds) { pauseAt_ = seconds; }
    /// Pauses and goes to a recorded moment. Where that takes long it takes several frames, each of
    /// which shows a moment on the way.
    void seek(const Moment& moment);
    bool seeking() const { return wanted_.has_value(); }
    /// What was seen of the recorded past, small.
    const PastPictures& past() const { return past_; }
    /// Shows what was at a moment of the shown line, above a place of the lower edge, logical
    /// pixels from the left; where nothing was seen near it, or without a moment, nothing.
    void showPast(const std::optional<Moment>& moment, double x = 0) { pastCard_.ask(moment, x); }
    bool showsPast() const { return pastCard_.shown(); }
    /// Share of real time that the simulation reaches while it plays: 1 keeps up.
    double realTimeShare() const;
    /// What costs most of that while it does not keep up: "2400 contacts".
    std::string slowness() const { return realTimeShare() < 0.95 ? load_.cause() : ""; }
    /// Share of one core that the ticks take.
    double physicsLoad() const;
    double framesPerSecond() const;

    /// Shows a place in the middle, as large as things are now.
    void lookAt(const sulfur::Point& place) { camera_.centre = atlax::Vec2(place); }

    // -- others --
    /// Draws the scene in place of plain bodies; says whether it has.
    std::function<bool(atlax::Canvas&, const atlax::Camera&)> scenery;
    /// Draws over the scene, below the rulers.
    std::function<void(atlax::Canvas&, const atlax::Camera&, const atlax::Font&)> overlay;
    /// Gives the drawing area to another application with the next frame, in which `make` is
    /// called: it gets events and ticks, at this rate, and draws. It must live until dismiss().
    void invite(std::function<atlax::Application*(atlax::Canvas&)> make, int tickRate);
    void dismiss();
    bool hasGuest() const { return guest_ != nullptr || make_ != nullptr; }

    // -- the film --
    /// Begins to make a picture that moves of the last ten recorded seconds, seen as the scene is
    /// seen now, a bit with each frame. One that is being made is dropped. Precondition: something
    /// is recorded.
    void startFilm(const std::filesystem::path& file);
    /// 0..1 of one that is being made.
    std::optional<double> filmProgress() const;
    /// What is seen but for texts, rulers and what others draw. Also for films.
    void paintWorld(atlax::Canvas& canvas, const atlax::Camera& camera, ScenePainter& painter,
                    const ViewOptions& options, double alpha) const;

    // -- telling --
    /// A film is finished and written.
    std::function<void(const std::filesystem::path&)> onFilm;
    /// A file was dropped on the drawing area.
    std::function<void(const std::filesystem::path&)> onFile;
    /// Something did not work: one sentence. Without it the sentence goes to the log.
    std::function<void(const std::string&)> onProblem;
    /// After each frame.
    std::function<void()> onFrame;
    /// Whether somebody has work for every frame.
    std::function<bool()> busy;
    /// The canvas is another one: a guest was dismissed.
    std::function<void()> onGraphicsLost;
    /// Within each frame, for pictures of something else.
    std::function<void(atlax::Canvas&)> whileDrawing;

private:
    void applyTime();
    void letGuestIn(atlax::Canvas& canvas);
    void drawScene(atlax::Canvas& canvas, double alpha);
    void fit(atlax::PixelSize size);
    void mouseButton(const atlax::MouseButtonEvent& event);
    void mouseMoved(atlax::Vec2 position, atlax::Modifiers modifiers);
    SnapOptions snapOptions() const;
    void wheel(const atlax::WheelEvent& event);
    Pointer pointerAt(atlax::Vec2 position, atlax::Modifiers modifiers) const;
    void guarded(const std::function<void()>& body);
    void followSlider();
    void stepFilm(atlax::Canvas& canvas);
    void takePast(atlax::Canvas& canvas);
    void forgetPast();
    void paintRulerText(atlax::Canvas& canvas);
    void paintLabels(atlax::Canvas& canvas);
    void paintClock(atlax::Canvas& canvas);
    void paintGuide(atlax::Canvas& canvas);
    void paintPointer(atlax::Canvas& canvas) const;
    std::string clockState() const;

    Workbench& bench_;
    atlax::Platform* platform_ = nullptr;
    atlax::Application* guest_ = nullptr;
    std::function<atlax::Application*(atlax::Canvas&)> make_;
    int guestRate_ = 500;
    std::optional<atlax::Font> font_;
    std::optional<SkinTextures> textures_;
    ScenePainter painter_;
    GuideOverlay guide_;
    std::int64_t drawnNs_ = 0;
    ViewOptions options_;
    atlax::Camera camera_{{0, 2}, 90};
    std::optional<atlax::Vec2> mouse_;
    bool byKeys_ = false;  ///< keys have moved the pointer, and not the mouse since
    bool keyDown_ = false;
    atlax::Modifiers keysHeld_ = atlax::Modifiers::None;  ///< with the button that keys hold down
    int keyClicks_ = 0;  ///< at this place
    std::int64_t keyPressedNs_ = 0;
    std::optional<atlax::Vec2> panFrom_;
    /// Size of the drawing area that all fits into, nothing once somebody has touched the view.
    std::optional<atlax::PixelSize> fitted_ = atlax::PixelSize{};
    std::optional<Bounds> wantedBounds_;
    SnapSwitches snapping_;
    int speedPermille_ = 1000;
    int singles_ = 0;  // ticks asked for while paused
    std::optional<double> pauseAt_;
    std::optional<Moment> wanted_;  // on the way there
    PastPictures past_;
    PastCard pastCard_;
    atlax::RenderTarget pastTarget_;
    std::uint64_t buttonEvents_ = 0;
    std::uint64_t frames_ = 0;
    LoadWatch load_;
    std::unique_ptr<SceneFilm> film_;  // that is being made
};

}  // namespace sulfurchamber
