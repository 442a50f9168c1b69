#include "intention.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace quaoar {
namespace {

constexpr double secondsOfTick = 1.0 / Session::tickRate;
constexpr double longestSeconds = 60;

double rounded(double value, double steps) {
    const double result = std::round(value * steps) / steps;
    return result == 0 ? 0 : result;  // no minus zero
}

template <class... Values>
std::string printed(const char* pattern, Values... values) {
    std::array<char, 160> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, values...);
    return buffer.data();
}

/// Takes words and numbers off a text.
class Words {
public:
    explicit Words(std::string_view text) : stream_(std::string(text)) {}

    std::string word() {
        std::string result;
        if (!(stream_ >> result))
            throw WayError("ends too early; an intention needs \"until ...\"");
        return result;
    }
    double number(double low, double high) {
        const std::string text = word();
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (*end != 0 || !(value >= low && value <= high)) {
            throw WayError("\"" + text.substr(0, 40) + "\" is not a number from " +
                           printed("%g to %g", low, high));
        }
        return value;
    }
    sulfur::Point point(double limit) {
        const double x = number(-limit, limit);
        return {x, number(-limit, limit)};
    }
    int ticks() {
        return static_cast<int>(std::lround(number(0, longestSeconds) * Session::tickRate));
    }
    void expect(const char* wanted) {
        const std::string text = word();
        if (text != wanted) {
            throw WayError("has \"" + text.substr(0, 40) + "\" where \"" + wanted + "\" belongs");
        }
    }
    void end() {
        std::string rest;
        if (stream_ >> rest) throw WayError("goes on with \"" + rest.substr(0, 40) + "\"");
    }

private:
    std::istringstream stream_;
};

Until parseUntil(Words& words) {
    Until until;
    const std::string kind = words.word();
    if (kind == "after") {
        until.latest = words.ticks();
    } else if (kind == "calm") {
        until.kind = Until::Kind::calm;
        words.expect("to");
        until.latest = words.ticks();
    } else if (kind == "line") {
        until.kind = Until::Kind::line;
        until.place = words.point(1000);
        until.across = words.point(2);
        words.expect("from");
        until.earliest = words.ticks();
        words.expect("to");
        until.latest = words.ticks();
    } else {
        throw WayError("has \"until " + kind.substr(0, 40) +
                       "\"; allowed are \"after\", \"line\" and \"calm\"");
    }
    if (until.earliest > until.latest) throw WayError("ends before it may");
    return until;
}

constexpr std::pair<const char*, int> pushes[] = {
    {"left", -1}, {"right", 1}, {"along", 2}, {"against", -2}};

/// 0 if the word is none of them.
int pushOf(const std::string& word) {
    for (const auto& [known, push] : pushes) {
        if (word == known) return push;
    }
    return 0;
}

/// Takes one of the words between the hook and "until"; false at "until".
bool parseManner(Words& words, Intention& intention) {
    const std::string word = words.word();
    if (word == "until") return false;
    const std::string way = words.word();
    if (word == "reel" && (way == "in" || way == "out")) {
        intention.reel = way == "in" ? -1 : 1;
    } else if (word == "fast" && (way == "in" || way == "out")) {
        intention.reel = way == "in" ? -1 : 1;
        intention.boost = true;
    } else if (word == "push" && pushOf(way) != 0) {
        intention.push = pushOf(way);
    } else {
        throw WayError("has \"" + word.substr(0, 40) + " " + way.substr(0, 40) +
                       "\"; allowed are \"reel in\", \"reel out\", \"fast in\", \"fast out\", "
                       "\"push left\", \"push right\", \"push along\", \"push against\" and "
                       "\"until ...\"");
    }
    return true;
}

}  // namespace

void makeExact(Intention& intention) {
    for (int axis = 0; axis < 2; ++axis) {
        intention.aim[axis] = rounded(intention.aim[axis], 1e4);
        intention.until.place[axis] = rounded(intention.until.place[axis], 1e4);
        intention.until.across[axis] = rounded(intention.until.across[axis], 1e3);
    }
}

std::string format(const Intention& intention) {
    std::string text;
    switch (intention.hook) {
        case Intention::Hook::loose:
            text = "loose";
            break;
        case Intention::Hook::keep:
            text = "keep";
            break;
        case Intention::Hook::shoot:
            text = printed("shoot %.4f %.4f", intention.aim.x(), intention.aim.y());
            break;
    }
    if (intention.reel != 0) {
        text += intention.boost ? " fast" : " reel";
        text += intention.reel < 0 ? " in" : " out";
    }
    for (const auto& [word, push] : pushes) {
        if (push == intention.push) text += std::string(" push ") + word;
    }
    const Until& until = intention.until;
    const double latest = until.latest * secondsOfTick;
    if (until.kind == Until::Kind::time) return text + printed(" until after %.3f", latest);
    if (until.kind == Until::Kind::calm) return text + printed(" until calm to %.3f", latest);
    return text + printed(" until line %.4f %.4f %.3f %.3f from %.3f to %.3f", until.place.x(),
                          until.place.y(), until.across.x(), until.across.y(),
                          until.earliest * secondsOfTick, latest);
}

Intention parseIntention(std::string_view text) {
    Words words(text);
    Intention intention;
    const std::string hook = words.word();
    if (hook == "shoot") {
        intention.hook = Intention::Hook::shoot;
        intention.aim = words.point(1100);
    } else if (hook == "keep") {
        intention.hook = Intention::Hook::keep;
    } else if (hook != "loose") {
        throw WayError("begins with \"" + hook.substr(0, 40) +
                       "\"; allowed are \"shoot\", \"keep\" and \"loose\"");
    }
    while (parseManner(words, intention)) {
    }
    intention.until = parseUntil(words);
    words.end();
    return intention;
}

}  // namespace quaoar
