#include "game.hpp"

#include <algorithm>
#include <atlax/crash_report.hpp>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cmath>

#include "overlay.hpp"

namespace quaoar {

namespace {
/// Between reaching the gate and the screen that says so: one second to see it happen.
constexpr int finishDelay = Session::tickRate;
/// Ten times a second a crash report's state is brought up to date.
constexpr std::uint64_t ticksPerState = Session::tickRate / 10;
}  // namespace

Game::Game(GameOptions options, Preferences& preferences)
    : options_(std::move(options)),
      preferences_(preferences),
      session_(std::make_unique<Session>(options_.level)),
      recording_(*options_.level),
      best_(preferences.best(options_.level->id)) {
    preferences_.readBindings(actions_);
    chooseLanguage(options_.language.value_or(preferences_.language()));
}

void Game::start(atlax::Platform& platform) {
    platform_ = &platform;
    makePictures();
    sounds_ = std::make_unique<Sounds>(platform.audio());
    applyVolume();
    if (options_.replay) {
        watch(options_.replay);
    } else if (options_.skipTitle) {
        play();
    } else {
        show(Screen::title);
    }
}

void Game::makePictures() {
    const std::unique_ptr<GameView> before = std::move(view_);
    art_ = std::make_unique<Art>(platform_->canvas());
    view_ = std::make_unique<GameView>(*art_, *session_);
    if (before) view_->resume(*before);
}

bool Game::restoreGraphics() {
    makePictures();
    return true;
}

void Game::play() {
    playback_.reset();
    session_->restart();
    view_->cut();
    recording_.clear();
    saved_ = false;
    afterFinish_ = 0;
    atlax::log(atlax::LogLevel::Info, "level " + session_->level().id + " begins");
    show(Screen::playing);
}

void Game::watch(std::shared_ptr<const Recording> recording) {
    play();
    playback_ = std::make_unique<Playback>(std::move(recording));
}

void Game::toTitle() {
    playback_.reset();
    session_->restart();
    show(Screen::title);
}

void Game::event(const atlax::Event& event) {
    const auto* focus = std::get_if<atlax::FocusChanged>(&event);
    if (focus != nullptr && !focus->focused && screen_ == Screen::playing) show(Screen::paused);
    if (screen_ == Screen::capture) capture(event);
}

void Game::leaveWithPause() {
    switch (screen_) {
        case Screen::playing:
            return show(Screen::paused);
        case Screen::paused:
            return show(Screen::playing);
        case Screen::finished:
            return toTitle();
        case Screen::options:
            return show(below_);
        case Screen::bindings:
            return show(Screen::options);
        case Screen::title:
        case Screen::capture:
            break;
    }
}

void Game::act(const atlax::ActionState& state) {
    if (state.wasPressed(actions_.fullscreen)) toggleFullscreen();
    if (state.wasPressed(actions_.picture)) takePicture();
    if (state.wasPressed(actions_.pause)) {
        leaveWithPause();
        return;
    }
    if (screen_ == Screen::playing || screen_ == Screen::capture) return;
    const bool again = screen_ == Screen::finished || screen_ == Screen::paused;
    if (again && state.wasPressed(actions_.restart)) {
        play();
        return;
    }
    if (const auto chosen = menu_.tick(state, actions_)) {
        sounds_->click();
        chosen();
    }
}

void Game::tick() {
    ++time_;
    const atlax::ActionState& state = actions_.all.sample(platform_->input());
    const bool played = screen_ == Screen::playing;
    act(state);
    if (scene() == Screen::paused) return;
    // The tick that ends a menu is not yet one of the level, nor the other way round.
    if (played && screen_ == Screen::playing)
        tickSession(state);
    else if (screen_ != Screen::playing)
        tickScene();
}

/// Behind title and finish the world goes on by itself.
void Game::tickScene() {
    session_->tick(TickInput{});
    view_->tick();
    if (scene() != Screen::title) return;
    const Level& level = session_->level();
    const double sweep = 0.5 - 0.5 * std::cos(static_cast<double>(time_) * 0.00021);
    const double low = level.boundsMin.x() + 4, high = level.boundsMax.x() - 4;
    view_->lookAt({static_cast<float>(low + (high - low) * sweep),
                   static_cast<float>((level.spawn.y() + level.exit.position.y()) * 0.5 + 0.6)});
}

void Game::tickSession(const atlax::ActionState& state) {
    const TickInput input = nextInput(state);
    session_->tick(input);
    view_->tick();
    sounds_->tick(*session_);
    remember(input);
    if (session_->ticks() % ticksPerState == 0)
        atlax::setCrashState(session_->ticks(), session_->hash());
    if (session_->events().finished) finish();
    const bool over = watching() && playback_->done();
    if (session_->phase() == Session::Phase::finished || over) {
        if (++afterFinish_ > finishDelay) show(Screen::finished);
    }
}

TickInput Game::nextInput(const atlax::ActionState& state) {
    if (watching()) return playback_->next();
    return controls_.read(state, view_->camera(platform_->size()), platform_->size(),
                          atlax::Vec2(session_->heroPosition()));
}

void Game::remember(const TickInput& input) {
    if (watching()) return;
    if (session_->events().restarted) {
        recording_.clear();
        return;
    }
    const bool over = session_->phase() == Session::Phase::finished && !session_->events().finished;
    if (!over) recording_.append(input);
}

void Game::finish() {
    if (watching()) return;
    atlax::log(atlax::LogLevel::Info,
               "level " + session_->level().id + " finished in " + clockText(session_->seconds()));
    if (best_ <= 0 || session_->seconds() < best_) {
        best_ = session_->seconds();
        preferences_.setBest(session_->level().id, best_);
        savePreferences();
    }
    recording_.finalHash = session_->hash();
    lastRun_ = std::make_shared<const Recording>(recording_);
    saveRecording();
}

void Game::saveRecording() {
    if (!options_.record || recording_.ticks() == 0) return;
    recording_.write(*options_.record);
    saved_ = true;
    atlax::log(atlax::LogLevel::Info, "recorded to " + options_.record->string());
}

void Game::takePicture() {
    for (int number = 1; number < 10000; ++number) {
        const auto file = atlax::dataFolder("quaoar") / "pictures" /
                          ("quaoar-" + std::to_string(number) + ".png");
        if (std::filesystem::exists(file)) continue;
        platform_->requestScreenshot(file);
        atlax::log(atlax::LogLevel::Info, "picture goes to " + file.string());
        return;
    }
}

/// Between two frames, waiting for the display and all: what the player sees.
void Game::timeFrame() {
    const auto now = std::chrono::steady_clock::now();
    if (lastFrame_) governor_.frame(std::chrono::duration<double>(now - *lastFrame_).count());
    lastFrame_ = now;
}

void Game::draw(atlax::Canvas& canvas, double alpha) {
    timeFrame();
    const bool playing = screen_ == Screen::playing;
    ViewOptions options;
    options.texts = &texts_;
    options.quality = governor_.quality();
    options.aim = playing && !watching();
    options.hints = scene() != Screen::title;
    if (options.aim && controls_.mouseAims()) options.crosshair = platform_->input().mouse;
    view_->draw(canvas, scene() == Screen::paused ? 1 : alpha, options);
    const OverlayTools tools{canvas, *art_, texts_};
    if (scene() != Screen::title) drawStatus(tools, *session_, watching());
    if (playing && session_->restarts() <= 1) {
        drawLevelName(tools, session_->level(),
                      static_cast<double>(session_->ticks()) / Session::tickRate);
    }
    drawScreen(canvas);
}

/// An attempt that never reached the exit is kept too: it may show where somebody got stuck.
void Game::stop() {
    savePreferences();
    if (!saved_ && !watching()) {
        recording_.finalHash = session_->hash();
        saveRecording();
    }
}

}  // namespace quaoar
