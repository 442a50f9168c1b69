// Work in pieces, for the threads that a host lends.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <sulfur/tasks.hpp>
#include <type_traits>

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

/// Calls both, at once where there are threads for two.
template <class First, class Second>
void runBoth(Tasks* tasks, First&& first, Second&& second) {
    if (!tasks || tasks->threads() < 2) {
        first();
        second();
        return;
    }
    runPieces(tasks, 2, [&](std::size_t i) { i == 0 ? first() : second(); });
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

}  // namespace sulfur::detail
