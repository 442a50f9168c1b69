#pragma once

#include <atlax/application.hpp>
#include <atlax/font.hpp>
#include <functional>
#include <optional>
#include <vector>

/// An application whose behaviour each test fills in, and which remembers what happened to it.
class ScriptedApp : public atlax::Application {
public:
    void start(atlax::Platform& given) override {
        platform = &given;
        if (onStart) onStart();
    }
    void event(const atlax::Event& e) override { events.push_back(e); }
    void tick() override {
        ++ticks;
        if (onTick) onTick();
    }
    void draw(atlax::Canvas& canvas, double alpha) override {
        ++draws;
        alphaInRange = alphaInRange && alpha >= 0 && alpha < 1;
        canvas.clear(atlax::Color::hex(0x0B1026));
        canvas.circle(canvas.size().toVec() * 0.5f, 20, atlax::Color::hex(0xFFB347));
        if (onDraw) onDraw(canvas);
    }
    bool mayClose() override {
        ++closeRequests;
        return closeRequests > refuseCloses;
    }
    void stop() override { ++stops; }

    /// The latest event of a kind.
    template <class T>
    std::optional<T> last() const {
        for (auto it = events.rbegin(); it != events.rend(); ++it)
            if (const T* found = std::get_if<T>(&*it)) return *found;
        return {};
    }

    atlax::Platform* platform = nullptr;
    std::function<void()> onStart;
    std::function<void()> onTick;
    std::function<void(atlax::Canvas&)> onDraw;
    std::vector<atlax::Event> events;
    int ticks = 0;
    int draws = 0;
    int stops = 0;
    int closeRequests = 0;
    int refuseCloses = 0;
    bool alphaInRange = true;
};
