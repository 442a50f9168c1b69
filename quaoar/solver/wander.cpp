#include "wander.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <new>

#include "workers.hpp"

namespace quaoar {
namespace {

/// The rules kill whoever is 10 m out of the bounds, or below the kill depth: who is farther out
/// lives where nobody can.
constexpr double farOut = 12;
/// m: a hero of 0.24 m who is stretched so far is none any more.
constexpr double tornApart = 3;
constexpr int looksPerSecond = 50;
constexpr int thoroughTicks = 250;  ///< between two looks at the whole world
constexpr int moments = 60;         ///< of the proof at which trips begin

double chance(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// What a hand that knows nothing does for a while.
struct Whim {
    TickInput input;
    int ticks = 0;

    void next(std::mt19937_64& random) {
        ticks = 1 + static_cast<int>(200 * chance(random) * chance(random));
        if (chance(random) < 0.6) {
            const double angle = 6.283185307179586 * chance(random);
            setAim(input, std::cos(angle), std::sin(angle));
        }
        input.fire = chance(random) < 0.65;
        input.reelIn = chance(random) < 0.4;
        input.reelOut = chance(random) < 0.2;
        input.boost = chance(random) < 0.3;
        input.push = static_cast<std::int8_t>(std::lround(254 * chance(random) - 127));
        input.restart = chance(random) < 0.0005;
        input.retry = chance(random) < 0.002;
    }
    /// Presses of a tick: held, they would restart in each.
    TickInput take() {
        --ticks;
        const TickInput now = input;
        input.restart = input.retry = false;
        return now;
    }
};

/// The proof at a moment, ready to go on from.
struct Start {
    std::shared_ptr<const Session::Snapshot> snapshot;
    std::uint64_t ticks = 0;
};

std::vector<Start> startsOf(const std::shared_ptr<const Level>& level, const Recording& proof) {
    Session session(level);
    std::vector<Start> starts{{session.snapshot(), 0}};
    Playback playback(std::make_shared<const Recording>(proof));
    const std::uint64_t every = std::max<std::uint64_t>(1, proof.ticks() / moments);
    for (std::uint64_t tick = 1; tick < proof.ticks(); ++tick) {
        session.tick(playback.next());
        if (tick % every == 0) starts.push_back({session.snapshot(), tick});
    }
    return starts;
}

Recording beginningOf(const Level& level, const Recording& proof, std::uint64_t ticks) {
    Recording recording(level);
    Playback playback(std::make_shared<const Recording>(proof));
    for (std::uint64_t tick = 0; tick < ticks; ++tick) recording.append(playback.next());
    return recording;
}

struct Trip {
    std::uint64_t ticks = 0;
    int deaths = 0;
    bool finished = false;
    std::string fault;
    std::vector<TickInput> inputs;
};

Trip goOn(Session& session, int ticks, std::uint64_t seed) {
    Trip trip;
    std::mt19937_64 random(seed);
    Whim whim;
    constexpr int look = Session::tickRate / looksPerSecond;
    for (int tick = 1; tick <= ticks && trip.fault.empty(); ++tick) {
        if (whim.ticks <= 0) whim.next(random);
        trip.inputs.push_back(whim.take());
        try {
            session.tick(trip.inputs.back());
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& error) {
            trip.fault = std::string("a tick ends with an error: ") + error.what();
        }
        trip.deaths += session.events().died ? 1 : 0;
        trip.finished = trip.finished || session.events().finished;
        if (trip.fault.empty() && tick % look == 0)
            trip.fault = faultOf(session, tick % thoroughTicks == 0);
        ++trip.ticks;
    }
    return trip;
}

std::string placeText(const sulfur::Point& place) {
    char text[64];
    std::snprintf(text, sizeof text, "%.2f %.2f", place.x(), place.y());
    return text;
}

}  // namespace

std::string faultOf(const Session& session, bool all) {
    const sulfur::World& world = session.world();
    const sulfur::Point hero = session.heroPosition();
    if (!hero.allFinite() || !session.heroVelocity().allFinite())
        return "the hero is at " + placeText(hero);
    for (const sulfur::ParticleId particle : world.particles(session.hero())) {
        const sulfur::Point place = world.position(particle);
        if (!place.allFinite() || (place - hero).norm() > tornApart)
            return "the hero is torn apart: one particle at " + placeText(hero) + ", another at " +
                   placeText(place);
    }
    const Level& level = session.level();
    const bool alive = session.phase() == Session::Phase::playing;
    const bool out = hero.x() < level.boundsMin.x() - farOut ||
                     hero.x() > level.boundsMax.x() + farOut ||
                     hero.y() > level.boundsMax.y() + farOut || hero.y() < level.killDepth - farOut;
    if (alive && out) return "the hero lives out of the world, at " + placeText(hero);
    for (const sulfur::BodyId body : world.bodies())
        for (const sulfur::ParticleId particle : world.particles(body))
            if (!world.position(particle).allFinite() || !world.velocity(particle).allFinite())
                return "a particle of " + world.name(body) + " is nowhere";
    if (!all) return "";
    const std::string wrong = world.validate();
    return wrong.empty() ? "" : "the world contradicts itself: " + wrong;
}

WanderReport wander(const std::shared_ptr<const Level>& level, const Recording& proof,
                    const WanderOptions& options) {
    requireMatch(*level, proof);
    const std::vector<Start> starts = startsOf(level, proof);
    const int trips = std::max(1, static_cast<int>(std::lround(options.seconds / options.trip)));
    const int ticks =
        static_cast<int>(std::lround(std::min(options.trip, options.seconds) * Session::tickRate));
    WanderReport report;
    // By the number of the trip, so that reports do not depend on the threads.
    std::map<int, WanderFault> faults;
    std::mutex guard;
    forAll(level, options.jobs, trips, [&](int i, Session& session) {
        const std::uint64_t seed = options.seed * 1'000'003 + static_cast<std::uint64_t>(i);
        std::mt19937_64 random(seed);
        const Start& start = starts[random() % starts.size()];
        session.restore(*start.snapshot);
        const Trip trip = goOn(session, ticks, seed);
        const std::lock_guard<std::mutex> lock(guard);
        ++report.trips;
        report.simulated += static_cast<double>(trip.ticks) / Session::tickRate;
        report.deaths += trip.deaths;
        report.finishes += trip.finished ? 1 : 0;
        if (trip.fault.empty()) return;
        WanderFault fault{trip.fault, beginningOf(*level, proof, start.ticks)};
        for (const TickInput& input : trip.inputs) fault.recording.append(input);
        fault.recording.finalHash = session.hash();
        faults.emplace(i, std::move(fault));
    });
    for (auto& [trip, fault] : faults) report.faults.push_back(std::move(fault));
    return report;
}

}  // namespace quaoar
