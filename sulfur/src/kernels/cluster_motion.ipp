// The kernels of cluster_motion.hpp, for the vectors of CLUSTER_BYTES that the including file has
// set: two or four clusters, one or two members at once.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr std::size_t width = CLUSTER_BYTES / sizeof(double);
using Lanes [[gnu::vector_size(CLUSTER_BYTES)]] = double;
using StoredLanes [[gnu::vector_size(CLUSTER_BYTES), gnu::aligned(8), gnu::may_alias]] = double;
using Bits [[gnu::vector_size(CLUSTER_BYTES)]] = long long;

inline Lanes load(const double* from) {
    return *reinterpret_cast<const StoredLanes*>(from);
}
inline void store(double* to, Lanes value) {
    *reinterpret_cast<StoredLanes*>(to) = value;
}
inline Lanes all(double value) {
    Lanes v;
    for (std::size_t k = 0; k < width; ++k) v[k] = value;
    return v;
}
inline Lanes root(Lanes v) {
#if defined(__AVX__) && CLUSTER_BYTES == 32
    return _mm256_sqrt_pd(v);
#elif defined(__SSE2__)
    return _mm_sqrt_pd(v);
#else
    for (std::size_t k = 0; k < width; ++k) v[k] = __builtin_sqrt(v[k]);
    return v;
#endif
}

/// The nearest whole number, with the sign of `v` also where that is 0. What is so large that it
/// has no fraction stays.
inline Lanes rounded(Lanes v) {
    const Lanes shift = all(6755399441055744.0);  // 1.5 * 2^52: what is added to it loses fractions
    const Bits sign = reinterpret_cast<Bits>(all(-0.0)), bits = reinterpret_cast<Bits>(v);
    const Bits whole = reinterpret_cast<Bits>((v + shift) - shift) | (bits & sign);
    const Lanes size = reinterpret_cast<Lanes>(bits & ~sign);
    return size < all(2251799813685248.0) ? reinterpret_cast<Lanes>(whole) : v;
}

struct Units {
    Lanes x, y;
};

/// As unitVector() has them, for a reduced angle.
constexpr double sineFactors[] = {1.0 / 210, 1.0 / 156, 1.0 / 110, 1.0 / 72,
                                  1.0 / 42,  1.0 / 20,  1.0 / 6};
constexpr double cosineFactors[] = {1.0 / 240, 1.0 / 182, 1.0 / 132, 1.0 / 90,
                                    1.0 / 56,  1.0 / 30,  1.0 / 12,  1.0 / 2};

inline Lanes sineOf(Lanes r, Lanes r2) {
    Lanes sum = all(1);
    for (const double factor : sineFactors) sum = 1 - r2 * factor * sum;
    return sum * r;
}
inline Lanes cosineOf(Lanes r2) {
    Lanes sum = all(1);
    for (const double factor : cosineFactors) sum = 1 - r2 * factor * sum;
    return sum;
}

inline Units unitVectors(Lanes angle) {
    constexpr double quarters = 4 / 6.283185307179586;
    constexpr double quarterHigh = 1.5707963267341256, quarterLow = 6.077100506506192e-11;
    const Lanes turns = rounded(angle * quarters);
    const Lanes r = (angle - turns * quarterHigh) - turns * quarterLow;
    const Lanes r2 = r * r, s = sineOf(r, r2), c = cosineOf(r2);
    // Which quarter of the circle: 0 to 3.
    const Lanes fours = turns * 0.25, near = rounded(fours);
    const Lanes below = near > fours ? near - 1 : near;
    const Lanes q = turns - 4 * below;
    const auto odd = (q == 1) | (q == 3);
    const Lanes x = odd ? s : c, y = odd ? c : s;
    const auto left = (q == 1) | (q == 2);
    return {left ? -x : x, q >= 2 ? -y : y};
}

void turnMany(const double* angle, double* headingX, double* headingY, std::size_t count) {
    for (std::size_t i = 0; i < count; i += width) {
        const Lanes by = load(angle + i), x = load(headingX + i), y = load(headingY + i);
        const Units u = unitVectors(by);
        const Lanes newX = u.x * x - u.y * y, newY = u.y * x + u.x * y;
        const Lanes length = root(newX * newX + newY * newY);
        store(headingX + i, by != 0 ? newX / length : x);
        store(headingY + i, by != 0 ? newY / length : y);
    }
}

void sineMany(const double* half, SweepReal* sine, SweepReal* versine, std::size_t count) {
    for (std::size_t i = 0; i < count; i += width) {
        const Units u = unitVectors(load(half + i));
        // 1 - cos = 2 sin^2 of half the angle, which loses nothing when the angle is small.
        const Lanes s = 2 * u.x * u.y, v = 2 * u.y * u.y;
        for (std::size_t k = 0; k < width; ++k) {
            sine[i + k] = static_cast<SweepReal>(s[k]);
            versine[i + k] = static_cast<SweepReal>(v[k]);
        }
    }
}

// Vectors at any address: their bytes are copied.
template <class Vector, class Number>
inline Vector loadFrom(const Number* from) {
    Vector v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
template <class Vector, class Number>
inline void storeTo(Number* to, Vector v) {
    __builtin_memcpy(to, &v, sizeof v);
}

/// x and y of a particle.
struct One {
    using Wide [[gnu::vector_size(2 * sizeof(double))]] = double;
    using Narrow [[gnu::vector_size(2 * sizeof(SweepReal))]] = SweepReal;

    static Wide both(double x, double y) { return Wide{x, y}; }
    static Narrow bothNarrow(SweepReal x, SweepReal y) { return Narrow{x, y}; }
    static Wide swapped(Wide v) { return __builtin_shufflevector(v, v, 1, 0); }
    static Narrow swappedNarrow(Narrow v) { return __builtin_shufflevector(v, v, 1, 0); }
    static Narrow narrowed(Wide v) { return __builtin_convertvector(v, Narrow); }
    static Wide limited(Wide v, Wide most) {
        v = v < -most ? -most : v;
        return most < v ? most : v;
    }
};

#if CLUSTER_BYTES == 32
/// x and y of two particles that are neighbours.
struct Two {
    using Wide [[gnu::vector_size(4 * sizeof(double))]] = double;
    using Narrow [[gnu::vector_size(4 * sizeof(SweepReal))]] = SweepReal;

    static Wide both(double x, double y) { return Wide{x, y, x, y}; }
    static Narrow bothNarrow(SweepReal x, SweepReal y) { return Narrow{x, y, x, y}; }
    static Wide swapped(Wide v) { return __builtin_shufflevector(v, v, 1, 0, 3, 2); }
    static Narrow swappedNarrow(Narrow v) { return __builtin_shufflevector(v, v, 1, 0, 3, 2); }
    static Narrow narrowed(Wide v) { return __builtin_convertvector(v, Narrow); }
    static Wide limited(Wide v, Wide most) {
        v = v < -most ? -most : v;
        return most < v ? most : v;
    }
};
#endif

/// For member k and, of Two, the next one.
template <class V>
inline void place(const MemberView& view, const ClusterPose& c, std::uint32_t k, double maxSpeed) {
    using Wide = typename V::Wide;
    const std::size_t i = 2 * std::size_t{view.particles[k]};
    const Wide rest = loadFrom<Wide>(view.places + 2 * std::size_t{k}), across = V::swapped(rest);
    const Wide arm =
        V::both(c.headingX, c.headingX) * rest + V::both(-c.headingY, c.headingY) * across;
    const Wide armBefore = V::both(c.headingBeforeX, c.headingBeforeX) * rest +
                           V::both(-c.headingBeforeY, c.headingBeforeY) * across;
    const Wide before = V::both(c.centreBeforeX, c.centreBeforeY) + armBefore;
    const Wide after = V::both(c.centreX, c.centreY) + arm;
    const Wide velocity =
        V::both(c.velocityX, c.velocityY) + V::both(-c.spin, c.spin) * V::swapped(arm);
    storeTo(view.position + i, after);
    storeTo(view.displacement + i, V::narrowed(after - before));
    storeTo(view.arm + i, V::narrowed(arm));
    storeTo(view.velocity + i, V::limited(velocity, V::both(maxSpeed, maxSpeed)));
}

template <class V>
inline void spread(const MemberView& view, const ClusterWay& c, std::uint32_t k) {
    using Narrow = typename V::Narrow;
    const std::size_t i = 2 * std::size_t{view.particles[k]};
    const Narrow arm = loadFrom<Narrow>(view.arm + i);
    const Narrow way = V::bothNarrow(c.x, c.y) +
                       V::bothNarrow(-c.sine, c.sine) * V::swappedNarrow(arm) -
                       V::bothNarrow(c.versine, c.versine) * arm;
    storeTo(view.displacement + i, way);
    storeTo(view.force + i, V::both(0, 0));
}

/// Calls f(V{}, k) for all members: with Two for one that its neighbour follows, where the vectors
/// are wide enough, else with One.
template <class Function>
inline void forEachMember(const std::uint32_t* particles, std::uint32_t first, std::uint32_t last,
                          Function&& f) {
    while (first != last) {
#if CLUSTER_BYTES == 32
        if (first + 1 != last && particles[first + 1] == particles[first] + 1) {
            f(Two{}, first);
            first += 2;
            continue;
        }
#else
        static_cast<void>(particles);
#endif
        f(One{}, first++);
    }
}

void placeMany(const MemberView& view, const ClusterPose* poses, std::size_t count,
               double maxSpeed) {
    for (const ClusterPose* c = poses; c != poses + count; ++c)
        forEachMember(view.particles, c->first, c->last,
                      [&](auto v, std::uint32_t k) { place<decltype(v)>(view, *c, k, maxSpeed); });
}

void spreadMany(const MemberView& view, const ClusterWay* ways, std::size_t count) {
    for (const ClusterWay* c = ways; c != ways + count; ++c)
        forEachMember(view.particles, c->first, c->last,
                      [&](auto v, std::uint32_t k) { spread<decltype(v)>(view, *c, k); });
}

}  // namespace

}  // namespace sulfur::detail
