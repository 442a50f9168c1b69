// Work in pieces, for the threads that a host lends.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <sulfur/tasks.hpp>
#include <type_traits>
#include <vector>

namespace sulfur::detail {

/// Into how many pieces `count` items are divided, of which a thread does so many in a microsecond:
/// a piece takes twice as long as to hand it over.
inline std::size_t piecesOf(const Tasks* tasks, std::size_t count, std::size_t inMicrosecond) {
    if (!tasks || count < 2) return 1;
    const double least = std::max(2 * tasks->overhead() * static_cast<double>(inMicrosecond), 1.0);
    const double most = static_cast<double>(count) / least;
    if (most < 2) return 1;
    const std::size_t threads = std::max<std::size_t>(1, tasks->threads());
    return most < static_cast<double>(threads) ? static_cast<std::size_t>(most) : threads;
}

/// Where piece `i` of so many begins; that of the last one's successor is `count`.
inline std::size_t pieceStart(std::size_t i, std::size_t pieces, std::size_t count) {
    return count / pieces * i + std::min(i, count % pieces);
}

/// Calls f(i) for each piece, at once where there are several.
template <class Function>
void runPieces(Tasks* tasks, std::size_t pieces, Function&& f) {
    if (pieces == 1) return f(std::size_t{0});
    tasks->run(
        pieces,
        [](void* context, std::size_t i) {
            (*static_cast<std::remove_reference_t<Function>*>(context))(i);
        },
        &f);
}

/// Calls f(first, last) for pieces of [0, count); see piecesOf().
template <class Function>
void inPieces(Tasks* tasks, std::size_t count, std::size_t inMicrosecond, Function&& f) {
    const std::size_t pieces = piecesOf(tasks, count, inMicrosecond);
    if (pieces == 1) return f(std::size_t{0}, count);
    runPieces(tasks, pieces, [&](std::size_t i) {
        f(pieceStart(i, pieces, count), pieceStart(i + 1, pieces, count));
    });
}

/// Whether f(first, last) is true for any of the pieces.
template <class Function>
bool anyInPieces(Tasks* tasks, std::size_t count, std::size_t inMicrosecond, Function&& f) {
    const std::size_t pieces = piecesOf(tasks, count, inMicrosecond);
    if (pieces == 1) return f(std::size_t{0}, count);
    std::atomic<bool> any{false};
    runPieces(tasks, pieces, [&](std::size_t i) {
        if (f(pieceStart(i, pieces, count), pieceStart(i + 1, pieces, count)))
            any.store(true, std::memory_order_relaxed);
    });
    return any.load(std::memory_order_relaxed);
}

/// The largest of what f(first, last), at least 0, gives for the pieces.
template <class Function>
auto mostInPieces(Tasks* tasks, std::size_t count, std::size_t inMicrosecond, Function&& f) {
    using Number = decltype(f(std::size_t{0}, count));
    const std::size_t pieces = piecesOf(tasks, count, inMicrosecond);
    if (pieces == 1) return f(std::size_t{0}, count);
    std::atomic<Number> most{0};
    runPieces(tasks, pieces, [&](std::size_t i) {
        const Number mine = f(pieceStart(i, pieces, count), pieceStart(i + 1, pieces, count));
        Number now = most.load(std::memory_order_relaxed);
        while (now < mine && !most.compare_exchange_weak(now, mine, std::memory_order_relaxed)) {
        }
    });
    return most.load(std::memory_order_relaxed);
}

/// Numbers that pieces of work find, in the order in which one piece would have found them.
class FoundInPieces {
public:
    /// Appends to `found` what f(first, last, list) appends to its list for the pieces of
    /// [0, count), at most `each` numbers for an item.
    template <class Function>
    void operator()(Tasks* tasks, std::size_t count, std::size_t inMicrosecond, std::size_t each,
                    std::vector<std::uint32_t>& found, Function&& f) {
        const std::size_t pieces = piecesOf(tasks, count, inMicrosecond);
        if (pieces == 1) return f(std::size_t{0}, count, found);
        if (lists_.size() < pieces) lists_.resize(pieces);
        // Pieces take no memory: nobody would see that there is none.
        for (std::size_t i = 0; i < pieces; ++i) {
            lists_[i].clear();
            lists_[i].reserve(each * (count / pieces + 1));
        }
        runPieces(tasks, pieces, [&](std::size_t i) {
            f(pieceStart(i, pieces, count), pieceStart(i + 1, pieces, count), lists_[i]);
        });
        for (std::size_t i = 0; i < pieces; ++i)
            found.insert(found.end(), lists_[i].begin(), lists_[i].end());
    }

private:
    std::vector<std::vector<std::uint32_t>> lists_;
};

}  // namespace sulfur::detail
