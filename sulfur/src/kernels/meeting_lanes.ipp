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

#if defined(__SSE2__) && !defined(SULFUR_REAL_DOUBLE)

/// Writes four pairs of x and y, two to a vector, to lanes of their own.
inline void part(__m128 first, __m128 second, float* x, float* y) {
    _mm_store_ps(x, _mm_shuffle_ps(first, second, _MM_SHUFFLE(2, 0, 2, 0)));
    _mm_store_ps(y, _mm_shuffle_ps(first, second, _MM_SHUFFLE(3, 1, 3, 1)));
}

inline __m128 twoPairs(const float* pairs, const std::uint32_t* of) {
    const auto at = [&](std::uint32_t i) { return pairs + std::size_t{2} * i; };
    const __m128d first = _mm_load_sd(reinterpret_cast<const double*>(at(of[0])));
    return _mm_loadh_pi(_mm_castpd_ps(first), reinterpret_cast<const __m64*>(at(of[1])));
}

inline void gatherPairs(const float* pairs, const std::uint32_t* of, float* x, float* y) {
    part(twoPairs(pairs, of), twoPairs(pairs, of + 2), x, y);
}

/// A particle and the second end of its capsule, rounded, as x and y each.
struct Sides {
    __m128 particle, end;
};

inline Sides gatherSides(const double* position, MeetingBlock& b, std::size_t i) {
    const auto at = [&](std::uint32_t k) { return _mm_loadu_pd(position + std::size_t{2} * k); };
    const __m128d a = at(b.a[i]), p = at(b.particle[i]) - a, end = at(b.b[i]) - a;
    const __m128d products = end * _mm_shuffle_pd(p, p, 1);
    _mm_store_sd(b.beside + i, products - _mm_unpackhi_pd(products, products));
    return {_mm_cvtpd_ps(p), _mm_cvtpd_ps(end)};
}

inline void gatherFour(const MeetingView& view, MeetingBlock& b, std::size_t i) {
    const Sides s0 = gatherSides(view.position, b, i), s1 = gatherSides(view.position, b, i + 1);
    const Sides s2 = gatherSides(view.position, b, i + 2),
                s3 = gatherSides(view.position, b, i + 3);
    part(_mm_movelh_ps(s0.particle, s1.particle), _mm_movelh_ps(s2.particle, s3.particle), b.x + i,
         b.y + i);
    part(_mm_movelh_ps(s0.end, s1.end), _mm_movelh_ps(s2.end, s3.end), b.endX + i, b.endY + i);
    gatherPairs(view.displacement, b.particle + i, b.moveX + i, b.moveY + i);
    gatherPairs(view.displacement, b.a + i, b.moveAX + i, b.moveAY + i);
    gatherPairs(view.displacement, b.b + i, b.moveBX + i, b.moveBY + i);
}

#else

inline void gatherOne(const MeetingView& view, MeetingBlock& b, std::size_t i) {
    const std::size_t particle = 2 * std::size_t{b.particle[i]};
    const std::size_t first = 2 * std::size_t{b.a[i]}, second = 2 * std::size_t{b.b[i]};
    const double* x = view.position;
    const SweepReal* d = view.displacement;
    const double pX = x[particle] - x[first], pY = x[particle + 1] - x[first + 1];
    const double bX = x[second] - x[first], bY = x[second + 1] - x[first + 1];
    b.beside[i] = bX * pY - bY * pX;
    b.x[i] = static_cast<SweepReal>(pX), b.y[i] = static_cast<SweepReal>(pY);
    b.endX[i] = static_cast<SweepReal>(bX), b.endY[i] = static_cast<SweepReal>(bY);
    b.moveX[i] = d[particle], b.moveY[i] = d[particle + 1];
    b.moveAX[i] = d[first], b.moveAY[i] = d[first + 1];
    b.moveBX[i] = d[second], b.moveBY[i] = d[second + 1];
}

inline void gatherFour(const MeetingView& view, MeetingBlock& b, std::size_t i) {
    for (std::size_t k = i; k < i + 4; ++k) gatherOne(view, b, k);
}

#endif

void gatherAll(const MeetingView& view, MeetingBlock* blocks, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < meetingLanes; i += 4) gatherFour(view, blocks[k], i);
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
