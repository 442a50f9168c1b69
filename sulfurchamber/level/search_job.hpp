// "Can it be finished?": the game's solver in a thread of its own, beside the editing.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "way_file.hpp"

namespace sulfurchamber {

/// How far a search is. A plain value.
struct SearchProgress {
    enum class Stage : std::uint8_t {
        replaying,   ///< what is known
        searching,   ///< for a way
        shortening,  ///< of the way that was found
        practising,  ///< for the robust bot
        playing,     ///< games of the robust bot
        done,
        failed,  ///< no way was found, or the level has none
        stopped,
    };
    Stage stage = Stage::replaying;
    double share = 0;      ///< 0 to 1, of the stage
    double simulated = 0;  ///< seconds in all
    double nearest = 0;    ///< metres left to the exit, at best; 0: not known
    std::string problem;   ///< why it failed, one sentence
    bool over() const { return stage >= Stage::done; }
};

/// What a search is told.
struct SearchJobOptions {
    std::uint64_t seed = 1;
    double budget = 6000;  ///< simulated seconds of the search
    double polish = 160;   ///< simulated seconds in which the way is made quicker
    int rounds = 2;        ///< of practice
    int games = 30;        ///< of the robust bot; 0: its survival is not asked for
    /// What may be a proof still, or for a level that is nearly the same: tried first.
    std::optional<quaoar::Recording> known = std::nullopt;
    bool search = true;  ///< else only `known` is tried
};

/// What was found.
struct SearchResult {
    quaoar::Recording proof;
    std::vector<sulfur::Point> way;  ///< places of the hero, ten a second, metres
    quaoar::MedalTimes medals;       ///< a suggestion
    quaoar::WayFile robust;          ///< survival and policy; no games while that is not known
};

/// Times that a proof of so many seconds suggests: gold a little longer than it, as in the game.
quaoar::MedalTimes medalsFor(double seconds);
/// A recording for a level that is another version of its own, such as one with other medals: it
/// must be replayed.
quaoar::Recording recordingFor(const quaoar::Level& level, const quaoar::Recording& recording);

/// One search. It begins at once, in one thread, which ends with the object: within some
/// milliseconds. All functions may be called at any time from the thread that made it.
class SearchJob {
public:
    SearchJob(std::shared_ptr<const quaoar::Level> level, SearchJobOptions options);
    ~SearchJob();
    SearchJob(const SearchJob&) = delete;
    SearchJob& operator=(const SearchJob&) = delete;

    void stop() { stop_ = true; }
    SearchProgress progress() const;
    /// Where the search has been so far, metres.
    std::vector<sulfur::Point> frontier() const;
    /// There with the first proof; changes when it gets quicker, and with the survival.
    std::shared_ptr<const SearchResult> result() const;
    const quaoar::Level& level() const { return *level_; }

private:
    void run();
    bool replay();
    void tell(SearchProgress::Stage stage, double share);
    void keep(SearchResult result);
    quaoar::Way search(const quaoar::Ground& ground);
    void shorten(const quaoar::Way& way);
    void askBot(const quaoar::Ground& ground, const quaoar::Way& way);
    void playGames(const quaoar::Ground& ground, quaoar::WayFile& robust);
    void setProof(SearchResult& result, quaoar::Recording proof) const;

    std::shared_ptr<const quaoar::Level> level_;
    SearchJobOptions options_;
    std::atomic<bool> stop_{false};
    double searched_ = 0;  ///< simulated seconds until the first way; of the thread alone
    mutable std::mutex guard_;
    SearchProgress progress_;
    std::vector<sulfur::Point> frontier_;
    std::shared_ptr<const SearchResult> result_;
    std::jthread thread_;
};

}  // namespace sulfurchamber
