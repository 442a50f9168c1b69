// Vectors of LANE_BYTES, which the including file has set, and how joints and particles get into
// their lanes: what several kernels have in common.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr int width = LANE_BYTES / sizeof(SweepReal);
using Lanes [[gnu::vector_size(LANE_BYTES)]] = SweepReal;
using Mask = decltype(Lanes{} < Lanes{});
/// The vectors as they lie in memory, at any address.
using Stored [[gnu::vector_size(LANE_BYTES), gnu::aligned(alignof(SweepReal)), gnu::may_alias]] =
    SweepReal;
/// x and y of one particle.
using Pair [[gnu::vector_size(16)]] = double;
using StoredPair [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;

/// A bit for each lane.
constexpr std::uint32_t everyLane = (1u << width) - 1;

inline Lanes load(const SweepReal* from) {
    return *reinterpret_cast<const Stored*>(from);
}
inline void store(SweepReal* to, Lanes value) {
    *reinterpret_cast<Stored*>(to) = value;
}
// Particles are named by the places of their x, which are twice their numbers.
inline Pair pairAt(const double* xy, std::uint32_t at) {
    return *reinterpret_cast<const StoredPair*>(xy + at);
}

inline Lanes root(Lanes v) {
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE) && LANE_BYTES == 32
    return _mm256_sqrt_ps(v);
#elif defined(__AVX__) && LANE_BYTES == 32
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
/// Of which lanes the condition is true.
inline std::uint32_t bits(Mask m) {
    const Lanes v = reinterpret_cast<Lanes>(m);
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE) && LANE_BYTES == 32
    return static_cast<std::uint32_t>(_mm256_movemask_ps(v));
#elif defined(__AVX__) && LANE_BYTES == 32
    return static_cast<std::uint32_t>(_mm256_movemask_pd(v));
#elif defined(__SSE2__) && !defined(SULFUR_REAL_DOUBLE)
    return static_cast<std::uint32_t>(_mm_movemask_ps(v));
#elif defined(__SSE2__)
    return static_cast<std::uint32_t>(_mm_movemask_pd(v));
#else
    std::uint32_t set = 0;
    for (int k = 0; k < width; ++k) set |= (m[k] != 0 ? 1u : 0u) << k;
    return set;
#endif
}

struct Places {
    Lanes x, y;
};

#ifdef SULFUR_REAL_DOUBLE

inline Places gather(const SweepReal* xy, const std::uint32_t* at) {
#if LANE_BYTES == 32
    return {Lanes{xy[at[0]], xy[at[1]], xy[at[2]], xy[at[3]]},
            Lanes{xy[at[0] + 1], xy[at[1] + 1], xy[at[2] + 1], xy[at[3] + 1]}};
#else
    return {Lanes{xy[at[0]], xy[at[1]]}, Lanes{xy[at[0] + 1], xy[at[1] + 1]}};
#endif
}
inline Lanes gatherOne(const SweepReal* from, const std::uint32_t* at) {
#if LANE_BYTES == 32
    return Lanes{from[at[0]], from[at[1]], from[at[2]], from[at[3]]};
#else
    return Lanes{from[at[0]], from[at[1]]};
#endif
}
/// From the particles a to the particles b.
inline Places between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    Places d;
    for (int i = 0; i < width; ++i) {
        const Pair p = pairAt(xy, b[i]) - pairAt(xy, a[i]);
        d.x[i] = p[0];
        d.y[i] = p[1];
    }
    return d;
}

#else

using Four [[gnu::vector_size(16)]] = float;

/// x and y of two particles, one after the other.
inline Four twoAt(const float* xy, std::uint32_t i, std::uint32_t j) {
#if defined(__SSE2__)
    const __m128i first = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(xy + i));
    return _mm_loadh_pi(_mm_castsi128_ps(first), reinterpret_cast<const __m64*>(xy + j));
#else
    return Four{xy[i], xy[i + 1], xy[j], xy[j + 1]};
#endif
}

#if LANE_BYTES == 32
inline Lanes joined(Four low, Four high) {
    return _mm256_set_m128(high, low);
}
/// From the one to the other of two pairs of particles.
inline Four betweenTwo(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    const auto two = [&](const std::uint32_t* at) {
        return _mm256_set_m128d(pairAt(xy, at[1]), pairAt(xy, at[0]));
    };
    return _mm256_cvtpd_ps(two(b) - two(a));
}
/// What is gathered comes in an order in which the halves of a register stay where they are.
inline Places sorted(Lanes even, Lanes odd) {
    return {__builtin_shufflevector(even, odd, 0, 2, 8, 10, 4, 6, 12, 14),
            __builtin_shufflevector(even, odd, 1, 3, 9, 11, 5, 7, 13, 15)};
}
inline Places gather(const float* xy, const std::uint32_t* at) {
    return sorted(joined(twoAt(xy, at[0], at[1]), twoAt(xy, at[4], at[5])),
                  joined(twoAt(xy, at[2], at[3]), twoAt(xy, at[6], at[7])));
}
inline Places between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    const auto d = [&](int i) { return betweenTwo(xy, a + i, b + i); };
    return sorted(joined(d(0), d(4)), joined(d(2), d(6)));
}
inline Lanes gatherOne(const float* from, const std::uint32_t* at) {
    return Lanes{from[at[0]], from[at[1]], from[at[2]], from[at[3]],
                 from[at[4]], from[at[5]], from[at[6]], from[at[7]]};
}
#else
using Two [[gnu::vector_size(8)]] = float;

inline Places gather(const float* xy, const std::uint32_t* at) {
    const Lanes p = twoAt(xy, at[0], at[1]), q = twoAt(xy, at[2], at[3]);
    return {__builtin_shufflevector(p, q, 0, 2, 4, 6), __builtin_shufflevector(p, q, 1, 3, 5, 7)};
}
/// From the particles a to the particles b.
inline Places between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    Places d;
    for (int i = 0; i < width; ++i) {
        const Two p = __builtin_convertvector(pairAt(xy, b[i]) - pairAt(xy, a[i]), Two);
        d.x[i] = p[0];
        d.y[i] = p[1];
    }
    return d;
}
inline Lanes gatherOne(const float* from, const std::uint32_t* at) {
    return Lanes{from[at[0]], from[at[1]], from[at[2]], from[at[3]]};
}
#endif

#endif

}  // namespace

}  // namespace sulfur::detail
