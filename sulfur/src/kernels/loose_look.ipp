// The kernels of loose_look.hpp, for the vectors of LANE_BYTES that the including file has set.
#include "core/settings.hpp"
#include "kernels/lanes.ipp"

namespace sulfur::detail {

namespace {

using R = SweepReal;
constexpr R reached = R(1 + tuned::reached), reachedRound = R(1 + tuned::reachedRound);
constexpr R beyondEnds = R(tuned::beyondEnds);

inline Lanes smaller(Lanes a, Lanes b) {
    return b < a ? b : a;
}
inline Lanes larger(Lanes a, Lanes b) {
    return a < b ? b : a;
}
inline Lanes all(R value) {
    return Lanes{} + value;
}
/// Between 0 and 1.
inline Lanes share(Lanes v) {
    return v < Lanes{} ? Lanes{} : all(1) < v ? all(1) : v;
}

inline Places operator+(const Places& a, const Places& b) {
    return {a.x + b.x, a.y + b.y};
}
inline Places operator-(const Places& a, const Places& b) {
    return {a.x - b.x, a.y - b.y};
}
inline Places operator*(Lanes s, const Places& a) {
    return {s * a.x, s * a.y};
}
inline Lanes dot(const Places& a, const Places& b) {
    return a.x * b.x + a.y * b.y;
}
inline Lanes cross(const Places& a, const Places& b) {
    return a.x * b.y - a.y * b.x;
}
inline Lanes norm(const Places& a) {
    return root(dot(a, a));
}

using LaneBit = decltype(Mask{}[0] + 0);
constexpr LaneBit laneBits[] = {1, 2, 4, 8, 16, 32, 64, 128};

/// Of the lanes whose bits are set.
inline Mask maskOf(std::uint32_t set) {
    using StoredMask
        [[gnu::vector_size(LANE_BYTES), gnu::aligned(alignof(LaneBit)), gnu::may_alias]] = LaneBit;
    const Mask lanes = *reinterpret_cast<const StoredMask*>(laneBits);
    return ((Mask{} + static_cast<LaneBit>(set)) & lanes) == lanes;
}
/// The least of all lanes: of each lane and the one so far from it, for ever nearer ones.
inline R least(Lanes v) {
#if LANE_BYTES == 32 && !defined(SULFUR_REAL_DOUBLE)
    v = smaller(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = smaller(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    v = smaller(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6));
#elif LANE_BYTES == 32 || !defined(SULFUR_REAL_DOUBLE)
    v = smaller(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
    v = smaller(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
#else
    v = smaller(v, __builtin_shufflevector(v, v, 1, 0));
#endif
    return v[0];
}

/// Where corners are, and where they go.
struct Ways {
    Places at, way;
    Places end() const { return at + way; }
    Places when(Lanes moment) const { return at + moment * way; }
};
inline Ways waysFrom(const CornerLanes& c, std::size_t k) {
    return {{load(c.x + k), load(c.y + k)}, {load(c.wayX + k), load(c.wayY + k)}};
}
inline Ways waysOf(const CornerWay& c) {
    return {{all(c.x), all(c.y)}, {all(c.wayX), all(c.wayY)}};
}

/// m: what comes nearer than that in a step may count.
inline Lanes nearFrom(Lanes thickness, Lanes closing) {
    return R(0.5) * thickness + 2 * closing;
}

/// When a height falls to a limit, as a share of the step: 0 if it is there already, 1 if it does
/// not come so far.
inline Lanes momentOfHeight(Lanes start, Lanes end, Lanes limit) {
    const Lanes on = (start - limit) / (start - end);
    const Lanes moment = start - end > start - limit ? on : all(1);
    return start > reached * limit ? moment : Lanes{};
}
/// When two points come as near as a limit; or when they are nearest, or 1 if that is later.
inline Lanes momentOfPoints(const Places& start, const Places& way, Lanes limit) {
    const Lanes a = dot(way, way), b = dot(start, way), s = dot(start, start);
    const Lanes c = s - limit * limit;
    // Far beyond all that has a size the difference is no number; then it is 0.
    const Lanes under = larger(Lanes{}, b * b - a * c);
    const Lanes on = share((-b - root(under)) / a);
    const Lanes moment = b < Lanes{} ? on : all(1);
    return s > reachedRound * reachedRound * limit * limit ? moment : Lanes{};
}

/// m, by which the foot of the perpendicular is beside a side.
inline Lanes beside(const Places& along, const Places& from, Lanes length) {
    const Lanes foot = dot(from, along) / length;
    const Lanes out = larger(-foot, foot - length) - beyondEnds * length;
    return length > Lanes{} ? out : norm(from);
}

/// m, by which points are before a capsule that leads from a place to a spoke; or `most`.
inline Lanes beforeSpoke(const Places& spoke, const Places& place, const Places& p, Lanes most) {
    const Places toSpoke = spoke - place;
    const Lanes along = dot(p - place, toSpoke);
    return along > Lanes{} ? larger(most, along / norm(toSpoke)) : most;
}

void sides(const CornerWay& corner, R radius, const SideLanes& other, std::uint32_t may,
           SidesSeen& seen) {
    const Ways p = waysOf(corner);
    const Lanes away = all(lookedAway);
    Lanes gap = away, spare = away, enter = away;
    R nearest = lookedAway;
    seen.nearest = mostOfChunk;
    seen.before = 0;
    for (std::size_t k = 0; k < other.count; k += width) {
        const Ways a = waysFrom(other.a, k), b = waysFrom(other.b, k);
        const Places along = b.at - a.at, from = p.at - a.at;
        const Lanes length2 = dot(along, along), length = root(length2);
        const Lanes on = share(dot(from, along) / length2);
        const Lanes far = norm(from - on * along);
        const Lanes closing = norm(p.way - (a.way + on * (b.way - a.way)));
        const Lanes thickness = radius + load(other.radius + k);
        const Lanes right = cross(from, along) / length;
        const Lanes known = load(other.outward + k);
        const Lanes found = right < Lanes{} ? all(-1) : all(1);
        const Lanes outward = known == Lanes{} ? found : known;
        const Lanes height = outward * right, apart = far - thickness;
        store(seen.far + k, far);
        store(seen.height + k, height);
        store(seen.outward + k, outward);
        const Mask counts = maskOf(may >> k) & (length2 > Lanes{});
        const Mask beyond = apart > nearFrom(thickness, closing);
        gap = smaller(gap, counts ? apart : away);
        spare = smaller(spare, counts & beyond ? apart : away);
        const R nearestHere = least(counts ? far : away);
        if (nearestHere < nearest) {
            nearest = nearestHere;
            const std::uint32_t equal = bits(counts & (far == all(nearest)));
            seen.nearest =
                static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(__builtin_ctz(equal));
        }
        const Mask near = counts & ~beyond;
        if (bits(near) == 0) continue;
        const Places alongEnd = b.end() - a.end(), fromEnd = p.end() - a.end();
        const Lanes lengthEnd = norm(alongEnd);
        const Lanes turned = outward * cross(fromEnd, alongEnd);
        const Lanes end = lengthEnd > Lanes{} ? turned / lengthEnd : height;
        const Lanes moment = momentOfHeight(height, end, thickness);
        const Places start = a.when(moment), alongThen = b.when(moment) - start;
        const Lanes then = beside(alongThen, p.when(moment) - start, norm(alongThen));
        const Mask before = near & (then <= Lanes{});
        seen.before |= bits(before) << k;
        const Lanes after = larger(smaller(then, beside(along, from, length)), apart);
        enter = smaller(enter, near & ~before ? after : away);
    }
    seen.gap = least(gap);
    seen.spare = least(spare);
    seen.enter = least(enter);
}

void corners(const SpokedCorners& own, std::uint32_t number, const SpokedCorners& others,
             std::uint32_t may, CornersSeen& seen) {
    const auto one = [number](const CornerLanes& c) {
        return waysOf({c.x[number], c.y[number], c.wayX[number], c.wayY[number]});
    };
    const Ways q = one(own.at);
    const Lanes away = all(lookedAway);
    Lanes gap = away, spare = away;
    seen.near = seen.before = 0;
    for (std::size_t k = 0; k < others.count; k += width) {
        const Ways p = waysFrom(others.at, k);
        const Places from = p.at - q.at, closing = p.way - q.way;
        const Lanes thickness = load(others.radius + k) + own.radius[number];
        const Lanes far = norm(from), apart = far - thickness;
        const Mask counts = maskOf(may >> k);
        const Mask beyond = apart > nearFrom(thickness, norm(closing));
        store(seen.far + k, far);
        gap = smaller(gap, counts ? apart : away);
        spare = smaller(spare, counts & beyond ? apart : away);
        const std::uint32_t near = bits(counts & ~beyond);
        seen.near |= near << k;
        if (near == 0) continue;
        const Lanes moment = momentOfPoints(from, closing, thickness);
        const Places pThen = p.when(moment), qThen = q.when(moment);
        Lanes then{}, nowQ{}, nowP{};
        for (std::uint32_t s = 0; s < own.mostSpokes; ++s) {
            const Ways spoke = one(own.spokes[s]);
            then = beforeSpoke(spoke.when(moment), qThen, pThen, then);
            nowQ = beforeSpoke(spoke.at, q.at, p.at, nowQ);
        }
        for (std::uint32_t s = 0; s < others.mostSpokes; ++s) {
            const Ways spoke = waysFrom(others.spokes[s], k);
            then = beforeSpoke(spoke.when(moment), pThen, qThen, then);
            nowP = beforeSpoke(spoke.at, p.at, q.at, nowP);
        }
        seen.before |= (near & (bits(then > Lanes{}) ^ everyLane)) << k;
        store(seen.enter + k, larger(smaller(smaller(then, nowQ), nowP), apart));
    }
    seen.gap = least(gap);
    seen.spare = least(spare);
}

}  // namespace

}  // namespace sulfur::detail
