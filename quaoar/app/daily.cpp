#include "daily.hpp"

#include <sys/resource.h>

#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <exception>
#include <quaoar/level_check.hpp>
#include <quaoar/recording.hpp>
#include <system_error>

#include "daily_course.hpp"
#include "shorten.hpp"
#include "solve.hpp"

namespace quaoar {
namespace {

constexpr double dailySlice = 4;    // simulated seconds between two looks at whether to stop
constexpr double dailyPolish = 60;  // in which the way is made quicker
constexpr int lowPriority = 15;     // of "nice"

/// As in the game's own levels.
MedalTimes medalsOf(double proof) {
    return {1.15 * proof, 2 * proof, 4.6 * proof};
}

}  // namespace

Daily::Daily(std::filesystem::path folder, std::string date)
    : folder_(std::move(folder)),
      date_(std::move(date)),
      file_(folder_ / (dailyId(date_) + ".json")) {
    try {
        thread_ = std::jthread([this](const std::stop_token& stop) {
            run(stop);
            ended_ = true;
        });
    } catch (const std::system_error& error) {
        atlax::log(atlax::LogLevel::Warning,
                   std::string("there is no level of the day: ") + error.what());
        ended_ = true;
    }
}

Daily::~Daily() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

std::filesystem::path Daily::usualFolder() {
    return atlax::dataFolder("quaoar") / "daily";
}

void Daily::run(const std::stop_token& stop) {
    // On Linux it is the thread that steps back, not the process.
    setpriority(PRIO_PROCESS, 0, lowPriority);
    try {
        bool there = isKept();
        for (int plan = 0; plan < mostPlans && !there && !stop.stop_requested(); ++plan)
            there = prove(plan, stop);
        if (there) removeOthers();
        ready_ = there;
    } catch (const std::exception& error) {
        atlax::log(atlax::LogLevel::Warning,
                   std::string("there is no level of the day: ") + error.what());
    }
}

/// Made by another version of the game or of the physics it may not hold any more.
bool Daily::isKept() const {
    std::error_code ignored;
    if (!std::filesystem::exists(proofOf(file_), ignored)) return false;
    try {
        const auto level = std::make_shared<const Level>(readLevel(file_));
        const Verdict verdict = verify(level, Recording::read(proofOf(file_)));
        return verdict.finished && verdict.sameAsRecorded;
    } catch (const std::exception&) {
        return false;
    }
}

bool Daily::prove(int plan, const std::stop_token& stop) const {
    const Ground ground(std::make_shared<const Level>(parseLevel(dailyCourse(date_, plan), file_)));
    if (checkLevel(*ground.level)) return false;
    if (ground.field.at(ground.level->spawn) >= DistanceField::unreachable) return false;
    Session session(ground.level);
    SearchOptions options;
    options.seed = static_cast<std::uint64_t>(plan) + 1;
    Search search(session, ground.field, options);
    std::optional<Way> way;
    for (double until = dailySlice; !way && until < budget; until += dailySlice) {
        if (stop.stop_requested()) return false;
        way = search.run(until);
    }
    if (!way) return false;
    const Way quicker = shortened(session, *way, options.seed, dailyPolish);
    const auto first = record(ground.level, quicker);
    if (!first || stop.stop_requested()) return false;
    // With its medals it is another file: the same way is recorded again.
    const std::string text =
        dailyCourse(date_, plan, medalsOf(static_cast<double>(first->ticks()) / Session::tickRate));
    const auto level = std::make_shared<const Level>(parseLevel(text, file_));
    const auto proof = record(level, quicker);
    if (!proof || !verify(level, *proof).finished) return false;
    atlax::writeFileAtomic(file_, text);
    proof->write(proofOf(file_));
    return true;
}

void Daily::removeOthers() const {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
        const auto& path = entry.path();
        const bool ours = path.filename().string().starts_with("daily-");
        if (ours && path.stem() != file_.stem()) std::filesystem::remove(path, error);
    }
}

}  // namespace quaoar
