// Work in pieces, for the threads that a host lends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <sulfur/tasks.hpp>
#include <type_traits>

namespace sulfur::detail {

/// Into how many pieces of at least `least` items `count` items are divided.
inline std::size_t piecesOf(const Tasks* tasks, std::size_t count, std::size_t least) {
    if (!tasks || count < 2 * least) return 1;
    return std::max<std::size_t>(1, std::min(tasks->threads(), count / least));
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

/// Calls f(first, last) for pieces of [0, count) of at least `least` items each.
template <class Function>
void inPieces(Tasks* tasks, std::size_t count, std::size_t least, Function&& f) {
    const std::size_t pieces = piecesOf(tasks, count, least);
    runPieces(tasks, pieces, [&](std::size_t i) {
        f(pieceStart(i, pieces, count), pieceStart(i + 1, pieces, count));
    });
}

}  // namespace sulfur::detail
