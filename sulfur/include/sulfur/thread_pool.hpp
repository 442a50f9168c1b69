/// \file
/// Threads for worlds, for programs that have no job system.
#pragma once

#include <cstddef>
#include <memory>
#include <sulfur/tasks.hpp>

namespace sulfur {

/// Threads of its own that stay awake while a tick lasts: a tick hands over work tens of times, a
/// few microseconds each, and to wake a thread takes longer than that. Between ticks they sleep.
/// Who has handed over work does what no other thread has begun, so that one which is late costs
/// nothing. Must outlive the worlds that it was given to, or be taken from them.
///
/// It serves one run() at a time; another thread that calls it meanwhile does its work alone.
class ThreadPool final : public Tasks {
public:
    /// `threads`: at most so many work at once, the caller's included, 1 to 32; 0: as many as the
    /// machine has, up to these. More than the processor has cores to spare slow a world down.
    /// Throws Error{outOfRange} when it is more.
    explicit ThreadPool(std::size_t threads = 0);
    ~ThreadPool() override;

    std::size_t threads() const override;
    void run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) override;
    double overhead() const override { return 0.25; }
    void rest() override;

private:
    class Crew;
    std::unique_ptr<Crew> crew_;
};

}  // namespace sulfur
