// The kernels of meeting_lanes.hpp, for the vectors of SWEEP_BYTES that the including file has set.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr int width = SWEEP_BYTES / sizeof(SweepReal);
using Lanes [[gnu::vector_size(SWEEP_BYTES)]] = SweepReal;

inline Lanes load(const SweepReal* from) {
    return *reinterpret_cast<const Lanes*>(from);
}
inline void store(SweepReal* to, Lanes value) {
    *reinterpret_cast<Lanes*>(to) = value;
}

inline Lanes root(Lanes v) {
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE) && SWEEP_BYTES == 32
    return _mm256_sqrt_ps(v);
#elif defined(__AVX__) && SWEEP_BYTES == 32
    return _mm256_sqrt_pd(v);
#elif defined(__SSE2__) && !defined(SULFUR_REAL_DOUBLE)
    return _mm_sqrt_ps(v);
#elif defined(__SSE2__)
    return _mm_sqrt_pd(v);
#else
    for (int i = 0; i < width; ++i)
        v[i] = static_cast<SweepReal>(__builtin_sqrt(static_cast<double>(v[i])));
    return v;
#endif
}

inline Lanes size(Lanes v) {
    return v < 0 ? -v : v;
}

/// As many candidates as there are lanes, from the `i`th of a block on.
inline void meet(MeetingBlock& b, std::size_t i) {
    const Lanes zero{}, one = zero + SweepReal(1);
    const Lanes x = load(b.x + i), y = load(b.y + i);
    const Lanes endX = load(b.endX + i), endY = load(b.endY + i);
    const Lanes moveX = load(b.moveX + i), moveY = load(b.moveY + i);
    const Lanes aX = load(b.moveAX + i), aY = load(b.moveAY + i);
    const Lanes bX = load(b.moveBX + i), bY = load(b.moveBY + i);

    const Lanes byA = size(moveX - aX) + size(moveY - aY);
    const Lanes byB = size(moveX - bX) + size(moveY - bY);
    const Lanes travel = byA < byB ? byB : byA;
    const Lanes length2 = endX * endX + endY * endY;
    const Lanes place = (x * endX + y * endY) / length2;
    const Lanes clamped = place < zero ? zero : one < place ? one : place;
    const Lanes along = length2 == zero ? zero : clamped;
    const Lanes offX = x - along * endX, offY = y - along * endY;
    const Lanes reach = load(b.reach + i) + travel;
    store(b.along + i, along);
    store(b.travel + i, travel);
    store(b.far + i, offX * offX + offY * offY > reach * reach ? one : zero);

    const Lanes length = root(length2);
    const Lanes leftX = -endY / length, leftY = endX / length;
    const Lanes height = leftX * x + leftY * y;
    const Lanes normalX = height < zero ? -leftX : leftX;
    const Lanes normalY = height < zero ? -leftY : leftY;
    const Lanes onA = one - along;
    const Lanes movedX = moveX - onA * aX - along * bX;
    const Lanes movedY = moveY - onA * aY - along * bY;
    store(b.normalX + i, normalX);
    store(b.normalY + i, normalY);
    store(b.distance + i, height < zero ? -height : height);
    store(b.movedX + i, movedX);
    store(b.movedY + i, movedY);
    store(b.closing + i, normalX * movedX + normalY * movedY);
}

void meetAll(MeetingBlock* blocks, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < meetingLanes; i += width) meet(blocks[k], i);
}

}  // namespace

}  // namespace sulfur::detail
