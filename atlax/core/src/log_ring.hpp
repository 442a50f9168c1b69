#pragma once

#include <array>
#include <atlax/log.hpp>
#include <atomic>
#include <cstdint>

namespace atlax {

/// The last lines of the log in static memory that a signal handler can read: no locks and no
/// allocation. Writers take turns by a counter; a line that is being written while it is read is
/// left out, as its sequence number tells.
class LogRing {
public:
    void add(LogLevel level, std::string_view line) noexcept;

    /// Calls `use(const char* text, std::size_t length)` for each line, oldest first.
    /// Async-signal-safe if `use` is.
    template <class Use>
    void forEach(Use use) const noexcept {
        const std::uint64_t end = next_.load(std::memory_order_acquire);
        const std::uint64_t begin = end > recentLogLines ? end - recentLogLines : 0;
        for (std::uint64_t i = begin; i < end; ++i) {
            std::array<char, recentLogBytes> text;
            const std::size_t length = copy(i, text);
            if (length > 0) use(text.data(), length);
        }
    }

private:
    /// Words, because a torn read of plain characters would be a data race.
    static constexpr std::size_t words = recentLogBytes / sizeof(std::uint64_t);
    struct Line {
        std::atomic<std::uint64_t> sequence{0};  ///< 2 i + 2 when line i is whole, odd meanwhile
        std::atomic<std::uint64_t> length{0};
        std::array<std::atomic<std::uint64_t>, words> text{};
    };

    std::size_t copy(std::uint64_t index, std::array<char, recentLogBytes>& out) const noexcept;

    std::array<Line, recentLogLines> lines_{};
    std::atomic<std::uint64_t> next_{0};
};

/// Of the one log.
LogRing& logRing() noexcept;

/// "warning" and so on.
std::string_view levelName(LogLevel level) noexcept;

}  // namespace atlax
