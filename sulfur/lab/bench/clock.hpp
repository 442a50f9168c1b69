// Time and the processor core on which it is measured.
#pragma once

#include <vector>

namespace sulfur::lab::bench {

/// Seconds of processor time that this thread has used: what other programs take does not count.
double threadTime();
/// Seconds on the wall, for what runs on several threads.
double wallTime();

/// Keeps this thread, and threads that it makes, on one core while it lives, and then gives back
/// the cores that it had. Where the system refuses, nothing changes.
class Pinned {
public:
    /// `core`: number of the core; below 0: the last of those that this thread may use.
    explicit Pinned(int core = -1);
    ~Pinned();
    Pinned(Pinned&&) = delete;
    Pinned& operator=(Pinned&&) = delete;

    /// The core, or -1 when the system refused.
    int core() const { return core_; }

private:
    std::vector<int> before_;
    int core_ = -1;
};

/// The cores that this thread may use.
std::vector<int> allowedCores();

}  // namespace sulfur::lab::bench
