// The levels that can be played, in the order of their numbers.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <quaoar/level.hpp>
#include <quaoar/recording.hpp>
#include <string>
#include <vector>

namespace quaoar {

/// Owns the levels. A plain value; main thread.
class LevelList {
public:
    struct Entry {
        std::filesystem::path file;  ///< empty: made by a program, without a proof
        std::shared_ptr<const Level> level;
        bool own = false;    ///< made by the player
        bool daily = false;  ///< the level of a day
        /// Found when somebody asks: LevelList::difficulty().
        mutable std::optional<std::optional<int>> difficulty = {};
    };

    LevelList() = default;
    /// One level, perhaps without a file.
    explicit LevelList(std::shared_ptr<const Level> level);
    /// All ".json" files of a folder that are levels. What is none is said in the log and left out.
    static LevelList ofFolder(const std::filesystem::path& folder);
    /// The level of a file among those of its folder, or alone where the folder cannot be listed.
    /// Throws what readLevel throws for this file.
    static LevelList around(const std::filesystem::path& file, std::size_t& index);

    /// Adds the player's own levels after the others: those of a folder and of the folders in it,
    /// each a pack.
    void addOwn(const std::filesystem::path& folder);
    /// In the player's data folder (XDG_DATA_HOME).
    static std::filesystem::path ownFolder();
    /// Adds the level of the day after all others; its place. Throws what readLevel throws.
    std::size_t addDaily(const std::filesystem::path& file);

    std::size_t size() const { return entries_.size(); }
    bool empty() const { return entries_.empty(); }
    const Level& operator[](std::size_t index) const { return *entries_[index].level; }
    std::shared_ptr<const Level> level(std::size_t index) const { return entries_[index].level; }
    /// Whether it is none of the game's: made by the player, or by the day.
    bool own(std::size_t index) const { return entries_[index].own || entries_[index].daily; }
    /// The level that is played after this one: the next of the game, or of the same pack.
    std::optional<std::size_t> next(std::size_t index) const;
    /// 1 (easy) to 5, by how many games the robust bot finishes; nothing where that was not
    /// measured, or for another version of the level.
    std::optional<int> difficulty(std::size_t index) const;
    /// What progress is kept under: an own level is another one than that of the game with its id.
    std::string key(std::size_t index) const;
    /// The proof beside the level; nothing when there is none, or one that does not fit.
    std::shared_ptr<const Recording> proof(std::size_t index) const;
    /// The level that a recording was made for, in this very version.
    std::optional<std::size_t> find(const Recording& recording) const;

private:
    void sort();
    std::vector<Entry> entries_;
};

}  // namespace quaoar
