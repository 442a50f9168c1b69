// Where the time of the ticks goes, stage by stage, and which object takes most of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <sulfur/world.hpp>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

/// A stage as a line of a table names it, in English: "Broad phase".
std::string stageTitle(sulfur::Stage stage);

/// Mean times of the last ticks. One thread.
class StageTimes {
public:
    static constexpr std::size_t stages = static_cast<std::size_t>(sulfur::Stage::count);

    /// After a tick of a world that measures its stages (World::setProfiling).
    void add(const sulfur::Statistics& tick);
    void clear() { *this = {}; }
    /// Seconds of processor time that a tick takes, of a stage and of all.
    double seconds(sulfur::Stage stage) const;
    double seconds() const;
    /// Share of a second that the stages of a second's ticks take, at this rate.
    double load(int tickRate) const { return seconds() * tickRate; }

private:
    std::array<double, stages> mean_{};
    double weight_ = 0;
};

/// What a group of bodies that hang together costs.
struct ObjectCost {
    std::string name;
    double share = 0;  ///< of a tick: what is gone when it is gone
};

/// Finds which object costs most, by what the world costs without it: for each of a few candidates
/// a copy of the world goes on for a while without it. Nothing of the document changes.
class CostSearch {
public:
    /// How many are tried: those with the most particles that are awake.
    static constexpr std::size_t mostCandidates = 6;

    explicit CostSearch(const Document& document);
    /// Goes on for about so many milliseconds; true when all is known.
    bool goOn(double milliseconds);
    /// 0 to 1.
    double progress() const;
    /// The dearest first; those below the noise of the measurement are left out.
    std::vector<ObjectCost> costs() const;

private:
    struct Candidate {
        std::string name;
        std::vector<sulfur::BodyId> bodies;
    };
    struct Run {
        std::optional<sulfur::World> world;
        int ticks = 0;
        std::vector<double> seconds;
    };
    void begin(std::size_t run);
    static double medianOf(std::vector<double> values);

    sulfur::World base_;
    std::vector<Candidate> candidates_;
    std::vector<Run> runs_;  ///< the first is that of all
    std::size_t current_ = 0;
};

}  // namespace sulfurchamber
