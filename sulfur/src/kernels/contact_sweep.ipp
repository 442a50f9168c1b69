// The kernels of contact_sweep.hpp, for the vectors of SWEEP_BYTES that the including file has set.
namespace sulfur::detail {

namespace {

constexpr int width = SWEEP_BYTES / sizeof(SweepReal);
using Lanes [[gnu::vector_size(SWEEP_BYTES)]] = SweepReal;

inline Lanes load(const SweepReal* from) {
    return *reinterpret_cast<const Lanes*>(from);
}
inline void store(SweepReal* to, Lanes value) {
    *reinterpret_cast<Lanes*>(to) = value;
}

inline Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}
inline Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}

/// Rows to columns, and back.
#if SWEEP_BYTES == 32 && !defined(SULFUR_REAL_DOUBLE)
inline void interleave4(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
    const Lanes p = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes q = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Lanes r = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes s = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    a = __builtin_shufflevector(p, r, 0, 1, 8, 9, 4, 5, 12, 13);
    b = __builtin_shufflevector(p, r, 2, 3, 10, 11, 6, 7, 14, 15);
    c = __builtin_shufflevector(q, s, 0, 1, 8, 9, 4, 5, 12, 13);
    d = __builtin_shufflevector(q, s, 2, 3, 10, 11, 6, 7, 14, 15);
}
inline void exchangeHalves(Lanes& a, Lanes& b) {
    const Lanes low = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    b = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    a = low;
}
inline void transpose(Lanes (&rows)[8]) {
    interleave4(rows[0], rows[1], rows[2], rows[3]);
    interleave4(rows[4], rows[5], rows[6], rows[7]);
    for (int i = 0; i < 4; ++i) exchangeHalves(rows[i], rows[i + 4]);
}
#elif (SWEEP_BYTES == 32) || !defined(SULFUR_REAL_DOUBLE)
inline void transpose(Lanes (&rows)[4]) {
    const Lanes p = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
    const Lanes q = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
    const Lanes r = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
    const Lanes s = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
    rows[0] = __builtin_shufflevector(p, r, 0, 1, 4, 5);
    rows[1] = __builtin_shufflevector(p, r, 2, 3, 6, 7);
    rows[2] = __builtin_shufflevector(q, s, 0, 1, 4, 5);
    rows[3] = __builtin_shufflevector(q, s, 2, 3, 6, 7);
}
#else
inline void transpose(Lanes (&rows)[2]) {
    const Lanes low = __builtin_shufflevector(rows[0], rows[1], 0, 2);
    rows[1] = __builtin_shufflevector(rows[0], rows[1], 1, 3);
    rows[0] = low;
}
#endif

/// The numbers of as many movers as there are lanes, each in the order in which Mover has them.
struct Gathered {
    static constexpr int numbers = sizeof(Mover) / sizeof(SweepReal);

    Lanes& x() { return of[0]; }
    Lanes& y() { return of[1]; }
    Lanes& sine() { return of[2]; }
    Lanes& versine() { return of[3]; }
    Lanes& turn() { return of[4]; }
    Lanes mass() const { return of[5]; }
    Lanes inertia() const { return of[6]; }
    Lanes of[numbers];
};

inline Gathered gather(const Mover* movers, const std::uint32_t* at) {
    Gathered g;
    for (int part = 0; part < Gathered::numbers; part += width) {
        Lanes rows[width];
        for (int i = 0; i < width; ++i) rows[i] = load(&movers[at[i]].x + part);
        transpose(rows);
        for (int i = 0; i < width; ++i) g.of[part + i] = rows[i];
    }
    return g;
}
/// What cannot be pushed may be in several lanes: all write the same.
inline void scatter(Mover* movers, const std::uint32_t* at, const Gathered& g) {
    for (int part = 0; part < Gathered::numbers; part += width) {
        Lanes rows[width];
        for (int i = 0; i < width; ++i) rows[i] = g.of[part + i];
        transpose(rows);
        for (int i = 0; i < width; ++i) store(&movers[at[i]].x + part, rows[i]);
    }
}

/// Where a point goes that is `arm` away from what the mover turns about.
struct Way {
    Lanes x, y;
};
inline Way wayOf(Gathered& m, Lanes armX, Lanes armY) {
    return {m.x() - m.sine() * armY - m.versine() * armX,
            m.y() + m.sine() * armX - m.versine() * armY};
}

/// Adds a turn, by the series of sine and cosine. Beyond 1 rad at once what counts is that they
/// stay bounded: there the series still keep the length of what they turn, at 3 rad they added a
/// seventh each time, and hundreds of blows to infinity.
inline void turnBy(Gathered& m, Lanes by) {
    m.turn() += by;
    const Lanes most = Lanes{} + SweepReal(1);
    const Lanes angle = smaller(larger(by, -most), most);
    const Lanes square = angle * angle;
    const Lanes c1 = Lanes{} + SweepReal(1.0 / 6), c2 = Lanes{} + SweepReal(1.0 / 120),
                c3 = Lanes{} + SweepReal(1.0 / 5040);
    const Lanes d0 = Lanes{} + SweepReal(1.0 / 2), d1 = Lanes{} + SweepReal(1.0 / 24),
                d2 = Lanes{} + SweepReal(1.0 / 720), one = Lanes{} + SweepReal(1);
    const Lanes sine = angle * (one - square * (c1 - square * (c2 - square * c3)));
    const Lanes versine = square * (d0 - square * (d1 - square * d2));
    const Lanes s = m.sine(), cosine = one - m.versine();
    m.sine() = s + sine * cosine - versine * s;
    m.versine() = m.versine() + sine * s + versine * cosine;
}

inline void push(Gathered& m, Lanes armX, Lanes armY, Lanes x, Lanes y) {
    m.x() += m.mass() * x;
    m.y() += m.mass() * y;
    turnBy(m, m.inertia() * (armX * y - armY * x));
}

/// Some contacts of a block, the movers that they hold apart, and how these move.
template <bool three>
struct Held {
    Held(const Mover* movers, const ContactBlock& block, int lane) {
        particle = gather(movers, block.particle + lane);
        a = gather(movers, block.a + lane);
        const Way p = wayOf(particle, load(block.armX + lane), load(block.armY + lane));
        const Way q = wayOf(a, load(block.armAX + lane), load(block.armAY + lane));
        const Lanes share = load(block.shareA + lane);
        Lanes x = p.x - share * q.x, y = p.y - share * q.y;
        if constexpr (three) {
            b = gather(movers, block.b + lane);
            const Way r = wayOf(b, load(block.armBX + lane), load(block.armBY + lane));
            const Lanes shareB = load(block.shareB + lane);
            x = x - shareB * r.x;
            y = y - shareB * r.y;
        }
        normalX = load(block.normalX + lane);
        normalY = load(block.normalY + lane);
        gap = load(block.start + lane) + (normalX * x + normalY * y);
        slip = load(block.conveyed + lane) + (normalX * y - normalY * x);
    }

    /// Pushes by multiples of the normal and of the tangent, and puts the movers back.
    void push(Mover* movers, const ContactBlock& block, int lane, Lanes along, Lanes across) {
        const Lanes x = along * normalX - across * normalY;
        const Lanes y = along * normalY + across * normalX;
        detail::push(particle, load(block.armX + lane), load(block.armY + lane), x, y);
        const Lanes share = -load(block.shareA + lane);
        detail::push(a, load(block.armAX + lane), load(block.armAY + lane), share * x, share * y);
        scatter(movers, block.particle + lane, particle);
        scatter(movers, block.a + lane, a);
        if constexpr (three) {
            const Lanes shareB = -load(block.shareB + lane);
            detail::push(b, load(block.armBX + lane), load(block.armBY + lane), shareB * x,
                         shareB * y);
            scatter(movers, block.b + lane, b);
        }
    }

    Gathered particle, a, b;
    Lanes normalX, normalY;
    Lanes gap;   // m, what it is more than it must be at the end of the tick
    Lanes slip;  // m, along the tangent in this tick
};

/// The same as solve() in contact_solver.cpp, except that the turns are made once for both pushes.
template <bool three>
void solve(Mover* movers, ContactBlock* blocks, std::size_t count) {
    const Lanes zero = {};
    for (ContactBlock* block = blocks; block != blocks + count; ++block) {
        for (int lane = 0; lane < static_cast<int>(contactLanes); lane += width) {
            Held<three> held(movers, *block, lane);
            const Lanes normalBefore = load(block->normalLambda + lane);
            const Lanes normal =
                larger(normalBefore - held.gap * load(block->normalMass + lane), zero);
            const Lanes along = normal - normalBefore;
            const Lanes slip = held.slip + load(block->coupling + lane) * along;
            const Lanes most = load(block->friction + lane) * normal;
            const Lanes tangentBefore = load(block->tangentLambda + lane);
            const Lanes wanted = tangentBefore - slip * load(block->tangentMass + lane);
            const Lanes tangent = smaller(larger(wanted, -most), most);
            store(block->normalLambda + lane, normal);
            store(block->tangentLambda + lane, tangent);
            held.push(movers, *block, lane, along, tangent - tangentBefore);
        }
    }
}

template <bool three>
void warm(Mover* movers, ContactBlock* blocks, std::size_t count) {
    for (ContactBlock* block = blocks; block != blocks + count; ++block)
        for (int lane = 0; lane < static_cast<int>(contactLanes); lane += width) {
            Held<three> held(movers, *block, lane);
            held.push(movers, *block, lane, load(block->normalLambda + lane),
                      load(block->tangentLambda + lane));
        }
}

inline void shift(Gathered& m, Lanes armX, Lanes armY, Lanes x, Lanes y) {
    m.x() += m.mass() * x;
    m.y() += m.mass() * y;
    m.turn() += m.inertia() * (armX * y - armY * x);
}

inline Way shiftOf(Gathered& m, Lanes armX, Lanes armY) {
    return {m.x() - m.turn() * armY, m.y() + m.turn() * armX};
}

/// The same as Held, of the correction.
template <bool three>
struct Shifted {
    Shifted(const Mover* movers, const ContactBlock& block, int lane) {
        particle = gather(movers, block.particle + lane);
        a = gather(movers, block.a + lane);
        const Way p = shiftOf(particle, load(block.armX + lane), load(block.armY + lane));
        const Way q = shiftOf(a, load(block.armAX + lane), load(block.armAY + lane));
        const Lanes share = load(block.shareA + lane);
        x = p.x - share * q.x;
        y = p.y - share * q.y;
        if constexpr (three) {
            b = gather(movers, block.b + lane);
            const Way r = shiftOf(b, load(block.armBX + lane), load(block.armBY + lane));
            const Lanes shareB = load(block.shareB + lane);
            x = x - shareB * r.x;
            y = y - shareB * r.y;
        }
    }

    void shift(Mover* movers, const ContactBlock& block, int lane, Lanes byX, Lanes byY) {
        detail::shift(particle, load(block.armX + lane), load(block.armY + lane), byX, byY);
        const Lanes share = -load(block.shareA + lane);
        detail::shift(a, load(block.armAX + lane), load(block.armAY + lane), share * byX,
                      share * byY);
        scatter(movers, block.particle + lane, particle);
        scatter(movers, block.a + lane, a);
        if constexpr (three) {
            const Lanes shareB = -load(block.shareB + lane);
            detail::shift(b, load(block.armBX + lane), load(block.armBY + lane), shareB * byX,
                          shareB * byY);
            scatter(movers, block.b + lane, b);
        }
    }

    Gathered particle, a, b;
    Lanes x, y;  // m, of the particle against the capsule
};

/// The same as recoverGap() in contact_solver.cpp.
template <bool three>
void recover(Mover* movers, ContactBlock* blocks, std::size_t count) {
    const Lanes zero = {};
    for (ContactBlock* block = blocks; block != blocks + count; ++block) {
        if (block->recovers == 0) continue;
        for (int lane = 0; lane < static_cast<int>(contactLanes); lane += width) {
            Shifted<three> held(movers, *block, lane);
            const Lanes normalX = load(block->normalX + lane);
            const Lanes normalY = load(block->normalY + lane);
            const Lanes wanted = load(block->wanted + lane);
            const Lanes left = wanted - (normalX * held.x + normalY * held.y);
            const Lanes before = load(block->recoveryLambda + lane);
            const Lanes unbound = before + left * load(block->normalMass + lane);
            const Lanes after = wanted > zero ? larger(unbound, zero) : smaller(unbound, zero);
            const Lanes change = wanted != zero ? after - before : zero;
            store(block->recoveryLambda + lane, before + change);
            held.shift(movers, *block, lane, change * normalX, change * normalY);
        }
    }
}

template <bool three>
void drift(Mover* movers, ContactBlock* blocks, std::size_t count) {
    for (ContactBlock* block = blocks; block != blocks + count; ++block) {
        if (block->drifts == 0) continue;
        for (int lane = 0; lane < static_cast<int>(contactLanes); lane += width) {
            Shifted<three> held(movers, *block, lane);
            const Lanes by = load(block->driftLambda + lane);
            held.shift(movers, *block, lane, -by * load(block->normalY + lane),
                       by * load(block->normalX + lane));
        }
    }
}

template <bool three>
bool anyError(const Mover* movers, const ContactBlock* blocks, std::size_t count, SweepReal most) {
    const Lanes zero = {}, bound = zero + most;
    for (const ContactBlock* block = blocks; block != blocks + count; ++block) {
        auto wrong = zero > zero;
        for (int lane = 0; lane < static_cast<int>(contactLanes); lane += width) {
            const Held<three> held(movers, *block, lane);
            const Lanes normal = load(block->normalLambda + lane);
            const Lanes normalMass = load(block->normalMass + lane);
            const Lanes along = larger(normal - held.gap * normalMass, zero) - normal;
            const Lanes limit = load(block->friction + lane) * normal;
            const Lanes tangent = load(block->tangentLambda + lane);
            const Lanes tangentMass = load(block->tangentMass + lane);
            const Lanes across =
                smaller(larger(tangent - held.slip * tangentMass, -limit), limit) - tangent;
            wrong |= (larger(along, -along) > bound * normalMass) |
                     (larger(across, -across) > bound * tangentMass);
        }
        for (int i = 0; i < width; ++i)
            if (wrong[i] != 0) return true;
    }
    return false;
}

template <bool three>
bool anyDeep(const Mover* movers, const ContactBlock* blocks, std::size_t count) {
    for (const ContactBlock* block = blocks; block != blocks + count; ++block)
        for (int lane = 0; lane < static_cast<int>(contactLanes); lane += width) {
            const auto deep = Held<three>(movers, *block, lane).gap < load(block->deepest + lane);
            for (int i = 0; i < width; ++i)
                if (deep[i] != 0) return true;
        }
    return false;
}

}  // namespace

}  // namespace sulfur::detail
