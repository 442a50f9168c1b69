#include "log_ring.hpp"

#include <algorithm>
#include <cstring>

namespace atlax {

void LogRing::add(LogLevel level, std::string_view line) noexcept {
    std::array<char, recentLogBytes> text{};
    std::size_t length = 0;
    const auto append = [&](std::string_view part) {
        const auto room = std::min(part.size(), text.size() - length);
        std::memcpy(text.data() + length, part.data(), room);
        length += room;
    };
    append(levelName(level));
    append(": ");
    append(line);
    std::replace(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length), '\n', ' ');

    const std::uint64_t index = next_.fetch_add(1, std::memory_order_acq_rel);
    Line& slot = lines_[index % recentLogLines];
    slot.sequence.store(2 * index + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    for (std::size_t i = 0; i < words; ++i) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + i * sizeof word, sizeof word);
        slot.text[i].store(word, std::memory_order_relaxed);
    }
    slot.length.store(length, std::memory_order_relaxed);
    slot.sequence.store(2 * index + 2, std::memory_order_release);
}

std::size_t LogRing::copy(std::uint64_t index,
                          std::array<char, recentLogBytes>& out) const noexcept {
    const Line& slot = lines_[index % recentLogLines];
    const std::uint64_t whole = 2 * index + 2;
    if (slot.sequence.load(std::memory_order_acquire) != whole) return 0;
    for (std::size_t i = 0; i < words; ++i) {
        const std::uint64_t word = slot.text[i].load(std::memory_order_relaxed);
        std::memcpy(out.data() + i * sizeof word, &word, sizeof word);
    }
    const std::uint64_t length = slot.length.load(std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_acquire);
    if (slot.sequence.load(std::memory_order_relaxed) != whole) return 0;
    return std::min<std::size_t>(length, out.size());
}

LogRing& logRing() noexcept {
    static constinit LogRing ring;
    return ring;
}

std::string_view levelName(LogLevel level) noexcept {
    switch (level) {
        case LogLevel::Debug:
            return "debug";
        case LogLevel::Info:
            return "info";
        case LogLevel::Warning:
            return "warning";
        case LogLevel::Error:
            break;
    }
    return "error";
}

}  // namespace atlax
