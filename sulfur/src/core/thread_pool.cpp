#include "sulfur/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <sulfur/error.hpp>
#include <thread>
#include <vector>

namespace sulfur {

namespace {

using Clock = std::chrono::steady_clock;

/// One bit of a word for the share of each thread.
constexpr std::size_t mostThreads = 32;

/// How long a thread stays awake without work: in a tick, whose longest part that is not divided
/// may take so long in a large world; and after it, in case that the next one follows at once.
constexpr auto patience = std::chrono::milliseconds(2);
constexpr auto patienceAtRest = std::chrono::microseconds(100);

std::size_t checked(std::size_t threads) {
    if (threads > mostThreads)
        throw Error(ErrorCode::outOfRange, "the number of threads is " + std::to_string(threads) +
                                               "; allowed are 0 to " + std::to_string(mostThreads));
    if (threads > 0) return threads;
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, mostThreads);
}

/// A moment's rest for the core, within a loop that waits.
inline void relax() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

/// Waits without sleeping until f(); gives way to other threads of the machine when that takes
/// longer than usual.
template <class Function>
void waitUntil(Function&& f) {
    for (std::uint32_t looks = 1; !f(); ++looks) {
        relax();
        if (looks % 4096 == 0) std::this_thread::yield();
    }
}

}  // namespace

/// The threads, and what they are offered. Work is divided into shares, of which the first is the
/// caller's; whoever takes one of the others clears its bit.
class ThreadPool::Crew {
public:
    using Task = void (*)(void* context, std::size_t i);

    explicit Crew(std::size_t threads) {
        for (std::size_t i = 1; i < threads; ++i)
            threads_.emplace_back([this, i] { work(static_cast<unsigned>(i)); });
    }

    ~Crew() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

    std::size_t size() const { return threads_.size() + 1; }

    void run(std::size_t count, Task task, void* context) {
        if (count < 2 || threads_.empty() || serves_.exchange(true, std::memory_order_acquire)) {
            for (std::size_t i = 0; i < count; ++i) task(context, i);
            return;
        }
        job_ = {task, context, count, std::min(count, size())};
        done_.store(0, std::memory_order_relaxed);
        resting_.store(false, std::memory_order_relaxed);
        offer();
        doShare(0);
        std::uint32_t others = static_cast<std::uint32_t>(job_.shares) - 1;
        for (unsigned share; takeShare(0, share); --others) doShare(share);
        waitUntil([&] { return done_.load(std::memory_order_acquire) == others; });
        serves_.store(false, std::memory_order_release);
    }

    void rest() { resting_.store(true, std::memory_order_relaxed); }

private:
    struct Job {
        Task task = nullptr;
        void* context = nullptr;
        std::size_t count = 0, shares = 0;
    };

    /// All shares but the first. Sequential consistency, so that either the caller sees who sleeps
    /// or they see the offer before they do.
    void offer() {
        const std::uint32_t mask =
            static_cast<std::uint32_t>(~std::uint64_t{0} >> (64 - job_.shares)) & ~1u;
        ++number_;
        offered_.store(std::uint64_t{number_} << 32 | mask, std::memory_order_seq_cst);
        // To wake them takes a while, within which nobody need be woken again.
        if (sleepers_.load(std::memory_order_seq_cst) == 0 || called_.exchange(true)) return;
        {
            const std::lock_guard lock(mutex_);
            ++calls_;
        }
        wake_.notify_all();
    }

    bool isOffered() const {
        return static_cast<std::uint32_t>(offered_.load(std::memory_order_seq_cst)) != 0;
    }

    /// Takes a share of what is offered, if it can be one's own, so that a thread has the same part
    /// of the data again. The number of the job, which is in the same word, keeps one that is late
    /// from taking a share of the next by mistake.
    bool takeShare(unsigned own, unsigned& share) {
        std::uint64_t offered = offered_.load(std::memory_order_acquire);
        for (;;) {
            const auto mask = static_cast<std::uint32_t>(offered);
            if (mask == 0) return false;
            share = (mask >> own & 1u) != 0 ? own : static_cast<unsigned>(std::countr_zero(mask));
            const std::uint64_t left = offered & ~(std::uint64_t{1} << share);
            if (offered_.compare_exchange_weak(offered, left, std::memory_order_acq_rel,
                                               std::memory_order_acquire))
                return true;
        }
    }

    void doShare(std::size_t share) {
        for (std::size_t i = share; i < job_.count; i += job_.shares) job_.task(job_.context, i);
    }

    void work(unsigned own) {
        while (waitForOffer())
            for (unsigned share; takeShare(own, share);) {
                doShare(share);
                done_.fetch_add(1, std::memory_order_release);
            }
    }

    /// Returns false when the thread shall end.
    bool waitForOffer() {
        Clock::time_point begin{};
        for (std::uint32_t looks = 1; !isOffered(); ++looks) {
            relax();
            if (looks % 64 != 0) continue;
            const auto now = Clock::now();
            if (looks == 64) begin = now;
            const bool resting = resting_.load(std::memory_order_relaxed);
            if (now - begin > (resting ? patienceAtRest : patience)) {
                if (!sleep()) return false;
                looks = 0;
            } else if (looks % 4096 == 0) {
                std::this_thread::yield();
            }
        }
        return true;
    }

    /// Until it is called. What it was called for may be done by then, but more of it will follow.
    /// Returns false when the thread shall end.
    bool sleep() {
        std::unique_lock lock(mutex_);
        sleepers_.fetch_add(1, std::memory_order_seq_cst);
        called_ = false;
        const auto before = calls_;
        if (!isOffered()) wake_.wait(lock, [&] { return stop_ || calls_ != before; });
        sleepers_.fetch_sub(1, std::memory_order_relaxed);
        return !stop_;
    }

    // What the caller writes and the others look at, and the other way round, each in lines of the
    // caches of its own.
    alignas(64) std::atomic<std::uint64_t> offered_{0};  // number of the job, and bits of shares
    Job job_;
    alignas(64) std::atomic<std::uint32_t> done_{0};  // shares, by others than the caller
    alignas(64) std::atomic<bool> serves_{false};
    std::atomic<bool> resting_{true};
    std::uint32_t number_ = 0;
    std::atomic<int> sleepers_{0};
    std::atomic<bool> called_{false};  // since somebody fell asleep
    bool stop_ = false;
    std::uint32_t calls_ = 0;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::thread> threads_;
};

ThreadPool::ThreadPool(std::size_t threads) : crew_(std::make_unique<Crew>(checked(threads))) {}
ThreadPool::~ThreadPool() = default;

std::size_t ThreadPool::threads() const {
    return crew_->size();
}

void ThreadPool::run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) {
    crew_->run(count, task, context);
}

void ThreadPool::rest() {
    crew_->rest();
}

}  // namespace sulfur
