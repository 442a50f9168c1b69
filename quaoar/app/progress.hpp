// What the player has reached, kept between runs.
#pragma once

#include <atlax/settings.hpp>
#include <filesystem>
#include <memory>
#include <quaoar/recording.hpp>
#include <string>
#include <vector>

namespace quaoar {

/// Of one level, over all attempts.
struct LevelProgress {
    bool finished = false;
    double best = 0;  ///< seconds, when finished
    int attempts = 0;
    int deaths = 0;
    int pickups = 0;  ///< bits of those that were ever brought home
    /// Of the best run: the timer at each of the level's checkpoints, seconds; 0: not reached.
    std::vector<double> splits = {};
};

/// Over all levels.
struct Totals {
    double seconds = 0;   ///< of play
    double distance = 0;  ///< metres that the hero has gone
    int shots = 0;        ///< ropes fired
    int attempts = 0;
    int deaths = 0;
};

/// Progress in a text file of version 1 (that of atlax::Settings, with one backup; a damaged file
/// is set aside) and the best run of each level as a recording beside it. Owns the values; main
/// thread. Nothing throws: what cannot be written is said in the log.
class Progress {
public:
    /// Reads "progress.json" in the folder, usually folder(). With an empty name nothing is kept.
    explicit Progress(const std::filesystem::path& folder);
    /// In the player's data folder (XDG_DATA_HOME).
    static std::filesystem::path folder();

    /// Of the level that LevelList::key() names so.
    LevelProgress of(const std::string& level) const;
    void set(const std::string& level, const LevelProgress& progress);
    Totals totals() const;
    void setTotals(const Totals& totals);

    /// The best run, when it is of this version of the level; else nothing.
    std::shared_ptr<const Recording> bestRun(const std::string& key, const Level& level) const;
    void keepBestRun(const std::string& key, const Recording& recording);

    void save();

private:
    std::filesystem::path folder_;
    atlax::Settings values_;
};

}  // namespace quaoar
