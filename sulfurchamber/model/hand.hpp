// A hand that works by itself: for films of tools, and where a lesson shows how.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "workbench.hpp"

namespace sulfurchamber {

/// One thing that a hand does, in a stretch of time.
struct HandMove {
    enum class Act : std::uint8_t {
        glide,    ///< goes to `to`, with the button as it is
        press,    ///< the button goes down where the hand is, with Shift if `shift`
        release,  ///< and up
        tool,     ///< takes `chosen`
        action,   ///< does `name`: play, pause, finish, reset, or what the owner knows
        rest      ///< waits
    };
    Act act = Act::rest;
    double seconds = 0;
    sulfur::Point to{0, 0};  ///< metres
    bool shift = false;
    ToolKind chosen = ToolKind::select;
    std::string name = {};
};
using HandMoves = std::vector<HandMove>;

/// The usual moves, one after the other.
namespace hand {

HandMoves take(ToolKind tool);
/// Goes there in 0.3 s.
HandMoves glide(const sulfur::Point& to, double seconds = 0.3);
HandMoves click(const sulfur::Point& at, bool shift = false);
HandMoves drag(const sulfur::Point& from, const sulfur::Point& to, bool shift = false);
/// Through all of these points with the button down.
HandMoves stroke(const std::vector<sulfur::Point>& points);
HandMoves act(const std::string& name, double seconds = 0.1);
HandMoves rest(double seconds);
HandMoves operator+(HandMoves first, const HandMoves& then);

}  // namespace hand

/// Carries out moves on a workbench as time goes by. What the moves throw goes through.
class Hand {
public:
    /// `bench` must outlive the hand. `act` does the actions that the workbench does not know, and
    /// may be empty.
    Hand(Workbench& bench, HandMoves moves, std::function<void(const std::string&)> act = {});

    void advance(double seconds);
    /// All moves are made.
    bool done() const { return next_ == moves_.size(); }
    /// Metres.
    const sulfur::Point& place() const { return place_; }
    bool pressed() const { return pressed_; }
    /// How long all of it takes, seconds.
    double length() const;

private:
    void begin(const HandMove& move);
    void perform(const std::string& name);
    Pointer pointer(bool shift) const;

    Workbench* bench_;
    HandMoves moves_;
    std::function<void(const std::string&)> act_;
    std::size_t next_ = 0;
    double spent_ = 0;  // of the present move
    bool begun_ = false;
    bool pressed_ = false;
    bool shift_ = false;
    sulfur::Point place_{0, 0};
    sulfur::Point from_{0, 0};  // where the present move began
};

}  // namespace sulfurchamber
