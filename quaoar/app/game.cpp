#include "game.hpp"

#include <algorithm>
#include <atlax/crash_report.hpp>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cmath>

namespace quaoar {

namespace {
/// Between reaching the gate and the screen that says so: one second to see it happen.
constexpr int finishDelay = Session::tickRate;
constexpr int splitSeconds = 3;
/// Ten times a second a crash report's state is brought up to date.
constexpr std::uint64_t ticksPerState = Session::tickRate / 10;
}  // namespace

Game::Game(GameOptions options, Preferences& preferences)
    : options_(std::move(options)),
      preferences_(preferences),
      levels_(options_.levels.empty() ? LevelList(options_.level) : std::move(options_.levels)),
      progress_(options_.progress.value_or(std::filesystem::path())),
      totals_(progress_.totals()) {
    preferences_.readBindings(actions_);
    chooseLanguage(options_.language.value_or(preferences_.language()));
    level_ = lastUnlocked();
    for (std::size_t i = 0; i < levels_.size(); ++i)
        if (levels_.level(i) == options_.level) level_ = i;
}

void Game::start(atlax::Platform& platform) {
    platform_ = &platform;
    art_ = std::make_unique<Art>(platform.canvas());
    sounds_ = std::make_unique<Sounds>(platform.audio());
    open(level_);
    applyOptions();
    if (options_.daily)
        daily_ = std::make_unique<Daily>(options_.daily->first, options_.daily->second);
    if (options_.replay) {
        watch(options_.replay);
    } else if (options_.skipTitle) {
        play();
    } else {
        show(Screen::title);
    }
}

void Game::makePictures() {
    view_.reset();
    view_ = std::make_unique<GameView>(*art_, *session_);
}

bool Game::restoreGraphics() {
    const std::unique_ptr<GameView> before = std::move(view_);
    thumbnails_.clear();
    film_.reset();
    art_ = std::make_unique<Art>(platform_->canvas());
    makePictures();
    if (story_) story_->remake(*art_);
    if (before) view_->resume(*before);
    return true;
}

void Game::event(const atlax::Event& event) {
    prompts_.event(event);
    const auto* focus = std::get_if<atlax::FocusChanged>(&event);
    const bool runs = screen_ == Screen::playing || screen_ == Screen::countIn;
    if (focus != nullptr && !focus->focused && runs) show(Screen::paused);
    if (screen_ == Screen::capture) return capture(event);
    if (const auto* dropped = std::get_if<atlax::FileDropped>(&event)) openReplay(dropped->file);
    const auto* key = std::get_if<atlax::KeyEvent>(&event);
    const bool paste = key != nullptr && key->down && !key->repeat && key->key == atlax::Key::V &&
                       has(key->modifiers, atlax::Modifiers::Control);
    if (paste && screen_ != Screen::playing) pasteReplay();
}

void Game::act(const atlax::ActionState& state) {
    if (state.wasPressed(actions_.fullscreen)) toggleFullscreen();
    if (state.wasPressed(actions_.picture)) takePicture();
    if (state.wasPressed(actions_.pause) || state.wasPressed(actions_.back)) {
        newsTicks_ = 0;
        leaveWithPause();
        return;
    }
    if (screen_ == Screen::playing || screen_ == Screen::capture || screen_ == Screen::countIn)
        return;
    if (screen_ == Screen::story) {
        if (state.wasPressed(actions_.choose) || state.wasPressed(actions_.click)) story_->next();
        return;
    }
    const bool again = screen_ == Screen::finished || screen_ == Screen::paused;
    if (again && state.wasPressed(actions_.restart)) {
        play();
        return;
    }
    if (const auto chosen = menu_.tick(state, actions_)) {
        sounds_->click();
        newsTicks_ = 0;
        chosen();
    }
}

void Game::tick() {
    ++time_;
    if (newsTicks_ > 0) --newsTicks_;
    if (splitTicks_ > 0) --splitTicks_;
    const atlax::ActionState& state = actions_.all.sample(platform_->input());
    const bool played = screen_ == Screen::playing;
    act(state);
    offerDaily();
    if (screen_ == Screen::story) {
        story_->tick();
        if (story_->over()) endStory();
        return;
    }
    if (still()) {
        controls_.rest(platform_->input(), screen_ == Screen::countIn);
        if (screen_ == Screen::countIn && --countIn_ <= 0) show(Screen::playing);
        return;
    }
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
    sounds_->accompany(session_->level());
    if (!ofTitle(scene())) return;
    const Level& level = session_->level();
    const double sweep = 0.5 - 0.5 * std::cos(static_cast<double>(time_) * 0.00021);
    const double low = level.boundsMin.x() + 4, high = level.boundsMax.x() - 4;
    view_->lookAt({static_cast<float>(low + (high - low) * sweep),
                   static_cast<float>((level.spawn.y() + level.exit.position.y()) * 0.5 + 0.6)});
}

void Game::tickSession(const atlax::ActionState& state) {
    const TickInput input = nextInput(state);
    const sulfur::Point before = session_->heroPosition();
    session_->tick(input);
    if (!session_->events().restarted && !session_->events().died)
        totals_.distance += (session_->heroPosition() - before).norm();
    view_->tick();
    sounds_->tick(*session_);
    hints_.tick(*session_, state);
    remember(input);
    account(input);
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
    const PlayerSight sight{view_->camera(platform_->size()), platform_->size(),
                            atlax::Vec2(session_->heroPosition()),
                            session_->rope().state() != Rope::State::idle};
    TickInput input = controls_.read(state, platform_->input(), sight);
    const bool shoots = input.fire && !fired_;
    fired_ = input.fire;
    if (shoots && preferences_.on(Choice::aimAssist)) assistAim(input, *session_);
    return input;
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

/// Statistics and the ghost follow the player's attempt.
void Game::account(const TickInput& input) {
    if (ghost_ && session_->events().restarted) ghost_->restart();
    const bool runs = session_->timerTicks() > 0 && session_->phase() == Session::Phase::playing;
    if (ghost_ && runs) ghost_->tick();
    if (watching()) return;
    totals_.seconds += 1.0 / Session::tickRate;
    const TickEvents& events = session_->events();
    if (events.checkpoint) split();
    if (events.restarted) splits_.clear();
    if (events.fired) ++totals_.shots;
    if (!events.restarted && !events.died) return;
    const bool asked = input.restart || input.retry;
    LevelProgress progress = progress_.of(levels_.key(level_));
    progress.attempts += events.restarted ? 1 : 0;
    totals_.attempts += events.restarted ? 1 : 0;
    progress.deaths += events.died && !asked ? 1 : 0;
    totals_.deaths += events.died && !asked ? 1 : 0;
    progress_.set(levels_.key(level_), progress);
}

/// The time at a checkpoint, and how far that is from the best run's.
void Game::split() {
    const auto checkpoint = session_->checkpoint();
    if (!checkpoint) return;
    splits_.resize(session_->level().checkpoints.size());
    splits_[*checkpoint] = session_->seconds();
    const LevelProgress progress = progress_.of(levels_.key(level_));
    split_ = clockText(session_->seconds());
    ahead_ = false;
    if (*checkpoint < progress.splits.size() && progress.splits[*checkpoint] > 0) {
        const double gap = session_->seconds() - progress.splits[*checkpoint];
        ahead_ = gap < 0;
        split_ += (ahead_ ? "   -" : "   +") + clockText(std::abs(gap));
    }
    splitTicks_ = splitSeconds * Session::tickRate;
}

void Game::finish() {
    if (watching()) return;
    atlax::log(atlax::LogLevel::Info,
               "level " + session_->level().id + " finished in " + clockText(session_->seconds()));
    recording_.finalHash = session_->hash();
    lastRun_ = std::make_shared<const Recording>(recording_);
    LevelProgress progress = progress_.of(levels_.key(level_));
    const bool faster = !progress.finished || session_->seconds() < progress.best;
    before_ = progress.best;
    progress.finished = true;
    for (std::size_t i = 0; i < session_->level().pickups.size() && i < 31; ++i)
        if (session_->pickedUp(i)) progress.pickups |= 1 << i;
    if (faster) {
        progress.best = session_->seconds();
        progress.splits = splits_;
        progress_.keepBestRun(levels_.key(level_), *lastRun_);
    }
    progress_.set(levels_.key(level_), progress);
    progress_.setTotals(totals_);
    progress_.save();
    saveRecording();
}

void Game::saveRecording() {
    if (!options_.record || recording_.ticks() == 0) return;
    recording_.write(*options_.record);
    saved_ = true;
    atlax::log(atlax::LogLevel::Info, "recorded to " + options_.record->string());
}

/// A name in the player's folder of pictures that is free yet.
std::filesystem::path Game::nextPicture(const char* ending) const {
    const auto folder = atlax::dataFolder("quaoar") / "pictures";
    for (int number = 1;; ++number) {
        const auto file = folder / ("quaoar-" + std::to_string(number) + ending);
        if (!std::filesystem::exists(file)) return file;
    }
}

void Game::takePicture() {
    const auto file = nextPicture(".png");
    platform_->requestScreenshot(file);
    atlax::log(atlax::LogLevel::Info, "picture goes to " + file.string());
    tell(texts_("Picture {}", {file.filename().string()}));
}

void Game::startFilm() {
    const auto& run = watching() ? watched_ : lastRun_;
    if (!run || film_) return;
    film_ = std::make_unique<Film>(*art_, levels_.level(level_), run, nextPicture("-film.png"));
}

/// A frame of the film beside each frame of a menu; play is not disturbed.
void Game::continueFilm(atlax::Canvas& canvas) {
    if (!film_ || screen_ == Screen::playing) return;
    try {
        if (!film_->step(canvas)) {
            const auto percent = std::to_string(std::lround(100 * film_->progress()));
            return tell(texts_("Film: {} %", {percent}));
        }
        tell(texts_("The film is {}", {film_->file().string()}));
    } catch (const atlax::Error& error) {
        tell(error.what());
    }
    film_.reset();
}

/// Between two frames, waiting for the display and all: what the player sees.
void Game::timeFrame() {
    const auto now = std::chrono::steady_clock::now();
    if (lastFrame_ && options_.adapt)
        governor_.frame(std::chrono::duration<double>(now - *lastFrame_).count());
    lastFrame_ = now;
}

void Game::drawWorld(atlax::Canvas& canvas, double alpha) {
    const bool playing = screen_ == Screen::playing;
    ViewOptions options;
    options.quality = governor_.quality();
    options.aim = playing && !watching();
    options.shake = preferences_.on(Choice::shake);
    options.flashes = preferences_.on(Choice::flashes);
    options.highContrast = preferences_.on(Choice::highContrast);
    if (story_) return story_->draw(canvas, alpha, options);
    if (options.aim && controls_.mouseAims()) options.crosshair = platform_->input().mouse;
    view_->draw(canvas, still() ? 1 : alpha, options);
    const bool started = session_->timerTicks() > 0;
    if (!ghost_ || !started || ofTitle(scene())) return;
    canvas.setCamera(view_->camera(canvas.size()));
    const bool gold = preferences_.ghost() == GhostChoice::gold;
    ghost_->draw(canvas, still() ? 1 : alpha, gold ? atlax::Color::hex(0xFFD15C) : palette::frost);
}

void Game::draw(atlax::Canvas& canvas, double alpha) {
    timeFrame();
    if (screen_ == Screen::levels) drawNextThumbnail(canvas);
    continueFilm(canvas);
    drawWorld(canvas, alpha);
    const OverlayTools tools{canvas, *art_, texts_};
    const bool playing = screen_ == Screen::playing;
    const bool news = newsTicks_ > 0;
    if (playing || screen_ == Screen::countIn) {
        drawStatus(tools, *session_,
                   {watching(), splitTicks_ > 0 ? split_ : std::string(), ahead_});
    }
    if (playing && session_->restarts() <= 1) {
        drawLevelName(tools, session_->level(),
                      static_cast<double>(session_->ticks()) / Session::tickRate);
    }
    if (playing && !news && !watching()) hints_.draw(tools);
    if (playing && news) drawBanner(tools, news_, 1);
    drawScreen(canvas);
}

/// An attempt that never reached the exit is kept too: it may show where somebody got stuck.
void Game::stop() {
    savePreferences();
    progress_.setTotals(totals_);
    progress_.save();
    if (!saved_ && !watching()) {
        recording_.finalHash = session_->hash();
        saveRecording();
    }
}

}  // namespace quaoar
