// The paper's Table 4 as an experiment: boxes that drop each second against the share of a
// processor core that physics takes.
#pragma once

#include <atomic>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace sulfurchamber {

/// What a rate of boxes took.
struct Table4Cell {
    int rate = 0;           ///< boxes a second
    double percent = 0;     ///< of a core's time, the mean of all seconds
    std::size_t boxes = 0;  ///< at the end
};

/// A machine of the paper, in per cent for each of table4Rates().
struct Table4Machine {
    std::string name;
    std::vector<double> percent;
};

/// Boxes a second: the columns of the table.
std::span<const int> table4Rates();
/// The figures of the paper.
std::vector<Table4Machine> table4Machines();

/// Runs the columns one after the other on a thread of its own, in worlds of its own. Boxes of 1 m
/// drop from 29 m into an arena with walls. Only the time of that thread counts, not what others
/// take. The functions belong to one thread; results may be asked for at any time.
class Table4 {
public:
    Table4() = default;
    ~Table4() { stop(); }
    Table4(const Table4&) = delete;
    Table4& operator=(const Table4&) = delete;

    /// Forgets what was measured and begins. `seconds` of simulated time for each rate.
    void start(std::vector<int> rates, double seconds = 10);
    /// Ends within a tick; what was measured stays.
    void stop();
    bool running() const { return running_; }
    /// 0 to 1, of all rates.
    double progress() const { return progress_; }
    /// Those that are finished, in their order.
    std::vector<Table4Cell> cells() const;

private:
    void run(std::stop_token stop, std::vector<int> rates, double seconds);

    mutable std::mutex mutex_;
    std::vector<Table4Cell> cells_;
    std::atomic<double> progress_ = 0;
    std::atomic<bool> running_ = false;
    std::jthread thread_;
};

/// A table: a head with the rates, a line for each machine of the paper, then ours.
std::string table4Csv(std::span<const Table4Cell> cells);

}  // namespace sulfurchamber
