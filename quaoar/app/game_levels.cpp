// Which level is played, watched or raced.
#include <algorithm>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <utility>

#include "game.hpp"
#include "share.hpp"

namespace quaoar {

/// Makes the world of a level and its pictures; what belonged to the one before goes.
void Game::open(std::size_t level) {
    level_ = level;
    view_.reset();
    ghost_.reset();
    lastRun_.reset();
    playback_.reset();
    session_ = std::make_unique<Session>(levels_.level(level_));
    recording_ = Recording(session_->level());
    hints_.start(session_->level());
    makePictures();
}

void Game::play() {
    playback_.reset();
    session_->restart();
    view_->cut();
    controls_.reset();
    fired_ = false;
    recording_.clear();
    saved_ = false;
    afterFinish_ = 0;
    splits_.clear();
    splitTicks_ = 0;
    makeGhost();
    LevelProgress progress = progress_.of(levels_.key(level_));
    ++progress.attempts;
    ++totals_.attempts;
    progress_.set(levels_.key(level_), progress);
    atlax::log(atlax::LogLevel::Info, "level " + session_->level().id + " begins");
    show(Screen::playing);
}

void Game::playLevel(std::size_t level) {
    const bool first = level == 0 && progress_.of(levels_.key(0)).attempts == 0;
    if (!unlocked(level)) {
        tell(texts_("Finish level {} first", {std::to_string(levels_[level - 1].number)}));
        return;
    }
    if (level != level_) open(level);
    if (first && options_.story) return tellStory(true);
    play();
}

void Game::playNext() {
    if (const auto next = levels_.next(level_)) playLevel(*next);
}

/// The four pictures; where they cannot be read there is no story, which the log says.
void Game::tellStory(bool thenPlay) {
    playAfterStory_ = thenPlay;
    try {
        story_ = std::make_unique<Story>(*art_, Story::levels());
        show(Screen::story);
    } catch (const std::runtime_error& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
        endStory();
    }
}

void Game::endStory() {
    story_.reset();
    if (std::exchange(playAfterStory_, false)) return play();
    show(Screen::credits);
}

/// Once it is proven it is the last one of the list, and can be chosen.
void Game::offerDaily() {
    if (!daily_ || !daily_->ended()) return;
    try {
        if (daily_->ready()) dailyLevel_ = levels_.addDaily(daily_->file());
    } catch (const std::runtime_error& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
    daily_.reset();
    if (screen_ == Screen::title) show(Screen::title, menu_.selected());
}

void Game::watch(std::shared_ptr<const Recording> recording) {
    playback_.reset();
    session_->restart();
    view_->cut();
    afterFinish_ = 0;
    ghost_.reset();
    watched_ = std::move(recording);
    playback_ = std::make_unique<Playback>(watched_);
    show(Screen::playing);
}

void Game::toTitle() {
    playback_.reset();
    session_->restart();
    progress_.setTotals(totals_);
    progress_.save();
    show(Screen::title);
}

/// The first level, and each after one that is finished.
bool Game::unlocked(std::size_t level) const {
    if (level == 0 || levels_.own(level) || options_.unlockAll ||
        preferences_.on(Choice::unlockAll))
        return true;
    const auto finished = [&](std::size_t i) { return progress_.of(levels_.key(i)).finished; };
    return finished(level) || finished(level - 1);
}

std::size_t Game::lastUnlocked() const {
    std::size_t last = 0;
    for (std::size_t i = 1; i < levels_.size() && !levels_.own(i); ++i)
        if (progress_.of(levels_.key(i - 1)).finished) last = i;
    return last;
}

std::shared_ptr<const Recording> Game::ghostRun() const {
    switch (preferences_.ghost()) {
        case GhostChoice::best:
            return progress_.bestRun(levels_.key(level_), session_->level());
        case GhostChoice::gold:
            return levels_.proof(level_);
        case GhostChoice::none:
            break;
    }
    return nullptr;
}

void Game::makeGhost() {
    ghost_.reset();
    if (const auto run = ghostRun()) ghost_ = std::make_unique<Ghost>(levels_.level(level_), run);
}

void Game::openReplay(const std::filesystem::path& file) {
    try {
        const std::string text = atlax::readFile(file, Recording::maxBytes);
        const bool plain = text.starts_with("quaoar-recording");
        watchShared(plain ? Recording::parse(text, file.filename().string())
                          : parseShareText(text));
    } catch (const std::runtime_error& error) {
        tell(error.what());
    }
}

void Game::pasteReplay() {
    try {
        watchShared(parseShareText(platform_->clipboard()));
    } catch (const RecordingError& error) {
        atlax::log(atlax::LogLevel::Info, error.what());
        tell(texts_("There is no replay in the clipboard"));
    }
}

/// Of a level that the player has, in the version that he has.
void Game::watchShared(Recording recording) {
    const auto level = levels_.find(recording);
    if (!level) {
        tell(texts_("This replay is of a level that is not here: {}", {recording.levelId}));
        return;
    }
    if (*level != level_) open(*level);
    watch(std::make_shared<const Recording>(std::move(recording)));
}

void Game::copyReplay() {
    const auto& run = watching() ? watched_ : lastRun_;
    if (!run) return;
    const std::string text = shareText(*run);
    platform_->setClipboard(text);
    tell(texts_("The replay is in the clipboard: {} letters", {std::to_string(text.size())}));
}

}  // namespace quaoar
