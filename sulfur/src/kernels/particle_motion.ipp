// The kernels of particle_motion.hpp, for the vectors of MOTION_BYTES that the including file has
// set: one or two particles at once.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr std::size_t together = MOTION_BYTES / 16;
using Lanes [[gnu::vector_size(MOTION_BYTES)]] = double;
using StoredLanes [[gnu::vector_size(MOTION_BYTES), gnu::aligned(8), gnu::may_alias]] = double;
using Narrow [[gnu::vector_size(2 * together * sizeof(SweepReal))]] = SweepReal;
using StoredNarrow [[gnu::vector_size(2 * together * sizeof(SweepReal)),
                     gnu::aligned(alignof(SweepReal)), gnu::may_alias]] = SweepReal;

inline Lanes load(const double* from) {
    return *reinterpret_cast<const StoredLanes*>(from);
}
inline void store(double* to, Lanes value) {
    *reinterpret_cast<StoredLanes*>(to) = value;
}
inline Narrow loadNarrow(const SweepReal* from) {
    return *reinterpret_cast<const StoredNarrow*>(from);
}
inline void storeNarrow(SweepReal* to, Narrow value) {
    *reinterpret_cast<StoredNarrow*>(to) = value;
}
inline Narrow narrowed(Lanes value) {
    return __builtin_convertvector(value, Narrow);
}
inline Lanes widened(Narrow value) {
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE) && MOTION_BYTES == 32
    return _mm256_cvtps_pd(value);  // compilers that are asked to convert do it by halves
#else
    return __builtin_convertvector(value, Lanes);
#endif
}

/// A value for x and one for y, for each particle.
inline Lanes both(double x, double y) {
#if MOTION_BYTES == 32
    return Lanes{x, y, x, y};
#else
    return Lanes{x, y};
#endif
}
inline Lanes masses(const SweepReal* w) {
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE) && MOTION_BYTES == 32
    const __m128 two = _mm_castsi128_ps(_mm_loadu_si64(w));
    return _mm256_cvtps_pd(_mm_unpacklo_ps(two, two));
#elif MOTION_BYTES == 32
    const double first = static_cast<double>(w[0]), second = static_cast<double>(w[1]);
    return Lanes{first, first, second, second};
#else
    return both(static_cast<double>(w[0]), static_cast<double>(w[0]));
#endif
}
/// Whether any is not 0.
inline bool anyOf(Lanes v) {
#if defined(__AVX__) && MOTION_BYTES == 32
    return _mm256_movemask_pd(reinterpret_cast<Lanes>(v != 0)) != 0;
#elif defined(__SSE2__)
    return _mm_movemask_pd(reinterpret_cast<Lanes>(v != 0)) != 0;
#else
    bool any = false;
    for (std::size_t k = 0; k < 2 * together; ++k) any |= v[k] != 0;
    return any;
#endif
}
inline Lanes limited(Lanes v, Lanes most) {
    v = v < -most ? -most : v;
    return most < v ? most : v;
}

/// Runs `whole` on full vectors. What is left over is done in a copy that is as long as a vector.
template <class Function>
inline void forEach(const MotionView& arrays, std::size_t first, std::size_t last,
                    Function&& whole) {
    const MotionView view = arrays;  // which nothing that is written can be part of
    std::size_t i = first;
    for (; i + together <= last; i += together)
        whole(view.position + 2 * i, view.velocity + 2 * i, view.force + 2 * i,
              view.displacement + 2 * i, view.inverseMass + i);
    if (i == last) return;
    double position[4] = {}, velocity[4] = {}, force[4] = {};
    SweepReal displacement[4] = {};
    const SweepReal inverseMass[2] = {view.inverseMass[i], 0};
    const std::size_t at = 2 * i;
    for (std::size_t k = 0; k < 2; ++k) {
        position[k] = view.position[at + k];
        velocity[k] = view.velocity[at + k];
        force[k] = view.force[at + k];
        displacement[k] = view.displacement[at + k];
    }
    whole(position, velocity, force, displacement, inverseMass);
    for (std::size_t k = 0; k < 2; ++k) {
        view.position[at + k] = position[k];
        view.velocity[at + k] = velocity[k];
        view.force[at + k] = force[k];
        view.displacement[at + k] = displacement[k];
    }
}

void predictMany(const MotionView& view, const Kick& kick, std::size_t first, std::size_t last) {
    const Lanes gravity = both(kick.gravityX, kick.gravityY), zero = both(0, 0);
    const Lanes keep = both(kick.keep, kick.keep), push = both(kick.push, kick.push);
    const Lanes duration = both(kick.duration, kick.duration);
    const Lanes most = both(kick.limit, kick.limit);
    forEach(view, first, last,
            [&](double*, double* velocity, double* force, SweepReal* displacement,
                const SweepReal* inverseMass) {
                const Lanes w = masses(inverseMass), before = load(velocity);
                const Lanes acceleration = gravity + w * load(force);
                const Lanes kicked = limited(keep * before + push * acceleration, most);
                const auto moves = w != zero;
                store(velocity, moves ? kicked : before);
                storeNarrow(displacement, narrowed(moves ? duration * kicked : zero));
                store(force, zero);
            });
}

void takeUpMany(const MotionView& view, const Kick& kick, std::size_t first, std::size_t last) {
    const Lanes zero = both(0, 0), duration = both(kick.duration, kick.duration);
    const Lanes most = both(kick.limit, kick.limit);
    forEach(view, first, last,
            [&](double*, double* velocity, double*, SweepReal* displacement,
                const SweepReal* inverseMass) {
                const Lanes before = load(velocity);
                const Narrow predicted = narrowed(duration * before);
                const Narrow led = loadNarrow(displacement);
                const Lanes change = widened(led - predicted);
                // Mostly nothing was changed, and a division costs more than all else here.
                if (!anyOf(change)) return;
                const Lanes after = limited(before + change / duration, most);
                const auto moves = masses(inverseMass) != zero;
                const Lanes way = widened(led), within = limited(way, duration * most);
                store(velocity, moves ? after : before);
                storeNarrow(displacement, narrowed(moves ? within : way));
            });
}

void moveMany(const MotionView& view, double limit, std::size_t first, std::size_t last) {
    const Lanes most = both(limit, limit);
    forEach(view, first, last,
            [&](double* position, double*, double*, SweepReal* displacement, const SweepReal*) {
                const Lanes moved = load(position) + widened(loadNarrow(displacement));
                store(position, limited(moved, most));
            });
}

}  // namespace

}  // namespace sulfur::detail
