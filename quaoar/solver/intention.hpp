// What a player means to do next, as he would say it: "swing at that bolt, reel in, let go when I
// pass this line".
#pragma once

#include <cstdint>
#include <optional>
#include <quaoar/session.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace quaoar {

/// A way or an intention that cannot be read. The message is one sentence.
class WayError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// When an intention is done with. Times count from its beginning, in ticks.
struct Until {
    enum class Kind : std::uint8_t {
        time,  ///< after `latest`
        line,  ///< when the hero is beyond the line, from `earliest` on, at `latest` in any case
        calm,  ///< when the hero has come to rest, at `latest` in any case
    };
    Kind kind = Kind::time;
    sulfur::Point place{0, 0};   ///< metres, on the line
    sulfur::Point across{1, 0};  ///< direction in which the line is passed; about of unit length
    int earliest = 0;
    int latest = 0;

    friend bool operator==(const Until&, const Until&) = default;
};

struct Intention {
    enum class Hook : std::uint8_t {
        loose,  ///< let go, or fly on without a rope
        keep,   ///< hold what is tied
        shoot,  ///< let go, aim at `aim` and fire
    };
    Hook hook = Hook::loose;
    sulfur::Point aim{0, 0};  ///< metres, a place in the world
    int reel = 0;             ///< -1 in, 1 out
    bool boost = false;
    /// -1 left, 1 right; 2 along the swing, to gain speed; -2 against it, to come to rest.
    int push = 0;
    Until until;

    friend bool operator==(const Intention&, const Intention&) = default;
};

/// One line of text, such as "shoot 10.31 2.62 reel in push right until line 11.2 1.9 0.9 -0.4
/// from 0.42 to 1.3"; seconds and metres. parseIntention gives back the same bits if the numbers
/// are rounded as makeExact does it. Throws WayError.
std::string format(const Intention& intention);
Intention parseIntention(std::string_view text);

/// Rounds places to tenths of a millimetre, directions to thousandths: what the text holds.
void makeExact(Intention& intention);

}  // namespace quaoar
