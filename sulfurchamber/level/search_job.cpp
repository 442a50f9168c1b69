#include "search_job.hpp"

#include <algorithm>
#include <cmath>

#include "../model/refusals.hpp"
#include "../model/words.hpp"
#include "practice.hpp"
#include "shorten.hpp"
#include "solve.hpp"
#include "steady_search.hpp"

namespace sulfurchamber {
namespace {

using quaoar::Level;
using quaoar::Recording;
using quaoar::Session;
using sulfur::Point;

constexpr double slice = 4;           // simulated seconds between two looks at the archive
constexpr double steadyShare = 0.25;  // of the budget, for ways from rest to rest
constexpr int ticksPerPlace = Session::tickRate / 10;

// The hero's places while a recording is played.
std::vector<Point> placesOf(const std::shared_ptr<const Level>& level, const Recording& recording) {
    Session session(level);
    std::vector<Point> places{session.heroPosition()};
    for (const quaoar::InputRun& run : recording.runs())
        for (std::uint32_t n = 0; n < run.ticks; ++n) {
            session.tick(run.input);
            if (session.ticks() % ticksPerPlace == 0) places.push_back(session.heroPosition());
        }
    places.push_back(session.heroPosition());
    return places;
}

double middleOf(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double roundedUp(double seconds, double step) {
    return std::ceil(seconds / step) * step;
}

}  // namespace

quaoar::MedalTimes medalsFor(double seconds) {
    quaoar::MedalTimes medals;
    medals.gold = roundedUp(1.15 * seconds, 0.1);
    medals.silver = roundedUp(2 * seconds, 1);
    medals.bronze = roundedUp(4.6 * seconds, 1);
    return medals;
}

Recording recordingFor(const Level& level, const Recording& recording) {
    Recording made = recording;
    made.levelId = level.id;
    made.levelHash = level.contentHash;
    return made;
}

SearchJob::SearchJob(std::shared_ptr<const Level> level, SearchJobOptions options)
    : level_(std::move(level)), options_(std::move(options)), thread_([this] { run(); }) {}

SearchJob::~SearchJob() {
    stop_ = true;
}

SearchProgress SearchJob::progress() const {
    const std::lock_guard lock(guard_);
    return progress_;
}

std::vector<Point> SearchJob::frontier() const {
    const std::lock_guard lock(guard_);
    return frontier_;
}

std::shared_ptr<const SearchResult> SearchJob::result() const {
    const std::lock_guard lock(guard_);
    return result_;
}

// --- in the thread ---------------------------------------------------------------------------

void SearchJob::tell(SearchProgress::Stage stage, double share) {
    const std::lock_guard lock(guard_);
    progress_.stage = stage;
    progress_.share = std::clamp(share, 0.0, 1.0);
}

void SearchJob::keep(SearchResult result) {
    auto kept = std::make_shared<const SearchResult>(std::move(result));
    const std::lock_guard lock(guard_);
    result_ = std::move(kept);
}

void SearchJob::run() {
    using Stage = SearchProgress::Stage;
    const auto fail = [this](const std::string& why) {
        const std::lock_guard lock(guard_);
        progress_.stage = Stage::failed;
        progress_.problem = why;
    };
    quaoar::stopPlayersBy(&stop_);
    try {
        if (replay()) return tell(Stage::done, 1);
        if (!options_.search) return fail(tr("what was known does not finish this version"));
        const quaoar::Ground ground(level_);
        const quaoar::Way way = search(ground);
        shorten(way);
        if (options_.games > 0) askBot(ground, way);
        tell(Stage::done, 1);
    } catch (const quaoar::Stopped&) {
        tell(Stage::stopped, 0);
    } catch (const std::exception& error) {
        fail(trRefusal(error.what()));
    }
}

void SearchJob::setProof(SearchResult& result, Recording proof) const {
    result.way = placesOf(level_, proof);
    result.medals = medalsFor(quaoar::secondsOf(proof.ticks()));
    result.proof = std::move(proof);
}

// What is known may finish the level as it is now, also where its end is another one.
bool SearchJob::replay() {
    if (!options_.known) return false;
    tell(SearchProgress::Stage::replaying, 0);
    Session session(level_);
    Recording made(*level_);
    for (const quaoar::InputRun& run : options_.known->runs()) {
        for (std::uint32_t n = 0; n < run.ticks; ++n) {
            if (stop_) throw quaoar::Stopped{};
            made.append(run.input);
            session.tick(run.input);
            if (session.phase() == Session::Phase::finished) break;
        }
        if (session.phase() == Session::Phase::finished) break;
    }
    if (session.phase() != Session::Phase::finished) return false;
    made.finalHash = session.hash();
    SearchResult result;
    setProof(result, std::move(made));
    keep(std::move(result));
    return true;
}

quaoar::Way SearchJob::search(const quaoar::Ground& ground) {
    tell(SearchProgress::Stage::searching, 0);
    if (ground.field.at(level_->spawn) >= quaoar::DistanceField::unreachable)
        throw std::runtime_error(tr("no free space leads from the spawn to the exit"));
    Session session(level_);
    quaoar::SearchOptions options;
    options.seed = options_.seed;
    quaoar::Search search(session, ground.field, options);
    std::vector<Point> before;  // of stages that are over
    std::size_t cells = 0;
    for (double until = slice; until <= options_.budget; until += slice) {
        auto way = search.run(until);
        const quaoar::SearchReport& report = search.report();
        auto seen = search.frontier();
        const std::lock_guard lock(guard_);
        if (report.cells < cells) before = frontier_;
        cells = report.cells;
        seen.insert(seen.end(), before.begin(), before.end());
        frontier_ = std::move(seen);
        progress_.simulated = searched_ = report.simulated;
        progress_.nearest = report.nearest;
        progress_.share = std::min(1.0, report.simulated / options_.budget);
        if (way) return *way;
    }
    throw std::runtime_error(tr("no way was found in {} simulated seconds",
                                {std::to_string(std::lround(options_.budget))}));
}

void SearchJob::shorten(const quaoar::Way& way) {
    auto proof = quaoar::record(level_, way);
    if (!proof) throw std::runtime_error(tr("the way that was found does not replay"));
    SearchResult result;
    setProof(result, *proof);
    keep(result);
    Session session(level_);
    quaoar::Way best = way;
    const double step = options_.polish / 8;
    for (int n = 0; n < 8; ++n) {
        tell(SearchProgress::Stage::shortening, n / 8.0);
        best =
            quaoar::shortened(session, best, options_.seed + static_cast<std::uint64_t>(n), step);
        auto shorter = quaoar::record(level_, best);
        if (!shorter || shorter->ticks() >= result.proof.ticks()) continue;
        setProof(result, std::move(*shorter));
        keep(result);
    }
}

// How many of some games a player with a human's faults would finish.
void SearchJob::askBot(const quaoar::Ground& ground, const quaoar::Way& way) {
    SearchResult result = *this->result();
    quaoar::WayFile& robust = result.robust;
    robust.levelId = level_->id;
    robust.levelHash = level_->contentHash;
    robust.searched = searched_;
    Session session(level_);
    const quaoar::Skill skill = quaoar::Skill::level(3);
    quaoar::SteadySearch steady(session, ground.field, skill, options_.seed);
    std::optional<quaoar::Way> calm;
    const double budget = std::max(200.0, searched_ * 2 + options_.budget * steadyShare / 4);
    for (double until = slice; until <= budget && !calm; until += slice) {
        tell(SearchProgress::Stage::practising, 0.5 * until / budget);
        calm = steady.run(until);
    }
    quaoar::learnWay(robust.policy, session, calm ? *calm : way);
    quaoar::PracticeOptions practice;
    practice.skill = skill;
    practice.seed = options_.seed;
    quaoar::Practice teacher(ground, robust.policy, practice);
    teacher.studyAll();
    for (int n = 0; n < options_.rounds; ++n) {
        tell(SearchProgress::Stage::practising, 0.5 + 0.5 * n / options_.rounds);
        teacher.round();
    }
    playGames(ground, robust);
    keep(std::move(result));
}

void SearchJob::playGames(const quaoar::Ground& ground, quaoar::WayFile& robust) {
    Session session(level_);
    std::vector<double> tries, seconds;
    for (int n = 0; n < options_.games; ++n) {
        tell(SearchProgress::Stage::playing, static_cast<double>(n) / options_.games);
        quaoar::BotOptions bot;
        bot.skill = quaoar::Skill::level(3);
        bot.seed = options_.seed + static_cast<std::uint64_t>(n);
        const quaoar::PlayedGame game = quaoar::playGame(session, ground, robust.policy, bot);
        tries.push_back(game.tries);
        if (game.finished) seconds.push_back(game.seconds);
    }
    robust.survival.games = options_.games;
    robust.survival.finished = static_cast<int>(seconds.size());
    robust.survival.tries = middleOf(tries);
    robust.survival.seconds = middleOf(seconds);
}

}  // namespace sulfurchamber
