// Screens and what can be chosen on them.
#include <algorithm>
#include <atlax/log.hpp>
#include <bit>
#include <cmath>
#include <cstdio>

#include "game.hpp"

namespace quaoar {

namespace {

constexpr int newsSeconds = 4;
/// Three steps of the count-in, 0.4 s each.
constexpr int countInStep = Session::tickRate * 2 / 5;
constexpr atlax::PixelSize thumbnailSize{320, 180};
constexpr std::size_t thumbnailQuality = 2;  ///< they are small, and the menu waits for them

/// "1:02:03"
std::string longClock(double seconds) {
    const auto whole = static_cast<long>(seconds);
    char text[32];
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    return text;
}

}  // namespace

void Game::show(Screen screen, std::size_t selected) {
    const bool playing = screen == Screen::playing;
    if (screen == Screen::options && screen_ < Screen::options) below_ = screen_;
    if (screen == Screen::paused && screen_ == Screen::playing) controls_.pause();
    if (screen == Screen::finished) endSeconds_ = session_->seconds();
    screen_ = screen;
    menu_ = Menu(itemsOf(screen), selected, screen == Screen::levels ? 4 : 1);
    actions_.all.setContext(playing ? "play" : screen == Screen::capture ? "capture" : "menu");
    platform_->clock().setSpeedPermille(playing ? preferences_.speed() * 10 : 1000);
    if (!playing) sounds_->hush();
    platform_->setCursorVisible(!playing && screen != Screen::countIn);
}

void Game::goOn() {
    countIn_ = 3 * countInStep;
    show(preferences_.on(Choice::countIn) ? Screen::countIn : Screen::playing);
}

void Game::leaveWithPause() {
    switch (screen_) {
        case Screen::playing:
        case Screen::countIn:
            return show(Screen::paused);
        case Screen::paused:
            return goOn();
        case Screen::finished:
            return toTitle();
        case Screen::options:
            return show(below_, below_ == Screen::title    ? titlePlace(Screen::options)
                                : below_ == Screen::paused ? 2
                                                           : 0);
        case Screen::sound:
        case Screen::picture:
        case Screen::play:
        case Screen::controls:
        case Screen::levels:
        case Screen::statistics:
        case Screen::credits:
            return toMenuOf(screen_);
        case Screen::bindings:
            return show(Screen::controls, captured_);
        case Screen::conflict:
            return show(Screen::bindings);
        case Screen::story:
            return endStory();
        case Screen::title:
        case Screen::capture:
            break;
    }
}

/// Back to the menu that a screen was chosen from, to its entry.
void Game::toMenuOf(Screen screen) {
    if (ofTitle(screen)) return show(Screen::title, titlePlace(screen));
    const int place = static_cast<int>(screen) - static_cast<int>(Screen::options);
    show(Screen::options, static_cast<std::size_t>(place));
}

void Game::tell(const std::string& news) {
    news_ = news;
    newsTicks_ = newsSeconds * Session::tickRate;
}

std::vector<MenuItem> Game::itemsOf(Screen screen) {
    const MenuItem title{texts_("Back"), [this, screen] { toMenuOf(screen); }};
    switch (screen) {
        case Screen::title:
            return titleItems();
        case Screen::levels:
            return levelItems();
        case Screen::statistics:
            return {{texts_("Watch the replay in the clipboard"), [this] { pasteReplay(); }},
                    title};
        case Screen::credits:
            return {{texts_("The story"), [this] { tellStory(false); }}, title};
        case Screen::paused:
            return pausedItems();
        case Screen::finished:
            return finishedItems();
        case Screen::options:
            return optionItems();
        case Screen::sound:
            return soundItems();
        case Screen::picture:
            return pictureItems();
        case Screen::play:
            return playItems();
        case Screen::controls:
            return controlItems();
        case Screen::bindings:
            return bindingItems();
        case Screen::conflict:
            return conflictItems();
        case Screen::story:
        case Screen::playing:
        case Screen::countIn:
        case Screen::capture:
            break;
    }
    return {};
}

std::vector<MenuItem> Game::titleItems() {
    const std::size_t last = lastUnlocked();
    const bool begun = progress_.of(levels_.key(0)).attempts > 0;
    const std::string level =
        std::to_string(levels_[last].number) + "  " + texts_(levels_[last].name);
    const std::string play = begun ? texts_("Continue: {}", {level}) : texts_("Play");
    std::vector<MenuItem> items{{play, [this, last] { playLevel(last); }}};
    if (options_.daily) items.push_back(dailyItem());
    const std::vector<MenuItem> rest{{texts_("Levels"), [this] { show(Screen::levels, level_); }},
                                     {texts_("Options"), [this] { show(Screen::options); }},
                                     {texts_("Statistics"), [this] { show(Screen::statistics); }},
                                     {texts_("Credits"), [this] { show(Screen::credits); }},
                                     {texts_("Quit"), [this] { platform_->quit(); }}};
    items.insert(items.end(), rest.begin(), rest.end());
    return items;
}

/// It has its place before there is anything to play: no other entry moves under a player's hand.
MenuItem Game::dailyItem() {
    if (dailyLevel_) return {texts_("Level of the day"), [this] { playLevel(*dailyLevel_); }};
    return {.label = texts_(daily_ ? "Level of the day: being made" : "Level of the day: none"),
            .run = {},
            .dim = true};
}

/// Where the entry of a screen stands in the menu of the title.
std::size_t Game::titlePlace(Screen screen) const {
    const std::size_t before = options_.daily ? 2 : 1;
    switch (screen) {
        case Screen::options:
            return before + 1;
        case Screen::statistics:
            return before + 2;
        case Screen::credits:
            return before + 3;
        default:
            return before;  // the levels
    }
}

std::vector<MenuItem> Game::pausedItems() {
    if (watching()) {
        return {{texts_("Go on"), [this] { goOn(); }},
                {texts_("Title screen"), [this] { toTitle(); }},
                {texts_("Quit"), [this] { platform_->quit(); }}};
    }
    return {{texts_("Go on"), [this] { goOn(); }},
            {texts_("Try again"), [this] { play(); }},
            {texts_("Options"), [this] { show(Screen::options); }},
            {texts_("Title screen"), [this] { toTitle(); }},
            {texts_("Quit"), [this] { platform_->quit(); }}};
}

std::vector<MenuItem> Game::finishedItems() {
    std::vector<MenuItem> items;
    const auto next = levels_.next(level_);
    const bool more = next && unlocked(*next);
    if (more && !watching()) items.push_back({texts_("Next level"), [this] { playNext(); }});
    items.push_back({texts_(watching() ? "Play this level" : "Play again"), [this] { play(); }});
    items.push_back({texts_("Watch replay"), [this] { watch(watching() ? watched_ : lastRun_); }});
    items.push_back({texts_("Copy replay"), [this] { copyReplay(); }});
    items.push_back({texts_("Make a film of it"), [this] { startFilm(); }});
    items.push_back({texts_("Levels"), [this] {
                         toTitle();
                         show(Screen::levels, level_);
                     }});
    items.push_back({texts_("Title screen"), [this] { toTitle(); }});
    return items;
}

std::vector<MenuItem> Game::levelItems() {
    std::vector<MenuItem> items;
    for (std::size_t i = 0; i < levels_.size(); ++i)
        items.push_back({"", [this, i] { playLevel(i); }});
    return items;
}

void Game::drawScreen(atlax::Canvas& canvas) {
    const OverlayTools tools{canvas, *art_, texts_};
    if (screen_ == Screen::playing || screen_ == Screen::story) return;
    if (screen_ == Screen::countIn) return drawCountIn(tools, 1 + (countIn_ - 1) / countInStep);
    const bool news = newsTicks_ > 0;
    if (screen_ == Screen::levels) {
        drawLevels(tools);
    } else {
        const MenuRoom room = drawBehindMenu(tools);
        menu_.draw(canvas, art_->bold(), room.top, room.bottom);
    }
    const bool title = screen_ == Screen::title;
    drawFooter(tools, news ? news_ : title ? prompts_.controls() : prompts_.menu(), news);
}

MenuRoom Game::drawBehindMenu(const OverlayTools& tools) {
    switch (screen_) {
        case Screen::title:
            return drawTitle(tools, static_cast<double>(time_) / Session::tickRate);
        case Screen::statistics:
            return drawLines(tools, texts_("Statistics"), statisticsLines());
        case Screen::credits:
            return drawLines(
                tools, texts_("Credits"),
                {{texts_("Game, levels, pictures and sound"), "Sulfur"},
                 {texts_("Physics"), "libsulfur"},
                 {texts_("Window, drawing and audio"), "atlax, SDL, OpenAL Soft"},
                 {texts_("Letters"), "Jura (SIL Open Font License)"},
                 {texts_("Text"), "FreeType, HarfBuzz, gettext"},
                 {texts_("Thanks to Umihara Kawase, Gish and DDNet for the joy of ropes."), ""}});
        case Screen::paused:
            return drawHeadline(tools, texts_("Paused"),
                                std::to_string(session_->level().number) + "   " +
                                    texts_(session_->level().name) + "   " +
                                    clockText(session_->seconds()));
        case Screen::finished:
            return drawFinish(
                tools, *session_,
                {endSeconds_, progress_.of(levels_.key(level_)).best, before_, watching()});
        case Screen::options:
            return drawHeadline(tools, texts_("Options"));
        case Screen::sound:
            return drawHeadline(tools, texts_("Sound"));
        case Screen::picture:
            return drawHeadline(tools, texts_("Picture"));
        case Screen::play:
            return drawHeadline(tools, texts_("Game"));
        case Screen::controls:
            return drawHeadline(tools, texts_("Controls"));
        case Screen::bindings:
            return drawHeadline(tools, actionName(captured_));
        case Screen::conflict:
            return drawHeadline(
                tools, actionName(captured_),
                texts_("{} is in use for: {}",
                       {bindingName(*wanted_, texts_),
                        actionName(actions_.owner(captured_, *wanted_).value_or(captured_))}));
        case Screen::capture:
            return drawHeadline(tools,
                                texts_("Press a key or button for: {}", {actionName(captured_)}),
                                texts_(instead_ ? "Escape keeps what it is. Delete takes it away."
                                                : "Escape keeps what it is."));
        case Screen::levels:
        case Screen::story:
        case Screen::playing:
        case Screen::countIn:
            break;
    }
    return {};
}

std::vector<TextLine> Game::statisticsLines() const {
    std::size_t finished = 0, gold = 0;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const LevelProgress progress = progress_.of(levels_.key(i));
        finished += progress.finished ? 1 : 0;
        gold += progress.finished && levels_[i].medalFor(progress.best) == Medal::gold ? 1 : 0;
    }
    const auto of = [&](std::size_t count) {
        return std::to_string(count) + " / " + std::to_string(levels_.size());
    };
    return {{texts_("Levels finished"), of(finished)},
            {texts_("Gold medals"), of(gold)},
            {texts_("Attempts"), std::to_string(totals_.attempts)},
            {texts_("Falls"), std::to_string(totals_.deaths)},
            {texts_("Ropes fired"), std::to_string(totals_.shots)},
            {texts_("Distance"), std::to_string(std::lround(totals_.distance)) + " m"},
            {texts_("Time of play"), longClock(totals_.seconds)}};
}

std::string Game::levelDetails(std::size_t level) const {
    const Level& it = levels_[level];
    std::string text = std::to_string(it.number) + "   " + texts_(it.name);
    if (!unlocked(level)) return text + "     " + texts_("locked");
    const LevelProgress progress = progress_.of(levels_.key(level));
    if (const auto difficulty = levels_.difficulty(level))
        text += "     " + texts_("difficulty {}", {std::to_string(*difficulty) + "/5"});
    if (progress.finished) text += "     " + texts_("best {}", {clockText(progress.best)});
    if (!progress.finished || it.medalFor(progress.best) != Medal::gold)
        text += "     " + texts_("gold below {}", {clockText(it.medals.gold)});
    if (!it.pickups.empty()) {
        const int found = std::popcount(static_cast<unsigned>(progress.pickups));
        text += "     " + texts_("shards {}",
                                 {std::to_string(found) + "/" + std::to_string(it.pickups.size())});
    }
    if (progress.deaths > 0)
        text += "     " + texts_("falls: {}", {std::to_string(progress.deaths)});
    return text;
}

void Game::drawLevels(const OverlayTools& tools) {
    std::vector<LevelCell> cells;
    std::vector<atlax::Texture> pictures(levels_.size());
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const LevelProgress progress = progress_.of(levels_.key(i));
        LevelCell cell{levels_[i].number, unlocked(i)};
        cell.finished = progress.finished;
        if (progress.finished) cell.medal = levels_[i].medalFor(progress.best);
        if (i < thumbnails_.size() && thumbnails_[i].valid()) {
            pictures[i] = thumbnails_[i].texture();
            cell.picture = &pictures[i];
        }
        cells.push_back(cell);
    }
    int columns = 1;
    menu_.place(drawGrid(tools, cells, menu_.selected(), levelDetails(menu_.selected()), columns));
    menu_.setColumns(columns);
}

/// One a frame, so that the screen comes at once; each is drawn once.
void Game::drawNextThumbnail(atlax::Canvas& canvas) {
    thumbnails_.resize(levels_.size());
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        if (thumbnails_[i].valid() || !unlocked(i)) continue;
        thumbnails_[i] = canvas.createTarget(thumbnailSize);
        const Session session(levels_.level(i));
        GameView view(*art_, session);
        canvas.pushTarget(thumbnails_[i]);
        ViewOptions options;
        options.aim = false;
        options.quality = qualities[thumbnailQuality];
        // Where the level begins to be itself: they all start alike.
        const std::vector<Checkpoint>& checkpoints = levels_[i].checkpoints;
        if (!checkpoints.empty()) view.lookAt(atlax::Vec2(checkpoints.front().position));
        view.draw(canvas, 1, options);
        canvas.popTarget();
        return;
    }
}

}  // namespace quaoar
