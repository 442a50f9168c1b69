// The kernels of outings.hpp, for the vectors of LANE_BYTES that the including file has set.
#include "kernels/lanes.ipp"

namespace sulfur::detail {

namespace {

#if LANE_BYTES == 32 && !defined(SULFUR_REAL_DOUBLE)
/// What leads from the one to the other of as many neighbours as there are lanes.
inline Places ways(const double* from, const double* to) {
    const auto two = [&](int i) {
        return _mm256_cvtpd_ps(_mm256_loadu_pd(to + 2 * i) - _mm256_loadu_pd(from + 2 * i));
    };
    return sorted(joined(two(0), two(4)), joined(two(2), two(6)));
}
/// Of as many neighbours as there are lanes.
inline Places pairs(const float* xy) {
    const auto two = [&](int i) { return Four(_mm_loadu_ps(xy + 2 * i)); };
    return sorted(joined(two(0), two(4)), joined(two(2), two(6)));
}
#else
inline Places ways(const double* from, const double* to) {
    Places d;
    for (int i = 0; i < width; ++i) {
        d.x[i] = static_cast<SweepReal>(to[2 * i] - from[2 * i]);
        d.y[i] = static_cast<SweepReal>(to[2 * i + 1] - from[2 * i + 1]);
    }
    return d;
}
inline Places pairs(const SweepReal* xy) {
    Places d;
    for (int i = 0; i < width; ++i) {
        d.x[i] = xy[2 * i];
        d.y[i] = xy[2 * i + 1];
    }
    return d;
}
#endif

inline Lanes all(SweepReal value) {
    return Lanes{} + value;
}
inline Lanes lengths(const Places& d) {
    return root(d.x * d.x + d.y * d.y);
}

/// Fewer neighbours than there are lanes, and others that stay where they were drawn.
struct Few {
    Few(const OutingView& view, std::size_t first, std::size_t last) {
        for (std::size_t k = 0; k < 2 * (last - first); ++k) {
            position[k] = view.position[2 * first + k];
            reference[k] = view.reference[2 * first + k];
            displacement[k] = view.displacement[2 * first + k];
        }
    }
    OutingView view() const { return {position, reference, displacement}; }

    double position[2 * width] = {}, reference[2 * width] = {};
    SweepReal displacement[2 * width] = {};
};

inline Lanes outings(const OutingView& view, std::size_t i) {
    return lengths(ways(view.reference + 2 * i, view.position + 2 * i)) +
           lengths(pairs(view.displacement + 2 * i));
}

void measureMany(const OutingView& view, SweepReal* to, std::size_t first, std::size_t last) {
    for (; first + width <= last; first += width) store(to + first, outings(view, first));
    if (first == last) return;
    const Few few(view, first, last);
    const Lanes far = outings(few.view(), 0);
    for (int k = 0; first < last; ++first, ++k) to[first] = far[k];
}

inline bool anyFar(const OutingView& view, const SweepReal* drawnFor, const SweepReal* reach,
                   const SkinBound& bound, std::size_t i) {
    const Places way = ways(view.reference + 2 * i, view.position + 2 * i);
    const Places step = pairs(view.displacement + 2 * i);
    const Lanes ahead = all(bound.lookAhead), share = all(bound.share);
    const Lanes x = way.x + ahead * step.x, y = way.y + ahead * step.y;
    const Lanes longest = load(drawnFor), more = all(moreSteps) * longest, cell = all(bound.cell);
    const Lanes leeway =
        all(leastLeeway * bound.base) + all(leewaySteps) * longest + (more < cell ? more : cell);
    const Lanes stride = all(leastStride * bound.base) + all(strideSteps) * longest;
    const Lanes here = way.x * way.x + way.y * way.y, there = x * x + y * y;
    const Lanes steps = ahead * ahead * (step.x * step.x + step.y * step.y);
    const Lanes allowed = share * share * (leeway * leeway);
    const Mask far = (here > allowed) | (there > allowed) | (steps > stride * stride);
    return bits(far & (load(reach) > Lanes{})) != 0;
}

std::size_t findNearMany(const CandidateView& c, const SweepReal* outings, std::uint32_t* near,
                         std::size_t first, std::size_t last) {
    // In no order that a processor could foresee, so that there is no branch.
    std::size_t count = 0;
    for (; first + width <= last; first += width) {
        const Lanes a = gatherOne(outings, c.a + first), b = gatherOne(outings, c.b + first);
        const Lanes off = gatherOne(outings, c.particle + first) + (a < b ? b : a);
        const std::uint32_t are = bits(off >= load(c.spare + first));
        for (std::uint32_t k = 0; k < width; ++k) {
            near[count] = static_cast<std::uint32_t>(first) + k;
            count += are >> k & 1u;
        }
    }
    for (; first < last; ++first) {
        const SweepReal a = outings[c.a[first]], b = outings[c.b[first]];
        near[count] = static_cast<std::uint32_t>(first);
        count += outings[c.particle[first]] + (a < b ? b : a) >= c.spare[first] ? 1 : 0;
    }
    return count;
}

bool anyBeyondMany(const OutingView& view, const SkinBound& bound, std::size_t first,
                   std::size_t last) {
    for (; first + width <= last; first += width)
        if (anyFar(view, bound.step + first, bound.reach + first, bound, first)) return true;
    if (first == last) return false;
    const Few few(view, first, last);
    SweepReal step[width] = {}, reach[width] = {};
    for (std::size_t k = 0; first + k < last; ++k) {
        step[k] = bound.step[first + k];
        reach[k] = bound.reach[first + k];
    }
    return anyFar(few.view(), step, reach, bound, 0);
}

}  // namespace

}  // namespace sulfur::detail
