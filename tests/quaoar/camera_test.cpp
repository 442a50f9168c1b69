// The camera: the hero stays well inside of the picture, and the picture shows more than rock.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <quaoar/view/follow_camera.hpp>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

using atlax::PixelSize;
using atlax::Rect;
using atlax::Vec2;

constexpr PixelSize sizes[] = {{1280, 720}, {500, 700}, {3840, 1080}};
constexpr float heroRadius = 0.12f;

OpenSpace spaceOf(const Session& session) {
    return OpenSpace(session.level(), fixedShapes(session));
}

/// How far the hero's edge is from the picture's middle, as a share of its width or height.
float eccentricity(const Session& session, const FollowCamera& camera, PixelSize size) {
    const Rect view = camera.camera(size).view(size);
    const Vec2 away = Vec2(session.heroPosition()) - view.centre();
    return std::max((std::abs(away.x) + heroRadius) / view.size.x,
                    (std::abs(away.y) + heroRadius) / view.size.y);
}

/// Plays and looks at every tick through a window of each size; the worst that was seen in each.
template <class Hand>
std::vector<float> worst(const std::shared_ptr<const Level>& level,
                         std::span<const PixelSize> windows, int ticks, Hand hand) {
    Session session(level);
    std::vector<FollowCamera> cameras;
    for (const PixelSize size : windows)
        cameras.emplace_back(session, spaceOf(session)).setAspect(size.toVec().x / size.toVec().y);
    std::vector<float> most(windows.size(), 0.f);
    for (int n = 0; n < ticks; ++n) {
        session.tick(hand(n));
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            if (session.events().restarted)
                cameras[i].cut();
            else
                cameras[i].tick();
            most[i] = std::max(most[i], eccentricity(session, cameras[i], windows[i]));
        }
    }
    return most;
}

std::vector<std::filesystem::path> levelFiles() {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(levelsFolder())) {
        const bool level =
            entry.path().extension() == ".json" &&
            std::isdigit(static_cast<unsigned char>(entry.path().filename().string()[0]));
        if (level) files.insert(entry.path());
    }
    return {files.begin(), files.end()};
}

TEST(Camera, holdsTheHeroAtEveryTickOfEveryProof) {
    int replayed = 0;
    for (const auto& file : levelFiles()) {
        if (!std::filesystem::exists(proofOf(file))) continue;
        const auto level = std::make_shared<const Level>(readLevel(file));
        const auto proof = std::make_shared<const Recording>(Recording::read(proofOf(file)));
        Playback playback(proof);
        const std::vector<float> most = worst(level, sizes, static_cast<int>(proof->ticks()),
                                              [&](int) { return playback.next(); });
        for (std::size_t i = 0; i < most.size(); ++i)
            EXPECT_LE(most[i], 0.4f)
                << file << " at " << sizes[i].width << " x " << sizes[i].height;
        ++replayed;
    }
    EXPECT_GE(replayed, 1);
}

TEST(Camera, holdsAHeroWhoIsPlayedAtRandom) {
    const auto level = firstLevel();
    for (unsigned seed = 1; seed <= 4; ++seed) {
        std::mt19937 dice(seed);
        TickInput input;
        const std::vector<float> most = worst(level, {&sizes[seed % 3], 1}, 6000, [&](int n) {
            if (n % 60 == 0) {
                const double angle = static_cast<double>(dice() % 628) / 100;
                setAim(input, std::cos(angle), std::sin(angle));
                input.fire = dice() % 4 != 0;
                input.reelIn = dice() % 2 == 0;
                input.boost = dice() % 3 == 0;
                input.push = dice() % 2 == 0 ? 127 : -127;
            }
            return input;
        });
        EXPECT_LE(most.front(), 0.4f) << "seed " << seed;
    }
}

TEST(Camera, holdsAHeroWhoFliesAtTheCapAndIsStoppedDead) {
    Session session(room());
    FollowCamera camera(session, spaceOf(session));
    for (const sulfur::Vec2& way : {sulfur::Vec2{9, 0}, sulfur::Vec2{-9, 0}, sulfur::Vec2{0, 9},
                                    sulfur::Vec2{0, -9}, sulfur::Vec2{6, -6}}) {
        session.restart();
        camera.cut();
        for (int n = 0; n < 400; ++n) {
            // By hand, so that no wall ends the flight.
            const sulfur::Vec2 speed = n < 250 ? way : sulfur::Vec2{0, 0};
            for (const sulfur::ParticleId particle : session.world().particles(session.hero())) {
                session.world().setVelocity(particle, speed);
                session.world().setPosition(particle,
                                            session.world().position(particle) +
                                                (speed / Session::tickRate).cast<double>());
            }
            camera.tick();
            for (const PixelSize size : sizes)
                ASSERT_LE(eccentricity(session, camera, size), 0.4f) << "tick " << n;
        }
    }
}

TEST(Camera, looksAheadAndOpensWithSpeed) {
    Session session(room());
    FollowCamera camera(session, spaceOf(session));
    const float rest = camera.camera(sizes[0]).view(sizes[0]).size.y;
    EXPECT_GE(2 * heroRadius / rest, 0.07f);
    EXPECT_LE(2 * heroRadius / rest, 0.09f);
    for (int n = 0; n < 500; ++n) {
        for (const sulfur::ParticleId particle : session.world().particles(session.hero())) {
            session.world().setVelocity(particle, {8, 0});
            session.world().setPosition(particle, session.world().position(particle) +
                                                      sulfur::Point{8.0 / Session::tickRate, 0});
        }
        camera.tick();
    }
    const Rect view = camera.camera(sizes[0]).view(sizes[0]);
    EXPECT_GT(view.size.y, rest * 1.2f);
    EXPECT_GT(view.centre().x, static_cast<float>(session.heroPosition().x()) + 0.5f);
}

/// Whether nobody can be there for long.
bool kills(const Level& level, Vec2 at) {
    if (at.y < float(level.killDepth)) return true;
    return std::any_of(level.zones.begin(), level.zones.end(), [&](const Zone& zone) {
        return zone.deadly && zone.needs.empty() && !zone.pulse && at.x > float(zone.low.x()) &&
               at.x < float(zone.high.x()) && at.y > float(zone.low.y()) &&
               at.y < float(zone.high.y());
    });
}

/// Places where a hero can lie or hang: open, reachable from the spawn, with ground just below or
/// something to hang from just above.
std::vector<Vec2> restingPlaces(const Level& level, const OpenSpace& space) {
    constexpr float step = 0.2f;
    const auto open = [&](Vec2 at) {
        for (const Vec2 way :
             {Vec2{0, 0}, Vec2{0.12f, 0}, Vec2{-0.12f, 0}, Vec2{0, 0.12f}, Vec2{0, -0.12f}})
            if (space.isRock(at + way)) return false;
        return at.x > float(level.boundsMin.x()) && at.x < float(level.boundsMax.x()) &&
               at.y > float(level.boundsMin.y()) && at.y < float(level.boundsMax.y());
    };
    std::vector<Vec2> places;
    std::set<std::pair<int, int>> seen{{0, 0}};
    std::vector<std::pair<int, int>> open_{{0, 0}};
    while (!open_.empty()) {
        const auto [x, y] = open_.back();
        open_.pop_back();
        const Vec2 at =
            Vec2(level.spawn) + Vec2{static_cast<float>(x), static_cast<float>(y)} * step;
        bool rests = false;
        for (const float below : {0.2f, 0.3f}) rests = rests || space.isRock(at - Vec2{0, below});
        for (const float above : {0.3f, 0.4f, 0.5f})
            rests = rests || space.isRock(at + Vec2{0, above});
        if (rests && !kills(level, at)) places.push_back(at);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const Vec2 next = at + Vec2{static_cast<float>(dx), static_cast<float>(dy)} * step;
            if (open(next) && seen.insert({x + dx, y + dy}).second)
                open_.push_back({x + dx, y + dy});
        }
    }
    return places;
}

TEST(Camera, showsMoreThanRockWhereverTheHeroRests) {
    for (const auto& file : levelFiles()) {
        Session session(std::make_shared<const Level>(readLevel(file)));
        const FollowCamera camera(session, spaceOf(session));
        float most = 0;
        Vec2 where;
        const auto places = restingPlaces(session.level(), camera.space());
        EXPECT_GT(places.size(), 20u) << file;
        for (const Vec2 at : places) {
            for (const Vec2 aim : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0.7f, -0.7f}}) {
                const Rect view = camera.restingView(at, aim);
                const float share = 2 * heroRadius / view.size.y;
                ASSERT_TRUE(share >= 0.07f && share <= 0.09f) << share;
                const float rock = camera.space().rock(view);
                if (rock <= most) continue;
                most = rock;
                where = at;
            }
        }
        EXPECT_LE(most, 0.4f) << file << " at " << where.x << ", " << where.y;
        RecordProperty("most-rock-" + file.stem().string(), std::to_string(most));
    }
}

}  // namespace
}  // namespace quaoar::test
