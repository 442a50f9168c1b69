// The mouse and the keys of scripts of the window: real events, whose arrival is waited for.
#include <wx/settings.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <utility>

#include "chamber_app.hpp"
#include "script.hpp"

namespace sulfurchamber {
namespace {

double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// 0 when there is no such key.
int keyCode(const std::string& name) {
    static const std::map<std::string, int> keys{{"Space", WXK_SPACE},
                                                 {"Period", '.'},
                                                 {"Comma", ','},
                                                 {"Escape", WXK_ESCAPE},
                                                 {"Delete", WXK_DELETE},
                                                 {"Home", WXK_HOME},
                                                 {"End", WXK_END},
                                                 {"Left", WXK_LEFT},
                                                 {"Right", WXK_RIGHT},
                                                 {"Enter", WXK_RETURN},
                                                 {"Up", WXK_UP},
                                                 {"Down", WXK_DOWN},
                                                 {"F5", WXK_F5},
                                                 {"F6", WXK_F6},
                                                 {"F8", WXK_F8},
                                                 {"PageUp", WXK_PAGEUP},
                                                 {"PageDown", WXK_PAGEDOWN}};
    if (name.size() == 1) return name[0];
    const auto key = keys.find(name);
    return key == keys.end() ? 0 : key->second;
}

}  // namespace

void Script::waitForFrames(int frames, std::function<void()> then) {
    waitFor([frames]() mutable { return --frames <= 0; }, std::move(then));
}

void Script::moveMouse(const sulfur::Point& at, std::function<void()> then) {
    const atlax::Vec2 pixels = frame_.sceneView().toPixels(at);
    if (!moveMouseTo(pixels, std::move(then)))
        fail("the place " + std::to_string(at.x()) + " " + std::to_string(at.y()) +
             " is not in view");
}

bool Script::moveMouseTo(const atlax::Vec2& pixels, std::function<void()> then) {
    const double scale = frame_.canvas().GetContentScaleFactor();
    const wxPoint target(static_cast<int>(std::lround(static_cast<double>(pixels.x) / scale)),
                         static_cast<int>(std::lround(static_cast<double>(pixels.y) / scale)));
    if (!frame_.canvas().GetClientRect().Contains(target)) return false;
    const wxPoint screen = frame_.canvas().ClientToScreen(target);
    // The pointer may be there already, then no event comes: it goes beside first. Of two motions
    // close after each other the server may keep one to itself, each time anew: what is lost is
    // asked for again by one motion at a time.
    simulator_.MouseMove(screen.x + 1, screen.y);
    simulator_.MouseMove(screen.x, screen.y);
    const auto arrived = [this, target, scale, screen, calls = 0]() mutable {
        const auto seen = frame_.sceneView().mousePixels();
        if (seen && std::lround(static_cast<double>(seen->x) / scale) == target.x &&
            std::lround(static_cast<double>(seen->y) / scale) == target.y)
            return true;
        if (++calls % 10 == 0) simulator_.MouseMove(screen.x + (calls / 10) % 2, screen.y);
        return false;
    };
    waitFor(arrived, std::move(then));
    return true;
}

void Script::press(const sulfur::Point& at, std::function<void()> then) {
    const auto pressNow = [this, then = std::move(then)] {
        const std::uint64_t before = frame_.sceneView().buttonEvents();
        lastPress_ = std::chrono::steady_clock::now();
        simulator_.MouseDown();
        waitFor([this, before] { return frame_.sceneView().buttonEvents() != before; }, then);
    };
    // Two clicks at one place are no double click, however fast the machine is.
    const auto isApart = [this] {
        const auto pause =
            std::chrono::milliseconds(wxSystemSettings::GetMetric(wxSYS_DCLICK_MSEC));
        return std::chrono::steady_clock::now() - lastPress_ > pause + pause / 4;
    };
    moveMouse(at, [this, isApart, pressNow] { waitFor(isApart, pressNow); });
}

void Script::strokeThrough(const std::vector<sulfur::Point>& places, std::size_t next,
                           const std::function<void()>& then) {
    if (next == places.size()) {
        then();
        return;
    }
    moveMouse(places[next], [this, places, next, then] { strokeThrough(places, next + 1, then); });
}

bool Script::startPointer(const Words& words) {
    const auto releaseNow = [this] {
        const std::uint64_t before = frame_.sceneView().buttonEvents();
        simulator_.MouseUp();
        waitFor([this, before] { return frame_.sceneView().buttonEvents() != before; });
    };
    const auto point = [&](std::size_t first) {
        return sulfur::Point(number(words[first]), number(words[first + 1]));
    };
    if (words[0] == "tool" && words.size() == 2) {
        if (!frame_.perform("tool-" + words[1])) fail("there is no tool " + words[1]);
    } else if (words[0] == "click" && words.size() == 3) {
        press(point(1), releaseNow);
    } else if (words[0] == "drag" && words.size() == 5) {
        press(point(1), [this, to = point(3), releaseNow] { moveMouse(to, releaseNow); });
    } else if (words[0] == "stroke" && words.size() > 4 && words.size() % 2 == 1) {
        std::vector<sulfur::Point> places;
        for (std::size_t i = 3; i + 1 < words.size(); i += 2) places.push_back(point(i));
        press(point(1), [this, places = std::move(places), releaseNow] {
            strokeThrough(places, 0, releaseNow);
        });
    } else if (words[0] == "hold" && words.size() == 6) {
        const double seconds = number(words[5]);
        press(point(1), [this, to = point(3), seconds, releaseNow] {
            moveMouse(to, [this, seconds, releaseNow] {
                const auto& world = frame_.bench().document().world();
                waitFor([&world, until = world.time() + seconds] { return world.time() >= until; },
                        releaseNow);
            });
        });
    } else if (words[0] == "wheel" && words.size() == 4) {
        // wxUIActionSimulator turns no wheels: the event begins where atlax has it.
        const atlax::Vec2 at = frame_.sceneView().toPixels(point(1));
        frame_.canvas().send(atlax::WheelEvent{{0, static_cast<float>(number(words[3]))}, at, {}});
    } else if (words[0] == "hold-key" && words.size() == 3) {
        const int code = keyCode(words[1]);
        if (code == 0) fail("there is no key " + words[1]);
        Document& document = frame_.bench().document();
        frame_.canvas().SetFocus();
        document.play();
        simulator_.KeyDown(code);
        const double until = document.world().time() + number(words[2]);
        double last = -1;
        waitFor(
            [this, until, last]() mutable {
                const auto& world = frame_.bench().document().world();
                if (world.time() != last) waitedFrames_ = 0;
                last = world.time();
                return world.time() >= until;
            },
            [this, code] {
                simulator_.KeyUp(code);
                frame_.bench().document().pause();
                waitForFrames(10, {});
            });
    } else if (words[0] == "key" && words.size() == 2) {
        const bool control = words[1].starts_with("Ctrl+");
        const std::string name = words[1].substr(control ? 5 : 0);
        const int code = keyCode(name);
        if (code == 0) fail("there is no key " + name);
        frame_.canvas().SetFocus();
        simulator_.Char(code, control ? wxMOD_CONTROL : wxMOD_NONE);
        waitForFrames(30, {});
    } else {
        return false;
    }
    return true;
}

// Two seconds of dragging: a step each frame.
void Script::slide(double from, double to) {
    const wxRect track = frame_.timeBar().trackOnScreen();
    const int y = track.GetBottom() - frame_.FromDIP(11);
    const auto x = [track](double share) {
        return track.GetLeft() + static_cast<int>(std::lround(share * track.GetWidth()));
    };
    simulator_.MouseMove(x(from), y);
    if (from == to) {
        waitForFrames(20, {});
        return;
    }
    simulator_.MouseDown();
    const double cpuBefore = processorSeconds();
    const std::uint64_t framesBefore = frame_.sceneView().frames();
    constexpr int steps = 60;
    const auto drag = [this, x, y, from, to, step = 0]() mutable {
        if (++step <= steps) simulator_.MouseMove(x(from + (to - from) * step / steps), y);
        return step > steps;
    };
    waitFor(drag, [this, cpuBefore, framesBefore] {
        const auto frames = frame_.sceneView().frames() - framesBefore;
        slideCost_ = (processorSeconds() - cpuBefore) * 1000 /
                     static_cast<double>(std::max<std::uint64_t>(1, frames));
        simulator_.MouseUp();
        waitFor(
            [this, frames = 0]() mutable { return ++frames > 5 && !frame_.sceneView().seeking(); });
    });
}

void Script::dragPlot(double from, double to) {
    const wxRect plot = frame_.plot().plotOnScreen();
    const auto place = [plot](double share) {
        return wxPoint(plot.GetLeft() + static_cast<int>(std::lround(share * plot.GetWidth())),
                       plot.GetTop() + plot.GetHeight() / 2);
    };
    simulator_.MouseMove(place(from));
    if (from == to) {
        waitForFrames(20, {});
        return;
    }
    simulator_.MouseDown();
    simulator_.MouseMove(place((from + to) / 2));
    simulator_.MouseMove(place(to));
    waitForFrames(10, [this] {
        simulator_.MouseUp();
        waitForFrames(10, {});
    });
}

}  // namespace sulfurchamber
