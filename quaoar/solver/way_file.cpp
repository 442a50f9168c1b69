#include "way_file.hpp"

#include <array>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace quaoar {
namespace {

constexpr const char* wayFirstLine = "quaoar-way 1";
constexpr std::size_t wayBytes = std::size_t{4} << 20;

template <class... Values>
std::string lineOf(const char* pattern, Values... values) {
    std::array<char, 256> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, values...);
    return std::string(buffer.data()) + "\n";
}

std::string situationLine(const Situation& here) {
    std::string line = lineOf("at %.3f %.3f %.3f %.3f", here.place.x(), here.place.y(),
                              here.velocity.x(), here.velocity.y());
    line.pop_back();
    if (here.tied) {
        line += lineOf(" tied %.3f %.3f %.3f", here.anchor.x(), here.anchor.y(), here.length);
        line.pop_back();
    }
    if (here.signals != 0) return line + lineOf(" signals %x", here.signals);
    return line + "\n";
}

/// Goes through the lines of the file and knows where it is.
class WayLines {
public:
    WayLines(const std::string& text, std::string file) : stream_(text), file_(std::move(file)) {}

    std::string next() {
        ++number_;
        std::string line;
        if (!std::getline(stream_, line)) fail("the way ends too early; it was cut short");
        return line;
    }
    /// The value of a line "key value".
    std::string value(const std::string& key) {
        const std::string line = next();
        if (!line.starts_with(key + " ")) fail("expected \"" + key + " ...\"");
        return line.substr(key.size() + 1);
    }
    double number(const std::string& key, double low, double high) {
        return numberOf(value(key), low, high);
    }
    double numberOf(const std::string& text, double low, double high) const {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (text.empty() || *end != 0 || !(value >= low && value <= high)) {
            fail("\"" + text.substr(0, 40) + "\" is not a number from " + std::to_string(low) +
                 " to " + std::to_string(high));
        }
        return value;
    }
    std::uint64_t hash(const std::string& key) {
        const std::string text = value(key);
        if (text.size() != 16 || text.find_first_not_of("0123456789abcdef") != text.npos) {
            fail("a hash has 16 hexadecimal digits");
        }
        return std::stoull(text, nullptr, 16);
    }
    [[noreturn]] void fail(const std::string& problem) const {
        throw WayError(file_ + ":" + std::to_string(number_) + ": " + problem);
    }

private:
    std::istringstream stream_;
    std::string file_;
    int number_ = 0;
};

Situation readSituation(const WayLines& lines, const std::string& text) {
    std::istringstream words(text);
    std::string word;
    const auto number = [&] {
        word.clear();
        words >> word;
        return lines.numberOf(word, -1100, 1100);
    };
    words >> word;
    if (word != "at") lines.fail("expected \"at ...\" or \"end\"");
    Situation here;
    for (int axis = 0; axis < 2; ++axis) here.place[axis] = number();
    for (int axis = 0; axis < 2; ++axis) here.velocity[axis] = number();
    while (words >> word) {
        if (word == "tied") {
            here.tied = true;
            for (int axis = 0; axis < 2; ++axis) here.anchor[axis] = number();
            here.length = number();
        } else if (word == "signals") {
            if (!(words >> std::hex >> here.signals)) lines.fail("has no number after \"signals\"");
        } else {
            lines.fail("has \"" + word + "\" where \"tied ...\" or \"signals ...\" may stand");
        }
    }
    return here;
}

Place readPlace(WayLines& lines, const std::string& first) {
    Place place;
    place.here = readSituation(lines, first);
    const std::string line = lines.value("worth");
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) lines.fail("expected \"worth VALUE: what to do\"");
    place.value = lines.numberOf(line.substr(0, colon), 0, 1);
    try {
        place.choices.push_back({parseIntention(line.substr(colon + 2)), {}, place.value});
    } catch (const WayError& error) {
        lines.fail(std::string("the intention ") + error.what());
    }
    place.best = 0;
    return place;
}

}  // namespace

std::string WayFile::format() const {
    std::string text = std::string(wayFirstLine) + "\n";
    text += "level " + levelId + "\n";
    text += lineOf("level-hash %016" PRIx64, levelHash);
    text += lineOf("searched %.0f", searched);
    text += lineOf("survival %.1f", 100 * survival.share());
    text += lineOf("games %d", survival.games);
    text += lineOf("tries %.0f", survival.tries);
    text += lineOf("seconds %.2f", survival.seconds);
    for (const Place& place : policy.places()) {
        if (place.best < 0) continue;
        const PolicyChoice& best = place.choices[static_cast<std::size_t>(place.best)];
        text += situationLine(place.here);
        std::string worth = lineOf("worth %.3f: ", place.value);
        worth.pop_back();
        text += worth + quaoar::format(best.intention) + "\n";
    }
    return text + "end\n";
}

WayFile WayFile::parse(const std::string& text, const std::string& file) {
    WayLines lines(text, file);
    if (lines.next() != wayFirstLine) {
        lines.fail(std::string("this is no way of version 1; the first line must be \"") +
                   wayFirstLine + "\"");
    }
    WayFile way;
    way.levelId = lines.value("level");
    way.levelHash = lines.hash("level-hash");
    way.searched = lines.number("searched", 0, 1e9);
    const double percent = lines.number("survival", 0, 100);
    way.survival.games = static_cast<int>(lines.number("games", 0, 1e6));
    way.survival.finished = static_cast<int>(std::lround(percent / 100 * way.survival.games));
    way.survival.tries = lines.number("tries", 0, 1e6);
    way.survival.seconds = lines.number("seconds", 0, 1e6);
    for (std::string line = lines.next(); line != "end"; line = lines.next()) {
        way.policy.add(readPlace(lines, line));
    }
    return way;
}

WayFile WayFile::read(const std::filesystem::path& file) {
    try {
        return parse(atlax::readFile(file, wayBytes), file.string());
    } catch (const atlax::Error& error) {
        throw WayError(error.what());
    }
}

void WayFile::write(const std::filesystem::path& file) const {
    atlax::writeFileAtomic(file, format());
}

std::filesystem::path wayOf(const std::filesystem::path& levelFile) {
    std::filesystem::path way = levelFile;
    return way.replace_extension(".way");
}

}  // namespace quaoar
