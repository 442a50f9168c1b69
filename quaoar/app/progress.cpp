#include "progress.hpp"

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cctype>
#include <charconv>
#include <cmath>

namespace quaoar {
namespace {

constexpr double longest = 1e9;  ///< seconds, metres

/// Levels have any names, keys and files do not.
std::string safeName(const std::string& level) {
    constexpr std::size_t mostLetters = 40;
    std::string name;
    for (const char c : level.substr(0, mostLetters)) {
        const auto byte = static_cast<unsigned char>(c);
        name += byte < 128 && std::isalnum(byte) != 0 ? static_cast<char>(std::tolower(byte)) : '-';
    }
    return name;
}

std::string settingOf(const std::string& level, const char* what) {
    return "level." + safeName(level) + "." + what;
}

/// From whole milliseconds; 0 for what is no number.
double secondsOf(const std::string& text) {
    std::int64_t milliseconds = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), milliseconds);
    const bool good = error == std::errc() && milliseconds > 0 && milliseconds < 1'000'000'000;
    return good ? static_cast<double>(milliseconds) / 1000 : 0;
}

}  // namespace

Progress::Progress(const std::filesystem::path& folder)
    : folder_(folder), values_({.file = folder / "progress.json"}) {
    if (!folder_.empty()) values_.load();
}

std::filesystem::path Progress::folder() {
    return atlax::dataFolder("quaoar");
}

LevelProgress Progress::of(const std::string& level) const {
    LevelProgress out;
    out.best = values_.get(settingOf(level, "best"), 0.0, 0.0, longest);
    out.finished = values_.get(settingOf(level, "finished"), false);
    out.attempts = values_.get(settingOf(level, "attempts"), 0, 0);
    out.deaths = values_.get(settingOf(level, "deaths"), 0, 0);
    out.pickups = values_.get(settingOf(level, "pickups"), 0, 0);
    const auto splits = values_.get(settingOf(level, "splits"), std::vector<std::string>());
    for (const std::string& split : splits) out.splits.push_back(secondsOf(split));
    return out;
}

void Progress::set(const std::string& level, const LevelProgress& progress) {
    values_.set(settingOf(level, "finished"), progress.finished);
    values_.set(settingOf(level, "best"), progress.best);
    values_.set(settingOf(level, "attempts"), progress.attempts);
    values_.set(settingOf(level, "deaths"), progress.deaths);
    values_.set(settingOf(level, "pickups"), progress.pickups);
    std::vector<std::string> splits;
    for (const double split : progress.splits)
        splits.push_back(std::to_string(std::llround(split * 1000)));
    values_.set(settingOf(level, "splits"), splits);
}

Totals Progress::totals() const {
    Totals out;
    out.seconds = values_.get("total.seconds", 0.0, 0.0, longest);
    out.distance = values_.get("total.distance", 0.0, 0.0, longest);
    out.shots = values_.get("total.shots", 0, 0);
    out.attempts = values_.get("total.attempts", 0, 0);
    out.deaths = values_.get("total.deaths", 0, 0);
    return out;
}

void Progress::setTotals(const Totals& totals) {
    values_.set("total.seconds", totals.seconds);
    values_.set("total.distance", totals.distance);
    values_.set("total.shots", totals.shots);
    values_.set("total.attempts", totals.attempts);
    values_.set("total.deaths", totals.deaths);
}

std::shared_ptr<const Recording> Progress::bestRun(const std::string& key,
                                                   const Level& level) const {
    const auto file = folder_ / "replays" / (safeName(key) + ".recording");
    std::error_code ignored;
    if (folder_.empty() || !std::filesystem::exists(file, ignored)) return nullptr;
    try {
        auto recording = std::make_shared<const Recording>(Recording::read(file));
        if (recording->levelHash == level.contentHash) return recording;
    } catch (const RecordingError& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
    return nullptr;
}

void Progress::keepBestRun(const std::string& key, const Recording& recording) {
    if (folder_.empty()) return;
    try {
        recording.write(folder_ / "replays" / (safeName(key) + ".recording"));
    } catch (const atlax::Error& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
}

void Progress::save() {
    if (!folder_.empty() && values_.changed()) values_.trySave();
}

}  // namespace quaoar
