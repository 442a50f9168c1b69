/// \file
/// Threads of oneTBB for a world: link sulfur::tbb.
#pragma once

#include <cstddef>
#include <memory>
#include <sulfur/tasks.hpp>

namespace sulfur {

/// Lends the threads of oneTBB. Owns an arena; the threads are TBB's own, shared with whatever else
/// in the program uses it. Must outlive the worlds that it was given to, or be taken from them.
class TbbTasks final : public Tasks {
public:
    /// `threads`: at most so many work at once, the caller's included, 1 to 1024; 0: as many as the
    /// machine has. Throws Error{outOfRange} when it is more.
    explicit TbbTasks(std::size_t threads = 0);
    ~TbbTasks() override;

    std::size_t threads() const override;
    void run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) override;
    double overhead() const override { return 1; }

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

}  // namespace sulfur
