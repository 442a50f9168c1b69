// The kernels of joint_sweep.hpp, for the vectors of LANE_BYTES that the including file has set.
#include "kernels/lanes.ipp"

namespace sulfur::detail {

namespace {

#ifdef SULFUR_REAL_DOUBLE

inline void scatter(SweepReal* xy, const std::uint32_t* at, const Places& p) {
    for (int i = 0; i < width; ++i) {
        xy[at[i]] = p.x[i];
        xy[at[i] + 1] = p.y[i];
    }
}

#else

/// x and y of one particle, moved as one number.
using Both [[gnu::vector_size(LANE_BYTES)]] = double;
inline void setBoth(SweepReal* xy, std::uint32_t at, double value) {
    __builtin_memcpy(xy + at, &value, sizeof value);
}

inline void scatter(SweepReal* xy, const std::uint32_t* at, const Places& v) {
#if LANE_BYTES == 32
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
        xy[at[i]] = p.x[i];
        xy[at[i] + 1] = p.y[i];
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

/// How the joints from `k` on stand when the tick begins. Returns their lengths.
Lanes startEnds(const StartView& joints, std::size_t k) {
    const Lanes zero = {};
    const Places start = between(joints.position, joints.a + k, joints.b + k);
    const Lanes length = root(start.x * start.x + start.y * start.y);
    store(joints.startX + k, start.x);
    store(joints.startY + k, start.y);
    store(joints.directionX + k, length > zero ? start.x / length : zero);
    store(joints.directionY + k, length > zero ? start.y / length : zero);
    store(joints.lambda + k, zero);
    // The same as whip() in stiff_joints.cpp.
    const Lanes pulled = gatherOne(joints.pulled, joints.joint + k),
                atRest = load(joints.length + k);
    const Lanes w = load(joints.massA + k) + load(joints.massB + k);
    const Lanes size = pulled < zero ? -pulled : pulled;
    const Lanes bend =
        SweepReal(2) * w * size * joints.h * joints.h / (atRest > zero ? atRest : length);
    store(joints.whips + k, bend > joints.mostWhip ? zero + SweepReal(1) : zero);
    return length;
}

void startImplicit(const StartView& joints, std::size_t first, std::size_t count) {
    const Lanes zero = {};
    for (std::size_t k = first; k < first + count; k += width) {
        const Lanes length = startEnds(joints, k);
        const Lanes w = load(joints.massA + k) + load(joints.massB + k);
        const Lanes one = zero + SweepReal(1);
        const Lanes gain = one / ((load(joints.hk + k) + load(joints.hb + k)) * w + one);
        store(joints.gain + k, length > zero ? gain : zero);
    }
}

/// The same as restOf() in stiff_joints.cpp.
SweepReal restOf(SweepReal length, SweepReal atRest, double closing) {
    const double torn = static_cast<double>(length - atRest);
    const double left = torn > closing ? torn - closing : torn < -closing ? torn + closing : 0;
    return atRest + static_cast<SweepReal>(left);
}

void startRigid(const StartView& joints, std::size_t first, std::size_t count) {
    const Lanes zero = {};
    const auto near = static_cast<SweepReal>(joints.closing * 0.99);
    for (std::size_t k = first; k < first + count; k += width) {
        const Lanes length = startEnds(joints, k), atRest = load(joints.length + k);
        const Lanes w = load(joints.massA + k) + load(joints.massB + k);
        store(joints.gain + k,
              ((length > zero) & (w > zero)) ? SweepReal(1) / w : zero);
        store(joints.rest + k, atRest);
        const Lanes torn = length - atRest;
        if (bits((torn <= near) & (torn >= -near)) == everyLane) continue;
        for (std::size_t i = 0; i < width; ++i)
            joints.rest[k + i] = restOf(length[i], atRest[i], joints.closing);
    }
}

/// The same as pullDirection() in stiff_joints.cpp, of joints of this length at the end of the
/// tick.
[[gnu::noinline]] Places pullDirectionWhere(const SweepView& joints, std::size_t k, Lanes endX,
                                            Lanes endY, Lanes length) {
    const Lanes zero = {}, half = zero + SweepReal(0.5);
    Lanes x = load(joints.directionX + k), y = load(joints.directionY + k);
    const Places now = {length > zero ? endX / length : zero, length > zero ? endY / length : zero};
    const Lanes meanX = x + now.x, meanY = y + now.y;
    const Lanes mean = root(meanX * meanX + meanY * meanY);
    const auto whips = (load(joints.whips + k) > zero) & (mean > zero);
    x = whips ? meanX / mean : x;
    y = whips ? meanY / mean : y;
    const auto turned = x * now.x + y * now.y < half;
    return {turned ? now.x : x, turned ? now.y : y};
}

/// The same where mostly none whips or has turned far, which takes no division to see: it points
/// ahead by more than half of the length, and by more than all roundings.
[[gnu::always_inline]] inline Places pullDirection(const SweepView& joints, const Ends& ends,
                                                   Lanes length) {
    const Lanes zero = {};
    const Lanes x = load(joints.directionX + ends.k), y = load(joints.directionY + ends.k);
    const Lanes ahead = x * ends.x + y * ends.y;
    const auto stays = (ahead > length * SweepReal(0.6) + SweepReal(1e-15)) &
                       (load(joints.whips + ends.k) == zero);
    if (bits(stays) == everyLane) return {x, y};
    return pullDirectionWhere(joints, ends.k, ends.x, ends.y, length);
}

/// The same as solveImplicit() in stiff_joints.cpp.
void sweepImplicit(const SweepView& joints, std::size_t first, std::size_t count) {
    const Lanes zero = {};
    for (std::size_t done = 0; done < count; done += width) {
        const std::size_t k = first + done;
        Ends ends(joints, k);
        const Lanes length = root(ends.x * ends.x + ends.y * ends.y);
        const Places direction = pullDirection(joints, ends, length);
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
        const Lanes length = root(ends.x * ends.x + ends.y * ends.y), rest = load(joints.rest + k);
        const Places direction = pullDirection(joints, ends, length);
        const Lanes along = direction.x * ends.x + direction.y * ends.y;
        const Lanes wanted = (rest - length) * length * load(joints.gain + k);
        const Lanes change = length > zero ? wanted / along : zero;
        store(joints.lambda + k, load(joints.lambda + k) + change);
        ends.push(change * direction.x, change * direction.y, count - done);
    }
}

}  // namespace

}  // namespace sulfur::detail
