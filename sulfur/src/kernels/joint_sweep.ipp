// The kernels of joint_sweep.hpp, for the vectors of SWEEP_BYTES that the including file has set.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr int width = SWEEP_BYTES / sizeof(SweepReal);
using Lanes [[gnu::vector_size(SWEEP_BYTES)]] = SweepReal;
/// The vectors as they lie in memory, at any address.
using Stored [[gnu::vector_size(SWEEP_BYTES), gnu::aligned(alignof(SweepReal)), gnu::may_alias]] =
    SweepReal;

inline Lanes load(const SweepReal* from) {
    return *reinterpret_cast<const Stored*>(from);
}
inline void store(SweepReal* to, Lanes value) {
    *reinterpret_cast<Stored*>(to) = value;
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

struct Places {
    Lanes x, y;
};

#ifdef SULFUR_REAL_DOUBLE

inline Places gather(const SweepReal* xy, const std::uint32_t* at) {
#if SWEEP_BYTES == 32
    return {Lanes{xy[2 * at[0]], xy[2 * at[1]], xy[2 * at[2]], xy[2 * at[3]]},
            Lanes{xy[2 * at[0] + 1], xy[2 * at[1] + 1], xy[2 * at[2] + 1], xy[2 * at[3] + 1]}};
#else
    return {Lanes{xy[2 * at[0]], xy[2 * at[1]]}, Lanes{xy[2 * at[0] + 1], xy[2 * at[1] + 1]}};
#endif
}
inline void scatter(SweepReal* xy, const std::uint32_t* at, const Places& p) {
    for (int i = 0; i < width; ++i) {
        xy[2 * at[i]] = p.x[i];
        xy[2 * at[i] + 1] = p.y[i];
    }
}

#else

/// x and y of one particle, moved as one number.
using Both [[gnu::vector_size(SWEEP_BYTES)]] = double;
inline double both(const SweepReal* xy, std::uint32_t at) {
    double value;
    __builtin_memcpy(&value, xy + 2 * std::size_t{at}, sizeof value);
    return value;
}
inline void setBoth(SweepReal* xy, std::uint32_t at, double value) {
    __builtin_memcpy(xy + 2 * std::size_t{at}, &value, sizeof value);
}

inline Places gather(const SweepReal* xy, const std::uint32_t* at) {
#if SWEEP_BYTES == 32
    // In an order in which the halves of a register stay where they are.
    const Both even = {both(xy, at[0]), both(xy, at[1]), both(xy, at[4]), both(xy, at[5])};
    const Both odd = {both(xy, at[2]), both(xy, at[3]), both(xy, at[6]), both(xy, at[7])};
    const Lanes p = reinterpret_cast<Lanes>(even), q = reinterpret_cast<Lanes>(odd);
    return {__builtin_shufflevector(p, q, 0, 2, 8, 10, 4, 6, 12, 14),
            __builtin_shufflevector(p, q, 1, 3, 9, 11, 5, 7, 13, 15)};
#else
    const Both first = {both(xy, at[0]), both(xy, at[1])};
    const Both second = {both(xy, at[2]), both(xy, at[3])};
    const Lanes p = reinterpret_cast<Lanes>(first), q = reinterpret_cast<Lanes>(second);
    return {__builtin_shufflevector(p, q, 0, 2, 4, 6), __builtin_shufflevector(p, q, 1, 3, 5, 7)};
#endif
}
inline void scatter(SweepReal* xy, const std::uint32_t* at, const Places& v) {
#if SWEEP_BYTES == 32
    const Both p =
        reinterpret_cast<Both>(__builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13));
    const Both q =
        reinterpret_cast<Both>(__builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15));
    setBoth(xy, at[0], p[0]);
    setBoth(xy, at[1], p[1]);
    setBoth(xy, at[2], q[0]);
    setBoth(xy, at[3], q[1]);
    setBoth(xy, at[4], p[2]);
    setBoth(xy, at[5], p[3]);
    setBoth(xy, at[6], q[2]);
    setBoth(xy, at[7], q[3]);
#else
    const Both p = reinterpret_cast<Both>(__builtin_shufflevector(v.x, v.y, 0, 4, 1, 5));
    const Both q = reinterpret_cast<Both>(__builtin_shufflevector(v.x, v.y, 2, 6, 3, 7));
    setBoth(xy, at[0], p[0]);
    setBoth(xy, at[1], p[1]);
    setBoth(xy, at[2], q[0]);
    setBoth(xy, at[3], q[1]);
#endif
}

#endif

/// Of the first `count` lanes only.
inline void scatterSome(SweepReal* xy, const std::uint32_t* at, const Places& p,
                        std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        xy[2 * std::size_t{at[i]}] = p.x[i];
        xy[2 * std::size_t{at[i]} + 1] = p.y[i];
    }
}

/// The ends of the joints from `k` on, and what has to be done to them.
struct Ends {
    Ends(const SweepView& view, std::size_t at)
        : joints(view),
          k(at),
          a(gather(view.displacement, view.a + at)),
          b(gather(view.displacement, view.b + at)),
          movedX(b.x - a.x),
          movedY(b.y - a.y),
          x(load(view.startX + at) + movedX),
          y(load(view.startY + at) + movedY) {}

    void push(Lanes pushX, Lanes pushY, std::size_t count) {
        const Lanes massA = load(joints.massA + k), massB = load(joints.massB + k);
        a = {a.x - massA * pushX, a.y - massA * pushY};
        b = {b.x + massB * pushX, b.y + massB * pushY};
        if (count >= width) {
            scatter(joints.displacement, joints.a + k, a);
            scatter(joints.displacement, joints.b + k, b);
        } else {
            scatterSome(joints.displacement, joints.a + k, a, count);
            scatterSome(joints.displacement, joints.b + k, b, count);
        }
    }

    const SweepView& joints;
    std::size_t k;
    Places a, b;
    Lanes movedX, movedY, x, y;  // m, apart at the end of the tick
};

/// The same as pullDirection() in stiff_joints.cpp, of joints that point along `now`.
Places pullDirection(const SweepView& joints, std::size_t k, const Places& now) {
    const Lanes zero = {}, half = zero + SweepReal(0.5);
    Lanes x = load(joints.directionX + k), y = load(joints.directionY + k);
    const Lanes meanX = x + now.x, meanY = y + now.y;
    const Lanes mean = root(meanX * meanX + meanY * meanY);
    const auto whips = (load(joints.whips + k) > zero) & (mean > zero);
    x = whips ? meanX / mean : x;
    y = whips ? meanY / mean : y;
    const auto turned = x * now.x + y * now.y < half;
    return {turned ? now.x : x, turned ? now.y : y};
}

/// The same as solveImplicit() in stiff_joints.cpp.
void sweepImplicit(const SweepView& joints, std::size_t first, std::size_t count) {
    const Lanes zero = {};
    for (std::size_t done = 0; done < count; done += width) {
        const std::size_t k = first + done;
        Ends ends(joints, k);
        const Lanes length = root(ends.x * ends.x + ends.y * ends.y);
        const Places direction = pullDirection(
            joints, k,
            {length > zero ? ends.x / length : zero, length > zero ? ends.y / length : zero});
        const Lanes lambda = load(joints.lambda + k);
        const Lanes moved = direction.x * ends.movedX + direction.y * ends.movedY;
        const Lanes pull = load(joints.hk + k) * (length - load(joints.rest + k)) +
                           load(joints.hb + k) * moved + lambda;
        const Lanes change = length > zero ? -pull * load(joints.gain + k) : zero;
        store(joints.lambda + k, lambda + change);
        ends.push(change * direction.x, change * direction.y, count - done);
    }
}

/// The same as solveRigid() in stiff_joints.cpp.
void sweepRigid(const SweepView& joints, std::size_t first, std::size_t count) {
    const Lanes zero = {};
    for (std::size_t done = 0; done < count; done += width) {
        const std::size_t k = first + done;
        Ends ends(joints, k);
        const Lanes square = ends.x * ends.x + ends.y * ends.y;
        const Lanes length = root(square), rest = load(joints.rest + k);
        const Places direction = pullDirection(
            joints, k,
            {length > zero ? ends.x / length : zero, length > zero ? ends.y / length : zero});
        const Lanes along = direction.x * ends.x + direction.y * ends.y;
        const Lanes wanted = (rest * rest - square) * load(joints.scale + k);
        const Lanes change = length > zero ? wanted / along : zero;
        store(joints.lambda + k, load(joints.lambda + k) + change);
        ends.push(change * direction.x, change * direction.y, count - done);
    }
}

}  // namespace

}  // namespace sulfur::detail
