#include "battery/contacts/shots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double fastest = 300;  // m/s

Point rotated(const Point& p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

Material randomSurface(Random& random) {
    return {.restitution = real(random.uniform(0, 1) < 0.5 ? 0.0 : random.uniform(0, 0.9))};
}

struct Thing {
    std::string kind;
    Blueprint plan;
};

Thing randomProjectile(Random& random) {
    const int kind = static_cast<int>(random.uniform(0, 4));
    const double mass = std::pow(10.0, random.uniform(-1, 1));
    const double size = random.uniform(0.2, 0.5);
    Thing thing;
    if (kind == 0) {
        const double half = size;
        thing = {"rod", shapes::rope({.from = vec2(-half, 0),
                                      .to = vec2(half, 0),
                                      .links = 1,
                                      .mass = real(mass),
                                      .radius = real(random.uniform(0.01, 0.03))})};
    } else if (kind == 1) {
        thing = {"crate", crate({.size = size, .mass = mass})};
    } else if (kind == 2) {
        thing = {"jelly", firmJelly(size, mass, std::pow(10.0, random.uniform(2, 5)), 1)};
    } else {
        thing = {"ball", shapes::ball({.radius = real(size / 4), .mass = real(mass)})};
    }
    thing.plan.material = randomSurface(random);
    return thing;
}

/// Gives a body a velocity and a spin about its centre.
void launch(World& world, const Body& body, const Vec& velocity, double omega) {
    spin(world, body, omega);
    for (const ParticleId id : body.particles())
        world.setVelocity(id, world.velocity(id) + velocity.cast<Real>());
}

/// For each particle of a plan whether it has a surface: a radius, or a capsule.
std::vector<bool> surfaceOf(const Blueprint& plan) {
    std::vector<bool> surface;
    for (const ParticleSpec& p : plan.particles) surface.push_back(p.radius > 0);
    for (const JointSpec& joint : plan.joints)
        if (joint.radius > 0) surface[joint.a] = surface[joint.b] = true;
    return surface;
}

/// Where the projectile is that it may not be.
struct Verdict {
    bool through = false;  // its surface
    bool inner = false;    // a particle that touches nothing, after the last tick
};

/// A shot, set up and ready to be let go.
class Shot {
public:
    Shot(const Setup& setup, Random& random)
        : world(still(setup, 0)),
          projectile_(randomProjectile(random)),
          surface_(surfaceOf(projectile_.plan)) {}
    virtual ~Shot() = default;

    /// Call after every tick; `last` says that it was the last one.
    Verdict judge(bool last) {
        look();
        Verdict verdict;
        Point sum(0, 0);
        for (std::size_t i = 0; i < body.size(); ++i) {
            const Point p = world.position(body[i]);
            if (surface_[i]) sum += p;
            if (!behind(i, p)) continue;
            if (surface_[i]) verdict.through = verdict.through || last || atAnyTime();
            if (!surface_[i]) verdict.inner = last;
        }
        const auto count = static_cast<double>(std::count(surface_.begin(), surface_.end(), true));
        verdict.through = verdict.through || behind(body.size(), sum / count);
        return verdict;
    }

    World world;
    Body body;
    int ticks = 0;  // to run
    std::string target;
    const std::string& projectile() const { return projectile_.kind; }

protected:
    const Blueprint& plan() const { return projectile_.plan; }

private:
    /// Called before behind() in each tick.
    virtual void look() {}
    /// Whether a place is behind what is shot at, or not finite: that of particle `i`, or of the
    /// middle of all that have a surface, which has the number after the last one.
    virtual bool behind(std::size_t i, const Point& p) = 0;
    /// Whether no particle may ever be behind, or only none at the end and the middle never.
    virtual bool atAnyTime() const = 0;

    Thing projectile_;
    std::vector<bool> surface_;
};

class RoomShot final : public Shot {
public:
    RoomShot(const Setup& setup, Random& random)
        : Shot(setup, random), angle_(random.uniform(0, std::numbers::pi)) {
        target = "thin walls";
        world.add(shapes::ground({.points = {vec2(-half, -half), vec2(half, -half),
                                             vec2(half, half), vec2(-half, half)},
                                  .closed = true,
                                  .radius = real(random.uniform(0.01, 0.05)),
                                  .material = randomSurface(random)}),
                  {.angle = angle_});
        body = world.add(plan(), {.position = Point(random.uniform(-1, 1), random.uniform(-1, 1)),
                                  .angle = random.uniform(0, 2 * std::numbers::pi)});
        const Point way =
            rotated(Point(random.uniform(1, fastest), 0), random.uniform(0, 2 * std::numbers::pi));
        launch(world, body, way, random.uniform(-50, 50));
        ticks = setup.tickRate / 5;
    }

private:
    bool behind(std::size_t, const Point& p) override {
        return !(rotated(p, -angle_).cwiseAbs().maxCoeff() < half);
    }
    bool atAnyTime() const override { return true; }

    static constexpr double half = 2;  // m
    double angle_;
};

/// Whether the end of an open line is what is nearest to a point.
bool beyondEnds(const std::vector<Point>& line, const Point& p) {
    double nearest = std::numeric_limits<double>::max();
    bool end = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point way = line[i + 1] - line[i];
        const double t = std::clamp((p - line[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
        const double distance = (p - line[i] - t * way).norm();
        if (distance > nearest) continue;
        nearest = distance;
        end = (i == 0 && t <= 0) || (i + 2 == line.size() && t >= 1);
    }
    return end;
}

/// What is shot at: the particles of the side that is hit, from left to right seen from the other
/// side of the thing. A ball has none.
struct Target {
    Thing thing;
    std::vector<std::size_t> front;
    double surface = 0;  // m, of the front's axis above the middle
};

constexpr double bigBall = 1;  // m

Target randomTarget(Random& random) {
    const int kind = static_cast<int>(random.uniform(0, 5));
    const double mass = std::pow(10.0, random.uniform(-0.5, 1.5));
    Target target;
    const auto line = [&](int links, double radius) {
        return shapes::rope({.from = vec2(-2.5, 0),
                             .to = vec2(2.5, 0),
                             .links = links,
                             .mass = real(mass),
                             .radius = real(radius)});
    };
    if (kind == 0) {
        target = {{"a plank", line(1, random.uniform(0.02, 0.05))}, {0, 1}};
    } else if (kind == 1) {
        target = {
            {"a crate", shapes::box({.size = vec2(3, 0.6), .mass = real(mass)})}, {3, 2}, 0.3};
    } else if (kind == 2) {
        const double stiffness = std::pow(10.0, random.uniform(2.5, 5));
        target = {{"a jelly", shapes::jelly({.size = vec2(3, 1),
                                             .columns = 7,
                                             .rows = 3,
                                             .mass = real(mass),
                                             .stiffness = real(stiffness)})},
                  {14, 15, 16, 17, 18, 19, 20},
                  0.5};
    } else if (kind == 3) {
        target = {{"a rope", line(100, 0.015)}, {}};
        for (std::size_t i = 0; i <= 100; ++i) target.front.push_back(i);
    } else {
        target = {
            {"a ball", shapes::ball({.radius = real(bigBall), .mass = real(mass)})}, {}, bigBall};
    }
    target.thing.plan.material = randomSurface(random);
    return target;
}

class BodyShot final : public Shot {
public:
    BodyShot(const Setup& setup, Random& random) : Shot(setup, random), aim_(randomTarget(random)) {
        target = aim_.thing.kind;
        constexpr double distance = 1.5, after = 1;  // m
        const double turned = random.uniform(0, 2 * std::numbers::pi);
        target_ = world.add(aim_.thing.plan, {.angle = turned});
        // Within 60 degrees of the front's normal, so that nothing touches at the start; at a ball
        // nearer to its middle, so that nothing gets past it on the way that is watched.
        const double slant = random.uniform(-1, 1) * (aim_.front.empty() ? 0.3 : 1.0);
        const Point down = rotated(Point(0, -1), slant);
        const Point hit(random.uniform(-0.3, 0.3), aim_.surface);
        body = world.add(plan(), {.position = rotated(hit - distance * down, turned),
                                  .angle = random.uniform(0, 2 * std::numbers::pi)});
        const double speed = random.uniform(10, fastest);
        const bool moving = random.uniform(0, 1) < 0.5;
        const Vec common =
            moving ? Vec(random.uniform(-100, 100), random.uniform(-100, 100)) : Vec(Vec::Zero());
        const Vec way = rotated(speed * down, turned);
        launch(world, target_, common, moving ? random.uniform(-1, 1) : 0);
        launch(world, body, common + way, random.uniform(-50, 50));
        way_ = way.normalized();
        behind_ = rotated(Point(0, -1), turned);
        // As long at any rate: what is dragged far on wraps round it.
        const double seconds = (distance + after) / speed + 2.0 / 500;
        ticks = static_cast<int>(std::lround(seconds * setup.tickRate));
    }

private:
    void look() override {
        beyond_.resize(body.size() + 1, false);
        front_.clear();
        for (const std::size_t i : aim_.front) front_.push_back(world.position(target_[i]));
        if (front_.empty()) return;
        // Closed far behind, the front goes round what has passed through it.
        constexpr double far = 100;  // m
        closed_ = front_;
        closed_.push_back(front_.back() + far * behind_);
        closed_.push_back(front_.front() + far * behind_);
    }

    bool behind(std::size_t i, const Point& p) override {
        if (!p.allFinite()) return true;
        if (front_.empty()) {
            const Point way = p - world.centreOfMass(target_);
            return way.norm() < bigBall / 2 || (i == body.size() && way.dot(way_) > 0);
        }
        // Once it is beyond an end, it may be anywhere.
        beyond_[i] = beyond_[i] || beyondEnds(front_, p);
        return !beyond_[i] && windingNumber(closed_, p) != 0;
    }
    bool atAnyTime() const override { return false; }

    Target aim_;
    Body target_;
    Vec way_;
    Point behind_{0, 0};  // from the front into the thing
    std::vector<Point> front_, closed_;
    std::vector<bool> beyond_;  // of each particle, and of the middle
};

std::unique_ptr<Shot> prepare(long number, const Setup& setup) {
    Random random(static_cast<std::uint64_t>(number));
    if (number % 2 == 0) return std::make_unique<RoomShot>(setup, random);
    return std::make_unique<BodyShot>(setup, random);
}

ShotTick look(const Shot& shot, double energy, bool through) {
    const Point centre = shot.world.centreOfMass(shot.body);
    const Vec2 velocity = shot.world.meanVelocity(shot.body);
    return {.time = shot.world.time(),
            .x = centre.x(),
            .y = centre.y(),
            .speedX = static_cast<double>(velocity.x()),
            .speedY = static_cast<double>(velocity.y()),
            .energy = energy,
            .contacts = static_cast<int>(shot.world.contacts().size()),
            .through = through};
}

/// What became of all shots of one projectile at one target.
struct Tally {
    int shots = 0, through = 0, inner = 0, gained = 0;
    long firstThrough = -1, firstGained = -1;
    double gain = 0;
};

constexpr double gainBound = 1e-4;

void count(Tally& tally, const ShotResult& result, long number) {
    ++tally.shots;
    if (result.through && tally.through++ == 0) tally.firstThrough = number;
    tally.inner += result.inner ? 1 : 0;
    if (!(result.energyGain <= gainBound) && tally.gained++ == 0) tally.firstGained = number;
    tally.gain = worst(tally.gain, result.energyGain);
}

/// JSON knows neither NaN nor infinity.
std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string first(long number) {
    return number < 0 ? "" : fmt::format(", first with --shot {}", number);
}

}  // namespace

ShotResult shoot(long number, const Setup& setup, std::vector<ShotTick>* ticks) {
    const auto shot = prepare(number, setup);
    ShotResult result{shot->projectile(), shot->target};
    double start = shot->world.energy();
    for (int i = 0; i < shot->ticks; ++i) {
        shot->world.step();
        const Verdict verdict = shot->judge(i + 1 == shot->ticks);
        const double energy = shot->world.energy();
        // A rod's velocities are set for the start of the tick and stand in its middle after it.
        const Events& events = shot->world.events();
        const bool untouched = shot->world.contacts().empty() && events.contactsBegun.empty();
        if (i == 0 && untouched) start = energy;
        result.through = result.through || verdict.through;
        result.inner = result.inner || verdict.inner;
        result.energyGain = worst(result.energyGain, energy / start - 1);
        if (ticks != nullptr) ticks->push_back(look(*shot, energy, verdict.through));
    }
    if (ticks != nullptr) keepPicture(setup, fmt::format("shot-{}", number), shot->world);
    return result;
}

ShotReplay replayShot(long number, const Setup& setup) {
    ShotReplay replay{.number = number, .result = {}, .ticks = {}};
    replay.result = shoot(number, setup, &replay.ticks);
    return replay;
}

std::string asText(const ShotReplay& replay) {
    return fmt::format("Shot {}: a {} at {}, {}; largest gain of energy {:.3g} of it.\n{}",
                       replay.number, replay.result.projectile, replay.result.target,
                       replay.result.through ? "passes through" : "does not pass through",
                       replay.result.energyGain, asCsv(replay));
}

std::string asCsv(const ShotReplay& replay) {
    std::string out = "time,x,y,speedX,speedY,energy,contacts,through\n";
    for (const ShotTick& t : replay.ticks)
        out += fmt::format("{:.4f},{:.5f},{:.5f},{:.4f},{:.4f},{:.7g},{},{}\n", t.time, t.x, t.y,
                           t.speedX, t.speedY, t.energy, t.contacts, t.through);
    return out;
}

std::string asJson(const ShotReplay& replay) {
    std::string out = fmt::format("{{\n  \"shot\": {},\n  \"ticks\": [", replay.number);
    const char* separator = "\n";
    for (const ShotTick& t : replay.ticks) {
        out += fmt::format(
            "{}    {{\"time\": {:.4f}, \"x\": {}, \"y\": {}, \"energy\": {}, "
            "\"through\": {}}}",
            separator, t.time, number(t.x), number(t.y), number(t.energy), t.through);
        separator = ",\n";
    }
    return out + "\n  ]\n}\n";
}

/// What soft things may still gain: a jelly at 300 m/s covers more than its own width in a tick,
/// turns inside out, and its springs then push on after the impact.
constexpr double mostGained = 6;

/// None, but for what is soft: at most one shot in twenty.
double throughAtMost(const std::array<std::string, 2>& pair, const Tally& tally) {
    if (pair[0] == "thin walls") return 0;
    const bool soft = pair[0] == "a jelly" || pair[0] == "a rope" || pair[1] == "jelly";
    return soft ? std::ceil(static_cast<double>(tally.shots) / 20) : 0;
}

Rows shots(const Setup& setup) {
    std::map<std::array<std::string, 2>, Tally> tallies;
    const int each = setup.quick ? std::min(setup.shots, 1000) : setup.shots;
    for (long number = 0; number < 2L * each; ++number) {
        const ShotResult result = shoot(number, setup);
        count(tallies[{result.target, result.projectile}], result, number);
    }
    Rows rows;
    for (const auto& [pair, tally] : tallies) {
        const std::string name =
            fmt::format("{} shots of a {} at {}: ", tally.shots, pair[1], pair[0]);
        const std::string passes = name + "pass through" + first(tally.firstThrough);
        const double through = throughAtMost(pair, tally);
        rows.push_back(through > 0 ? fallsShort(passes, tally.through, through, 0)
                                   : atMost(passes, tally.through, 0));
        if (pair[1] == "jelly")
            rows.push_back(reported(name + "inner particles behind at the end", tally.inner));
        const std::string gains = fmt::format("{}gain of energy (share; {} above the bound{})",
                                              name, tally.gained, first(tally.firstGained));
        const bool solid = pair[1] != "jelly" && pair[0] != "a jelly";
        rows.push_back(solid ? atMost(gains, tally.gain, gainBound)
                             : fallsShort(gains, tally.gain, mostGained, gainBound));
    }
    return rows;
}

}  // namespace sulfur::lab
