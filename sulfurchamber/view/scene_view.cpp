#include "scene_view.hpp"

#include <algorithm>
#include <array>
#include <atlax/backend.hpp>
#include <atlax/crash_report.hpp>
#include <atlax/log.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "../model/geometry.hpp"
#include "../model/words.hpp"
#include "debug_painter.hpp"
#include "fitting_camera.hpp"
#include "force_painter.hpp"
#include "grid_painter.hpp"
#include "meter_painter.hpp"
#include "palette.hpp"

namespace sulfurchamber {
namespace {

constexpr std::int64_t keyDoubleClickNs = 1'000'000'000;

constexpr float minZoom = 0.5f;  // pixels per metre
constexpr float maxZoom = 20000;
constexpr float zoomPerNotch = 1.18f;
constexpr float rulersTake = 44;         // logical pixels at the left and at the bottom
constexpr float mostCropped = 1.25f;     // how much larger pictures of the past are for that
constexpr double seekMilliseconds = 12;  // of a frame that the way to a moment may take

}  // namespace

void SceneView::start(atlax::Platform& platform) {
    platform_ = &platform;
    font_ = atlax::Font::standard();
    painter_.setFont(&*font_);
    applyTime();
}

void SceneView::setSkins(SkinStore store) {
    textures_.emplace(std::move(store));
    painter_.setTextures(&*textures_);
}

// The document decides about time; the clock follows.
void SceneView::applyTime() {
    if (platform_ == nullptr) return;
    atlax::FixedTimestep& clock = platform_->clock();
    const bool guest = guest_ != nullptr;
    const int rate = guest ? guestRate_ : bench_.document().world().settings().tickRate;
    if (clock.rateHz() != rate) clock.setRateHz(rate);
    if (!bench_.document().playing()) bench_.controls().release();
    clock.setPaused(!guest && !bench_.document().playing());
    clock.setSpeedPermille(guest ? 1000 : speedPermille_);
}

// --- guests ----------------------------------------------------------------------------------

void SceneView::invite(std::function<atlax::Application*(atlax::Canvas&)> make, int tickRate) {
    dismiss();
    bench_.cancel();
    bench_.document().pause();
    make_ = std::move(make);
    guestRate_ = tickRate;
}

void SceneView::letGuestIn(atlax::Canvas& canvas) {
    if (!make_) return;
    const auto make = std::exchange(make_, nullptr);
    guarded([&] {
        atlax::Application* guest = make(canvas);
        guest->start(*platform_);
        guest_ = guest;
    });
    applyTime();
}

void SceneView::dismiss() {
    make_ = nullptr;
    if (guest_ != nullptr) guest_->stop();
    guest_ = nullptr;
    applyTime();
}

bool SceneView::restoreGraphics() {
    if (textures_) textures_->forget();
    forgetPast();
    dismiss();
    if (onGraphicsLost) onGraphicsLost();
    return true;
}

void SceneView::stop() {
    forgetPast();
    dismiss();
    if (onGraphicsLost) onGraphicsLost();
    platform_ = nullptr;
}

void SceneView::setSpeedPermille(int permille) {
    speedPermille_ = std::clamp(permille, 1, 10000);
    applyTime();
}

void SceneView::singleTick() {
    bench_.document().pause();
    applyTime();
    if (platform_ == nullptr) return;
    platform_->clock().singleTick();
    ++singles_;
}

void SceneView::seek(const Moment& moment) {
    guarded([&] { bench_.cancel(); });
    bench_.document().pause();
    wanted_ = moment;
    applyTime();
}

void SceneView::followSlider() {
    if (!wanted_) return;
    const Document& document = bench_.document();
    // Who plays on, or opens another scene, no longer wants to be there.
    if (document.playing() || document.timeline().empty()) {
        wanted_.reset();
        return;
    }
    guarded([&] {
        if (bench_.document().goTo(*wanted_, seekMilliseconds)) wanted_.reset();
        bench_.documentChanged();
    });
}

double SceneView::realTimeShare() const {
    if (platform_ == nullptr || !bench_.document().playing()) return 1;
    return 1 - platform_->clock().overload();
}

double SceneView::physicsLoad() const {
    if (platform_ == nullptr || !bench_.document().playing()) return 0;
    return platform_->statistics().tickMilliseconds / 1000 * platform_->clock().rateHz() *
           speedPermille_ / 1000.0;
}

double SceneView::framesPerSecond() const {
    return platform_ == nullptr ? 0 : platform_->statistics().framesPerSecond;
}

void SceneView::guarded(const std::function<void()>& body) {
    try {
        body();
    } catch (const std::exception& error) {
        bench_.cancel();
        if (onProblem)
            onProblem(error.what());
        else
            atlax::log(atlax::LogLevel::Warning, error.what());
    }
}

// --- events ----------------------------------------------------------------------------------

void SceneView::event(const atlax::Event& event) {
    if (guest_ != nullptr) {
        if (const auto* moved = std::get_if<atlax::MouseMoved>(&event)) mouse_ = moved->position;
        if (std::holds_alternative<atlax::MouseButtonEvent>(event)) ++buttonEvents_;
        guest_->event(event);
        return;
    }
    if (const auto* moved = std::get_if<atlax::MouseMoved>(&event)) {
        byKeys_ = false;
        keyClicks_ = 0;
        mouseMoved(moved->position, moved->modifiers);
    }
    if (const auto* button = std::get_if<atlax::MouseButtonEvent>(&event)) {
        letGoOfKeys();
        mouseButton(*button);
    }
    if (const auto* turned = std::get_if<atlax::WheelEvent>(&event)) wheel(*turned);
    if (const auto* focus = std::get_if<atlax::FocusChanged>(&event); focus && !focus->focused) {
        guarded([&] { bench_.cancel(); });
        bench_.controls().release();
        panFrom_.reset();
        letGoOfKeys();
    }
    if (const auto* dropped = std::get_if<atlax::FileDropped>(&event); dropped && onFile)
        onFile(dropped->file);
}

double SceneView::reach() const {
    const float scale = platform_ == nullptr ? 1.0f : platform_->scaleFactor();
    return static_cast<double>(reachPixels * scale / camera_.pixelsPerMetre);
}

Pointer SceneView::pointerAt(atlax::Vec2 position, atlax::Modifiers modifiers) const {
    Pointer pointer;
    pointer.position = toWorld(position);
    pointer.reach = reach();
    pointer.shift = has(modifiers, atlax::Modifiers::Shift);
    pointer.control = has(modifiers, atlax::Modifiers::Control);
    pointer.alt = has(modifiers, atlax::Modifiers::Alt);
    return pointer;
}

void SceneView::mouseButton(const atlax::MouseButtonEvent& event) {
    mouse_ = event.position;
    ++buttonEvents_;
    fitted_.reset();
    if (event.button == atlax::MouseButton::Middle || event.button == atlax::MouseButton::Right) {
        panFrom_ = event.down ? std::optional(event.position) : std::nullopt;
        return;
    }
    if (event.button != atlax::MouseButton::Left) return;
    Pointer pointer = pointerAt(event.position, event.modifiers);
    pointer.clicks = event.clicks;
    bench_.setSnapping(snapOptions());
    guarded([&] { event.down ? bench_.press(pointer) : bench_.release(pointer); });
}

SnapOptions SceneView::snapOptions() const {
    return {snapping_.grid ? fineStep() : 0, snapping_.corners, snapping_.centres,
            snapping_.angles};
}

double SceneView::fineStep() const {
    const float scale = platform_ == nullptr ? 1.0f : platform_->scaleFactor();
    return gridSteps(camera_.pixelsPerMetre, scale, options_.gridStep).fine;
}

void SceneView::mouseMoved(atlax::Vec2 position, atlax::Modifiers modifiers) {
    mouse_ = position;
    if (panFrom_) {
        const atlax::Vec2 by = (position - *panFrom_) / camera_.pixelsPerMetre;
        camera_.centre += {-by.x, by.y};
        panFrom_ = position;
    }
    bench_.setSnapping(snapOptions());
    guarded([&] { bench_.move(pointerAt(position, modifiers)); });
}

// It begins on a line of the grid, and the view follows it beyond its edges.
void SceneView::movePointer(const sulfur::Point& by) {
    if (platform_ == nullptr || guest_ != nullptr) return;
    const atlax::Vec2 size = platform_->size().toVec();
    const auto inside = [&](atlax::Vec2 pixels) {
        const float edge = std::min({12.0f, size.x / 2, size.y / 2});
        return atlax::Vec2{std::clamp(pixels.x, edge, size.x - edge),
                           std::clamp(pixels.y, edge, size.y - edge)};
    };
    sulfur::Point place = toWorld(inside(mouse_.value_or(size * 0.5f)));
    if (!byKeys_) place = (place / fineStep()).array().round().matrix() * fineStep();
    const atlax::Vec2 wanted = toPixels(place + by), to = inside(wanted);
    const atlax::Vec2 beyond = (wanted - to) / camera_.pixelsPerMetre;
    camera_.centre += {beyond.x, -beyond.y};
    if (beyond.x != 0 || beyond.y != 0) fitted_.reset();
    byKeys_ = true;
    keyClicks_ = 0;
    mouseMoved(to, keysHeld_);
}

void SceneView::switchButton(atlax::Modifiers held) {
    if (!mouse_) movePointer({0, 0});
    if (!mouse_ || guest_ != nullptr) return;
    byKeys_ = true;
    keyDown_ = !keyDown_;
    if (keyDown_) {
        const std::int64_t now = atlax::monotonicNs();
        const bool follows = now - std::exchange(keyPressedNs_, now) < keyDoubleClickNs;
        keyClicks_ = follows && held == atlax::Modifiers::None ? keyClicks_ + 1 : 1;
        keysHeld_ = held;
    }
    mouseButton({atlax::MouseButton::Left, keyDown_, *mouse_, keyClicks_ > 1 ? 2 : 1, keysHeld_});
    if (!keyDown_) keysHeld_ = atlax::Modifiers::None;
}

// A cross where keys have moved the pointer, and a disc in it while its button is down.
void SceneView::paintPointer(atlax::Canvas& canvas) const {
    if (!byKeys_ || !mouse_) return;
    const float scale = canvas.scaleFactor();
    canvas.setScreenSpace(scale);
    const atlax::Vec2 at = *mouse_ / scale, across{11, 0}, up{0, 11};
    canvas.line(at - across, at + across, 2, palette::ice);
    canvas.line(at - up, at + up, 2, palette::ice);
    if (keyDown_) canvas.circle(at, 5, palette::ice);
}

void SceneView::wheel(const atlax::WheelEvent& event) {
    mouse_ = event.position;
    zoom(std::pow(zoomPerNotch, event.notches.y));
}

// The point under the pointer stays under the pointer.
void SceneView::zoom(float factor) {
    if (platform_ == nullptr) return;
    fitted_.reset();
    const atlax::PixelSize size = platform_->size();
    const atlax::Vec2 fixed = mouse_.value_or(size.toVec() * 0.5f);
    const atlax::Vec2 before = camera_.toWorld(fixed, size);
    camera_.pixelsPerMetre = std::clamp(camera_.pixelsPerMetre * factor, minZoom, maxZoom);
    camera_.centre += before - camera_.toWorld(fixed, size);
}

atlax::Vec2 SceneView::toPixels(const sulfur::Point& point) const {
    return camera_.toScreen(point, platform_ == nullptr ? atlax::PixelSize{} : platform_->size());
}

sulfur::Point SceneView::toWorld(atlax::Vec2 pixels) const {
    const auto world =
        camera_.toWorld(pixels, platform_ == nullptr ? atlax::PixelSize{} : platform_->size());
    return {static_cast<double>(world.x), static_cast<double>(world.y)};
}

std::optional<sulfur::Point> SceneView::pointer() const {
    if (!mouse_) return std::nullopt;
    return toWorld(*mouse_);
}

std::optional<sulfur::Point> SceneView::pointerInView() const {
    if (!mouse_ || platform_ == nullptr) return std::nullopt;
    const atlax::Vec2 size = platform_->size().toVec();
    const bool in = mouse_->x >= 0 && mouse_->y >= 0 && mouse_->x < size.x && mouse_->y < size.y;
    return in ? pointer() : std::nullopt;
}

void SceneView::fit(atlax::PixelSize size) {
    const float scale = platform_ == nullptr ? 1.0f : platform_->scaleFactor();
    const float rulers = options_.rulers ? rulersTake * scale : 0;
    camera_ = fittingCamera(
        bench_.document(),
        {size.width - static_cast<int>(rulers), size.height - static_cast<int>(rulers / 2)},
        wantedBounds_);
    camera_.centre += atlax::Vec2{-rulers / 2, -rulers / 4} / camera_.pixelsPerMetre;
}

// --- time and drawing ------------------------------------------------------------------------

// The clock may have more ticks due in this frame when the document has just been paused.
void SceneView::tick() {
    if (guest_ != nullptr) {
        guarded([&] { guest_->tick(); });
        return;
    }
    Document& document = bench_.document();
    const double now =
        document.world().time() + static_cast<double>(document.world().tickDuration()) / 2;
    if (pauseAt_ && document.playing() && now >= *pauseAt_) {
        pauseAt_.reset();
        document.pause();
    }
    if (!document.playing() && singles_ == 0) return;
    singles_ = std::max(0, singles_ - 1);
    load_.beforeTick(document.world());
    guarded([&] { bench_.tick(); });
    const sulfur::World& world = document.world();
    load_.afterTick(world);
    if (world.ticks() % static_cast<std::uint64_t>(world.settings().tickRate) == 0)
        atlax::setCrashState(world.ticks(), world.hash());
}

void SceneView::draw(atlax::Canvas& canvas, double alpha) {
    ++frames_;
    letGuestIn(canvas);
    if (guest_ != nullptr)
        guest_->draw(canvas, alpha);
    else
        drawScene(canvas, alpha);
    if (onFrame) onFrame();
    applyTime();
}

bool SceneView::atRest() const {
    const bool moves = hasGuest() || bench_.document().playing() || singles_ > 0;
    const bool shows = seeking() || film_ || guide_.moves();
    return !moves && !shows && !(busy && busy());
}

void SceneView::drawScene(atlax::Canvas& canvas, double alpha) {
    followSlider();
    if (wantedBounds_) {
        fit(canvas.size());
        fitted_.reset();
    } else if (fitted_ && *fitted_ != canvas.size()) {
        // What has moved may be far away.
        if (fitted_->empty() || !bench_.document().canReset()) fit(canvas.size());
        fitted_ = canvas.size();
    }
    wantedBounds_.reset();
    stepFilm(canvas);
    takePast(canvas);
    options_.bodies = !(scenery && scenery(canvas, camera_));
    std::optional<palette::During> night;
    if (!options_.bodies) night.emplace(palette::dark);
    // Paused, the state itself is shown: a single tick is seen at once.
    paintWorld(canvas, camera_, painter_, options_, bench_.document().playing() ? alpha : 1.0);
    if (overlay) overlay(canvas, camera_, *font_);
    paintForces(canvas, camera_, bench_.document().world(), options_);
    paintMeters(canvas, camera_, *font_, bench_, bench_.document().playing() ? alpha : 1.0);
    if (options_.rulers) paintRulers(canvas, camera_, *font_, options_.gridStep);
    paintLegend(canvas, camera_, *font_, bench_.document().world(), options_);
    paintRulerText(canvas);
    paintLabels(canvas);
    paintClock(canvas);
    paintGuide(canvas);
    paintPointer(canvas);
    night.reset();
    pastCard_.paint(canvas, past_, bench_.document());
    if (whileDrawing) whileDrawing(canvas);
}

void SceneView::paintGuide(atlax::Canvas& canvas) {
    const std::int64_t now = atlax::monotonicNs();
    const double seconds = static_cast<double>(now - std::exchange(drawnNs_, now)) / 1e9;
    guide_.paint(canvas, *font_, bench_, camera_, options_.rulers ? rulersTake : 0, seconds);
}

void SceneView::paintWorld(atlax::Canvas& canvas, const atlax::Camera& camera,
                           ScenePainter& painter, const ViewOptions& options, double alpha) const {
    if (options.bodies)
        canvas.gradientRect({{0, 0}, canvas.size().toVec()}, palette::above, palette::deep);
    canvas.setCamera(camera);
    if (options.grid) paintGrid(canvas, camera, options.gridStep);
    painter.paint(canvas, bench_, options, alpha);
    if (!options.skeleton) return;
    canvas.setCamera(camera);
    paintDebug(canvas, bench_.document().world(), alpha);
}

// --- the past --------------------------------------------------------------------------------

// What is seen now, so small that it costs little. Without texts: nobody could read them.
void SceneView::takePast(atlax::Canvas& canvas) {
    const std::int64_t before = atlax::monotonicNs();
    if (!past_.due(bench_.document(), before)) return;
    if (!pastTarget_.valid()) pastTarget_ = canvas.createTarget(PastPictures::size);
    const atlax::Vec2 whole = canvas.size().toVec();
    const atlax::Vec2 small = PastPictures::size.toVec();
    // Its edges go, so far as that makes the rest larger.
    const auto [least, most] = std::minmax({small.x / whole.x, small.y / whole.y});
    atlax::Camera camera = camera_;
    camera.pixelsPerMetre *= std::min(most, mostCropped * least);
    ViewOptions options = options_;
    options.tools = options.grid = false;
    options.bodies = true;
    painter_.setFont(nullptr);
    canvas.pushTarget(pastTarget_);
    paintWorld(canvas, camera, painter_, options, 1);
    canvas.popTarget();
    painter_.setFont(&*font_);
    atlax::Image image = canvas.read(pastTarget_);
    const std::int64_t after = atlax::monotonicNs();
    past_.add(bench_.document(), std::move(image), after, after - before);
}

void SceneView::forgetPast() {
    pastTarget_ = {};
    pastCard_.forgetTexture();
}

// --- the film --------------------------------------------------------------------------------

void SceneView::startFilm(const std::filesystem::path& file) {
    if (platform_ == nullptr) return;
    film_ = std::make_unique<SceneFilm>(*this, bench_.document(), camera_, platform_->size(), file);
}

// A few milliseconds of each frame, so that nobody waits for it.
void SceneView::stepFilm(atlax::Canvas& canvas) {
    if (!film_) return;
    try {
        if (!film_->step(canvas)) return;
        const auto file = film_->file();
        film_.reset();
        if (onFilm) onFilm(file);
    } catch (const std::exception& error) {
        film_.reset();
        if (onProblem) onProblem(error.what());
    }
}

std::optional<double> SceneView::filmProgress() const {
    return film_ ? std::optional(film_->progress()) : std::nullopt;
}

// Length and angle beside the middle of the ruler.
void SceneView::paintRulerText(atlax::Canvas& canvas) {
    const Preview preview = bench_.preview();
    if (preview.kind != Preview::Kind::ruler || !(preview.size > 0)) return;
    const float scale = canvas.scaleFactor();
    const sulfur::Point by = preview.to - preview.from;
    const std::string text = fixed(preview.size, 3) + " m  " +
                             fixed(std::atan2(by.y(), by.x()) * 180 / std::numbers::pi, 1) + "°";
    const sulfur::Point middle = (preview.from + preview.to) / 2;
    const atlax::Vec2 at = camera_.toScreen(atlax::Vec2(middle), canvas.size()) / scale;
    canvas.setScreenSpace(scale);
    canvas.text(*font_, text, {at.x + 12, at.y - 8}, {16, palette::ice});
}

// How large what one draws is: on plates, so that they are read before anything.
void SceneView::paintLabels(atlax::Canvas& canvas) {
    constexpr float size = 14;
    const float scale = canvas.scaleFactor();
    for (const Label& label : bench_.preview().labels) {
        const atlax::Vec2 at = camera_.toScreen(atlax::Vec2(label.at), canvas.size()) / scale;
        canvas.setScreenSpace(scale);
        const float width = canvas.measure(*font_, label.text, size).width;
        const atlax::Rect plate{{at.x - width / 2 - 6, at.y - 10}, {width + 12, 20}};
        canvas.roundedRect(plate, 4, palette::deep.withAlpha(0.82f));
        canvas.text(*font_, label.text, at,
                    {size, palette::ice, atlax::AlignX::Centre, atlax::AlignY::Middle});
    }
}

void SceneView::paintClock(atlax::Canvas& canvas) {
    const float scale = canvas.scaleFactor();
    canvas.setScreenSpace(scale);
    const float right = canvas.size().toVec().x / scale - 14;
    const std::string text = fixed(bench_.document().world().time(), 2) + " s";
    const bool playing = bench_.document().playing();
    canvas.text(*font_, text, {right, 28},
                {20, playing ? palette::ice : palette::sky, atlax::AlignX::Right});
    const std::string state = clockState();
    canvas.text(*font_, state, {right, 46}, {13, palette::amber, atlax::AlignX::Right});
    if (!film_) return;
    canvas.text(*font_, tr("film {} %", {fixed(100 * film_->progress(), 0)}), {right, 64},
                {13, palette::ice, atlax::AlignX::Right});
}

// Below the clock: how time runs, or where in the past one is.
std::string SceneView::clockState() const {
    const Document& document = bench_.document();
    if (document.playing()) {
        if (speedPermille_ == 1000) return "";
        std::array<char, 32> factor{};
        std::snprintf(factor.data(), factor.size(), " \xC3\x97%g", speedPermille_ / 1000.0);
        return (speedPermille_ < 1000 ? tr("slow motion") : tr("fast")) + factor.data();
    }
    const auto& now = document.timeline().now();
    if (!now) return tr("paused");
    const std::uint64_t left = document.timeline().last(now->branch) - now->tick;
    if (left == 0) return tr("paused");
    const std::string ago =
        fixed(static_cast<double>(left) * static_cast<double>(document.world().tickDuration()), 2);
    // What was edited later is in the plan, but not here.
    std::size_t later = 0;
    std::string label;
    for (const Mark& mark : document.timeline().marks(now->branch))
        if (mark.kind == Mark::Kind::edit && mark.tick > now->tick && ++later == 1)
            label = mark.label;
    if (later == 1) return tr("{} s before the end, before “{}”", {ago, tr(label)});
    if (later > 1) return tr("{} s before the end, before {} edits", {ago, std::to_string(later)});
    return tr("{} s before the end", {ago});
}

}  // namespace sulfurchamber
