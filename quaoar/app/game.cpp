#include "game.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cmath>

#include "overlay.hpp"

namespace quaoar {

using atlax::Key;

namespace {
/// Between reaching the gate and the screen that says so: one second to see it happen.
constexpr int finishDelay = Session::tickRate;
}  // namespace

Game::Game(GameOptions options)
    : options_(std::move(options)),
      session_(std::make_unique<Session>(options_.level)),
      recording_(*options_.level) {}

void Game::start(atlax::Platform& platform) {
    platform_ = &platform;
    art_ = std::make_unique<Art>(platform.canvas());
    view_ = std::make_unique<GameView>(*art_, *session_);
    sounds_ = std::make_unique<Sounds>(platform.audio());
    if (options_.replay) {
        watch(options_.replay);
    } else if (options_.skipTitle) {
        play();
    } else {
        show(Screen::title);
    }
}

void Game::show(Screen screen) {
    screen_ = screen;
    switch (screen) {
        case Screen::title:
            menu_ = Menu({"Play", "Quit"});
            break;
        case Screen::paused:
            menu_ = Menu({"Go on", "Try again", "Title screen", "Quit"});
            break;
        case Screen::finished:
            menu_ = Menu({"Play again", "Watch replay", "Title screen", "Quit"});
            break;
        case Screen::playing:
            menu_ = Menu();
            break;
    }
    if (screen != Screen::playing) sounds_->hush();
    platform_->setCursorVisible(screen != Screen::playing);
    if (screen == Screen::playing) controls_.requireFreshFire();
}

void Game::play() {
    playback_.reset();
    session_->restart();
    view_->cut();
    recording_.clear();
    saved_ = false;
    afterFinish_ = 0;
    show(Screen::playing);
}

void Game::watch(std::shared_ptr<const Recording> recording) {
    play();
    playback_ = std::make_unique<Playback>(std::move(recording));
}

void Game::event(const atlax::Event& event) {
    if (const auto* focus = std::get_if<atlax::FocusChanged>(&event)) {
        if (!focus->focused && screen_ == Screen::playing) show(Screen::paused);
    }
    if (const auto* pad = std::get_if<atlax::PadButtonEvent>(&event); pad && pad->down) {
        if (pad->button == atlax::PadButton::Start) {
            keyPressed(Key::Escape);
            return;
        }
    }
    if (const auto* key = std::get_if<atlax::KeyEvent>(&event); key && key->down && !key->repeat) {
        keyPressed(key->key);
    }
    if (screen_ == Screen::playing) return;
    if (const auto item = menu_.event(event)) {
        sounds_->click();
        choose(*item);
    }
}

void Game::keyPressed(Key key) {
    if (key == Key::F11) platform_->setFullscreen(!platform_->fullscreen());
    if (key == Key::F12) takePicture();
    if (key == Key::R && (screen_ == Screen::finished || screen_ == Screen::paused)) play();
    if (key != Key::Escape) return;
    if (screen_ == Screen::playing) {
        show(Screen::paused);
    } else if (screen_ == Screen::paused) {
        show(Screen::playing);
    } else if (screen_ == Screen::finished) {
        show(Screen::title);
    }
}

void Game::choose(std::size_t item) {
    if (screen_ == Screen::title) {
        item == 0 ? play() : platform_->quit();
        return;
    }
    if (item == 0) {
        screen_ == Screen::paused ? show(Screen::playing) : play();
    } else if (item == 1) {
        screen_ == Screen::paused ? play() : watch(watching() ? options_.replay : lastRun_);
    } else if (item == 2) {
        playback_.reset();
        session_->restart();
        show(Screen::title);
    } else {
        platform_->quit();
    }
}

void Game::tick() {
    ++time_;
    if (screen_ == Screen::paused) return;
    if (screen_ == Screen::playing) {
        tickSession();
        return;
    }
    // Behind title and finish the world goes on by itself.
    session_->tick(TickInput{});
    view_->tick();
    if (screen_ != Screen::title) return;
    const Level& level = session_->level();
    const double sweep = 0.5 - 0.5 * std::cos(static_cast<double>(time_) * 0.00021);
    const double low = level.boundsMin.x() + 4, high = level.boundsMax.x() - 4;
    view_->lookAt({static_cast<float>(low + (high - low) * sweep),
                   static_cast<float>((level.spawn.y() + level.exit.position.y()) * 0.5 + 0.6)});
}

void Game::tickSession() {
    const TickInput input = nextInput();
    session_->tick(input);
    view_->tick();
    sounds_->tick(*session_);
    remember(input);
    if (session_->events().finished) finish();
    const bool over = watching() && playback_->done();
    if (session_->phase() == Session::Phase::finished || over) {
        if (++afterFinish_ > finishDelay) show(Screen::finished);
    }
}

TickInput Game::nextInput() {
    if (watching()) return playback_->next();
    return controls_.read(platform_->input(), view_->camera(platform_->size()), platform_->size(),
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
    if (best_ <= 0 || session_->seconds() < best_) best_ = session_->seconds();
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

void Game::draw(atlax::Canvas& canvas, double alpha) {
    const bool playing = screen_ == Screen::playing;
    ViewOptions options;
    options.aim = playing && !watching();
    options.hints = screen_ != Screen::title;
    if (options.aim && controls_.mouseAims()) options.crosshair = platform_->input().mouse;
    view_->draw(canvas, screen_ == Screen::paused ? 1 : alpha, options);
    const double seconds = static_cast<double>(time_) / Session::tickRate;
    if (screen_ == Screen::title) {
        menu_.draw(canvas, art_->bold(), drawTitle(canvas, *art_, seconds));
        return;
    }
    drawStatus(canvas, *art_, *session_, watching());
    if (playing && session_->restarts() <= 1) {
        drawLevelName(canvas, *art_, session_->level(),
                      static_cast<double>(session_->ticks()) / Session::tickRate);
    }
    if (screen_ == Screen::paused) menu_.draw(canvas, art_->bold(), drawPause(canvas, *art_));
    if (screen_ == Screen::finished) {
        menu_.draw(canvas, art_->bold(), drawFinish(canvas, *art_, *session_, best_, watching()));
    }
}

/// An attempt that never reached the exit is kept too: it may show where somebody got stuck.
void Game::stop() {
    if (!saved_ && !watching()) {
        recording_.finalHash = session_->hash();
        saveRecording();
    }
}

}  // namespace quaoar
