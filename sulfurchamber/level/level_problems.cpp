#include "level_problems.hpp"

#include <algorithm>
#include <cmath>
#include <quaoar/level_check.hpp>

#include "../model/refusals.hpp"
#include "../model/words.hpp"
#include "distance_field.hpp"

namespace sulfurchamber {
namespace {

using quaoar::DistanceField;
using quaoar::Level;
using quaoar::Session;
using sulfur::Point;

constexpr int mostRefusals = 40;    // of the reader, that are told
constexpr double columnStep = 0.5;  // metres between places that are looked at
constexpr double bareFloor = 4;     // metres of floor without an anchor that are worth a word
constexpr double heroHeight = 0.2;  // metres of the hero's middle above the floor

// Where a problem of the reader lies, by its line.
void locate(LevelProblem& problem, const JsonText& whole, int line) {
    int least = 1 << 30;
    const auto consider = [&](LevelKind kind, std::size_t index, const std::string& key) {
        const LevelThing thing{kind, index, key};
        JsonPath path = pathOf(thing);
        path.insert(path.begin(), "level");
        const auto lines = whole.lines(path);
        if (!lines || line < lines->first || line > lines->second) return;
        if (lines->second - lines->first >= least) return;
        least = lines->second - lines->first;
        problem.thing = thing;
    };
    for (const LevelKindInfo& info : levelKinds()) {
        const JsonPath list{"level", std::string(info.key)};
        if (info.kind == LevelKind::surface)
            for (const std::string& key : whole.keys(list)) consider(info.kind, 0, key);
        else if (info.list)
            for (std::size_t i = 0; i < whole.size(list); ++i) consider(info.kind, i, {});
        else if (!info.key.empty())
            consider(info.kind, 0, {});
    }
}

// Takes out what the reader refuses, so that it tells what comes after; false where that would
// leave no level.
bool leaveOut(JsonText& text, const std::optional<LevelThing>& thing) {
    if (!thing || !isRemovable(*thing)) return false;
    JsonPath path = pathOf(*thing);
    path.insert(path.begin(), "level");
    if (!text.has(path)) return false;
    text.erase(path);
    return true;
}

// All refusals of the reader. Items that were left out shift the places of those behind them.
void readAll(const std::string& text, const std::filesystem::path& file, LevelReport& report) {
    JsonText trial(text);
    std::vector<LevelThing> gone;
    for (int n = 0; n < mostRefusals; ++n) {
        LevelProblem problem;
        try {
            auto level = std::make_shared<const Level>(quaoar::parseLevel(trial.text(), file));
            if (gone.empty()) report.level = std::move(level);
            return;
        } catch (const sulfur::scene::ReadError& error) {
            problem.text = (error.object().empty() ? "" : "\"" + error.object() + "\": ") +
                           trRefusal(error.message());
            locate(problem, trial, error.line());
            if (!problem.thing) problem.body = error.object();
        }
        std::optional<LevelThing> here = problem.thing;
        if (here)
            for (const LevelThing& before : gone)
                if (before.kind == here->kind && infoOf(here->kind).list &&
                    before.index <= problem.thing->index)
                    ++problem.thing->index;
        report.problems.push_back(problem);
        if (!leaveOut(trial, here)) return;
        gone.push_back(*problem.thing);
        std::sort(gone.begin(), gone.end());
    }
}

void add(LevelReport& report, bool grave, LevelKind kind, std::size_t index, std::string text,
         std::optional<Point> place) {
    report.problems.push_back({std::move(text), grave, LevelThing{kind, index, {}}, {}, place});
}

void checkPlaces(const Level& level, LevelReport& report) {
    const auto found = quaoar::checkLevel(level);
    if (found) {
        const bool spawn = found->object == "spawn";
        add(report, true, spawn ? LevelKind::spawn : LevelKind::exit, 0,
            tr(spawn ? "The spawn {}" : "The exit {}", {trRefusal(found->problem)}),
            spawn ? level.spawn : level.exit.position);
    }
    const Point low = level.boundsMin, high = level.boundsMax;
    for (std::size_t i = 0; i < level.hints.size(); ++i) {
        const Point at = level.hints[i].position;
        if ((at.array() >= low.array()).all() && (at.array() <= high.array()).all()) continue;
        add(report, false, LevelKind::hint, i,
            tr("A hint lies outside of the camera's bounds, where nobody sees it"), at);
    }
    if (level.killDepth < low.y() - 20)
        add(report, false, LevelKind::killDepth, 0,
            tr("The kill depth is far below the bounds; whoever falls waits long"),
            Point(low.x(), level.killDepth));
}

bool isInRock(const Session& session, const Point& place) {
    for (const sulfur::BodyId body :
         session.world().bodiesAt(place, {.mask = quaoar::Category::scenery}))
        if (session.world().kind(body) == sulfur::BodyKind::fixed) return true;
    return false;
}

// What the hero cannot come to.
void checkReach(const Session& session, const DistanceField& field, LevelReport& report) {
    const Level& level = session.level();
    const auto isCut = [&](const Point& place) {
        return field.at(place) >= DistanceField::unreachable;
    };
    if (isCut(level.spawn)) {
        add(report, true, LevelKind::exit, 0, tr("The exit is cut off: no free space leads to it"),
            level.exit.position);
        return;
    }
    for (std::size_t i = 0; i < level.checkpoints.size(); ++i) {
        const auto& one = level.checkpoints[i];
        if (isInRock(session, one.position))
            add(report, true, LevelKind::checkpoint, i,
                tr("Checkpoint \"{}\" lies in the ground", {one.id}), one.position);
        else if (isCut(one.position))
            add(report, false, LevelKind::checkpoint, i,
                tr("Checkpoint \"{}\" is cut off from the exit", {one.id}), one.position);
    }
    for (std::size_t i = 0; i < level.pickups.size(); ++i) {
        const auto& one = level.pickups[i];
        if (isInRock(session, one.position))
            add(report, false, LevelKind::pickup, i,
                tr("Pick-up \"{}\" lies in the ground", {one.id}), one.position);
        else if (isCut(one.position))
            add(report, false, LevelKind::pickup, i,
                tr("Pick-up \"{}\" cannot be reached", {one.id}), one.position);
    }
}

// The floor right below a free place, or nothing.
std::optional<Point> floorBelow(const Session& session, const Point& place) {
    const sulfur::QueryFilter scenery{.mask = quaoar::Category::scenery};
    const auto hit = session.world().castRay(place, {0, -1}, DistanceField::cell * 1.5, scenery);
    if (!hit || hit->normal.y() < sulfur::Real(0.5)) return std::nullopt;
    if (session.surface(hit->body).deadly) return std::nullopt;
    return hit->point;
}

// Whether something to which the rope sticks is in reach above a place.
bool hasAnchor(const Session& session, const Point& place) {
    constexpr int directions = 15;
    const double reach = static_cast<double>(session.rope().rules().reach);
    for (int i = 1; i < directions; ++i) {
        const double angle = M_PI * i / directions;
        const Point to = place + reach * Point(std::cos(angle), std::sin(angle));
        const auto hit =
            session.world().castSegment(place, to, {.mask = quaoar::Category::scenery});
        if (hit && session.surface(hit->body).sticky) return true;
    }
    return false;
}

// Stretches of floor along which the rope finds nothing.
void checkAnchors(const Session& session, const DistanceField& field, LevelReport& report) {
    const Level& level = session.level();
    std::optional<Point> from, to;
    const auto tell = [&] {
        if (from && to->x() - from->x() >= bareFloor)
            report.problems.push_back({tr("Nothing that the rope holds on is in reach from the "
                                          "floor between x = {} and {}",
                                          {jsonOf(from->x()), jsonOf(to->x())}),
                                       false,
                                       std::nullopt,
                                       {},
                                       Point((*from + *to) / 2)});
        from.reset();
    };
    for (double x = level.boundsMin.x(); x <= level.boundsMax.x(); x += columnStep) {
        std::optional<Point> bare;
        bool held = false;
        for (double y = level.boundsMin.y(); y <= level.boundsMax.y(); y += DistanceField::cell) {
            const Point place(x, y);
            if (field.at(place) >= DistanceField::unreachable) continue;
            const auto floor = floorBelow(session, place);
            if (!floor) continue;
            if (hasAnchor(session, *floor + Point(0, heroHeight)))
                held = true;
            else
                bare = *floor;
        }
        if (bare && !held) {
            if (!from) from = bare;
            to = bare;
        } else {
            tell();
        }
    }
    tell();
}

}  // namespace

bool LevelReport::playable() const {
    return level != nullptr && std::none_of(problems.begin(), problems.end(),
                                            [](const auto& problem) { return problem.grave; });
}

LevelReport checkLevelText(const std::string& text, const std::filesystem::path& file) {
    LevelReport report;
    try {
        readAll(text, file, report);
        if (!report.level) return report;
        checkPlaces(*report.level, report);
        report.session = std::make_unique<Session>(report.level);
        const DistanceField field(*report.session);
        checkReach(*report.session, field, report);
        checkAnchors(*report.session, field, report);
    } catch (const std::exception& error) {
        report.problems.push_back({trRefusal(error.what()), true, std::nullopt, {}, std::nullopt});
    }
    return report;
}

}  // namespace sulfurchamber
