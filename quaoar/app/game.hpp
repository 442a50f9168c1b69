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

#include "menu.hpp"
#include "preferences.hpp"

namespace quaoar {

struct GameOptions {
    std::shared_ptr<const Level> level;
    /// Start in the level instead of on the title screen.
    bool skipTitle = false;
    /// Where the inputs of the last attempt go.
    std::optional<std::filesystem::path> record = std::nullopt;
    /// Watch this instead of playing.
    std::shared_ptr<const Recording> replay = nullptr;
    /// Instead of the player's own; not kept.
    std::optional<std::string> language = std::nullopt;
};

class Game : public atlax::Application {
public:
    /// `preferences` must outlive the game, which changes and saves them.
    Game(GameOptions options, Preferences& preferences);

    void start(atlax::Platform& platform) override;
    void event(const atlax::Event& event) override;
    void tick() override;
    void draw(atlax::Canvas& canvas, double alpha) override;
    bool restoreGraphics() override;
    void stop() override;

private:
    enum class Screen { title, playing, paused, finished, options, bindings, capture };

    // game.cpp
    void play();
    void watch(std::shared_ptr<const Recording> recording);
    void toTitle();
    void leaveWithPause();
    void act(const atlax::ActionState& state);
    void tickScene();
    void tickSession(const atlax::ActionState& state);
    TickInput nextInput(const atlax::ActionState& state);
    void remember(const TickInput& input);
    void finish();
    void saveRecording();
    void takePicture();
    void makePictures();
    void timeFrame();
    bool watching() const { return playback_ != nullptr; }
    /// The screen below options and what belongs to them.
    Screen scene() const { return screen_ >= Screen::options ? below_ : screen_; }

    // game_menus.cpp
    void show(Screen screen, std::size_t selected = 0);
    void drawScreen(atlax::Canvas& canvas);
    std::vector<MenuItem> itemsOf(Screen screen);
    std::vector<MenuItem> optionItems();
    std::vector<MenuItem> bindingItems();
    void chooseLanguage(const std::string& language);
    void nextLanguage();
    void nextVolume();
    void applyVolume();
    void toggleFullscreen();
    void capture(const atlax::Event& event);
    void bind(atlax::Action action, const atlax::Binding& binding);
    void savePreferences();

    GameOptions options_;
    Preferences& preferences_;
    Texts texts_;
    PlayerActions actions_;
    Controls controls_{actions_};
    atlax::Platform* platform_ = nullptr;
    std::unique_ptr<Session> session_;
    std::unique_ptr<Art> art_;
    std::unique_ptr<GameView> view_;
    std::unique_ptr<Sounds> sounds_;
    std::unique_ptr<Playback> playback_;
    FrameGovernor governor_;
    std::optional<std::chrono::steady_clock::time_point> lastFrame_;
    Menu menu_;
    Screen screen_ = Screen::title;
    Screen below_ = Screen::title;
    atlax::Action captured_ = 0;  ///< the action that waits for a key
    Recording recording_;
    std::shared_ptr<const Recording> lastRun_;  ///< the last attempt that reached the exit
    bool saved_ = false;
    double best_ = 0;         ///< seconds; 0: none yet
    int afterFinish_ = 0;     ///< ticks since the exit was reached
    std::uint64_t time_ = 0;  ///< ticks since the program began
};

}  // namespace quaoar
