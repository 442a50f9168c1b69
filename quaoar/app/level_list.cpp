#include "level_list.hpp"

#include <algorithm>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cmath>
#include <new>

#include "way_file.hpp"

namespace quaoar {

LevelList::LevelList(std::shared_ptr<const Level> level) {
    entries_.push_back({{}, std::move(level)});
}

LevelList LevelList::ofFolder(const std::filesystem::path& folder) {
    LevelList list;
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const bool schema = entry.path().stem().extension() == ".schema";
        if (entry.path().extension() == ".json" && !schema) files.push_back(entry.path());
    }
    for (const auto& file : files) {
        try {
            list.entries_.push_back({file, std::make_shared<const Level>(readLevel(file))});
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& problem) {
            atlax::log(atlax::LogLevel::Warning, problem.what());
        }
    }
    list.sort();
    return list;
}

void LevelList::addOwn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> folders{folder};
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.is_directory(error)) folders.push_back(entry.path());
    std::sort(folders.begin() + 1, folders.end());
    for (const auto& pack : folders) {
        LevelList levels = ofFolder(pack);
        for (Entry& entry : levels.entries_) {
            entry.own = true;
            entries_.push_back(std::move(entry));
        }
    }
}

std::filesystem::path LevelList::ownFolder() {
    return atlax::dataFolder("quaoar") / "levels";
}

std::size_t LevelList::addDaily(const std::filesystem::path& file) {
    Entry entry{file, std::make_shared<const Level>(readLevel(file))};
    entry.daily = true;
    entries_.push_back(std::move(entry));
    return entries_.size() - 1;
}

std::optional<std::size_t> LevelList::next(std::size_t index) const {
    const std::size_t after = index + 1;
    if (after >= size()) return {};
    const Entry &now = entries_[index], &then = entries_[after];
    if (now.daily || then.daily || now.own != then.own) return {};
    if (now.own && now.file.parent_path() != then.file.parent_path()) return {};
    return after;
}

std::optional<int> LevelList::difficulty(std::size_t index) const {
    const Entry& entry = entries_[index];
    if (entry.difficulty) return *entry.difficulty;
    entry.difficulty.emplace();
    const std::filesystem::path file = wayOf(entry.file);
    std::error_code ignored;
    if (entry.file.empty() || !std::filesystem::exists(file, ignored)) return {};
    try {
        const WayFile way = WayFile::read(file);
        if (way.survival.games > 0 && way.levelHash == entry.level->contentHash) {
            const int fifths = static_cast<int>(std::floor(5 * way.survival.share()));
            *entry.difficulty = std::clamp(5 - fifths, 1, 5);
        }
    } catch (const WayError& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
    return *entry.difficulty;
}

std::string LevelList::key(std::size_t index) const {
    const Entry& entry = entries_[index];
    if (!entry.own) return entry.level->id;  // that of a day names its date
    return "own-" + entry.file.parent_path().filename().string() + "-" + entry.level->id;
}

LevelList LevelList::around(const std::filesystem::path& file, std::size_t& index) {
    const auto level = std::make_shared<const Level>(readLevel(file));
    std::filesystem::path folder = file.parent_path();
    LevelList list = ofFolder(folder.empty() ? "." : folder);
    for (index = 0; index < list.size(); ++index)
        if (list[index].id == level->id) return list;
    list.entries_.push_back({file, level});
    list.sort();
    for (index = 0; list[index].id != level->id;) ++index;
    return list;
}

void LevelList::sort() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.level->number != b.level->number ? a.level->number < b.level->number
                                                  : a.level->id < b.level->id;
    });
}

std::shared_ptr<const Recording> LevelList::proof(std::size_t index) const {
    const Entry& entry = entries_[index];
    if (entry.file.empty()) return nullptr;
    const std::filesystem::path file = proofOf(entry.file);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return nullptr;
    try {
        auto recording = std::make_shared<const Recording>(Recording::read(file));
        requireMatch(*entry.level, *recording);
        return recording;
    } catch (const RecordingError& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
        return nullptr;
    }
}

std::optional<std::size_t> LevelList::find(const Recording& recording) const {
    for (std::size_t i = 0; i < size(); ++i)
        if (entries_[i].level->contentHash == recording.levelHash) return i;
    return {};
}

}  // namespace quaoar
