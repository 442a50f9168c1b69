// A game that is played by a test, without a window.
#pragma once

#include <algorithm>
#include <atlax/backend.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <functional>

#include "game.hpp"
#include "helpers.hpp"

namespace quaoar::test {

/// Runs a game and lets the test see and do what a player would, before and after each frame.
class Played : public atlax::Application {
public:
    using Hand = std::function<void(atlax::Platform&, int)>;
    explicit Played(Game& game, Hand hand, std::function<void(atlax::Canvas&)> look = {})
        : game_(game), hand_(std::move(hand)), look_(std::move(look)) {}

    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        game_.start(platform);
    }
    void event(const atlax::Event& event) override { game_.event(event); }
    void tick() override { game_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        hand_(*platform_, ++frames_);
        if (look_) canvas.recordTexts(true);
        game_.draw(canvas, alpha);
        if (look_) look_(canvas);
    }
    bool restoreGraphics() override {
        ++restored;
        return game_.restoreGraphics();
    }
    void stop() override { game_.stop(); }

    int restored = 0;

private:
    Game& game_;
    Hand hand_;
    std::function<void(atlax::Canvas&)> look_;
    atlax::Platform* platform_ = nullptr;
    int frames_ = 0;
};

inline int play(Played& played) {
    atlax::WindowOptions window;
    window.size = {320, 180};
    window.tickRateHz = Session::tickRate;
    window.offscreen = true;
    return atlax::runOffscreen(played, window);
}

inline void tap(atlax::Platform& platform, atlax::Key key) {
    platform.post(atlax::KeyEvent{.key = key, .down = true});
    platform.post(atlax::KeyEvent{.key = key, .down = false});
}

/// What a player does, one after the other, a few frames apart.
class Script {
public:
    using Step = std::function<void(atlax::Platform&)>;
    Script& keys(std::initializer_list<atlax::Key> keys) {
        for (const atlax::Key key : keys)
            then([key](atlax::Platform& platform) { tap(platform, key); });
        return *this;
    }
    Script& then(Step step) {
        steps_.push_back({std::move(step), 4});
        return *this;
    }
    Script& next(Step step) {
        steps_.push_back({std::move(step), 1});
        return *this;
    }
    Script& wait(int frames) {
        steps_.push_back({[](atlax::Platform&) {}, frames});
        return *this;
    }
    void operator()(atlax::Platform& platform, int) {
        if (--rest_ > 0) return;
        if (next_ == steps_.size()) return platform.quit(9);
        steps_[next_].first(platform);
        rest_ = steps_[next_++].second;
    }

private:
    std::vector<std::pair<Step, int>> steps_;
    std::size_t next_ = 0;
    int rest_ = 0;
};

/// Rooms in which the hero stands in the exit from the start.
inline void writeEasyLevels(const Folder& folder, int count) {
    for (int i = 1; i <= count; ++i) {
        const std::string number = std::to_string(i);
        std::string text = replaced(roomText, "\"number\": 1", "\"number\": " + number);
        text = replaced(text, "\"Room\"", "\"Room " + number + "\"");
        text = replaced(text, "[3.2, 0.3], \"radius\": 0.4", "[0.3, 0.3], \"radius\": 0.4");
        writeText(folder / ("room-" + number + ".json"), text);
    }
}

/// A minute of a hand that aims with small movements, and fires and reels now and then.
inline Recording handRun(int seconds) {
    Recording run(*firstLevel());
    std::uint32_t dice = 7;
    const auto roll = [&](int sides) {
        dice = dice * 1664525u + 1013904223u;
        return static_cast<int>(dice >> 16) % sides;
    };
    TickInput input;
    double angle = 0.8;
    for (int tick = 0; tick < seconds * Session::tickRate; ++tick) {
        if (tick % 8 == 0) {
            angle += 0.004 * (roll(9) - 4);
            const double x = std::cos(angle), y = std::sin(angle);
            const double reach = std::max(std::abs(x), std::abs(y));
            input.aimX = static_cast<std::int16_t>(std::lround(512 * x / reach));
            input.aimY = static_cast<std::int16_t>(std::lround(512 * y / reach));
        }
        if (roll(300) == 0) input.fire = !input.fire;
        if (roll(400) == 0) input.reelIn = !input.reelIn;
        if (roll(600) == 0) input.push = static_cast<std::int8_t>(roll(3) * 127 - 127);
        run.append(input);
    }
    return run;
}

}  // namespace quaoar::test
