// The program: screens, input, recording and sound around one session.
#pragma once

#include <atlax/application.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <quaoar/recording.hpp>
#include <quaoar/session.hpp>
#include <quaoar/view/controls.hpp>
#include <quaoar/view/game_view.hpp>
#include <quaoar/view/sounds.hpp>
#include <quaoar/view/texts.hpp>

#include "daily.hpp"
#include "film.hpp"
#include "ghost.hpp"
#include "hints.hpp"
#include "level_list.hpp"
#include "menu.hpp"
#include "overlay.hpp"
#include "preferences.hpp"
#include "progress.hpp"
#include "prompts.hpp"
#include "story.hpp"

namespace quaoar {

struct GameOptions {
    /// The first one to be played; null: the last that the player has unlocked.
    std::shared_ptr<const Level> level = nullptr;
    /// All of the menu; empty: only `level`.
    LevelList levels = {};
    /// Start in the level instead of on the title screen.
    bool skipTitle = false;
    /// Where the inputs of the last attempt go.
    std::optional<std::filesystem::path> record = std::nullopt;
    /// Watch this instead of playing.
    std::shared_ptr<const Recording> replay = nullptr;
    /// Instead of the player's own; not kept.
    std::optional<std::string> language = std::nullopt;
    /// Where progress is kept; nothing: nowhere.
    std::optional<std::filesystem::path> progress = std::nullopt;
    /// Every level may be played.
    bool unlockAll = false;
    /// Tell how it began before the first level is played for the first time.
    bool story = false;
    /// Where levels of days are kept, and the date of today's; nothing: there is none.
    std::optional<std::pair<std::filesystem::path, std::string>> daily = std::nullopt;
    /// The picture's quality follows the time that frames take; else it stays as at first.
    bool adapt = true;
};

class Game : public atlax::Application {
public:
    enum class Screen {
        title,
        levels,
        statistics,
        credits,
        story,
        playing,
        countIn,
        paused,
        finished,
        // What lies over another screen, to which it goes back:
        options,
        sound,
        picture,
        play,
        controls,
        bindings,
        capture,
        conflict
    };

    /// `preferences` must outlive the game, which changes and saves them.
    Game(GameOptions options, Preferences& preferences);

    void start(atlax::Platform& platform) override;
    void event(const atlax::Event& event) override;
    void tick() override;
    void draw(atlax::Canvas& canvas, double alpha) override;
    bool restoreGraphics() override;
    void stop() override;

    // What tests ask.
    Screen screen() const { return screen_; }
    const Session& session() const { return *session_; }
    std::size_t selected() const { return menu_.selected(); }
    const PlayerActions& actions() const { return actions_; }
    const Progress& progress() const { return progress_; }
    const LevelList& levels() const { return levels_; }
    const Story* story() const { return story_.get(); }

private:
    // game.cpp
    void act(const atlax::ActionState& state);
    void tickScene();
    void tickSession(const atlax::ActionState& state);
    TickInput nextInput(const atlax::ActionState& state);
    void remember(const TickInput& input);
    void account(const TickInput& input);
    void split();
    void finish();
    void saveRecording();
    void takePicture();
    std::filesystem::path nextPicture(const char* ending) const;
    void startFilm();
    void continueFilm(atlax::Canvas& canvas);
    void makePictures();
    void timeFrame();
    void drawWorld(atlax::Canvas& canvas, double alpha);
    bool watching() const { return playback_ != nullptr; }
    /// The screen below options and what belongs to them.
    Screen scene() const { return screen_ >= Screen::options ? below_ : screen_; }
    /// Whether the world stands still.
    bool still() const { return scene() == Screen::paused || scene() == Screen::countIn; }
    bool ofTitle(Screen screen) const { return screen <= Screen::story; }

    // game_levels.cpp
    void open(std::size_t level);
    void play();
    void playLevel(std::size_t level);
    void playNext();
    void tellStory(bool thenPlay);
    void endStory();
    void offerDaily();
    void watch(std::shared_ptr<const Recording> recording);
    void toTitle();
    bool unlocked(std::size_t level) const;
    std::size_t lastUnlocked() const;
    std::shared_ptr<const Recording> ghostRun() const;
    void makeGhost();
    void openReplay(const std::filesystem::path& file);
    void pasteReplay();
    void copyReplay();
    void watchShared(Recording recording);

    // game_menus.cpp
    void show(Screen screen, std::size_t selected = 0);
    void goOn();
    void leaveWithPause();
    void toMenuOf(Screen screen);
    void drawScreen(atlax::Canvas& canvas);
    MenuRoom drawBehindMenu(const OverlayTools& tools);
    void drawLevels(const OverlayTools& tools);
    void drawNextThumbnail(atlax::Canvas& canvas);
    std::string levelDetails(std::size_t level) const;
    std::vector<TextLine> statisticsLines() const;
    std::vector<MenuItem> itemsOf(Screen screen);
    std::vector<MenuItem> titleItems();
    MenuItem dailyItem();
    std::size_t titlePlace(Screen screen) const;
    std::vector<MenuItem> pausedItems();
    std::vector<MenuItem> finishedItems();
    std::vector<MenuItem> levelItems();
    void tell(const std::string& news);

    // game_options.cpp
    std::vector<MenuItem> optionItems();
    std::vector<MenuItem> soundItems();
    std::vector<MenuItem> pictureItems();
    std::vector<MenuItem> playItems();
    MenuItem toggle(const char* label, Choice choice);
    MenuItem volume(const char* label, atlax::Bus bus);
    MenuItem windowSizes();
    MenuItem speeds();
    MenuItem ghosts();
    void chooseLanguage(const std::string& language);
    void nextLanguage(int way);
    void applyOptions();
    void toggleFullscreen();
    void redo();
    void savePreferences();

    // game_bindings.cpp
    std::vector<MenuItem> controlItems();
    std::vector<MenuItem> bindingItems();
    std::vector<MenuItem> conflictItems();
    std::string actionName(atlax::Action action) const;
    void startCapture(std::optional<atlax::Binding> instead);
    void capture(const atlax::Event& event);
    void offer(const atlax::Binding& binding);
    void bind(const atlax::Binding& binding);

    GameOptions options_;
    Preferences& preferences_;
    LevelList levels_;
    std::size_t level_ = 0;  ///< the one that is open
    Progress progress_;
    Totals totals_;
    Texts texts_;
    PlayerActions actions_;
    Controls controls_{actions_};
    Prompts prompts_{actions_, texts_};
    Hints hints_{actions_, prompts_, texts_};
    atlax::Platform* platform_ = nullptr;
    std::unique_ptr<Session> session_;
    std::unique_ptr<Art> art_;
    std::unique_ptr<GameView> view_;
    std::unique_ptr<Sounds> sounds_;
    std::unique_ptr<Playback> playback_;
    FrameGovernor governor_;
    std::optional<std::chrono::steady_clock::time_point> lastFrame_;
    std::unique_ptr<Ghost> ghost_;
    std::unique_ptr<Story> story_;
    bool playAfterStory_ = false;
    std::unique_ptr<Daily> daily_;
    std::optional<std::size_t> dailyLevel_;        ///< its place, once it is proven
    std::unique_ptr<Film> film_;                   ///< that is being made
    std::vector<atlax::RenderTarget> thumbnails_;  ///< of the levels, as far as drawn
    Menu menu_;
    Screen screen_ = Screen::title;
    Screen below_ = Screen::title;
    atlax::Action captured_ = 0;             ///< the action that gets a key
    std::optional<atlax::Binding> instead_;  ///< in place of this one
    std::optional<atlax::Binding> wanted_;   ///< what another action has
    Recording recording_;
    std::shared_ptr<const Recording> lastRun_;  ///< the last attempt that reached the exit
    std::shared_ptr<const Recording> watched_;
    bool saved_ = false;
    double before_ = 0;           ///< best time before the last finish, seconds; 0: none
    double endSeconds_ = 0;       ///< of the run that the finish screen is about
    int afterFinish_ = 0;         ///< ticks since the exit was reached
    int countIn_ = 0;             ///< ticks until play goes on
    bool fired_ = false;          ///< fire was held in the last tick
    std::uint64_t time_ = 0;      ///< ticks since the program began
    std::vector<double> splits_;  ///< of this attempt, as in LevelProgress
    std::string split_;           ///< what is said of the last one
    bool ahead_ = false;          ///< of the best run, there
    int splitTicks_ = 0;          ///< for which it is still shown
    std::string news_;            ///< what the last action came to
    int newsTicks_ = 0;           ///< for which it is still shown
};

}  // namespace quaoar
