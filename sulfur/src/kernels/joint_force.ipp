// The kernels of joint_force.hpp, for the vectors of FORCE_BYTES that the including file has set.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr int width = FORCE_BYTES / sizeof(SweepReal);
using Lanes [[gnu::vector_size(FORCE_BYTES)]] = SweepReal;
using Stored [[gnu::vector_size(FORCE_BYTES), gnu::aligned(alignof(SweepReal)), gnu::may_alias]] =
    SweepReal;
/// x and y of one particle.
using Pair [[gnu::vector_size(16)]] = double;
using StoredPair [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;

inline Lanes load(const SweepReal* from) {
    return *reinterpret_cast<const Stored*>(from);
}
inline Pair pairAt(const double* xy, std::uint32_t at) {
    return *reinterpret_cast<const StoredPair*>(xy + 2 * std::size_t{at});
}
inline void addAt(double* xy, std::uint32_t at, Pair by) {
    auto* place = reinterpret_cast<StoredPair*>(xy + 2 * std::size_t{at});
    *place = *place + by;
}

inline Lanes root(Lanes v) {
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE) && FORCE_BYTES == 32
    return _mm256_sqrt_ps(v);
#elif defined(__AVX__) && FORCE_BYTES == 32
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

struct Both {
    Lanes x, y;
};

#ifdef SULFUR_REAL_DOUBLE

/// From the particles a to the particles b.
inline Both between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    Both d;
    for (int i = 0; i < width; ++i) {
        const Pair p = pairAt(xy, b[i]) - pairAt(xy, a[i]);
        d.x[i] = p[0];
        d.y[i] = p[1];
    }
    return d;
}
inline void unpack(const Both& v, Pair* pairs) {
    for (int i = 0; i < width; ++i) pairs[i] = Pair{v.x[i], v.y[i]};
}

#else

using Wide [[gnu::vector_size(2 * FORCE_BYTES / 2)]] = double;  // of half as many joints as lanes
using Half [[gnu::vector_size(FORCE_BYTES / 2)]] = float;       // the same, narrowed

#if FORCE_BYTES == 32
inline Half narrowedTwo(Pair p, Pair q) {
    return __builtin_convertvector(__builtin_shufflevector(p, q, 0, 1, 2, 3), Half);
}
/// In an order in which the halves of a register stay where they are.
inline Both between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    const auto d = [&](int i) { return pairAt(xy, b[i]) - pairAt(xy, a[i]); };
    const Lanes even = __builtin_shufflevector(narrowedTwo(d(0), d(1)), narrowedTwo(d(4), d(5)), 0,
                                               1, 2, 3, 4, 5, 6, 7);
    const Lanes odd = __builtin_shufflevector(narrowedTwo(d(2), d(3)), narrowedTwo(d(6), d(7)), 0,
                                              1, 2, 3, 4, 5, 6, 7);
    return {__builtin_shufflevector(even, odd, 0, 2, 8, 10, 4, 6, 12, 14),
            __builtin_shufflevector(even, odd, 1, 3, 9, 11, 5, 7, 13, 15)};
}
inline void unpack(const Both& v, Pair* pairs) {
    const Lanes even = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes odd = __builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto widen = [&](Half half, int at) {
        const Wide wide = __builtin_convertvector(half, Wide);
        pairs[at] = __builtin_shufflevector(wide, wide, 0, 1);
        pairs[at + 1] = __builtin_shufflevector(wide, wide, 2, 3);
    };
    widen(__builtin_shufflevector(even, even, 0, 1, 2, 3), 0);
    widen(__builtin_shufflevector(odd, odd, 0, 1, 2, 3), 2);
    widen(__builtin_shufflevector(even, even, 4, 5, 6, 7), 4);
    widen(__builtin_shufflevector(odd, odd, 4, 5, 6, 7), 6);
}
#else
inline Both between(const double* xy, const std::uint32_t* a, const std::uint32_t* b) {
    Both d;
    for (int i = 0; i < width; ++i) {
        const Half p = __builtin_convertvector(pairAt(xy, b[i]) - pairAt(xy, a[i]), Half);
        d.x[i] = p[0];
        d.y[i] = p[1];
    }
    return d;
}
inline void unpack(const Both& v, Pair* pairs) {
    const Lanes first = __builtin_shufflevector(v.x, v.y, 0, 4, 1, 5);
    const Lanes second = __builtin_shufflevector(v.x, v.y, 2, 6, 3, 7);
    const auto widen = [&](Half half) { return __builtin_convertvector(half, Pair); };
    pairs[0] = widen(__builtin_shufflevector(first, first, 0, 1));
    pairs[1] = widen(__builtin_shufflevector(first, first, 2, 3));
    pairs[2] = widen(__builtin_shufflevector(second, second, 0, 1));
    pairs[3] = widen(__builtin_shufflevector(second, second, 2, 3));
}
#endif

#endif

/// The same as addElasticForce() in forces.cpp.
template <bool withDampers>
void addForces(const ForceView& joints, std::size_t first, std::size_t count) {
    const Lanes zero = {};
    for (std::size_t done = 0; done < count; done += width) {
        const std::size_t k = first + done;
        const std::uint32_t *a = joints.a + k, *b = joints.b + k;
        const Both apart = between(joints.position, a, b);
        const Lanes length = root(apart.x * apart.x + apart.y * apart.y);
        const auto pulls = length > zero;
        const Both along = {pulls ? apart.x / length : zero, pulls ? apart.y / length : zero};
        Lanes pull = load(joints.stiffness + k) * (length - load(joints.rest + k));
        if constexpr (withDampers) {
            const Both relative = between(joints.velocity, a, b);
            const Lanes lengthening = along.x * relative.x + along.y * relative.y;
            const Lanes damping = load(joints.damping + k);
            pull = damping > zero ? pull + damping * lengthening : pull;
        }
        pull = pulls ? pull : zero;
        Pair pairs[width];
        unpack({pull * along.x + zero, pull * along.y + zero}, pairs);
        const std::size_t here = count - done < width ? count - done : width;
        for (std::size_t i = 0; i < here; ++i) {
            joints.pull[joints.joint[k + i]] = pull[i];
            addAt(joints.force, a[i], pairs[i]);
            addAt(joints.force, b[i], -pairs[i]);
        }
    }
}

}  // namespace

}  // namespace sulfur::detail
