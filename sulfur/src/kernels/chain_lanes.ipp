// The kernel of chain_lanes.hpp, for the vectors of CHAIN_BYTES that the including file has set.
//
// What each function computes is said at the one of the same name in trees/point_chain.cpp.
#if defined(__SSE2__)
#include <immintrin.h>  // its functions are always inlined
#endif

namespace sulfur::detail {

namespace {

constexpr std::size_t width = CHAIN_BYTES / sizeof(double);
using Lanes [[gnu::vector_size(CHAIN_BYTES)]] = double;
using Mask = decltype(Lanes{} < Lanes{});
using Two [[gnu::vector_size(16)]] = double;
using StoredTwo [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;

constexpr std::uint32_t everyLane = (1u << width) - 1;
constexpr double infinity = __builtin_inf();

inline Lanes all(double value) {
    return Lanes{} + value;
}
inline std::uint32_t bits(Mask m) {
#if CHAIN_BYTES == 64
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m));
#elif defined(__AVX__) && CHAIN_BYTES == 32
    return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<Lanes>(m)));
#elif defined(__SSE2__)
    return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<Lanes>(m)));
#else
    std::uint32_t set = 0;
    for (std::size_t k = 0; k < width; ++k) set |= (m[k] != 0 ? 1u : 0u) << k;
    return set;
#endif
}
inline Lanes root(Lanes v) {
#if CHAIN_BYTES == 64
    return _mm512_maskz_sqrt_pd(0xff, v);
#elif defined(__AVX__) && CHAIN_BYTES == 32
    return _mm256_sqrt_pd(v);
#elif defined(__SSE2__)
    return _mm_sqrt_pd(v);
#else
    for (std::size_t k = 0; k < width; ++k) v[k] = __builtin_sqrt(v[k]);
    return v;
#endif
}
inline Lanes size(Lanes v) {
    return reinterpret_cast<Lanes>(reinterpret_cast<Mask>(v) & 0x7fffffffffffffff);
}
/// As std::max and std::min, which keep the first where the second is no number.
inline Lanes larger(Lanes a, Lanes b) {
    return a < b ? b : a;
}
inline Lanes smaller(Lanes a, Lanes b) {
    return b < a ? b : a;
}
inline Lanes limited(Lanes most, Lanes v) {
    v = v < most ? v : most;
    return v > -most ? v : -most;
}

struct Pairs {
    Lanes x, y;
};
inline Pairs operator+(Pairs a, Pairs b) {
    return {a.x + b.x, a.y + b.y};
}
inline Pairs operator-(Pairs a, Pairs b) {
    return {a.x - b.x, a.y - b.y};
}
inline Pairs operator*(Lanes f, Pairs v) {
    return {f * v.x, f * v.y};
}
inline Lanes dot(Pairs a, Pairs b) {
    return a.x * b.x + a.y * b.y;
}
inline Pairs where(Mask m, Pairs a, Pairs b) {
    return {m ? a.x : b.x, m ? a.y : b.y};
}

// --- in and out of the arrays of a world ----------------------------------------------------

/// x and y of one particle.
using TwoReals [[gnu::vector_size(2 * sizeof(SweepReal))]] = SweepReal;
using LanesOfReals [[gnu::vector_size(width * sizeof(SweepReal))]] = SweepReal;
using StoredTwoReals
    [[gnu::vector_size(2 * sizeof(SweepReal)), gnu::aligned(alignof(SweepReal)), gnu::may_alias]] =
        SweepReal;
using StoredLanes [[gnu::vector_size(CHAIN_BYTES), gnu::aligned(8), gnu::may_alias]] = double;

inline Two loadTwo(const double* from) {
    return *reinterpret_cast<const StoredTwo*>(from);
}
inline void storeTwo(double* to, Two v) {
    *reinterpret_cast<StoredTwo*>(to) = v;
}
inline TwoReals loadTwoReals(const SweepReal* from) {
    return *reinterpret_cast<const StoredTwoReals*>(from);
}
inline void storeTwoReals(SweepReal* to, TwoReals v) {
    *reinterpret_cast<StoredTwoReals*>(to) = v;
}

#if CHAIN_BYTES >= 32
using Four [[gnu::vector_size(32)]] = double;

/// In an order in which the halves of a register stay where they are.
inline Four even(const Two* v) {
    return __builtin_shufflevector(v[0], v[2], 0, 1, 2, 3);
}
inline Four odd(const Two* v) {
    return __builtin_shufflevector(v[1], v[3], 0, 1, 2, 3);
}
inline Four firsts(const Two* v) {
    return __builtin_shufflevector(even(v), odd(v), 0, 4, 2, 6);
}
inline Four seconds(const Two* v) {
    return __builtin_shufflevector(even(v), odd(v), 1, 5, 3, 7);
}
inline void splitFour(Four x, Four y, Two* v) {
    const Four even = __builtin_shufflevector(x, y, 0, 4, 2, 6);
    const Four odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
    v[0] = __builtin_shufflevector(even, even, 0, 1);
    v[1] = __builtin_shufflevector(odd, odd, 0, 1);
    v[2] = __builtin_shufflevector(even, even, 2, 3);
    v[3] = __builtin_shufflevector(odd, odd, 2, 3);
}
#endif

/// From x and y of one particle after the other to those of all lanes, and back.
inline Pairs joined(const Two* v) {
#if CHAIN_BYTES == 64
    return {__builtin_shufflevector(firsts(v), firsts(v + 4), 0, 1, 2, 3, 4, 5, 6, 7),
            __builtin_shufflevector(seconds(v), seconds(v + 4), 0, 1, 2, 3, 4, 5, 6, 7)};
#elif CHAIN_BYTES == 32
    return {firsts(v), seconds(v)};
#else
    return {__builtin_shufflevector(v[0], v[1], 0, 2), __builtin_shufflevector(v[0], v[1], 1, 3)};
#endif
}
inline void split(const Pairs& p, Two* v) {
#if CHAIN_BYTES == 64
    splitFour(__builtin_shufflevector(p.x, p.x, 0, 1, 2, 3),
              __builtin_shufflevector(p.y, p.y, 0, 1, 2, 3), v);
    splitFour(__builtin_shufflevector(p.x, p.x, 4, 5, 6, 7),
              __builtin_shufflevector(p.y, p.y, 4, 5, 6, 7), v + 4);
#elif CHAIN_BYTES == 32
    splitFour(p.x, p.y, v);
#else
    v[0] = __builtin_shufflevector(p.x, p.y, 0, 2);
    v[1] = __builtin_shufflevector(p.x, p.y, 1, 3);
#endif
}

inline Pairs gather(const double* xy, const std::uint32_t* at) {
    Two v[width];
    for (std::size_t k = 0; k < width; ++k) v[k] = loadTwo(xy + 2 * std::size_t{at[k]});
    return joined(v);
}
inline Pairs gatherReals(const SweepReal* xy, const std::uint32_t* at) {
    Two v[width];
    for (std::size_t k = 0; k < width; ++k)
        v[k] = __builtin_convertvector(loadTwoReals(xy + 2 * std::size_t{at[k]}), Two);
    return joined(v);
}
inline Lanes load(const double* from) {
    return *reinterpret_cast<const StoredLanes*>(from);
}
inline Lanes gatherOnes(const SweepReal* values, const std::uint32_t* at) {
#if CHAIN_BYTES == 64
    const LanesOfReals v = {values[at[0]], values[at[1]], values[at[2]], values[at[3]],
                            values[at[4]], values[at[5]], values[at[6]], values[at[7]]};
#elif CHAIN_BYTES == 32
    const LanesOfReals v = {values[at[0]], values[at[1]], values[at[2]], values[at[3]]};
#else
    const LanesOfReals v = {values[at[0]], values[at[1]]};
#endif
    return __builtin_convertvector(v, Lanes);
}

// --- a chain in each lane -------------------------------------------------------------------

struct Node {
    Pairs displacement, velocity, moved, acceleration;
    Lanes inverseMass;
};

/// A link that leads to the node of the same number from the one before it, and its factors.
struct Link {
    Pairs apart, now, start, present;
    Lanes value, lambda, impulse, target, scale, inverseLength, masses, rest, share;
    Lanes inverse, back, ahead, right;
};

struct Item {
    Node node;
    Link link;
};
static_assert(sizeof(Item) <= chainScratch && alignof(Item) <= chainAlignment);

/// `fixed`: the number of nodes, where it is known when this is compiled, otherwise 0. With
/// `heldRoot` nothing is computed for node 0.
template <std::size_t fixed, bool heldRoot>
class Chains {
public:
    Chains(const ChainView& view, const ChainRules& rules, const ChainBatch& batch,
           std::size_t firstLane, Item* items)
        : view_(view), rules_(rules), batch_(batch), lane_(firstLane), items_(items) {}

    /// Bits of the lanes from firstLane on.
    ChainOutcome run() {
        load();
        const double step = rules_.tick / batch_.steps;
        prepare(step);
        for (std::uint32_t s = 0; s < batch_.steps && bits(good_) != 0; ++s) {
            if (s == 0)
                predict(step + rules_.late, (lastStep() + all(step)) / all(2), step);
            else
                predict(step, all(step), step);
            good_ &= beginStep(step);
            good_ &= converge();
            judge();
            finishStep(step);
        }
        good_ &= areFinite();
        const std::uint32_t wanted = (batch_.lanes >> lane_) & everyLane;
        const std::uint32_t done = bits(good_) & wanted;
        if (done != 0) store(done);
        const Mask calm = (whip_ < all(rules_.calmWhip)) & (turn_ < all(rules_.calmTurn));
        return {done, done & bits(calm)};
    }

private:
    std::size_t count() const { return fixed != 0 ? fixed : batch_.nodes; }
    const std::uint32_t* particles(std::size_t i) const {
        return batch_.particles + i * chainLanes + lane_;
    }
    const std::uint32_t* joints(std::size_t i) const {
        return batch_.joints + i * chainLanes + lane_;
    }
    Lanes lastStep() const { return detail::load(batch_.lastStep + lane_); }
    Node& node(std::size_t i) const { return items_[i].node; }
    Link& link(std::size_t i) const { return items_[i].link; }

    static constexpr std::size_t firstMoving = heldRoot ? 1 : 0;
    Lanes inverseMassOf(std::size_t i) const {
        return i < firstMoving ? all(0) : node(i).inverseMass;
    }
    Pairs movedOf(std::size_t i) const {
        return i < firstMoving ? Pairs{all(0), all(0)} : node(i).moved;
    }
    Pairs displacementOf(std::size_t i) const {
        return i < firstMoving ? Pairs{all(0), all(0)} : node(i).displacement;
    }

    void load() {
        for (std::size_t i = firstMoving; i < count(); ++i) loadNode(i);
        for (std::size_t i = 1; i < count(); ++i) loadLink(i);
    }

    void loadNode(std::size_t i) {
        const std::uint32_t* at = particles(i);
        Node& n = node(i);
        n.inverseMass = detail::load(batch_.inverseMass + i * chainLanes + lane_);
        const Mask moves = n.inverseMass > all(0);
        const Pairs gravity{all(rules_.gravityX), all(rules_.gravityY)}, nothing{all(0), all(0)};
        n.velocity = gather(view_.velocity, at);
        n.acceleration = gravity + n.inverseMass * gather(view_.force, at);
        if (bits(moves) == everyLane) return;
        Pairs driven = gatherReals(view_.displacement, at);
        const Lanes tick = all(rules_.tick);
        // Nearly always it is a pin, and a division less counts.
        if (bits((driven.x != all(0)) | (driven.y != all(0))) != 0)
            driven = {driven.x / tick, driven.y / tick};
        n.velocity = where(moves, n.velocity, driven);
        n.acceleration = where(moves, n.acceleration, nothing);
    }

    void loadLink(std::size_t i) {
        Link& l = link(i);
        l.apart = gather(view_.position, particles(i)) - gather(view_.position, particles(i - 1));
        l.masses = node(i).inverseMass + inverseMassOf(i - 1);
        l.rest = detail::load(batch_.rest + i * chainLanes + lane_);
        l.share = detail::load(batch_.share + i * chainLanes + lane_);
        const Lanes force = gatherOnes(view_.tension, joints(i));
        l.lambda = size(force) < all(rules_.maxForce) ? force : all(0);
        l.inverse = l.back = l.ahead = all(0);
    }

    void prepare(double step) {
        for (std::size_t i = firstMoving; i < count(); ++i) node(i).moved = {all(0), all(0)};
        for (std::size_t i = 1; i < count(); ++i) {
            link(i).impulse = all(0);
            link(i).lambda = -link(i).lambda * step * step;
        }
    }

    /// The same as resistance() in motion.hpp.
    double resistance(double step) const { return 1 + step * rules_.airFriction / 2; }

    /// Forces act for `kick` seconds, gravity for others.
    void predict(double kick, Lanes gravity, double step) {
        const double half = kick * rules_.airFriction / 2;
        const Lanes keep = all((1 - half) / (1 + half)), push = all(kick / (1 + half));
        const Lanes longer = gravity - all(kick);
        const Pairs falls{longer * all(rules_.gravityX), longer * all(rules_.gravityY)};
        const Lanes most = all(rules_.maxSpeed);
        for (std::size_t i = firstMoving; i < count(); ++i) {
            Node& n = node(i);
            const Pairs kicked = keep * n.velocity + push * n.acceleration + falls;
            n.velocity = where(n.inverseMass > all(0),
                               {limited(most, kicked.x), limited(most, kicked.y)}, n.velocity);
            n.displacement = all(step) * n.velocity;
        }
    }

    Mask beginStep(double step) {
        Mask directed = all(0) == all(0);
        Pairs before{all(0), all(0)};
        for (std::size_t i = 1; i < count(); ++i) {
            Link& l = link(i);
            l.now = l.apart + (node(i).moved - movedOf(i - 1));
            l.target = l.rest;
            l.scale = l.inverseLength = l.share;
            const Mask atRest = isAtRest(l);
            if (bits(atRest) != everyLane) directed &= measure(l, ~atRest, step);
            l.start = l.inverseLength * l.now;
            const Pairs push = l.lambda * l.start;
            if (i > firstMoving) {
                Node& there = node(i - 1);
                there.displacement = there.displacement + there.inverseMass * (before - push);
            }
            before = push;
        }
        Node& end = node(count() - 1);
        end.displacement = end.displacement + end.inverseMass * before;
        return directed;
    }

    Mask isAtRest(const Link& l) const {
        const Lanes stretch = dot(l.now, l.now) * l.share - l.rest;
        return (size(stretch) < smaller(all(2e-6) * l.rest, all(rules_.smallStretch))) &
               (l.share < all(1e3));
    }

    /// Whether the links among `these` have a direction.
    Mask measure(Link& l, Mask these, double step) const {
        const Lanes length = root(dot(l.now, l.now));
        l.inverseLength = these ? all(1) / length : l.inverseLength;
        const Lanes error = length - l.rest, most = all(rules_.closingSpeed * step);
        const Lanes left = error > most ? error - most : (error < -most ? error + most : all(0));
        l.target = these ? l.rest + left : l.target;
        l.scale = these ? all(1) / l.target : l.scale;
        return ~these | (length > all(1e-12));
    }

    /// Whether Newton's method arrives.
    Mask converge() {
        Mask going = all(0) == all(0), failed = Mask{};
        Lanes before = all(0), factored = all(0);
        for (int pass = 0;; ++pass) {
            const Lanes worst = evaluate();
            going &= ~(worst <= all(rules_.tolerance));
            const Mask stale = pass == 0 ? going : going & ~(worst < rules_.worthwhile * before);
            const Mask tired = stale & (factored == all(rules_.mostFactored));
            const Mask lost = pass == rules_.mostPasses ? going : tired | ~(worst < all(infinity));
            failed |= going & lost;
            going &= ~lost;
            if (bits(going) == 0) return ~failed;
            if (bits(going & stale) != 0) factorise(going & stale);
            factored += going & stale ? all(1) : all(0);
            solve(going);
            before = worst;
        }
    }

    Lanes evaluate() {
        Lanes worst = all(0);
        for (std::size_t i = 1; i < count(); ++i) {
            Link& l = link(i);
            const Pairs apart = l.now + (node(i).displacement - displacementOf(i - 1));
            const Lanes square = dot(apart, apart);
            l.present = l.scale * apart;
            l.value = all(0.5) * (square * l.scale - l.target);
            worst = larger(worst, size(l.value) * l.share);
        }
        return worst;
    }

    // --- the tridiagonal system -------------------------------------------------------------

    std::size_t lastLink() const { return count() - 1; }
    /// As many links after it as before it, or one more.
    std::size_t middle() const { return count() / 2; }

    Lanes diagonal(std::size_t i) const {
        return link(i).masses * dot(link(i).present, link(i).start);
    }
    Lanes above(std::size_t i) const {
        return -node(i).inverseMass * dot(link(i).present, link(i + 1).start);
    }
    Lanes below(std::size_t i) const {
        return -node(i - 1).inverseMass * dot(link(i).present, link(i - 1).start);
    }
    void setInverse(std::size_t i, Lanes pivot, Mask these) {
        const Mask isPivot = size(pivot) > rules_.redundant * link(i).masses;
        const Lanes inverse = isPivot ? all(1) / pivot : all(0);
        link(i).inverse = these ? inverse : link(i).inverse;
    }
    void setAhead(std::size_t i, Lanes coupling, Mask these) {
        link(i).ahead = these ? coupling * link(i).inverse : link(i).ahead;
    }

    void factorise(Mask these) {
        const std::size_t last = lastLink(), m = middle();
        if (m > 1) {
            setInverse(1, diagonal(1), these);
            setAhead(1, above(1), these);
        }
        if (last > m) {
            setInverse(last, diagonal(last), these);
            setAhead(last, below(last), these);
        }
        for (std::size_t up = 2, down = last - 1; down > m; ++up, --down) {
            if (up < m) {
                link(up).back = these ? below(up) : link(up).back;
                setInverse(up, diagonal(up) - link(up).back * link(up - 1).ahead, these);
                setAhead(up, above(up), these);
            }
            link(down).back = these ? above(down) : link(down).back;
            setInverse(down, diagonal(down) - link(down).back * link(down + 1).ahead, these);
            setAhead(down, below(down), these);
        }
        Lanes pivot = diagonal(m);
        if (m > 1) pivot -= below(m) * link(m - 1).ahead;
        if (m < last) pivot -= above(m) * link(m + 1).ahead;
        setInverse(m, pivot, these);
    }

    void solve(Mask these) {
        const std::size_t last = lastLink(), m = middle();
        if (m > 1) link(1).right = -link(1).value * link(1).inverse;
        if (m < last) link(last).right = -link(last).value * link(last).inverse;
        const auto eliminate = [&](std::size_t i, std::size_t from) {
            Link& l = link(i);
            l.right = (-l.value - l.back * link(from).right) * l.inverse;
        };
        for (std::size_t up = 2, down = last - 1; down > m; ++up, --down) {
            if (up < m) eliminate(up, up - 1);
            eliminate(down, down + 1);
        }
        Lanes right = -link(m).value;
        if (m > 1) right -= below(m) * link(m - 1).right;
        if (m < last) right -= above(m) * link(m + 1).right;
        link(m).right = right * link(m).inverse;
        substitute(these);
    }

    void substitute(Mask these) {
        const std::size_t last = lastLink(), m = middle();
        for (std::size_t up = m + 1, down = m - 1; up <= last; ++up, --down) {
            if (down > 0) link(down).right -= link(down).ahead * link(down + 1).right;
            link(up).right -= link(up).ahead * link(up - 1).right;
        }
        Pairs before{all(0), all(0)};
        for (std::size_t i = 1; i <= last; ++i) {
            Link& l = link(i);
            const Pairs push = l.right * l.start;
            l.lambda = these ? l.lambda + l.right : l.lambda;
            if (i > firstMoving) moveBy(node(i - 1), before - push, these);
            before = push;
        }
        moveBy(node(last), before, these);
    }

    static void moveBy(Node& n, Pairs push, Mask these) {
        n.displacement = where(these, n.displacement + n.inverseMass * push, n.displacement);
    }

    // --- the step's end ---------------------------------------------------------------------

    void judge() {
        Lanes pullBefore = all(0), whip = all(0), turn = all(0);
        for (std::size_t i = 1; i < count(); ++i) {
            const Link& l = link(i);
            const Lanes pull = size(l.lambda) * l.inverseLength;
            if (i > firstMoving)
                whip = larger(whip, all(2) * node(i - 1).inverseMass * (pullBefore + pull));
            pullBefore = pull;
            turn = larger(turn, size(l.start.x * l.present.y - l.start.y * l.present.x));
            turn = dot(l.start, l.present) < all(0) ? all(2) : turn;
        }
        whip = larger(whip, all(2) * node(lastLink()).inverseMass * pullBefore);
        whip_ = larger(whip_, whip);
        turn_ = larger(turn_, turn);
        good_ &= (whip < all(infinity)) & (whip_ <= all(rules_.mostWhip)) &
                 (turn_ <= all(rules_.mostTurn));
    }

    void finishStep(double step) {
        const Lanes rate = all(1 / step), most = all(rules_.maxSpeed * step);
        for (std::size_t i = firstMoving; i < count(); ++i) {
            Node& n = node(i);
            n.displacement = {limited(most, n.displacement.x), limited(most, n.displacement.y)};
            n.moved = n.moved + n.displacement;
            n.velocity = where(n.inverseMass > all(0), rate * n.displacement, n.velocity);
        }
        const Lanes newtons = all(1 / step * resistance(step));
        for (std::size_t i = 1; i < count(); ++i) link(i).impulse += newtons * link(i).lambda;
    }

    Mask areFinite() const {
        Lanes sum = all(0);
        for (std::size_t i = firstMoving; i < count(); ++i) {
            const Pairs both = node(i).moved + node(i).velocity;
            sum += all(0) * both.x + all(0) * both.y;
        }
        for (std::size_t i = 1; i < count(); ++i) sum += all(0) * link(i).impulse;
        return sum == all(0);
    }

    void store(std::uint32_t done) {
        if (heldRoot) storeRoot(done);
        for (std::size_t i = firstMoving; i < count(); ++i) storeNode(i, done);
        const Lanes perNewton = all(rules_.tick / resistance(rules_.tick));
        for (std::size_t i = 1; i < count(); ++i) {
            const Lanes whole = link(i).impulse * perNewton;
            for (std::size_t k = 0; k < width; ++k)
                if ((done >> k & 1u) != 0)
                    view_.lambda[joints(i)[k]] = static_cast<SweepReal>(whole[k]);
        }
    }

    void storeRoot(std::uint32_t done) {
        for (std::size_t k = 0; k < width; ++k) {
            if ((done >> k & 1u) == 0) continue;
            storeTwoReals(view_.predicted + 2 * std::size_t{batch_.firsts[lane_ + k]},
                          TwoReals{0, 0});
            storeTwo(view_.force + 2 * std::size_t{particles(0)[k]}, Two{0, 0});
        }
    }

    void storeNode(std::size_t i, std::uint32_t done) {
        const Node& n = node(i);
        const std::uint32_t moves = bits(n.inverseMass > all(0));
        Two moved[width], velocity[width];
        split(n.moved, moved);
        split(n.velocity, velocity);
        for (std::size_t k = 0; k < width; ++k) {
            if ((done >> k & 1u) == 0) continue;
            const TwoReals displacement = __builtin_convertvector(moved[k], TwoReals);
            const std::size_t p = 2 * std::size_t{particles(i)[k]};
            storeTwoReals(view_.predicted + 2 * (batch_.firsts[lane_ + k] + i), displacement);
            storeTwo(view_.force + p, Two{0, 0});
            if ((moves >> k & 1u) == 0) continue;
            storeTwoReals(view_.displacement + p, displacement);
            storeTwo(view_.velocity + p, velocity[k]);
        }
    }

    const ChainView& view_;
    const ChainRules& rules_;
    const ChainBatch& batch_;
    const std::size_t lane_;
    Item* const items_;
    Mask good_ = all(0) == all(0);
    Lanes whip_ = all(0), turn_ = all(0);
};

template <std::size_t fixed, bool heldRoot>
ChainOutcome stepLanes(const ChainView& view, const ChainRules& rules, const ChainBatch& batch,
                       void* scratch) {
    ChainOutcome whole{0, 0};
    for (std::size_t lane = 0; lane < chainLanes; lane += width) {
        if ((batch.lanes >> lane & everyLane) == 0) continue;
        Item local[fixed == 0 ? 1 : fixed];
        Item* items = fixed == 0 ? static_cast<Item*>(scratch) : local;
        const ChainOutcome some = Chains<fixed, heldRoot>(view, rules, batch, lane, items).run();
        whole.done |= some.done << lane;
        whole.calm |= some.calm << lane;
    }
    return whole;
}

template <std::size_t fixed>
ChainOutcome stepLanes(const ChainView& view, const ChainRules& rules, const ChainBatch& batch,
                       void* scratch) {
    return batch.heldRoot ? stepLanes<fixed, true>(view, rules, batch, scratch)
                          : stepLanes<fixed, false>(view, rules, batch, scratch);
}

ChainOutcome stepChains(const ChainView& view, const ChainRules& rules, const ChainBatch& batch,
                        void* scratch) {
    return batch.nodes == 2 ? stepLanes<2>(view, rules, batch, scratch)
                            : stepLanes<0>(view, rules, batch, scratch);
}

}  // namespace

}  // namespace sulfur::detail
