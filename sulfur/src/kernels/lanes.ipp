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
inline Pair pairAt(const double* xy, std::uint32_t at) {
    return *reinterpret_cast<const StoredPair*>(xy + 2 * std::size_t{at});
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
    return {Lanes{xy[2 * at[0]], xy[2 * at[1]], xy[2 * at[2]], xy[2 * at[3]]},
            Lanes{xy[2 * at[0] + 1], xy[2 * at[1] + 1], xy[2 * at[2] + 1], xy[2 * at[3] + 1]}};
#else
    return {Lanes{xy[2 * at[0]], xy[2 * at[1]]}, Lanes{xy[2 * at[0] + 1], xy[2 * at[1] + 1]}};
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

/// x and y of one particle, moved as one number.
using Both [[gnu::vector_size(LANE_BYTES)]] = double;
inline double both(const SweepReal* xy, std::uint32_t at) {
    double value;
    __builtin_memcpy(&value, xy + 2 * std::size_t{at}, sizeof value);
    return value;
}
using Half [[gnu::vector_size(LANE_BYTES / 2)]] = float;  // of half as many joints as lanes

#if LANE_BYTES == 32
/// Both in an order in which the halves of a register stay where they are.
inline Places gather(const SweepReal* xy, const std::uint32_t* at) {
    const Both even = {both(xy, at[0]), both(xy, at[1]), both(xy, at[4]), both(xy, at[5])};
    const Both odd = {both(xy, at[2]), both(xy, at[3]), both(xy, at[6]), both(xy, at[7])};
    const Lanes p = reinterpret_cast<Lanes>(even), q = reinterpret_cast<Lanes>(odd);
    return {__builtin_shufflevector(p, q, 0, 2, 8, 10, 4, 6, 12, 14),
            __builtin_shufflevector(p, q, 1, 3, 9, 11, 5, 7, 13, 15)};
}
inline Lanes gatherOne(const SweepReal* from, const std::uint32_t* at) {
    return Lanes{from[at[0]], from[at[1]], from[at[2]], from[at[3]],
                 from[at[4]], from[at[5]], from[at[6]], from[at[7]]};
}
inline Half narrowedTwo(Pair p, Pair q) {
    return __builtin_convertvector(__builtin_shufflevector(p, q, 0, 1, 2, 3), Half);
}
/// From the particles a to the particles b.
inline Places between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    const auto d = [&](int i) { return pairAt(xy, b[i]) - pairAt(xy, a[i]); };
    const Lanes even = __builtin_shufflevector(narrowedTwo(d(0), d(1)), narrowedTwo(d(4), d(5)), 0,
                                               1, 2, 3, 4, 5, 6, 7);
    const Lanes odd = __builtin_shufflevector(narrowedTwo(d(2), d(3)), narrowedTwo(d(6), d(7)), 0,
                                              1, 2, 3, 4, 5, 6, 7);
    return {__builtin_shufflevector(even, odd, 0, 2, 8, 10, 4, 6, 12, 14),
            __builtin_shufflevector(even, odd, 1, 3, 9, 11, 5, 7, 13, 15)};
}
#else
inline Places gather(const SweepReal* xy, const std::uint32_t* at) {
    const Both first = {both(xy, at[0]), both(xy, at[1])};
    const Both second = {both(xy, at[2]), both(xy, at[3])};
    const Lanes p = reinterpret_cast<Lanes>(first), q = reinterpret_cast<Lanes>(second);
    return {__builtin_shufflevector(p, q, 0, 2, 4, 6), __builtin_shufflevector(p, q, 1, 3, 5, 7)};
}
inline Lanes gatherOne(const SweepReal* from, const std::uint32_t* at) {
    return Lanes{from[at[0]], from[at[1]], from[at[2]], from[at[3]]};
}
inline Places between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    Places d;
    for (int i = 0; i < width; ++i) {
        const Half p = __builtin_convertvector(pairAt(xy, b[i]) - pairAt(xy, a[i]), Half);
        d.x[i] = p[0];
        d.y[i] = p[1];
    }
    return d;
}
#endif

#endif

}  // namespace

}  // namespace sulfur::detail
