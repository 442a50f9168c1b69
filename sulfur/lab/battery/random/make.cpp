// The scene of a seed.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "battery/random/dice.hpp"
#include "battery/random/outline.hpp"
#include "battery/random/scene.hpp"

namespace sulfur::lab {

namespace {

using Vec = Eigen::Vector2d;

Vec polar(double length, double angle) {
    return {length * std::cos(angle), length * std::sin(angle)};
}

/// How a family of scenes draws its things.
struct Palette {
    double size = 1;      // m, of the largest
    double sizes = 10;    // the largest over the smallest
    double masses = 30;   // the heaviest over the lightest
    double speed = 1;     // m/s, of the fastest
    double mass = 1;      // kg, of the lightest
    double friction = 1;  // the most
    double restitution = 1;
    double resting = 0.4;  // share of those that do not move at first
    double breakable = 0.1;
    bool alike = false;            // one kind, size, mass and surface, one beside the other
    std::vector<Kind> kinds = {};  // none: all
};

/// Fills a scene, one thing beside another.
class Maker {
public:
    Maker(Scene& scene, Dice& dice, const Palette& palette)
        : scene_(scene), dice_(dice), palette_(palette) {}

    void addThings(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) add(thing());
        stir();
    }
    void add(Thing thing) {
        const Blueprint plan = planOf(thing);
        const double reach = reachOf(plan);
        Outline outline(plan, {0, 0}, thing.angle);
        if (!scene_.things.empty()) place(thing, outline, reach);
        scene_.things.push_back(thing);
        reach_.push_back(reach);
        outlines_.push_back(outline);
    }
    void addTies(std::size_t count) {
        if (scene_.things.size() < 2) return;
        for (std::size_t i = 0; i < count; ++i) {
            Tie tie;
            tie.kind = static_cast<Tie::Kind>(dice_.below(3));
            tie.a = dice_.below(scene_.things.size());
            tie.b = (tie.a + 1 + dice_.below(scene_.things.size() - 1)) % scene_.things.size();
            tie.alongA = dice_.uniform(0, 1);
            tie.alongB = dice_.uniform(0, 1);
            tie.frequency = dice_.decades(5, 500);
            scene_.ties.push_back(tie);
        }
    }
    /// Something moves at first: whoever was added last, if nobody else does.
    void stir() {
        const auto moves = [](const Thing& t) {
            return !t.velocity.isZero() || t.role == Role::driven;
        };
        if (std::any_of(scene_.things.begin(), scene_.things.end(), moves)) return;
        const Thing& target = scene_.things.front();
        Thing& last = scene_.things.back();
        const Vec way = target.place - last.place;
        last.velocity = polar(palette_.speed, std::atan2(way.y(), way.x()));
    }
    /// Half of the width of a room that holds everything, so many times as wide as needed.
    double room(double times = 1.3) const {
        double most = 0;
        for (std::size_t i = 0; i < reach_.size(); ++i)
            most = std::max(most, scene_.things[i].place.cwiseAbs().maxCoeff() + reach_[i]);
        return times * most;
    }

private:
    Thing thing() {
        Thing t;
        if (palette_.alike && !scene_.things.empty()) {
            t = scene_.things.front();
            t.place = {0, 0};
            t.velocity = {dice_.chance(palette_.resting) ? 0 : palette_.speed, 0};
            return t;
        }
        t.kind = palette_.kinds.empty() ? static_cast<Kind>(dice_.below(kindCount))
                                        : palette_.kinds[dice_.below(palette_.kinds.size())];
        t.size = palette_.size / dice_.decades(1, palette_.sizes);
        t.mass = palette_.mass * dice_.decades(1, palette_.masses);
        t.variant = dice_.uniform(0, 1);
        t.frequency = dice_.decades(10, 1000);
        t.friction = dice_.chance(0.3) ? 0 : dice_.uniform(0, palette_.friction);
        t.restitution = dice_.chance(0.5) ? 0 : dice_.uniform(0, palette_.restitution);
        if (palette_.alike && dice_.chance(0.5)) t.restitution = palette_.restitution;
        if (t.kind == Kind::wall || dice_.chance(palette_.breakable))
            t.strength = dice_.decades(100, 1e5);
        t.angle = dice_.angle();
        if (!dice_.chance(palette_.resting)) {
            const double speed = palette_.speed * dice_.decades(0.05, 1);
            t.velocity = {speed, 0};  // towards whom place() decides
            if (dice_.chance(0.5)) t.spin = dice_.uniform(-1, 1) * speed / t.size;
        }
        return t;
    }
    /// Beside another thing: so near that the two meet, if one of them moves.
    void place(Thing& t, Outline& outline, double reach) {
        const double seconds = static_cast<double>(scene_.ticks) / scene_.rate;
        const std::size_t other = dice_.below(scene_.things.size());
        const double speed = t.velocity.norm() + scene_.things[other].velocity.norm();
        double gap = t.size * dice_.decades(1e-4, 0.3);
        if (palette_.alike) gap = dice_.chance(0.3) ? 0 : t.size * dice_.decades(1e-4, 1e-2);
        if (!palette_.alike && dice_.chance(0.5))
            gap += std::min(speed * seconds * dice_.uniform(0.02, 0.4), 20 * palette_.size);
        for (int tries = 0;; ++tries) {
            const Vec heading = polar(1, dice_.angle());
            const Vec outside =
                scene_.things[other].place + (reach_[other] + reach + gap) * heading;
            outline.move(outside - t.place);
            t.place = outside;
            approach(t, outline, other, heading, gap);
            if (isFree(t, outline, reach, gap)) break;
            if (tries % 8 == 7) gap = 1.5 * gap + 0.1 * t.size;
        }
        const Vec way = scene_.things[other].place - t.place;
        const double heading = std::atan2(way.y(), way.x()) + dice_.uniform(-0.3, 0.3);
        t.velocity = polar(t.velocity.norm(), heading);
    }
    /// Goes against `heading` until the surfaces are `gap` apart.
    void approach(Thing& t, Outline& outline, std::size_t other, const Vec& heading,
                  double gap) const {
        for (int i = 0; i < 30; ++i) {
            const double rest = distance(outline, outlines_[other]) - gap;
            if (rest < 0.1 * gap + 1e-6 * t.size ||
                (t.place - scene_.things[other].place).dot(heading) < 0)
                return;
            outline.move(-rest * heading);
            t.place -= rest * heading;
        }
    }
    bool isFree(const Thing& t, const Outline& outline, double reach, double gap) const {
        for (std::size_t i = 0; i < reach_.size(); ++i) {
            const bool near = (scene_.things[i].place - t.place).norm() <= reach_[i] + reach + gap;
            if (near && !isApart(outline, outlines_[i], t, i, reach, gap)) return false;
        }
        return true;
    }
    /// Apart, and neither within the other.
    bool isApart(const Outline& outline, const Outline& other, const Thing& t, std::size_t i,
                 double reach, double gap) const {
        const double middles = (scene_.things[i].place - t.place).norm();
        return middles > 0.3 * std::max(reach_[i], reach) &&
               distance(outline, other) >= std::min(gap, 1e-4 * t.size) - 1e-9 * t.size;
    }

    Scene& scene_;
    Dice& dice_;
    const Palette& palette_;
    std::vector<double> reach_;
    std::vector<Outline> outlines_;
};

/// rad/s: what turns by more than half a turn in a tick shows another spin to who only looks at
/// chords, and who is struck off its middle turns at about its speed over its size.
constexpr double fastestSpin = 3000;

Palette anyPalette(Dice& dice) {
    Palette p;
    p.speed = dice.decades(0.1, 300);
    p.sizes = dice.chance(0.7) ? dice.decades(1, 10) : dice.decades(10, 1000);
    p.size = std::max(dice.decades(0.03, 30), p.speed * p.sizes / fastestSpin);
    p.masses = dice.chance(0.5) ? dice.decades(1, 30) : dice.decades(30, 1e6);
    p.mass = dice.decades(1e-3, 1e3) / std::sqrt(p.masses);
    p.alike = dice.chance(0.2);
    if (p.alike) p.sizes = p.masses = 1;
    return p;
}

int anyRate(Dice& dice) {
    constexpr std::array rates{60, 120, 240, 500, 500, 1000, 2000};
    return rates[dice.below(rates.size())];
}

/// Free space: momentum, angular momentum and energy are kept.
Scene closedScene(Dice& dice) {
    Scene scene;
    scene.rate = anyRate(dice);
    scene.ticks = static_cast<int>(dice.uniform(60, 300));
    scene.sleeping = dice.chance(0.5);
    Palette palette = anyPalette(dice);
    if (scene.sleeping) {
        scene.calm = 2;
        palette.resting = 0.8;
    }
    Maker maker(scene, dice, palette);
    maker.addThings(2 + dice.below(8));
    if (dice.chance(0.4)) maker.addTies(1 + dice.below(3));
    return scene;
}

/// A room with gravity.
Scene roomScene(Dice& dice) {
    Scene scene;
    scene.rate = anyRate(dice);
    scene.ticks = static_cast<int>(dice.uniform(100, 400));
    scene.sleeping = dice.chance(0.5);
    const Palette palette = anyPalette(dice);
    Maker maker(scene, dice, palette);
    maker.addThings(2 + dice.below(10));
    if (dice.chance(0.4)) maker.addTies(1 + dice.below(3));
    scene.gravity = dice.chance(0.3) ? 0 : dice.decades(1, 30);
    scene.room = maker.room();
    return scene;
}

/// A room with drivers: what turns about itself, apart from the walls, pushes the others.
Scene drivenScene(Dice& dice) {
    Scene scene;
    scene.rate = anyRate(dice);
    scene.ticks = static_cast<int>(dice.uniform(100, 300));
    scene.sleeping = dice.chance(0.5);
    Palette palette = anyPalette(dice);
    palette.resting = 1;
    palette.restitution = 0.5;
    palette.sizes = std::min(palette.sizes, 20.0);
    palette.size = std::max(palette.size, palette.speed * palette.sizes / fastestSpin);
    const bool crowd = dice.chance(0.5);
    if (crowd) palette.kinds = {Kind::ball, Kind::crate, Kind::plank, Kind::polygon};
    Maker maker(scene, dice, palette);
    Thing rotor{.kind = dice.chance(0.5) ? Kind::plank : Kind::crate, .role = Role::driven};
    rotor.size = palette.size * dice.uniform(1, 5);
    // Half a turn to three, at most 300 m/s at its ends.
    const double seconds = static_cast<double>(scene.ticks) / scene.rate;
    rotor.spin = std::min(2 * std::numbers::pi * dice.uniform(0.5, 3) / seconds, 600 / rotor.size) *
                 (dice.chance(0.5) ? 1 : -1);
    rotor.friction = dice.uniform(0, 1);
    maker.add(rotor);
    maker.addThings(4 + dice.below(crowd ? 30 : 10));
    scene.gravity = dice.chance(0.5) ? 0 : 9.81;
    // What is between the rotor and a wall has room enough.
    scene.room = std::max(maker.room(1.1), rotor.size / 2 + 2 * palette.size);
    return scene;
}

/// A room with fields, hands and air.
Scene influencedScene(Dice& dice) {
    Scene scene = roomScene(dice);
    scene.airFriction = dice.chance(0.5) ? 0 : dice.decades(0.01, 10);
    const std::size_t count = 1 + dice.below(2);
    for (std::size_t i = 0; i < count; ++i)
        scene.influences.push_back({.kind = static_cast<Influence::Kind>(dice.below(3)),
                                    .strength = dice.decades(0.1, 30),
                                    .angle = dice.angle()});
    if (dice.chance(0.5))
        scene.ties.push_back({.kind = Tie::Kind::grab,
                              .a = dice.below(scene.things.size()),
                              .alongA = dice.uniform(0, 1)});
    if (dice.chance(0.3)) scene.things[dice.below(scene.things.size())].role = Role::sensor;
    return scene;
}

/// What falls at no more than 5 m/s into a room, with friction and without much rebound, and has no
/// wheels: it comes to rest.
Scene restingScene(Dice& dice) {
    Scene scene;
    scene.rate = std::array{60, 120, 240, 500}[dice.below(4)];
    scene.sleeping = dice.chance(0.5);
    scene.gravity = 9.81;
    scene.restsAfter = 6;
    scene.ticks = static_cast<int>(7 * scene.rate);
    Palette palette;
    palette.size = dice.decades(0.3, 2);
    palette.sizes = dice.decades(1, 4);
    palette.masses = dice.decades(1, 100);
    palette.speed = dice.decades(0.1, 5);
    palette.restitution = 0.3;
    palette.breakable = 0;
    palette.kinds = {Kind::crate, Kind::plank, Kind::hook, Kind::jelly, Kind::crate};
    {
        Maker maker(scene, dice, palette);
        maker.addThings(2 + dice.below(5));
        scene.room = std::max(maker.room(), 2 * palette.size);
    }
    for (Thing& thing : scene.things) {
        thing.friction = std::max(thing.friction, 0.3);
        thing.frequency = std::max(thing.frequency, 100.0);
    }
    return scene;
}

}  // namespace

Scene sceneOf(std::uint64_t seed) {
    Dice dice(seed);
    constexpr std::array<Scene (*)(Dice&), 10> families{
        closedScene, closedScene, closedScene, closedScene,     closedScene,
        roomScene,   roomScene,   drivenScene, influencedScene, restingScene};
    // In turn, so that any ten seeds in a row have all of them.
    return families[seed % families.size()](dice);
}

bool Scene::undriven() const {
    const auto drives = [](const Thing& t) { return t.role == Role::driven; };
    const auto pulls = [](const Tie& t) { return t.kind == Tie::Kind::grab; };
    return influences.empty() && std::none_of(things.begin(), things.end(), drives) &&
           std::none_of(ties.begin(), ties.end(), pulls);
}

bool Scene::closed() const {
    return undriven() && gravity == 0 && room == 0 && airFriction == 0;
}

}  // namespace sulfur::lab
