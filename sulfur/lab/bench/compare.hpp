// Runs scenes in engines, in turns, and keeps what was measured.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/scenes.hpp"
#include "bench/spread.hpp"

namespace sulfur::lab::bench {

struct CompareOptions {
    int rounds = 5;      ///< runs of each row; in each round every row runs once
    double limit = 120;  ///< s: a run that takes longer is stopped, and not run again
    int core = -1;       ///< where to run; below 0: the last allowed one
    bool stages = true;  ///< one run more of each engine that tells the times of its stages
    /// Called with a line on what runs now; may be empty.
    std::function<void(const std::string&)> tell = {};
};

/// One scene in one setting of one engine.
struct Row {
    Scene scene;
    Setting setting;
    Spread msPerSecond;      ///< milliseconds of processor time for a simulated second
    Spread lastSecond;       ///< the same, of the last second only
    double simulated = 0;    ///< s; less than the scene's when the limit stopped it
    Figures figures;         ///< of the first run
    StageTimes stages = {};  ///< s on the wall in all, of a run of its own

    bool cut() const { return simulated < scene.seconds; }
    /// Not a number when there is none of this name.
    double figure(const std::string& name) const;
};

struct Comparison {
    std::vector<Row> rows;
    CompareOptions options;
    int core = -1;  ///< on which it ran; -1 where the system refused
};

/// `wanted` are keys of engines; none: all that were found. What a library cannot play is left
/// out.
Comparison compare(const std::vector<Scene>& scenes, const std::vector<std::string>& wanted,
                   const CompareOptions& options);

/// One run: what it took, and what it showed.
struct RunResult {
    double seconds = 0;     ///< of the clock
    double lastSecond = 0;  ///< of the clock, for the last simulated second
    double simulated = 0;   ///< s
    Figures figures = {};
    StageTimes stages = {};
};
RunResult runOnce(const Scene& scene, const Engine& engine, const Setting& setting, double limit,
                  bool profiling = false);

}  // namespace sulfur::lab::bench
