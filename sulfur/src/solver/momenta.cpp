#include "solver/momenta.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "bodies/mechanism_bodies.hpp"
#include "core/disjoint_sets.hpp"
#include "model/contact_core.hpp"

namespace sulfur::detail {

namespace {

/// Bodies that push each other, and what a step has changed of them.
struct Group {
    std::uint32_t parts = 0;
    double mass = 0, inertia = 0;         // kg; kg m^2 about its centre
    Point about{0, 0}, centre{0, 0};      // m: where its first part is; from there
    Point momentum{0, 0}, lost{0, 0};     // kg m/s: as it is, and what is missing
    double angular = 0, lostAngular = 0;  // kg m^2/s about `about`, the same
    double energy = 0;                    // J, of motion
    // What is given back.
    Point velocity{0, 0}, way{0, 0};  // m/s: of its centre before, and more of it
    double spin = 0;                  // rad/s
    double slower = 0;                // share of the motion within it
};

/// A rigid component or a particle that moves by itself, as the step leaves it.
struct Part {
    double mass = 0, inertia = 0;
    Point predicted{0, 0}, end{0, 0};    // m: its place without constraints, and with them
    Point velocity{0, 0}, change{0, 0};  // m/s: without constraints, and by them
    double spin = 0, spinChange = 0;     // rad/s
    Point* newVelocity = nullptr;        // where it takes up what is given back
    double* newSpin = nullptr;
};

/// Not inlined, because GCC 12 leaves a rounding out where two numbers side by side become Real and
/// double again, which other compilers do not.
[[gnu::noinline]] Vec2 rounded(const Point& p) {
    return p.cast<Real>();
}

class Momenta {
public:
    explicit Momenta(State& state)
        : state_(state),
          core_(state.core),
          index_(state.bodies.size(), outside, &state.arena),
          sets_(state.work.bodies.size() + 1, &state.arena),
          parts_(state.work.bodies.size() + 1, 0, &state.arena),
          group_(state.work.bodies.size() + 1, none, &state.arena),
          groups_(&state.arena),
          grouped_(&state.arena) {
        std::uint32_t place = outside;
        for (const auto body : state_.work.bodies) index_[body] = ++place;
        for (const auto body : state_.work.kinematic) index_[body] = outside;
        linkRows();
        linkBodies();
        countParts();
        findGroups();
        if (groups_.empty()) return;
        noteClusters();
        forEachPart([&](Group& g, const Part& p) { add(g, p); });
        for (Group& g : groups_) settle(g);
    }

    void giveBack() {
        if (groups_.empty()) return;
        forEachPart([&](const Group& g, const Part& p) {
            const Point arm = p.end - g.about, turning(-g.spin * arm[1], g.spin * arm[0]);
            *p.newVelocity += g.way + turning - g.slower * (*p.newVelocity - g.velocity);
            if (p.newSpin) *p.newSpin += g.spin - g.slower * *p.newSpin;
        });
    }

private:
    /// The place of all that is fixed, driven or asleep: whoever pushes it is in no group, nor who
    /// pushes him. It leads its set, because it is the smallest.
    static constexpr std::uint32_t outside = 0;

    void link(std::uint32_t a, std::uint32_t b) {
        sets_.unite(a == none ? outside : index_[a], b == none ? outside : index_[b]);
    }
    void linkBodies() {
        for (const auto* pairs : {&core_.struck, &core_.held})
            for (const auto pair : *pairs) linkPair(core_.pairs[pair]);
        for (const auto e : core_.leading)
            link(state_.bodySlots.dense(core_.encounters[e].a),
                 state_.bodySlots.dense(core_.encounters[e].b));
        const auto& body = state_.particles.body;
        for (const auto j : state_.work.tiedJoints)
            link(body[state_.joints.a[j]], body[state_.joints.b[j]]);
        for (const Attachment& held : state_.attachments)
            link(body[held.particle], body[held.support[0]]);
        for (const Mechanism& m : state_.mechanisms.list)
            forEachTieOf(state_, m, [&](std::uint32_t a, std::uint32_t b) { link(a, b); });
        for (const Grab& grab : state_.influences.grabs)
            link(body[state_.particleSlots.dense(grab.support[0])], none);
        for (const auto i : state_.work.heldNodes) link(body[i], none);
        // What somebody has torn apart by hand loses what brings it together.
        for (const auto b : state_.work.strained) link(b, none);
    }
    void linkPair(const Pair& pair) {
        const auto bodyOf = [&](std::uint32_t chunk) {
            return state_.bodySlots.denseOf(core_.shapes.chunks[chunk].body);
        };
        if (pair.a != none) link(bodyOf(pair.a), bodyOf(pair.b));
    }
    void linkRows() {
        std::pmr::vector<std::uint32_t> placeOf(core_.movers.size(), outside, &state_.arena);
        for (const auto m : core_.awakeMovers)
            placeOf[m] = index_[state_.bodySlots.denseOf(core_.movers.body[m])];
        // A mover takes the leader of its set for its place: mostly both have the same one already.
        // (One test, because nobody can foretell which rows act.)
        const auto linkMovers = [&](bool acts, std::uint32_t a, std::uint32_t b) {
            std::uint32_t &one = placeOf[a], &other = placeOf[b];
            if (!acts | (one == other)) return;
            sets_.unite(one, other);
            one = other = sets_.find(one);
        };
        const auto forEachLane = [&](const auto& list, auto kernel, auto&& f) {
            for (const auto& block : list.blocks) {
                const std::uint32_t lanes = kernel(block);
                for (std::uint32_t l = 0; l < rowLanes; ++l) f(block, l, (lanes >> l & 1) != 0);
            }
        };
        const RowKernels& kernels = rowKernels();
        for (const auto c : core_.rows.inUse()) {
            forEachLane(core_.rows.manifolds[c], kernels.actingManifolds,
                        [&](const ManifoldBlock& r, std::uint32_t l, bool acts) {
                            linkMovers(acts, r.a[l], r.b[l]);
                        });
            forEachLane(core_.rows.touches[c], kernels.actingTouches,
                        [&](const TouchBlock& t, std::uint32_t l, bool acts) {
                            linkMovers(acts, t.p[l], t.a[l]);
                            // b is the world where a has both ends.
                            linkMovers(acts && t.b[l] != 0, t.p[l], t.b[l]);
                        });
        }
    }

    /// Counts what moves by itself, by places. What is pinned is as if its body pushed the world.
    void countParts() {
        const auto count = [&](std::uint32_t body, bool isFree) {
            const auto place = index_[body];
            ++parts_[place];
            if (!isFree) sets_.unite(place, outside);
        };
        for (const auto k : state_.work.awakeClusters) {
            const Cluster& c = state_.clusters.list[k];
            count(c.body, c.inverseMass > 0 && c.inverseInertia > 0);
        }
        const Particles& p = state_.particles;
        for (const Range range : state_.work.points)
            for (auto i = range.first; i < range.last; ++i) count(p.body[i], p.inverseMass[i] > 0);
    }

    /// Those of several parts that push nothing else: mostly none, because most of what touches
    /// stands on something.
    void findGroups() {
        std::pmr::vector<std::uint32_t> candidates(&state_.arena);  // places
        for (std::uint32_t k = outside + 1; k < parts_.size(); ++k) {
            const auto root = sets_.find(k);
            if (root == outside) continue;
            if (root != k) parts_[root] += parts_[k];
            if (parts_[root] > 1) candidates.push_back(root);
        }
        if (candidates.empty()) return;
        for (const auto root : candidates) {
            if (group_[root] != none) continue;
            group_[root] = static_cast<std::uint32_t>(groups_.size());
            groups_.emplace_back();
        }
        for (std::uint32_t k = outside + 1; k < parts_.size(); ++k)
            group_[k] = group_[sets_.find(k)];
    }
    Group* groupOf(std::uint32_t body) {
        const auto group = group_[index_[body]];
        return group == none ? nullptr : &groups_[group];
    }
    void noteClusters() {
        const std::uint32_t *index = index_.data(), *group = group_.data();
        for (const auto k : state_.work.awakeClusters)
            if (group[index[state_.clusters.list[k].body]] != none) grouped_.push_back(k);
    }

    /// Calls f(group, part) for all that is in a group.
    template <class Function>
    void forEachPart(Function&& f) {
        const double h = static_cast<double>(state_.h);
        for (const auto k : grouped_) {
            Cluster& c = state_.clusters.list[k];
            Part p;
            p.mass = c.mass;
            p.inertia = 1 / c.freeInverseInertia;
            p.predicted = c.centre + c.predicted.cast<double>();
            p.end = c.centre + c.displacement.cast<double>() + c.shift.cast<double>();
            p.velocity = c.velocity;
            p.change = (c.displacement - c.predicted).cast<double>() / h;
            p.spin = c.spin;
            p.spinChange = (c.angle - c.predictedAngle) / h;
            p.newVelocity = &c.velocity;
            p.newSpin = &c.spin;
            f(groups_[group_[index_[c.body]]], p);
        }
        const auto& velocity = state_.particles.velocity;
        for (const Range range : state_.work.free)
            for (auto i = range.first; i < range.last; ++i)
                withParticle(i, rounded(h * velocity[i]), f);
        for (const auto t : state_.work.lonelyTrees) {
            const Tree& tree = state_.trees.list[t];
            const bool isTouched = state_.trees.touched[t] != 0;
            for (auto k = tree.first; k < tree.last; ++k)
                if (const auto i = state_.trees.nodes[k].particle; i != none)
                    withParticle(
                        i, isTouched ? state_.trees.predicted[k] : state_.particles.displacement[i],
                        f);
        }
    }
    template <class Function>
    void withParticle(std::uint32_t i, const Vec2& predicted, Function&& f) {
        Particles& q = state_.particles;
        Group* const group = groupOf(q.body[i]);
        if (group == nullptr) return;
        Part p;
        p.mass = 1 / static_cast<double>(q.inverseMass[i]);
        p.predicted = core_.places[i] + predicted.cast<double>();
        p.end = q.position[i] + q.displacement[i].cast<double>();
        p.velocity = q.velocity[i];
        p.change = (q.displacement[i] - predicted).cast<double>() / static_cast<double>(state_.h);
        p.newVelocity = &q.velocity[i];
        f(*group, p);
    }

    static void add(Group& g, const Part& p) {
        if (g.parts++ == 0) g.about = p.end;
        const Point arm = p.end - g.about, now = p.velocity + p.change;
        const double spin = p.spin + p.spinChange;
        const double angular = p.mass * cross(arm, now) + p.inertia * spin;
        const double before =
            p.mass * cross(Point(p.predicted - g.about), p.velocity) + p.inertia * p.spin;
        g.mass += p.mass;
        g.inertia += p.inertia + p.mass * arm.squaredNorm();
        g.centre += p.mass * arm;
        g.momentum += p.mass * now;
        g.lost -= p.mass * p.change;
        g.angular += angular;
        g.lostAngular += before - angular;
        g.energy += (p.mass * now.squaredNorm() + p.inertia * spin * spin) / 2;
    }

    static void settle(Group& g) {
        g.centre /= g.mass;
        g.about += g.centre;
        g.velocity = g.momentum / g.mass;
        g.way = g.lost / g.mass;
        const double inertia = g.inertia - g.mass * g.centre.squaredNorm();
        if (!(inertia > 0)) return;
        const double lost = g.lostAngular - g.mass * cross(g.centre, g.way);
        const double within = g.angular - g.mass * cross(g.centre, g.velocity);
        const double energy = g.energy - g.mass * g.velocity.squaredNorm() / 2;
        // A spin w adds w L to the energy within, and slower motion by a share s takes 2 s E away,
        // but also s L.
        const double gain = lost * within / inertia, takes = 2 * energy - within * within / inertia;
        if (gain > 0 && takes > 0) g.slower = std::min(gain / takes, 1.0);
        g.spin = (lost + g.slower * within) / inertia;
    }

    State& state_;
    ContactCore& core_;
    std::pmr::vector<std::uint32_t> index_;  // by body: its place, or outside
    DisjointSets sets_;                      // of places that push each other
    std::pmr::vector<std::uint32_t> parts_;  // by place: what moves by itself
    std::pmr::vector<std::uint32_t> group_;  // by place, or none
    std::pmr::vector<Group> groups_;
    std::pmr::vector<std::uint32_t> grouped_;  // clusters
};

}  // namespace

void notePlaces(State& state) {
    auto& places = state.core.places;
    if (state.work.points.empty()) return;
    places.resize(state.particles.size());
    for (const Range range : state.work.points)
        std::copy(state.particles.position.begin() + range.first,
                  state.particles.position.begin() + range.last, places.begin() + range.first);
}

void keepMomenta(State& state, void (*takeUp)(State& state)) {
    Momenta momenta(state);
    takeUp(state);
    momenta.giveBack();
}

}  // namespace sulfur::detail
