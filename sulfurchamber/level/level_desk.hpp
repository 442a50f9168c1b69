// What goes on beside the editing of a level: checking, proving, publishing.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "level_problems.hpp"
#include "search_job.hpp"

namespace sulfurchamber {

/// Checks the newest of the texts that it is given, in a thread of its own.
class LevelWatch {
public:
    LevelWatch();
    ~LevelWatch();

    /// What was asked before and is not begun is forgotten.
    void ask(std::string text, std::filesystem::path file, std::uint64_t ticket);
    /// A report that has become ready, with its ticket, once.
    struct Answer {
        std::uint64_t ticket = 0;
        std::string text;
        LevelReport report;
    };
    std::optional<Answer> take();

private:
    struct Question {
        std::uint64_t ticket = 0;
        std::string text;
        std::filesystem::path file;
    };
    void run(const std::stop_token& stop);

    std::mutex guard_;
    std::condition_variable_any wake_;
    std::optional<Question> question_;
    std::optional<Answer> answer_;
    std::jthread thread_;
};

/// What is known about the level that is open. Follows a document; knows no window. Main thread.
class LevelDesk {
public:
    /// The document must outlive the desk.
    explicit LevelDesk(Document& document) : document_(document) {}

    /// Often, such as with each frame: sees changes, takes results. Cheap.
    void follow();

    // -- problems --
    const std::vector<LevelProblem>& problems() const { return problems_; }
    /// Whether they are those of the level as it is now.
    bool checked() const { return checkedState_ == document_.state(); }
    /// Whether it is known that the level, as it is now, has no grave problem.
    bool playable() const { return checked() && playable_; }
    /// The level of the last check, with its session, which belongs to the caller from then on;
    /// once for each check. Null before one and where the reader refuses the level.
    std::shared_ptr<const quaoar::Level> level() const { return level_; }
    std::unique_ptr<quaoar::Session> takeSession() { return std::move(session_); }

    // -- the proof --
    enum class Proof : std::uint8_t {
        none,      ///< it is not known whether the level can be finished
        asked,     ///< a search is on its way
        holds,     ///< it can, as it is now
        outdated,  ///< an earlier version could
        failed,    ///< a search has found no way
    };
    Proof proof() const;
    /// One or two sentences about it.
    std::string proofText() const;
    /// Searches for a way, beginning with what is known. Throws std::runtime_error where the level
    /// has a grave problem, or sulfur::scene::ReadError.
    void search(SearchJobOptions options = {});
    void stopSearch();
    /// Null when none was asked for.
    const SearchJob* job() const { return job_.get(); }
    /// What holds, or held.
    std::shared_ptr<const SearchResult> result() const { return result_; }
    /// A recording that somebody has played; kept if it finishes the level as it is.
    void offer(const quaoar::Recording& recording);
    /// Enters the times that the proof suggests, as one step, and proves the level with them.
    void takeMedals();

    // -- files --
    /// After the document was opened: its proof lies beside it.
    void opened();
    /// After it was saved: the proof goes beside it, if it holds.
    void saved();
    /// Writes the level and its proof into the folder, under a name made of the level's. Returns
    /// the file. Throws std::runtime_error where the level cannot be played, and atlax::Error.
    std::filesystem::path publish(const std::filesystem::path& folder);
    /// Where the game looks for the player's own levels.
    static std::filesystem::path gameFolder();

private:
    std::string text() const { return document_.text(); }
    std::filesystem::path name() const;
    void start(SearchJobOptions options);
    void writeProof(const std::filesystem::path& levelFile, const SearchResult& result) const;

    Document& document_;
    LevelWatch watch_;
    std::uint64_t askedState_ = 0;    ///< of the document when a check was asked for
    std::uint64_t checkedState_ = 0;  ///< of the last check
    std::vector<LevelProblem> problems_;
    bool playable_ = false;
    std::shared_ptr<const quaoar::Level> level_;
    std::unique_ptr<quaoar::Session> session_;
    std::unique_ptr<SearchJob> job_;
    std::uint64_t jobState_ = 0;     ///< of the document when the job began
    std::uint64_t provenState_ = 0;  ///< of the document that the result is for
    bool quiet_ = false;             ///< the job only replays what lies beside the file
    std::shared_ptr<const SearchResult> result_;
};

}  // namespace sulfurchamber
