#include "daily_course.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace quaoar {
namespace {

/// Random numbers that are the same everywhere (Steele, Lea and Flood 2014, "SplitMix64").
class DayDice {
public:
    explicit DayDice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
    }
    bool happens(double chance) { return between(0, 1) < chance; }

private:
    std::uint64_t state_;
};

struct Spot {
    double x = 0, y = 0;
};

std::string metresText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

std::string pairText(const Spot& spot) {
    return "[" + metresText(spot.x) + ", " + metresText(spot.y) + "]";
}

constexpr const char* rockWords =
    "\"shape\": \"ground\", \"kind\": \"fixed\", \"closed\": true, \"radius\": 0.05, "
    "\"material\": {\"staticFriction\": 0.5, \"kineticFriction\": 0.35, \"restitution\": 0}";
constexpr double groundLow = -6.2;  // m: where the ground ends below
constexpr double roofHeight = 2.6;  // m above a place to stand

enum class Piece : std::uint8_t { gap, step, spikes, crates, jelly };

/// What has been laid so far, from the left to the right.
class Course {
public:
    explicit Course(std::uint64_t seed) : dice_(seed) {
        floor_ = {{-5, 1.7}, {-1.6, 1.2}, {-1.2, 0.5}, {-0.6, 0.08}, {0.4, 0}};
        roof_ = {{-5, 1.8}, {-1.75, 1.6}, {-1.2, 2.3}, {0.4, roofHeight}};
        stand(2.2);
        std::array<Piece, 5> pieces{Piece::gap, Piece::step, Piece::spikes, Piece::crates,
                                    Piece::jelly};
        for (std::size_t i = pieces.size() - 1; i > 0; --i)
            std::swap(pieces[i], pieces[dice_.next() % (i + 1)]);
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
            lay(pieces[i]);
            const double before = at_.x;
            stand(dice_.between(1.8, 2.4));
            // The exit is behind the last one.
            if (i + 2 < pieces.size()) checkpoints_.push_back({(before + at_.x) / 2, at_.y + 0.4});
        }
        end();
    }

    std::string text(const std::string& date, const MedalTimes& medals);

private:
    void lay(Piece piece) {
        switch (piece) {
            case Piece::gap:
                return gap(dice_.between(2.6, 3.6), dice_.between(-0.2, 0.2));
            case Piece::step:
                return gap(dice_.between(1.8, 2.4), dice_.between(0.4, 0.8));
            case Piece::spikes:
                return spikes(dice_.between(2.2, 3.0));
            case Piece::crates:
                return crates(dice_.between(2.4, 3.2));
            case Piece::jelly:
                return jelly(dice_.between(2.0, 2.6));
        }
    }

    void stand(double width) {
        floor_.push_back(at_);
        floor_.push_back({at_.x + width / 2, at_.y + 0.03});
        roof_.push_back({at_.x + 0.2, at_.y + roofHeight + 0.1});
        at_.x += width;
        floor_.push_back(at_);
        roof_.push_back({at_.x - 0.2, at_.y + roofHeight + 0.1});
    }

    /// A pit with something to hook over it; the far side is `up` higher.
    void gap(double width, double up) {
        const double far = at_.x + width, top = at_.y + std::max(0.0, up);
        floor_.insert(floor_.end(), {{at_.x + 0.05, at_.y - 0.5},
                                     {at_.x + 0.1, -4},
                                     {far - 0.1, -4},
                                     {far - 0.05, at_.y + up - 0.5}});
        roof_.insert(roof_.end(), {{at_.x + 0.6, at_.y + 3.6}, {far - 0.6, at_.y + up + 3.8}});
        bolt({at_.x + width / 2 + dice_.between(-0.2, 0.2), top + dice_.between(2.2, 2.6)});
        if (width > 3) bolt({at_.x + 0.85 * width, top + dice_.between(2.3, 2.7)});
        if (dice_.happens(0.7))
            shards_.push_back({at_.x + width / 2, at_.y + dice_.between(0.2, 1.2)});
        at_ = {far, at_.y + up};
    }

    void spikes(double width) {
        const double far = at_.x + width;
        floor_.insert(floor_.end(), {{at_.x + 0.1, at_.y - 0.55}, {far - 0.1, at_.y - 0.55}});
        roof_.insert(roof_.end(), {{at_.x + 0.5, at_.y + 3.3}, {far - 0.5, at_.y + 3.3}});
        const std::array<Spot, 4> slab{
            {{0.25, -0.5}, {width - 0.25, -0.5}, {width - 0.25, -0.3}, {0.25, -0.3}}};
        std::string points;
        for (const Spot& spot : slab) points += (points.empty() ? "" : ", ") + pairText(spot);
        blueprint("spikes", std::string(rockWords) + ", \"points\": [" + points + "]");
        body("spikes", "spikes", at_, R"({"look": "rock", "sticky": false, "deadly": true})");
        bolt({at_.x + 0.35 * width, at_.y + dice_.between(2.0, 2.4)});
        bolt({at_.x + 0.85 * width, at_.y + dice_.between(2.1, 2.5)});
        at_.x = far;
    }

    void crates(double width) {
        roof_.insert(roof_.end(), {{at_.x + 0.4, at_.y + 2.3}, {at_.x + width - 0.4, at_.y + 2.4}});
        blueprint(
            "crate",
            R"("shape": "box", "size": [0.36, 0.36], "mass": 1.2, "radius": 0.02, )"
            R"("material": {"staticFriction": 0.6, "kineticFriction": 0.5, "restitution": 0}, )"
            R"("skin": {"texture": "crate.svg"})");
        const double x = at_.x + 0.55 * width;
        const std::array<Spot, 3> pile{{{x, 0.25}, {x + 0.38, 0.25}, {x + 0.19, 0.62}}};
        for (std::size_t i = 0; i < pile.size(); ++i)
            body("crate-" + std::to_string(i + 1), "crate", {pile[i].x, at_.y + pile[i].y},
                 R"({"look": "metal"})");
        at_.x += width;
    }

    void jelly(double width) {
        const double far = at_.x + width;
        floor_.insert(floor_.end(), {{at_.x + 0.05, at_.y - 0.7}, {far - 0.05, at_.y - 0.7}});
        roof_.insert(roof_.end(), {{at_.x + 0.5, at_.y + 3.2}, {far - 0.5, at_.y + 3.2}});
        blueprint("jelly", R"("shape": "jelly", "size": [)" + metresText(width - 0.25) +
                               R"(, 0.55], "columns": 8, "rows": 3, "mass": 6, "stiffness": 500, )"
                               R"("damping": 0.5, "skin": {"texture": "jelly.svg"})");
        body("jelly", "jelly", {at_.x + width / 2, at_.y - 0.36}, "");
        bolt({at_.x + 0.6 * width, at_.y + dice_.between(2.0, 2.4)});
        at_.x = far;
    }

    void end() {
        floor_.insert(
            floor_.end(),
            {{at_.x + 2.2, at_.y + 0.02}, {at_.x + 2.8, at_.y + 0.8}, {at_.x + 5.5, at_.y + 1.6}});
        roof_.insert(roof_.end(), {{at_.x + 2, at_.y + roofHeight + 0.1},
                                   {at_.x + 2.9, at_.y + 1.9},
                                   {at_.x + 5.5, at_.y + 1.8}});
        shards_.push_back({at_.x + 1, at_.y + 0.5});
    }

    void bolt(const Spot& spot) {
        if (bolts_ == 0)
            blueprint("bolt", R"("shape": "ground", "kind": "fixed", "closed": true, )"
                              R"("radius": 0.05, "points": [[-0.1, -0.12], [0.1, -0.12], )"
                              R"([0.12, 0.1], [-0.12, 0.1]])");
        body("bolt-" + std::to_string(++bolts_), "bolt", spot, R"({"look": "peg"})");
    }

    void blueprint(const std::string& name, const std::string& what) {
        blueprints_ += ",\n    \"" + name + "\": {" + what + "}";
    }
    void body(const std::string& id, const std::string& blueprint, const Spot& spot,
              const std::string& surface) {
        bodies_ += ",\n    {\"id\": \"" + id + "\", \"blueprint\": \"" + blueprint +
                   "\", \"position\": " + pairText(spot) + "}";
        if (!surface.empty()) surfaces_ += ",\n      \"" + id + "\": " + surface;
    }

    DayDice dice_;
    Spot at_{0.4, 0};
    std::vector<Spot> floor_, roof_, checkpoints_, shards_;
    std::string blueprints_, bodies_, surfaces_;
    int bolts_ = 0;
};

/// Without points that lie on each other, where pieces meet.
std::string outlineOf(const std::vector<Spot>& spots) {
    std::string text;
    Spot last{1e9, 1e9};
    for (const Spot& spot : spots) {
        if (std::abs(spot.x - last.x) + std::abs(spot.y - last.y) < 0.02) continue;
        text += (text.empty() ? "" : ", ") + pairText(spot);
        last = spot;
    }
    return "[" + text + "]";
}

/// As members of an array, each with an id and a place.
std::string placesText(const char* name, const std::vector<Spot>& spots) {
    std::string text;
    for (std::size_t i = 0; i < spots.size(); ++i)
        text += std::string(i == 0 ? "" : ", ") + "{\"id\": \"" + name + "-" +
                std::to_string(i + 1) + "\", \"position\": " + pairText(spots[i]) + "}";
    return "[" + text + "]";
}

std::string Course::text(const std::string& date, const MedalTimes& medals) {
    static constexpr std::array<const char*, 4> worlds{"dawn", "bog", "machine", "deep"};
    const char* world = worlds[dice_.next() % worlds.size()];
    const std::string seed = std::to_string(dice_.next() % 1000);
    double high = 0;
    for (const Spot& spot : roof_) high = std::max(high, spot.y);
    high += 2.2;
    const double right = at_.x + 5.5;
    std::vector<Spot> ground{{-5, groundLow}, {right, groundLow}};
    ground.insert(ground.end(), floor_.rbegin(), floor_.rend());
    std::vector<Spot> roof = roof_;
    roof.insert(roof.end(), {{right, high}, {-5, high}});
    const std::string day = date.size() == 10 ? std::to_string(std::stoi(date.substr(8))) : "1";
    return "{\n  \"format\": \"sulfur-scene\",\n  \"version\": 1,\n"
           "  \"title\": \"Level of the day\",\n  \"description\": \"" +
           date +
           "\",\n"
           "  \"world\": {\"gravity\": [0, -9.81], \"airFriction\": 0.05, \"tickRate\": 500, "
           "\"sweeps\": 4},\n"
           "  \"level\": {\n    \"name\": \"Level of the day\",\n    \"number\": " +
           day + ",\n    \"spawn\": [0.6, 0.3],\n    \"exit\": {\"position\": " +
           pairText({at_.x + 1.9, at_.y + 1}) +
           ", \"radius\": 0.6},\n    \"bounds\": {\"min\": [-2.2, -2.6], \"max\": " +
           pairText({at_.x + 3.2, high - 1.2}) +
           "},\n    \"killDepth\": -2.4,\n    \"medals\": {\"gold\": " + metresText(medals.gold) +
           ", \"silver\": " + metresText(medals.silver) +
           ", \"bronze\": " + metresText(medals.bronze) +
           "},\n    \"surfaces\": {\n      \"ground\": {\"look\": \"ice\"},\n"
           "      \"roof\": {\"look\": \"ice\"}" +
           surfaces_ + "\n    },\n    \"checkpoints\": " + placesText("stand", checkpoints_) +
           ",\n    \"pickups\": " + placesText("shard", shards_) +
           ",\n    \"theme\": {\"world\": \"" + world + "\", \"seed\": " + seed +
           "}\n  },\n"
           "  \"blueprints\": {\n    \"ground\": {" +
           rockWords + ", \"points\": " + outlineOf(ground) + "},\n    \"roof\": {" + rockWords +
           ", \"points\": " + outlineOf(roof) + "}" + blueprints_ +
           "\n  },\n  \"bodies\": [\n    {\"id\": \"ground\", \"blueprint\": \"ground\"},\n"
           "    {\"id\": \"roof\", \"blueprint\": \"roof\"}" +
           bodies_ + "\n  ]\n}\n";
}

}  // namespace

std::string dailyCourse(const std::string& date, int plan, const MedalTimes& medals) {
    Course course(contentHash(date) + static_cast<std::uint64_t>(plan));
    return course.text(date, medals);
}

std::string dailyId(const std::string& date) {
    return "daily-" + date;
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", &local);
    return text;
}

}  // namespace quaoar
