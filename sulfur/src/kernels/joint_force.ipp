// The kernels of joint_force.hpp, for the vectors of LANE_BYTES that the including file has set.
#include "kernels/lanes.ipp"

namespace sulfur::detail {

namespace {

inline void addAt(double* xy, std::uint32_t at, Pair by) {
    auto* place = reinterpret_cast<StoredPair*>(xy + at);
    *place = *place + by;
}

#ifdef SULFUR_REAL_DOUBLE

inline void unpack(const Places& v, Pair* pairs) {
    for (int i = 0; i < width; ++i) pairs[i] = Pair{v.x[i], v.y[i]};
}

#else

#if LANE_BYTES == 32
inline void unpack(const Places& v, Pair* pairs) {
    const Lanes even = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes odd = __builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto widen = [&](Four two, int at) {
        const __m256d wide = _mm256_cvtps_pd(two);
        pairs[at] = _mm256_castpd256_pd128(wide);
        pairs[at + 1] = _mm256_extractf128_pd(wide, 1);
    };
    widen(_mm256_castps256_ps128(even), 0);
    widen(_mm256_castps256_ps128(odd), 2);
    widen(_mm256_extractf128_ps(even, 1), 4);
    widen(_mm256_extractf128_ps(odd, 1), 6);
}
#else
inline void unpack(const Places& v, Pair* pairs) {
    const Lanes first = __builtin_shufflevector(v.x, v.y, 0, 4, 1, 5);
    const Lanes second = __builtin_shufflevector(v.x, v.y, 2, 6, 3, 7);
    const auto widen = [&](Two half) { return __builtin_convertvector(half, Pair); };
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
        const Places apart = between(joints.position, a, b);
        const Lanes length = root(apart.x * apart.x + apart.y * apart.y);
        const auto pulls = length > zero;
        const Places along = {pulls ? apart.x / length : zero, pulls ? apart.y / length : zero};
        Lanes pull = load(joints.stiffness + k) * (length - load(joints.rest + k));
        if constexpr (withDampers) {
            const Places relative = between(joints.velocity, a, b);
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
