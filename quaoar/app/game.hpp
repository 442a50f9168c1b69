// The program: screens, input, recording and sound around one session.
#pragma once

#include <atlax/application.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <quaoar/recording.hpp>
#include <quaoar/session.hpp>
#include <quaoar/view/controls.hpp>
#include <quaoar/view/game_view.hpp>
#include <quaoar/view/sounds.hpp>

#include "menu.hpp"

namespace quaoar {

struct GameOptions {
    std::shared_ptr<const Level> level;
    /// Start in the level instead of on the title screen.
    bool skipTitle = false;
    /// Where the inputs of the last attempt go.
    std::optional<std::filesystem::path> record = std::nullopt;
    /// Watch this instead of playing.
    std::shared_ptr<const Recording> replay = nullptr;
};

class Game : public atlax::Application {
public:
    explicit Game(GameOptions options);

    void start(atlax::Platform& platform) override;
    void event(const atlax::Event& event) override;
    void tick() override;
    void draw(atlax::Canvas& canvas, double alpha) override;
    void stop() override;

private:
    enum class Screen { title, playing, paused, finished };

    void show(Screen screen);
    void play();
    void watch(std::shared_ptr<const Recording> recording);
    void choose(std::size_t item);
    void keyPressed(atlax::Key key);
    void tickSession();
    TickInput nextInput();
    void remember(const TickInput& input);
    void finish();
    void saveRecording();
    void takePicture();
    bool watching() const { return playback_ != nullptr; }

    GameOptions options_;
    atlax::Platform* platform_ = nullptr;
    std::unique_ptr<Session> session_;
    std::unique_ptr<Art> art_;
    std::unique_ptr<GameView> view_;
    std::unique_ptr<Sounds> sounds_;
    std::unique_ptr<Playback> playback_;
    Controls controls_;
    Menu menu_;
    Screen screen_ = Screen::title;
    Recording recording_;
    std::shared_ptr<const Recording> lastRun_;  ///< the last attempt that reached the exit
    bool saved_ = false;
    double best_ = 0;         ///< seconds; 0: none yet
    int afterFinish_ = 0;     ///< ticks since the exit was reached
    std::uint64_t time_ = 0;  ///< ticks since the program began
};

}  // namespace quaoar
