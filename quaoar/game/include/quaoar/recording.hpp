// The inputs of one attempt, tick by tick: replays, proofs, bug reports.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <quaoar/level.hpp>
#include <quaoar/session.hpp>
#include <quaoar/tick_input.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace quaoar {

/// A recording that cannot be used. The message is one sentence with file and line.
class RecordingError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The same input for a number of ticks.
struct InputRun {
    std::uint32_t ticks = 0;  ///< at least 1
    TickInput input;

    friend bool operator==(const InputRun&, const InputRun&) = default;
};

/// Run-length encoded inputs with what is needed to tell whether they fit.
///
/// The file is text, version 1: a line "quaoar-recording 1", lines "key value" (level, level-hash,
/// library, numbers, ticks, final-hash), a line "inputs", one line "ticks aimX aimY buttons push"
/// a run (buttons: a sum of 1 fire, 2 reel in, 4 reel out, 8 boost, 16 restart, 32 retry), a line
/// "end".
class Recording {
public:
    static constexpr std::size_t maxBytes = std::size_t{4} << 20;
    static constexpr std::uint64_t maxTicks = 500u * 3600u;  ///< an hour

    Recording() = default;
    /// An empty recording for this level with this library.
    explicit Recording(const Level& level);

    /// Adds one tick; says no, and adds nothing, when the recording is as long as it may be.
    bool append(const TickInput& input);
    void clear();

    const std::vector<InputRun>& runs() const { return runs_; }
    std::uint64_t ticks() const { return ticks_; }

    std::string levelId;
    std::uint64_t levelHash = 0;  ///< of the level file's bytes
    std::string library;          ///< version of the physics library
    std::string numbers;          ///< "float" or "double": what the library computed in
    std::uint64_t finalHash = 0;  ///< Session::hash() after the last tick

    /// The text of the file.
    std::string format() const;
    /// Throws RecordingError. `file` is for messages.
    static Recording parse(std::string_view text, const std::string& file);

    /// Throws RecordingError (also when the file cannot be read).
    static Recording read(const std::filesystem::path& file);
    /// Writes to a new file and renames it. Throws atlax::Error.
    void write(const std::filesystem::path& file) const;

private:
    std::vector<InputRun> runs_;
    std::uint64_t ticks_ = 0;
};

/// Hands out a recording tick by tick.
class Playback {
public:
    explicit Playback(std::shared_ptr<const Recording> recording);
    bool done() const { return run_ >= recording_->runs().size(); }
    /// The next tick's input; after the end, the last one with all buttons up.
    TickInput next();

private:
    std::shared_ptr<const Recording> recording_;
    std::size_t run_ = 0;
    std::uint32_t tick_ = 0;
    TickInput last_;
};

/// What a replay of a recording came to.
struct Verdict {
    bool finished = false;
    double seconds = 0;           ///< the timer at the end
    std::uint64_t ticks = 0;      ///< simulated
    std::uint64_t hash = 0;       ///< Session::hash() after the last tick
    bool sameAsRecorded = false;  ///< hash is the recording's finalHash
};

/// Throws RecordingError when the recording was made for another level or another version of it.
void requireMatch(const Level& level, const Recording& recording);

/// Replays a recording from the start in a new session. Throws as requireMatch.
Verdict verify(std::shared_ptr<const Level> level, const Recording& recording);

/// Where the proof of a level lies: beside it, with the extension ".proof".
std::filesystem::path proofOf(const std::filesystem::path& levelFile);

}  // namespace quaoar
