// The kernels of rows.hpp. A vector has eight lanes whatever the processor: the compiler splits it
// where its registers are narrower.
#if defined(__AVX__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

using Vec [[gnu::vector_size(8 * sizeof(SweepReal))]] = SweepReal;
using Mask = decltype(Vec{} < Vec{});

inline Vec load(const SweepReal* from) {
    return *reinterpret_cast<const Vec*>(from);
}
inline void store(SweepReal* to, Vec value) {
    *reinterpret_cast<Vec*>(to) = value;
}
// The compiler sees one instruction in these not everywhere.
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE)
inline Vec larger(Vec a, Vec b) {
    return _mm256_max_ps(a, b);
}
inline Vec smaller(Vec a, Vec b) {
    return _mm256_min_ps(a, b);
}
inline Vec magnitude(Vec v) {
    return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), v);
}
#else
inline Vec larger(Vec a, Vec b) {
    return a > b ? a : b;
}
inline Vec smaller(Vec a, Vec b) {
    return a < b ? a : b;
}
inline Vec magnitude(Vec v) {
    return v <= 0 ? Vec{} - v : v;
}
#endif
inline Vec clamped(Vec v, Vec low, Vec high) {
    return smaller(larger(v, low), high);
}
#if defined(__AVX__) && !defined(SULFUR_REAL_DOUBLE)
inline Vec root(Vec v) {
    return _mm256_sqrt_ps(v);
}
inline std::uint32_t bits(Mask m) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<Vec>(m)));
}
#elif defined(__AVX512F__) && defined(SULFUR_REAL_DOUBLE)
inline Vec root(Vec v) {
    return _mm512_maskz_sqrt_pd(0xff, v);
}
inline std::uint32_t bits(Mask m) {
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m));
}
#else
inline Vec root(Vec v) {
    for (int i = 0; i < 8; ++i)
        v[i] = static_cast<SweepReal>(__builtin_sqrt(static_cast<double>(v[i])));
    return v;
}
inline std::uint32_t bits(Mask m) {
    std::uint32_t set = 0;
    for (int i = 0; i < 8; ++i) set |= (m[i] != 0 ? 1u : 0u) << i;
    return set;
}
#endif

inline void interleave4(Vec& a, Vec& b, Vec& c, Vec& d) {
    const Vec p = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vec q = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Vec r = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vec s = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    a = __builtin_shufflevector(p, r, 0, 1, 8, 9, 4, 5, 12, 13);
    b = __builtin_shufflevector(p, r, 2, 3, 10, 11, 6, 7, 14, 15);
    c = __builtin_shufflevector(q, s, 0, 1, 8, 9, 4, 5, 12, 13);
    d = __builtin_shufflevector(q, s, 2, 3, 10, 11, 6, 7, 14, 15);
}

constexpr std::uint32_t allLanes = 255;

using Quad [[gnu::vector_size(4 * sizeof(SweepReal))]] = SweepReal;
inline Vec joined(Quad low, Quad high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

inline Vec joined(const SweepReal* low, const SweepReal* high) {
    return joined(*reinterpret_cast<const Quad*>(low), *reinterpret_cast<const Quad*>(high));
}
inline void split(SweepReal* low, SweepReal* high, Vec v) {
    *reinterpret_cast<Quad*>(low) = __builtin_shufflevector(v, v, 0, 1, 2, 3);
    *reinterpret_cast<Quad*>(high) = __builtin_shufflevector(v, v, 4, 5, 6, 7);
}

/// Four numbers of each of eight bodies, lane by lane. `from`: the first of them, by lane.
template <class From>
[[gnu::always_inline]] inline void gatherFour(From from, Vec& p, Vec& q, Vec& r, Vec& s) {
    p = joined(from(0), from(4));
    q = joined(from(1), from(5));
    r = joined(from(2), from(6));
    s = joined(from(3), from(7));
    interleave4(p, q, r, s);
}
/// Four numbers of each of the bodies whose bits are set: seldom not all.
[[gnu::noinline]] inline void scatterSome(SweepReal* const* to, std::uint32_t lanes,
                                          const Vec* four) {
    for (int i = 0; i < 4; ++i) {
        const Vec& v = four[i];
        if (lanes >> i & 1)
            *reinterpret_cast<Quad*>(to[i]) = __builtin_shufflevector(v, v, 0, 1, 2, 3);
        if (lanes >> (i + 4) & 1)
            *reinterpret_cast<Quad*>(to[i + 4]) = __builtin_shufflevector(v, v, 4, 5, 6, 7);
    }
}
template <class To>
[[gnu::always_inline]] inline void scatterFour(To to, std::uint32_t lanes, Vec p, Vec q, Vec r,
                                               Vec s) {
    interleave4(p, q, r, s);
    if (lanes == allLanes) {
        split(to(0), to(4), p);
        split(to(1), to(5), q);
        split(to(2), to(6), r);
        split(to(3), to(7), s);
    } else {
        SweepReal* const places[8] = {to(0), to(1), to(2), to(3), to(4), to(5), to(6), to(7)};
        const Vec four[4] = {p, q, r, s};
        scatterSome(places, lanes, four);
    }
}

/// How eight bodies move by rows, and their inverse masses.
struct Moving {
    Vec x, y, spin, mass;
};
/// Where they are, and their inverse moments of inertia.
struct Placed {
    Vec x, y, turn, inertia;
};
inline Moving gatherMoving(const SolverBody* bodies, const std::uint32_t* at) {
    Moving m;
    gatherFour([&](int i) { return &bodies[at[i]].vx; }, m.x, m.y, m.spin, m.mass);
    return m;
}
inline Placed gatherPlaced(const SolverBody* bodies, const std::uint32_t* at) {
    Placed p;
    gatherFour([&](int i) { return &bodies[at[i]].x; }, p.x, p.y, p.turn, p.inertia);
    return p;
}
/// The lanes whose bodies can be pushed. Only these are written: the others may be in several
/// lanes, also of blocks that another thread has.
inline std::uint32_t pushedLanes(Vec mass, Vec inertia) {
    return bits(mass + inertia > Vec{});
}
[[gnu::always_inline]] inline void scatter(SolverBody* bodies, const std::uint32_t* at,
                                           std::uint32_t lanes, const Moving& m) {
    scatterFour([&](int i) { return &bodies[at[i]].vx; }, lanes, m.x, m.y, m.spin, m.mass);
}
[[gnu::always_inline]] inline void scatter(SolverBody* bodies, const std::uint32_t* at,
                                           std::uint32_t lanes, const Placed& p) {
    scatterFour([&](int i) { return &bodies[at[i]].x; }, lanes, p.x, p.y, p.turn, p.inertia);
}
/// How they move without rows, and how they go with those of the step before.
inline Moving gatherFree(const Prediction* predictions, const std::uint32_t* at) {
    Moving m;
    gatherFour([&](int i) { return &predictions[at[i]].vx; }, m.x, m.y, m.spin, m.mass);
    return m;
}
inline Placed gatherGoing(const Prediction* predictions, const std::uint32_t* at) {
    Placed p;
    gatherFour([&](int i) { return &predictions[at[i]].goesX; }, p.x, p.y, p.turn, p.inertia);
    return p;
}

/// Coulomb's law: what static friction brings to rest in this step, or to a creep, it holds with
/// all that it has; anything else is braked by the kinetic one. What has stuck in one sweep of a
/// step sticks in the others, which may ask for more until they have found what other rows hold.
/// `early`: the slide, m, that is not judged; `grip`: the slip, m, that still is a creep.
inline Vec friction(Vec wanted, Vec early, Lane& grip, Vec mass, Vec pressing,
                    Vec staticCoefficient, Vec kineticCoefficient) {
    const Vec hold = staticCoefficient * pressing, brake = kineticCoefficient * pressing;
    const Vec creep = load(grip), endless = Vec{} + SweepReal(1e9);
    const auto sticks = magnitude(wanted + mass * early) <= hold + creep * mass;
    store(grip, sticks ? endless : creep);
    const Vec most = sticks ? hold : brake;
    return clamped(wanted, -most, most);
}

/// The share of a step that is over when a gap has closed by itself, where nothing pressed in the
/// step before. As much of the fall is left for the next step, and so it must be of the slide: what
/// is put down does not slide because it still does at the end of the step.
inline Vec shareBefore(Vec pressing, Vec gap, Vec closing) {
    const Vec zero{}, one = zero + 1;
    const Vec share = closing < zero ? smaller(gap / -closing, one) : one;
    return pressing > zero ? zero : share;
}

// --- two bodies -------------------------------------------------------------------------------

/// How b moves against a, with the spins of both.
struct Relative {
    Vec x, y, spinA, spinB;
};
inline Relative between(const Moving& a, const Moving& b) {
    return {b.x - a.x, b.y - a.y, a.spin, b.spin};
}
inline Relative between(const Placed& a, const Placed& b) {
    return {b.x - a.x, b.y - a.y, a.turn, b.turn};
}
inline Vec along(const Relative& r, Vec nx, Vec ny, Vec armA, Vec armB) {
    return nx * r.x + ny * r.y + armB * r.spinB - armA * r.spinA;
}
inline Vec along(const Relative& r, const ManifoldPoint& p) {
    return along(r, load(p.normalX), load(p.normalY), load(p.normalArmA), load(p.normalArmB));
}
inline Vec along(const Relative& r, const ManifoldBlock& b) {
    return along(r, load(b.tangentX), load(b.tangentY), load(b.tangentArmA), load(b.tangentArmB));
}

/// Impulses of a block, summed up: on b, and the other way on a.
struct Impulse {
    Vec x{}, y{}, twistA{}, twistB{};

    void add(Vec impulse, const Lane& nx, const Lane& ny, const Lane& armA, const Lane& armB) {
        x += load(nx) * impulse;
        y += load(ny) * impulse;
        twistA += load(armA) * impulse;
        twistB += load(armB) * impulse;
    }
    void add(Vec impulse, const ManifoldPoint& p) {
        add(impulse, p.normalX, p.normalY, p.normalArmA, p.normalArmB);
    }
    void add(Vec impulse, const ManifoldBlock& b) {
        add(impulse, b.tangentX, b.tangentY, b.tangentArmA, b.tangentArmB);
    }
};
inline void push(const Impulse& i, Vec inertiaA, Vec inertiaB, Moving& a, Moving& b) {
    a.x -= i.x * a.mass;
    a.y -= i.y * a.mass;
    a.spin -= i.twistA * inertiaA;
    b.x += i.x * b.mass;
    b.y += i.y * b.mass;
    b.spin += i.twistB * inertiaB;
}

/// What the points of a block do in this step without rows.
template <bool begins>
inline void predict(const Prediction* predictions, const Relative& x, ManifoldBlock& block) {
    const Relative v = between(gatherFree(predictions, block.a), gatherFree(predictions, block.b));
    Vec before = Vec{} + 1;
    for (ManifoldPoint& p : block.points) {
        const Vec closing = along(v, p);
        const Vec gap = larger(load(p.gap) + along(x, p), Vec{});
        store(p.closing, closing);
        store(p.room, closing + gap);
        before = smaller(before, shareBefore(load(p.pressing), gap, closing));
    }
    const Vec sliding = along(v, block) - load(block.slip);
    store(block.sliding, sliding);
    if constexpr (begins) store(block.early, sliding * before);
}

/// How both points of a block close, and what they press, while it is solved.
struct Normals {
    Vec closing1, closing2, pressing1, pressing2;
};

/// Both points rub as one. Where both press, their normals answer, so that neither closes faster.
/// Returns the impulse that comes to the others.
inline Vec solveFriction(const Relative& v, ManifoldBlock& block, Normals& n) {
    const Vec zero{};
    const auto held = (n.pressing1 > zero) & (n.pressing2 > zero);
    const Vec effective = held ? load(block.heldMass) : load(block.tangentMass);
    const Vec before = load(block.rubbing);
    const Vec speed = along(v, block) + load(block.sliding);
    const Vec after = friction(before - effective * speed, load(block.early), block.grip, effective,
                               n.pressing1 + n.pressing2, load(block.staticFriction),
                               load(block.kineticFriction));
    const Vec more = after - before, answered = held ? more : zero, alone = held ? zero : more;
    store(block.rubbing, after);
    n.pressing1 += load(block.answer1) * answered;
    n.pressing2 += load(block.answer2) * answered;
    n.closing1 += load(block.turns1) * alone;
    n.closing2 += load(block.turns2) * alone;
    return more;
}

/// Both normals at once: of the four ways in which two points press or part, the one that is
/// consistent (Catto 2006). Where the points are one, each by itself. Returns by how much either
/// point parts faster or slower.
inline Vec solveNormals(const ManifoldBlock& block, Normals& n) {
    const ManifoldPoint &p = block.points[0], &q = block.points[1];
    const Vec zero{};
    const Vec before1 = n.pressing1, before2 = n.pressing2;
    const Vec closing1 = n.closing1, closing2 = n.closing2;
    const Vec k11 = load(p.mobility), k22 = load(q.mobility), k12 = load(block.coupling);
    const Vec inverse = load(block.inverse);
    const auto apart = inverse > zero;
    const Vec both1 = before1 - inverse * (k22 * closing1 - k12 * closing2);
    const Vec both2 = before2 - inverse * (k11 * closing2 - k12 * closing1);
    // One presses and the other is let go of.
    const Vec alone1 = before1 - load(p.normalMass) * (closing1 - k12 * before2);
    const Vec alone2 = before2 - load(q.normalMass) * (closing2 - k12 * before1);
    const auto bothPress = apart & (both1 >= zero) & (both2 >= zero);
    // The gap of the one that is let go of, when the other has found its impulse.
    const Vec opens2 = closing2 + k12 * (alone1 - before1) - before2 * k22;
    const Vec opens1 = closing1 + k12 * (alone2 - before2) - before1 * k11;
    const auto onlyFirst = apart & (alone1 >= zero) & (opens2 >= zero);
    const auto onlySecond = apart & (alone2 >= zero) & (opens1 >= zero);
    // One after the other, where they are one or none of it is consistent.
    const Vec single1 = larger(before1 - load(p.normalMass) * closing1, zero);
    const Vec single2 =
        larger(before2 - load(q.normalMass) * (closing2 + k12 * (single1 - before1)), zero);
    n.pressing1 = bothPress ? both1 : onlyFirst ? alone1 : onlySecond ? zero : single1;
    n.pressing2 = bothPress ? both2 : onlyFirst ? zero : onlySecond ? alone2 : single2;
    return larger(magnitude(n.pressing1 - before1) * k11, magnitude(n.pressing2 - before2) * k22);
}

/// Whether the sweep before, or this one, has stirred any of the bodies.
inline bool isStirred(const std::uint32_t* at, const SweepSettings& settings) {
    for (std::size_t l = 0; l < rowLanes; ++l)
        if (settings.stirred[at[l]] + 1 >= settings.number) return true;
    return false;
}
/// Notes which bodies rows have stirred, by lanes.
inline void stir(const std::uint32_t* at, std::uint32_t lanes, const SweepSettings& settings) {
    std::uint8_t* const stirred = settings.stirred;  // bytes alias the settings
    const std::uint8_t number = settings.number;
    std::uint8_t nobodys = 0;
    // Without branches, because nobody can foretell which lanes do.
    for (std::size_t l = 0; l < rowLanes; ++l)
        *((lanes >> l & 1) != 0 ? &stirred[at[l]] : &nobodys) = number;
}

/// Moves the bodies of a block out of each other, by a share of what is beyond the slop.
inline void moveApart(const ManifoldBlock& block, Vec massA, Vec massB, SweepReal share, Placed& a,
                      Placed& b) {
    for (const ManifoldPoint& p : block.points) {
        const Vec gap = load(p.gap) + along(between(a, b), p);
        Impulse sum;
        sum.add(load(p.normalMass) * larger((-gap - load(block.slop)) * share, Vec{}), p);
        a.x -= sum.x * massA;
        a.y -= sum.y * massA;
        a.turn -= sum.twistA * a.inertia;
        b.x += sum.x * massB;
        b.y += sum.y * massB;
        b.turn += sum.twistB * b.inertia;
    }
}

template <bool anew, bool begins>
[[gnu::always_inline]] inline bool sweepBlock(SolverBody* bodies, const Prediction* predictions,
                                              ManifoldBlock& block, const SweepSettings& settings) {
    Placed placeA, placeB;  // of the first sweep since motion was predicted
    if constexpr (anew) {
        placeA = gatherPlaced(bodies, block.a);
        placeB = gatherPlaced(bodies, block.b);
        predict<begins>(predictions, between(placeA, placeB), block);
    }
    if constexpr (begins) store(block.grip, Vec{} + settings.creep);
    Moving a = gatherMoving(bodies, block.a), b = gatherMoving(bodies, block.b);
    const Relative v = between(a, b);
    ManifoldPoint &p = block.points[0], &q = block.points[1];
    const Vec pressing1 = load(p.pressing), pressing2 = load(q.pressing);
    Normals n{along(v, p) + load(p.room), along(v, q) + load(q.room), pressing1, pressing2};
    Impulse sum;
    sum.add(solveFriction(v, block, n), block);
    const std::uint32_t changed = bits(solveNormals(block, n) > settings.settled);
    store(p.pressing, n.pressing1);
    store(q.pressing, n.pressing2);
    sum.add(n.pressing1 - pressing1, p);
    sum.add(n.pressing2 - pressing2, q);
    const Vec inertiaA = load(block.inertiaA), inertiaB = load(block.inertiaB);
    push(sum, inertiaA, inertiaB, a, b);
    const std::uint32_t pushedA = pushedLanes(a.mass, inertiaA);
    const std::uint32_t pushedB = pushedLanes(b.mass, inertiaB);
    scatter(bodies, block.a, pushedA, a);
    scatter(bodies, block.b, pushedB, b);
    if constexpr (begins) {
        moveApart(block, a.mass, b.mass, settings.share, placeA, placeB);
        scatter(bodies, block.a, pushedA, placeA);
        scatter(bodies, block.b, pushedB, placeB);
    }
    if (changed != 0) {
        stir(block.a, changed & pushedA, settings);
        stir(block.b, changed & pushedB, settings);
    }
    return changed != 0;
}
inline bool isPassedOver(const ManifoldBlock& block, const SweepSettings& settings) {
    return !isStirred(block.a, settings) && !isStirred(block.b, settings);
}

/// A direction, or a rotation.
struct Unit {
    Vec x, y;
};
inline Unit rotated(const Unit& r, Vec x, Vec y) {
    return {r.x * x - r.y * y, r.y * x + r.x * y};
}
inline Unit rotatedBack(const Unit& r, Vec x, Vec y) {
    return {r.x * x + r.y * y, r.x * y - r.y * x};
}
inline Unit choose(Mask m, const Unit& a, const Unit& b) {
    return {m ? a.x : b.x, m ? a.y : b.y};
}
inline Vec cross(Vec ax, Vec ay, Vec bx, Vec by) {
    return ax * by - ay * bx;
}

/// A heading turned on by a small angle; a larger one counts as the largest for which the series is
/// good.
inline Unit turnedOn(const Unit& heading, Vec angle) {
    const Vec one = Vec{} + SweepReal(1), largest = Vec{} + SweepReal(0.7);
    const Vec turn = clamped(angle, -largest, largest), square = turn * turn;
    const Vec c = one - square * (SweepReal(1.0 / 2) -
                                  square * (SweepReal(1.0 / 24) - square * SweepReal(1.0 / 720)));
    const Vec s = turn * (one - square * (SweepReal(1.0 / 6) - square * SweepReal(1.0 / 120)));
    return rotated(heading, c, s);
}
constexpr SweepReal reached = SweepReal(1 + tuned::reached);
constexpr SweepReal reachedRound = SweepReal(1 + tuned::reachedRound);

/// When a height falls to a limit, as a share of the step: 0 if it is there already, 1 if it does
/// not come so far.
inline Vec momentOfHeight(Vec start, Vec end, Vec limit) {
    const Vec zero{}, one = zero + SweepReal(1), falls = start - end;
    const auto comes = falls > start - limit;
    const Vec moment = comes ? (start - limit) / larger(falls, zero + SweepReal(1e-30)) : one;
    return start > reached * limit ? moment : zero;
}
/// When two points come as near as a limit, by the first root of a quadratic; or when they are
/// nearest, or 1 if that is later.
inline Vec momentOfPoints(const Unit& start, const Unit& way, Vec limit) {
    const Vec zero{}, one = zero + SweepReal(1);
    const Vec a = way.x * way.x + way.y * way.y, b = start.x * way.x + start.y * way.y;
    const Vec c = start.x * start.x + start.y * start.y - limit * limit;
    const Vec discriminant = larger(b * b - a * c, zero);
    const Vec moment = (-b - root(discriminant)) / larger(a, zero + SweepReal(1e-30));
    const Vec coming = b < zero ? clamped(moment, zero, one) : one;
    const Vec square = start.x * start.x + start.y * start.y;
    return square > reachedRound * reachedRound * limit * limit ? coming : zero;
}
using Wide [[gnu::vector_size(4 * sizeof(double))]] = double;

/// How the references of two bodies lie to each other.
struct Apart {
    Unit way;  // m, from the one to the other
    Unit headingA, headingB;
};
/// Ways are in double until both places are subtracted.
inline Apart between(const Reference* references, const std::uint32_t* from,
                     const std::uint32_t* to) {
    const auto narrow = [](Wide v) { return __builtin_convertvector(v, Quad); };
    Vec first[4], second[4];
    for (int i = 0; i < 4; ++i) {
        Quad ways[2], others[2];
        for (int k = 0; k < 2; ++k) {
            const Wide a = *reinterpret_cast<const Wide*>(&references[from[i + 4 * k]]);
            const Wide b = *reinterpret_cast<const Wide*>(&references[to[i + 4 * k]]);
            ways[k] = __builtin_shufflevector(narrow(b - a), narrow(a), 0, 1, 6, 7);
            others[k] = narrow(b);
        }
        first[i] = joined(ways[0], ways[1]);
        second[i] = joined(others[0], others[1]);
    }
    interleave4(first[0], first[1], first[2], first[3]);
    interleave4(second[0], second[1], second[2], second[3]);
    return {{first[0], first[1]}, {first[2], first[3]}, {second[2], second[3]}};
}

/// Two bodies when a step begins and when it is predicted to end.
struct Pose {
    Unit apart, headA, headB;  // from a to b; how both are turned
};

/// A corner in the frame of the side's body, before whose middle it is.
struct Before {
    Vec height, place;
};
inline Before seenFromSide(const Pose& pose, const ManifoldFeature& f, Vec owner, Mask ofB) {
    const Unit own = choose(ofB, pose.headB, pose.headA),
               other = choose(ofB, pose.headA, pose.headB);
    const Unit corner = rotated(own, load(f.cornerX), load(f.cornerY));
    const Unit in =
        rotatedBack(other, owner * pose.apart.x + corner.x, owner * pose.apart.y + corner.y);
    const Vec ox = load(f.outX), oy = load(f.outY);
    return {ox * in.x + oy * in.y - load(f.offset), ox * in.y - oy * in.x - load(f.middle)};
}

/// m, by how much surfaces have moved against each other since the pair was looked at.
inline Vec movedSinceLook(const Pose& pose, const ManifoldShape& shape) {
    const Unit inA = rotatedBack(pose.headA, pose.apart.x, pose.apart.y);
    const Unit turned = rotatedBack(pose.headA, pose.headB.x, pose.headB.y);
    return magnitude(inA.x - load(shape.lookX)) + magnitude(inA.y - load(shape.lookY)) +
           load(shape.reach) * (magnitude(turned.x - load(shape.lookCosine)) +
                                magnitude(turned.y - load(shape.lookSine)));
}

/// What impulses along a direction have still to give: all of it, or what turning it changes.
template <bool anew>
inline Vec changeOf(const Lane& before, Vec now) {
    if constexpr (anew) return now;
    return now - load(before);
}
template <bool anew>
std::uint32_t refreshManifold(SolverBody* bodies, const PoseView& poses, ManifoldBlock& block,
                              const ManifoldShape& shape) {
    const Placed a = gatherPlaced(bodies, block.a), b = gatherPlaced(bodies, block.b);
    Moving movingA = gatherMoving(bodies, block.a), movingB = gatherMoving(bodies, block.b);
    const Placed goesA = gatherGoing(poses.predictions, block.a),
                 goesB = gatherGoing(poses.predictions, block.b);
    const Vec zero{}, one = zero + SweepReal(1);
    const Vec spinA = goesA.turn, spinB = goesB.turn;
    const Unit way{goesB.x - goesA.x, goesB.y - goesA.y};
    const Apart rest = between(poses.references, block.a, block.b);
    const Unit restA = rest.headingA, restB = rest.headingB;
    const Vec x = b.x - a.x, y = b.y - a.y;
    Pose start{rest.way, turnedOn(restA, a.turn), turnedOn(restB, b.turn)};
    start.apart.x += x;
    start.apart.y += y;
    const Pose end{{start.apart.x + way.x, start.apart.y + way.y},
                   turnedOn(restA, a.turn + spinA),
                   turnedOn(restB, b.turn + spinB)};
    const Vec moved = movedSinceLook(start, shape), ends = movedSinceLook(end, shape);
    const Vec thickness = load(shape.thickness), mass = movingA.mass + movingB.mass;
    store(block.slop, slop * thickness);
    store(block.used, moved);
    const auto bothGo = (movingA.mass > zero) & (movingB.mass > zero);
    Impulse sum;  // what turned impulses change
    // The place where both rub: the mean of the points that exist, and their normal.
    Vec midAX{}, midAY{}, midBX{}, midBY{}, sumX{}, sumY{}, count{};
    for (int k = 0; k < 2; ++k) {
        ManifoldPoint& p = block.points[k];
        const ManifoldFeature& f = shape.features[k];
        const Vec owner = load(f.owner), exists = magnitude(owner);
        const Vec signedHalf = load(f.half), half = magnitude(signedHalf);
        const auto ofB = owner > 0;
        // Geometry is that of the moment at which the two come to touch, as far as is predicted:
        // before a side, or, beyond its ends, round an end. A disc is an end on all sides.
        const Before first = seenFromSide(start, f, owner, ofB);
        const Before last = seenFromSide(end, f, owner, ofB);
        const Vec height = first.height, rise = last.height - first.height;
        const Vec place = first.place, run = last.place - first.place;
        Vec moment = momentOfHeight(height, last.height, thickness);
        const Vec there = place + moment * run, nearest = clamped(there, -half, half);
        const auto beyond =
            (there != nearest) & ((height + moment * rise > zero) | (signedHalf < zero));
        const auto round = (beyond | (half == zero)) & (exists > zero);
        const bool anyRound = bits(round) != 0;  // mostly none is
        if (anyRound) {
            const Vec curved = momentOfPoints({place - nearest, height}, {run, rise}, thickness);
            moment = round ? curved : moment;
        }
        Vec distance = height + moment * rise, up = one, aside = zero;
        if (anyRound) {
            const Vec beside = place + moment * run - nearest;
            const Vec far = root(beside * beside + distance * distance);
            const Vec safe = larger(far, zero + SweepReal(1e-30));
            const auto apart = round & (far > zero);
            up = apart ? distance / safe : one;
            aside = apart ? beside / safe : zero;
            distance = round ? far : distance;
        }
        const Unit headA = turnedOn(restA, a.turn + moment * spinA);
        const Unit headB = turnedOn(restB, b.turn + moment * spinB);
        const Unit own = choose(ofB, headB, headA), other = choose(ofB, headA, headB);
        const Vec ox = load(f.outX), oy = load(f.outY);
        // The corner from its own body's centre, and from that of the side.
        const Unit corner = rotated(own, load(f.cornerX), load(f.cornerY));
        const Vec fromX = owner * (start.apart.x + moment * way.x) + corner.x;
        const Vec fromY = owner * (start.apart.y + moment * way.y) + corner.y;
        const Unit outward = rotated(other, up * ox - aside * oy, up * oy + aside * ox);
        const Vec nx = outward.x * owner, ny = outward.y * owner;  // from a to b
        // Both sides act where the surfaces meet.
        const Vec back = distance * load(f.share) * owner;
        const Vec ownX = corner.x - nx * back, ownY = corner.y - ny * back;
        const Vec otherX = fromX - nx * back, otherY = fromY - ny * back;
        const Vec ax = ofB ? otherX : ownX, ay = ofB ? otherY : ownY;
        const Vec bx = ofB ? ownX : otherX, by = ofB ? ownY : otherY;
        // Whoever moves by this step's end moves as from its start: the side's body makes up for
        // what that is off the moment, so that no angular momentum is made. What stands fast takes
        // any.
        const Vec late = bothGo ? moment * cross(way.x, way.y, nx, ny) : zero;
        const Vec armA = exists * (cross(ax, ay, nx, ny) - (ofB ? late : zero));
        const Vec armB = exists * (cross(bx, by, nx, ny) + (ofB ? zero : late));
        const Vec mobility = mass + armA * armA * a.inertia + armB * armB * b.inertia;
        store(p.normalMass, mobility > zero ? exists / mobility : zero);
        store(p.mobility, exists * mobility);
        const Vec since = nx * (x + moment * way.x) + ny * (y + moment * way.y) +
                          armB * (b.turn + moment * spinB) - armA * (a.turn + moment * spinA);
        const Vec farAway = zero + SweepReal(1e18);
        store(p.gap, exists > zero ? distance - thickness - since : farAway);
        // Impulses stay what they are and act along the new directions.
        const Vec n = load(p.pressing);
        sum.x += changeOf<anew>(p.normalX, nx) * n;
        sum.y += changeOf<anew>(p.normalY, ny) * n;
        sum.twistA += changeOf<anew>(p.normalArmA, armA) * n;
        sum.twistB += changeOf<anew>(p.normalArmB, armB) * n;
        store(p.normalX, nx);
        store(p.normalY, ny);
        store(p.normalArmA, armA);
        store(p.normalArmB, armB);
        const Vec lateX = bothGo ? moment * way.x : zero, lateY = bothGo ? moment * way.y : zero;
        midAX += exists * (ax - (ofB ? lateX : zero));
        midAY += exists * (ay - (ofB ? lateY : zero));
        midBX += exists * (bx + (ofB ? zero : lateX));
        midBY += exists * (by + (ofB ? zero : lateY));
        sumX += nx;
        sumY += ny;
        count += exists;
    }
    const Vec share = count > zero ? one / larger(count, one) : zero;
    const Vec length = root(sumX * sumX + sumY * sumY);
    const Vec perLength = length > zero ? one / larger(length, zero + SweepReal(1e-30)) : zero;
    const Vec tx = -sumY * perLength, ty = sumX * perLength;
    const Vec armA = share * cross(midAX, midAY, tx, ty),
              armB = share * cross(midBX, midBY, tx, ty);
    const Vec mobility = mass + armA * armA * a.inertia + armB * armB * b.inertia;
    store(block.tangentMass, ((mobility > zero) & (count > zero)) ? one / mobility : zero);
    {
        const ManifoldPoint &p = block.points[0], &q = block.points[1];
        const auto mixed = [&](Vec ux, Vec uy, Vec ua, Vec ub, Vec wx, Vec wy, Vec wa, Vec wb) {
            return mass * (ux * wx + uy * wy) + a.inertia * ua * wa + b.inertia * ub * wb;
        };
        const Vec px = load(p.normalX), py = load(p.normalY), pa = load(p.normalArmA),
                  pb = load(p.normalArmB);
        const Vec qx = load(q.normalX), qy = load(q.normalY), qa = load(q.normalArmA),
                  qb = load(q.normalArmB);
        const Vec k11 = load(p.mobility), k22 = load(q.mobility);
        const Vec k12 = mixed(px, py, pa, pb, qx, qy, qa, qb);
        const Vec t1 = mixed(tx, ty, armA, armB, px, py, pa, pb);
        const Vec t2 = mixed(tx, ty, armA, armB, qx, qy, qa, qb);
        const Vec determinant = k11 * k22 - k12 * k12;
        const auto solvable = (count > one) & (determinant > SweepReal(1e-3) * k11 * k22);
        const Vec inverse = solvable ? one / determinant : zero;
        const Vec answer1 = (k12 * t2 - k22 * t1) * inverse;
        const Vec answer2 = (k12 * t1 - k11 * t2) * inverse;
        const Vec held = mobility + answer1 * t1 + answer2 * t2;
        store(block.coupling, k12);
        store(block.turns1, t1);
        store(block.turns2, t2);
        store(block.inverse, inverse);
        store(block.answer1, answer1);
        store(block.answer2, answer2);
        store(block.heldMass, ((held > zero) & (count > zero)) ? one / held : zero);
    }
    const Vec t = load(block.rubbing);
    sum.x += changeOf<anew>(block.tangentX, tx) * t;
    sum.y += changeOf<anew>(block.tangentY, ty) * t;
    sum.twistA += changeOf<anew>(block.tangentArmA, armA) * t;
    sum.twistB += changeOf<anew>(block.tangentArmB, armB) * t;
    store(block.tangentX, tx);
    store(block.tangentY, ty);
    store(block.tangentArmA, armA);
    store(block.tangentArmB, armB);
    store(block.inertiaA, a.inertia);
    store(block.inertiaB, b.inertia);
    push(sum, a.inertia, b.inertia, movingA, movingB);
    scatter(bodies, block.a, pushedLanes(movingA.mass, a.inertia), movingA);
    scatter(bodies, block.b, pushedLanes(movingB.mass, b.inertia), movingB);
    return bits(larger(moved, ends - unnoticed * thickness) > load(shape.margin));
}

void giveManifold(SolverBody* bodies, const ManifoldBlock& block) {
    Moving a = gatherMoving(bodies, block.a), b = gatherMoving(bodies, block.b);
    Impulse sum;
    sum.add(load(block.rubbing), block);
    for (const ManifoldPoint& p : block.points) sum.add(load(p.pressing), p);
    const Vec inertiaA = load(block.inertiaA), inertiaB = load(block.inertiaB);
    push(sum, inertiaA, inertiaB, a, b);
    scatter(bodies, block.a, pushedLanes(a.mass, inertiaA), a);
    scatter(bodies, block.b, pushedLanes(b.mass, inertiaB), b);
}

std::uint32_t meetingManifold(const SolverBody* bodies, const Prediction* predictions,
                              const ManifoldBlock& block, SweepReal slow) {
    const Relative v = between(gatherFree(predictions, block.a), gatherFree(predictions, block.b));
    const Relative x = between(gatherPlaced(bodies, block.a), gatherPlaced(bodies, block.b));
    const Vec zero{};
    Mask meets{};
    for (const ManifoldPoint& p : block.points) {
        const Vec closing = along(v, p), gap = load(p.gap) + along(x, p);
        meets |= (load(p.normalMass) > zero) & (closing < zero - slow) & (gap + closing < zero);
    }
    const auto presses =
        (load(block.points[0].pressing) > zero) | (load(block.points[1].pressing) > zero);
    return bits(meets & ~presses);
}

/// How eight bodies go in a step, and what their turns move of their surfaces.
struct Going {
    Vec x, y, turn, around;
};
inline Going gatherWays(const BodyWay* ways, const std::uint32_t* at) {
    Going g;
    gatherFour([&](int i) { return &ways[at[i]].x; }, g.x, g.y, g.turn, g.around);
    return g;
}

/// Points are known to be the right ones as long as their bodies do not move against each other by
/// more than the margin, and a row is exact to first order in what they turn by.
std::uint32_t passingManifold(const SolverBody* bodies, const BodyWay* ways,
                              const ManifoldBlock& block, const ManifoldShape& shape,
                              SweepReal fast) {
    const Going a = gatherWays(ways, block.a), b = gatherWays(ways, block.b);
    const Relative way{b.x - a.x, b.y - a.y, a.turn, b.turn};
    const Vec goes = magnitude(way.x) + magnitude(way.y) + a.around + b.around;
    const Mask isFast = goes > load(shape.fineness) * fast;
    if (bits(isFast) == 0) return 0;
    const Vec most = load(shape.thickness) * (fast / 2);
    const Vec turning = a.around * magnitude(a.turn) + b.around * magnitude(b.turn);
    Mask stops = (turning <= most) & (load(block.used) + goes <= load(shape.margin));
    const Relative x = between(gatherPlaced(bodies, block.a), gatherPlaced(bodies, block.b));
    for (const ManifoldPoint& p : block.points)
        stops &= load(p.gap) + along(x, p) + along(way, p) >= -most;
    return bits(isFast & ~stops);
}

std::uint32_t pressingManifold(const ManifoldBlock& block) {
    return bits((load(block.points[0].pressing) > Vec{}) |
                (load(block.points[1].pressing) > Vec{}));
}

/// Sweeps count an overlap as no gap: then nothing is left but how it closes.
std::uint32_t actingManifold(const ManifoldBlock& block) {
    Mask acts = load(block.rubbing) != Vec{};
    for (const ManifoldPoint& p : block.points)
        acts |= (load(p.pressing) > Vec{}) | (load(p.room) <= load(p.closing));
    return bits(acts);
}

// --- a corner and a side ------------------------------------------------------------------------

/// Eight bodies, lane by lane.
struct Bodies {
    Moving moving;
    Placed placed;

    Vec& vx() { return moving.x; }
    Vec& vy() { return moving.y; }
    Vec& spin() { return moving.spin; }
    Vec& x() { return placed.x; }
    Vec& y() { return placed.y; }
    Vec& turn() { return placed.turn; }
    Vec mass() const { return moving.mass; }
    Vec inertia() const { return placed.inertia; }
};

inline Bodies gather(const SolverBody* bodies, const std::uint32_t* at) {
    return {gatherMoving(bodies, at), gatherPlaced(bodies, at)};
}
inline std::uint32_t pushedLanes(const Bodies& b) {
    return pushedLanes(b.mass(), b.inertia());
}
inline void scatter(SolverBody* bodies, const std::uint32_t* at, const Bodies& b) {
    scatter(bodies, at, pushedLanes(b), b.moving);
}
inline Bodies gather(const Prediction* predictions, const std::uint32_t* at) {
    return {gatherFree(predictions, at), gatherGoing(predictions, at)};
}

/// What one direction of a touch has to do with the motions of its bodies.
struct Jacobian {
    Vec px, py, pTurn, ax, ay, aTurn, bx, by, bTurn;
};
inline Vec along(const Jacobian& j, Bodies& p, Bodies& a, Bodies& b) {
    return j.px * p.vx() + j.py * p.vy() + j.pTurn * p.spin() -
           (j.ax * a.vx() + j.ay * a.vy() + j.aTurn * a.spin()) -
           (j.bx * b.vx() + j.by * b.vy() + j.bTurn * b.spin());
}
inline Vec placeAlong(const Jacobian& j, Bodies& p, Bodies& a, Bodies& b) {
    return j.px * p.x() + j.py * p.y() + j.pTurn * p.turn() -
           (j.ax * a.x() + j.ay * a.y() + j.aTurn * a.turn()) -
           (j.bx * b.x() + j.by * b.y() + j.bTurn * b.turn());
}
inline void push(const Jacobian& j, Vec impulse, Bodies& p, Bodies& a, Bodies& b) {
    const Vec ofP = impulse * p.mass(), ofA = impulse * a.mass(), ofB = impulse * b.mass();
    p.vx() += j.px * ofP;
    p.vy() += j.py * ofP;
    p.spin() += j.pTurn * (impulse * p.inertia());
    a.vx() -= j.ax * ofA;
    a.vy() -= j.ay * ofA;
    a.spin() -= j.aTurn * (impulse * a.inertia());
    b.vx() -= j.bx * ofB;
    b.vy() -= j.by * ofB;
    b.spin() -= j.bTurn * (impulse * b.inertia());
}
inline void pushPlace(const Jacobian& j, Vec impulse, Bodies& p, Bodies& a, Bodies& b) {
    const Vec ofP = impulse * p.mass(), ofA = impulse * a.mass(), ofB = impulse * b.mass();
    p.x() += j.px * ofP;
    p.y() += j.py * ofP;
    p.turn() += j.pTurn * (impulse * p.inertia());
    a.x() -= j.ax * ofA;
    a.y() -= j.ay * ofA;
    a.turn() -= j.aTurn * (impulse * a.inertia());
    b.x() -= j.bx * ofB;
    b.y() -= j.by * ofB;
    b.turn() -= j.bTurn * (impulse * b.inertia());
}
inline Vec mobility(const Jacobian& j, const Bodies& p, const Bodies& a, const Bodies& b) {
    return (j.px * j.px + j.py * j.py) * p.mass() + j.pTurn * j.pTurn * p.inertia() +
           (j.ax * j.ax + j.ay * j.ay) * a.mass() + j.aTurn * j.aTurn * a.inertia() +
           (j.bx * j.bx + j.by * j.by) * b.mass() + j.bTurn * j.bTurn * b.inertia();
}
inline Jacobian normalOf(const TouchBlock& t) {
    const Vec nx = load(t.normalX), ny = load(t.normalY), wa = load(t.weightA),
              wb = load(t.weightB);
    const Vec lx = load(t.lean) * load(t.sideX), ly = load(t.lean) * load(t.sideY);
    return {nx,           ny,           load(t.normalArmP),
            wa * nx - lx, wa * ny - ly, load(t.normalArmA),
            wb * nx + lx, wb * ny + ly, load(t.normalArmB)};
}
inline Jacobian tangentOf(const TouchBlock& t) {
    const Vec tx = -load(t.normalY), ty = load(t.normalX), wa = load(t.weightA),
              wb = load(t.weightB);
    const Vec rx = load(t.rod) * load(t.sideX), ry = load(t.rod) * load(t.sideY);
    return {tx,           ty,           load(t.tangentArmP),
            wa * tx - rx, wa * ty - ry, load(t.tangentArmA),
            wb * tx + rx, wb * ty + ry, load(t.tangentArmB)};
}

template <bool anew, bool begins>
[[gnu::always_inline]] inline bool sweepBlock(SolverBody* bodies, const Prediction* predictions,
                                              TouchBlock& t, const SweepSettings& settings) {
    const Jacobian tangent = tangentOf(t), normal = normalOf(t);
    if constexpr (anew) {
        Bodies p = gather(predictions, t.p), a = gather(predictions, t.a),
               b = gather(predictions, t.b);
        store(t.sliding, along(tangent, p, a, b) - load(t.slip));
        store(t.closing, along(normal, p, a, b));
    }
    Bodies p = gather(bodies, t.p), a = gather(bodies, t.a), b = gather(bodies, t.b);
    const Vec zero{};
    if constexpr (anew) {
        const Vec gap = larger(load(t.gap) + placeAlong(normal, p, a, b), zero);
        store(t.room, load(t.closing) + gap);
        if constexpr (begins)
            store(t.early, load(t.sliding) * shareBefore(load(t.pressing), gap, load(t.closing)));
    }
    if constexpr (begins) store(t.grip, Vec{} + settings.creep);
    const Vec rubbed = load(t.rubbing), pressed = load(t.pressing);
    const Vec speed = along(tangent, p, a, b) + load(t.sliding);
    const Vec rubbing =
        friction(rubbed - load(t.tangentMass) * speed, load(t.early), t.grip, load(t.tangentMass),
                 pressed, load(t.staticFriction), load(t.kineticFriction));
    store(t.rubbing, rubbing);
    push(tangent, rubbing - rubbed, p, a, b);
    const Vec closing = along(normal, p, a, b) + load(t.room);
    const Vec pressing = larger(pressed - load(t.normalMass) * closing, zero);
    store(t.pressing, pressing);
    push(normal, pressing - pressed, p, a, b);
    const std::uint32_t changed =
        bits(magnitude(pressing - pressed) * load(t.mobility) > settings.settled);
    if (changed != 0) {
        stir(t.p, changed & pushedLanes(p), settings);
        stir(t.a, changed & pushedLanes(a), settings);
        stir(t.b, changed & pushedLanes(b), settings);
    }
    if constexpr (begins) {
        const Vec gap = load(t.gap) + placeAlong(normal, p, a, b);
        pushPlace(normal, load(t.normalMass) * larger((-gap - load(t.slop)) * settings.share, zero),
                  p, a, b);
        scatter(bodies, t.p, pushedLanes(p), p.placed);
        scatter(bodies, t.a, pushedLanes(a), a.placed);
        scatter(bodies, t.b, pushedLanes(b), b.placed);
    }
    scatter(bodies, t.p, p);
    scatter(bodies, t.a, a);
    scatter(bodies, t.b, b);
    return changed != 0;
}
inline bool isPassedOver(const TouchBlock& t, const SweepSettings& settings) {
    return !isStirred(t.p, settings) && !isStirred(t.a, settings) && !isStirred(t.b, settings);
}

template <bool anew, bool begins, class Block>
bool sweepEach(SolverBody* bodies, const Prediction* predictions, Block* blocks, std::size_t count,
               const SweepSettings& settings) {
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (settings.kind.onlyStirred && isPassedOver(blocks[i], settings)) continue;
        any |= sweepBlock<anew, begins>(bodies, predictions, blocks[i], settings);
    }
    return any;
}

template <class Block>
bool sweepBlocks(SolverBody* bodies, const Prediction* predictions, Block* blocks,
                 std::size_t count, const SweepSettings& settings) {
    const auto sweep = settings.kind.begins ? sweepEach<true, true, Block>
                       : settings.kind.anew ? sweepEach<true, false, Block>
                                            : sweepEach<false, false, Block>;
    return sweep(bodies, predictions, blocks, count, settings);
}

/// A corner and the ends of a side, from the reference of the corner's body.
struct Corners {
    Unit armP, armA, armB;  // from the centres of their bodies
    Unit p, a, b;
};
inline Unit sum(const Unit& a, const Unit& b) {
    return {a.x + b.x, a.y + b.y};
}
inline Unit difference(const Unit& a, const Unit& b) {
    return {a.x - b.x, a.y - b.y};
}
inline Unit scaled(Vec s, const Unit& a) {
    return {s * a.x, s * a.y};
}
inline Unit blend(const Unit& a, const Unit& b, Vec share) {
    return sum(a, scaled(share, difference(b, a)));
}

/// Where a point is on a circle.
struct OnArc {
    Vec out;      // m, outside of it
    Unit normal;  // outwards
    Vec sine;     // of the angle from the middle of the arc
};
/// `from`: m, from the middle of an arc whose outward normal is there; no large numbers that nearly
/// cancel.
inline OnArc fromArc(const Unit& from, const Unit& middle, Vec radius) {
    const Vec one = Vec{} + SweepReal(1), tiny = Vec{} + SweepReal(1e-30);
    const Vec square = from.x * from.x + from.y * from.y;
    const Vec more = 2 * radius * (from.x * middle.x + from.y * middle.y) + square;
    const Vec far = root(larger(radius * radius + more, Vec{}));
    const Vec perFar = one / larger(far, tiny);
    const Unit normal{(from.x + radius * middle.x) * perFar, (from.y + radius * middle.y) * perFar};
    return {more / (far + radius), normal, cross(middle.x, middle.y, from.x, from.y) * perFar};
}

template <bool anew>
std::uint32_t refreshTouch(SolverBody* bodies, const PoseView& poses, TouchBlock& t,
                           const TouchShape& shape) {
    Bodies p = gather(bodies, t.p), a = gather(bodies, t.a), b = gather(bodies, t.b);
    Bodies goesP = gather(poses.predictions, t.p), goesA = gather(poses.predictions, t.a),
           goesB = gather(poses.predictions, t.b);
    const Vec zero{}, one = zero + SweepReal(1), tiny = zero + SweepReal(1e-30);
    const auto same = load(shape.sameBody) > zero, free = load(shape.free) > zero;
    const Apart first = between(poses.references, t.p, t.a);
    const Apart second = between(poses.references, t.p, t.b);
    const Unit restP = first.headingA, restA = first.headingB, restB = second.headingB;
    const Unit toA = first.way, toB = second.way;
    const Unit wayP{goesP.x(), goesP.y()}, wayA{goesA.x(), goesA.y()}, wayB{goesB.x(), goesB.y()};
    const Vec spinP = goesP.turn(), spinA = goesA.turn(), spinB = goesB.turn();
    const Unit localP{load(shape.cornerX), load(shape.cornerY)};
    const Unit localA{load(shape.aX), load(shape.aY)}, localB{load(shape.bX), load(shape.bY)};
    const auto cornersAt = [&](Vec when) {
        const Unit headA = turnedOn(restA, a.turn() + when * spinA);
        const Unit headB = choose(same, headA, turnedOn(restB, b.turn() + when * spinB));
        Corners c;
        c.armP = rotated(turnedOn(restP, p.turn() + when * spinP), localP.x, localP.y);
        c.armA = rotated(headA, localA.x, localA.y);
        c.armB = rotated(headB, localB.x, localB.y);
        const Unit centreA = sum(sum(toA, Unit{a.x(), a.y()}), scaled(when, wayA));
        const Unit centreB = sum(sum(toB, Unit{b.x(), b.y()}), scaled(when, wayB));
        c.p = sum(sum(Unit{p.x(), p.y()}, scaled(when, wayP)), c.armP);
        c.a = sum(centreA, c.armA);
        c.b = sum(choose(same, centreA, centreB), c.armB);
        return c;
    };
    const Vec outward = load(shape.outward), thickness = load(shape.thickness);
    store(t.slop, slop * thickness);
    const Vec endShare = load(shape.endShare);
    const auto isEnd = outward == zero, bent = (outward != zero) & (endShare > zero);
    const bool anyBent = bits(bent) != 0;
    const auto heightOf = [&](const Corners& c) {
        const Unit way = difference(c.b, c.a), from = difference(c.p, c.a);
        const Vec length = root(way.x * way.x + way.y * way.y);
        const Vec straight = outward * cross(from.x, from.y, way.x, way.y) / larger(length, tiny);
        if (!anyBent) return straight;
        return bent ? outward * fromArc(from, scaled(one / larger(length, tiny), way), endShare).out
                    : straight;
    };
    // Geometry is that of the moment at which the two come to touch, as far as is predicted.
    const Corners start = cornersAt(zero), end = cornersAt(one);
    const Unit fromEnd = difference(start.p, blend(start.a, start.b, endShare));
    const Unit toEnd = difference(end.p, blend(end.a, end.b, endShare));
    const Vec moment = isEnd ? momentOfPoints(fromEnd, difference(toEnd, fromEnd), thickness)
                             : momentOfHeight(heightOf(start), heightOf(end), thickness);
    const Corners then = cornersAt(moment);
    const Unit armP = then.armP, armA = then.armA, armB = then.armB;
    const Unit way = difference(then.b, then.a), from = difference(then.p, then.a);
    const Vec length = root(way.x * way.x + way.y * way.y);
    const Vec perLength = length <= tiny ? zero : one / larger(length, tiny);
    const Vec ux = way.x * perLength, uy = way.y * perLength;
    Vec place = (from.x * ux + from.y * uy) * perLength;
    const Vec share = isEnd ? endShare : clamped(place, zero, one);
    const Vec dx = from.x - share * way.x, dy = from.y - share * way.y;
    const Vec ox = outward * uy, oy = -outward * ux;
    const Vec far = root(dx * dx + dy * dy), safe = larger(far, tiny);
    // Two corners in one place part upwards.
    const auto apart = far > tiny;
    Vec distance = isEnd ? far : dx * ox + dy * oy;
    Vec nx = isEnd ? (apart ? dx / safe : zero) : ox;
    Vec ny = isEnd ? (apart ? dy / safe : one) : oy;
    if (anyBent) {
        const OnArc arc = fromArc(from, Unit{ux, uy}, endShare);
        distance = bent ? outward * arc.out : distance;
        nx = bent ? outward * arc.normal.x : nx;
        ny = bent ? outward * arc.normal.y : ny;
        place = bent ? arc.sine : place;
    }
    const Vec tx = -ny, ty = nx;
    // Both sides act at one point: where the surfaces meet, or at a particle, which cannot turn.
    const Vec back = free ? zero : distance * load(shape.share), rest = distance - back;
    const Vec weightB = same ? zero : share, weightA = one - weightB;
    const Vec rod = same ? zero : rest * perLength;
    const Vec sideX = -uy, sideY = ux;
    const Vec atX = armP.x - nx * back, atY = armP.y - ny * back;
    const Vec atAX = same ? atX + (then.p.x - armP.x) - (then.a.x - armA.x) : armA.x;
    const Vec atAY = same ? atY + (then.p.y - armP.y) - (then.a.y - armA.y) : armA.y;
    const Vec atBX = same ? zero : armB.x, atBY = same ? zero : armB.y;
    // Impulses stay what they are and act along the new directions.
    const Jacobian oldNormal = normalOf(t), oldTangent = tangentOf(t);
    const Vec pressing = load(t.pressing), rubbing = load(t.rubbing);
    store(t.normalX, nx);
    store(t.normalY, ny);
    store(t.weightA, weightA);
    store(t.weightB, weightB);
    store(t.rod, rod);
    store(t.sideX, sideX);
    store(t.sideY, sideY);
    store(t.lean, zero);
    store(t.normalArmP, cross(atX, atY, nx, ny));
    store(t.tangentArmP, cross(atX, atY, tx, ty));
    store(t.normalArmA, weightA * cross(atAX, atAY, nx, ny));
    store(t.normalArmB, weightB * cross(atBX, atBY, nx, ny));
    store(t.tangentArmA, cross(atAX, atAY, weightA * tx - rod * sideX, weightA * ty - rod * sideY));
    store(t.tangentArmB, cross(atBX, atBY, weightB * tx + rod * sideX, weightB * ty + rod * sideY));
    // Whoever moves by this step's end moves as from its start: the side makes up for what that is
    // off the moment. A corner that stands fast takes any angular momentum.
    const Unit nowA = sum(toA, Unit{a.x(), a.y()}), nowB = sum(toB, Unit{b.x(), b.y()});
    const auto madeBy = [&](const Jacobian& j) {
        return cross(p.x(), p.y(), j.px, j.py) + j.pTurn - cross(nowA.x, nowA.y, j.ax, j.ay) -
               j.aTurn - cross(nowB.x, nowB.y, j.bx, j.by) - j.bTurn;
    };
    const auto cornerGoes = p.mass() > zero;
    const Vec madeN = cornerGoes ? madeBy(normalOf(t)) : zero,
              madeT = cornerGoes ? madeBy(tangentOf(t)) : zero;
    const Unit span = difference(sum(nowB, armB), sum(nowA, armA));
    const Vec lever = cross(span.x, span.y, sideX, sideY);
    const auto turnsAlone = same | (magnitude(lever) < tiny);
    const auto leanBy = [&](Vec made) {
        return turnsAlone ? zero : clamped(made / (turnsAlone ? one : lever), -one, one);
    };
    const Vec leanN = leanBy(madeN), leanT = leanBy(madeT);
    store(t.lean, leanN);
    store(t.rod, rod + leanT);
    const auto give = [&](Vec made, Vec lean, Lane& ofA, Lane& ofB) {
        store(ofA, load(ofA) + (same ? made : zero) - lean * cross(atAX, atAY, sideX, sideY));
        store(ofB, load(ofB) + lean * cross(atBX, atBY, sideX, sideY));
    };
    give(madeN, leanN, t.normalArmA, t.normalArmB);
    give(madeT, leanT, t.tangentArmA, t.tangentArmB);
    const Jacobian normal = normalOf(t), tangent = tangentOf(t);
    const Vec ahead = moment * placeAlong(normal, goesP, goesA, goesB);
    if constexpr (!anew) {
        push(oldNormal, -pressing, p, a, b);
        push(oldTangent, -rubbing, p, a, b);
    }
    push(normal, pressing, p, a, b);
    push(tangent, rubbing, p, a, b);
    const Vec normalK = mobility(normal, p, a, b), tangentK = mobility(tangent, p, a, b);
    store(t.normalMass, normalK > zero ? one / normalK : zero);
    store(t.mobility, normalK);
    store(t.tangentMass, tangentK > zero ? one / tangentK : zero);
    store(t.gap, distance - thickness - placeAlong(normal, p, a, b) - ahead);
    scatter(bodies, t.p, p);
    scatter(bodies, t.a, a);
    scatter(bodies, t.b, b);
    return bits((place < load(shape.low)) | (place > load(shape.high)));
}

void giveTouch(SolverBody* bodies, const TouchBlock& t) {
    Bodies p = gather(bodies, t.p), a = gather(bodies, t.a), b = gather(bodies, t.b);
    push(normalOf(t), load(t.pressing), p, a, b);
    push(tangentOf(t), load(t.rubbing), p, a, b);
    scatter(bodies, t.p, p);
    scatter(bodies, t.a, a);
    scatter(bodies, t.b, b);
}

std::uint32_t meetingTouch(const SolverBody* bodies, const Prediction* predictions,
                           const TouchBlock& t, SweepReal slow) {
    const Jacobian normal = normalOf(t);
    Bodies p = gather(bodies, t.p), a = gather(bodies, t.a), b = gather(bodies, t.b);
    Bodies goesP = gather(predictions, t.p), goesA = gather(predictions, t.a),
           goesB = gather(predictions, t.b);
    const Vec zero{};
    const Vec closing = along(normal, goesP, goesA, goesB);
    const Vec gap = load(t.gap) + placeAlong(normal, p, a, b);
    return bits((load(t.normalMass) > zero) & (load(t.pressing) <= zero) & (closing < zero - slow) &
                (gap + closing < zero));
}

std::uint32_t pressingTouch(const TouchBlock& block) {
    return bits(load(block.pressing) > Vec{});
}

std::uint32_t actingTouch(const TouchBlock& block) {
    return bits((load(block.rubbing) != Vec{}) | (load(block.pressing) > Vec{}) |
                (load(block.room) <= load(block.closing)));
}

/// The kernels, as compiled for the processors of the file that includes this.
constexpr RowKernels rowKernelsHere = {sweepBlocks<ManifoldBlock>,
                                       sweepBlocks<TouchBlock>,
                                       {refreshManifold<false>, refreshManifold<true>},
                                       {refreshTouch<false>, refreshTouch<true>},
                                       giveManifold,
                                       giveTouch,
                                       meetingManifold,
                                       meetingTouch,
                                       passingManifold,
                                       pressingManifold,
                                       pressingTouch,
                                       actingManifold,
                                       actingTouch};

}  // namespace

}  // namespace sulfur::detail
