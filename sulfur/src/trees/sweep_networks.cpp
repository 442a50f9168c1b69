// Networks in the sweeps: what contacts and other constraints push, they answer as a whole.
//
// A network has already arrived at the tick's end. What its links have grown by since then goes
// back along their directions at the end, by Newton's method for the multipliers of all sweeps of
// the step together. Contacts that press are part of the equations, so that what the whole network
// pulls with meets the surface at once. Networks that touch each other are solved together: to one
// of them a light node of another would be free, and be flung, whatever it carries.
#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <utility>
#include <vector>

#include "core/settings.hpp"
#include "trees/network_contacts.hpp"
#include "trees/swept_network.hpp"

namespace sulfur::detail {

namespace {

/// Networks that touch each other: each solves its links, and all of them their contacts together.
class SweptGroup {
public:
    SweptGroup(State& state, std::uint32_t number)
        : state_(state),
          group_(state.trees.networkGroups[number]),
          contacts_(state, number),
          members_(&state.arena) {
        auto& work = state.trees.networkSweep.members;
        if (work.size() < group_.trees.size()) work.resize(group_.trees.size());
        members_.reserve(group_.trees.size());
        for (std::size_t m = 0; m < group_.trees.size(); ++m)
            members_.emplace_back(state, state.trees.list[group_.trees[m]], work[m]);
    }

    bool isSpent() const {
        std::uint64_t budget = 0;
        for (const SweptNetwork& m : members_) budget += m.budget();
        return group_.work > budget;
    }

    /// Up to so many passes, unless there is no work left.
    void sweep(bool loads) {
        for (SweptNetwork& m : members_) m.load(loads);
        contacts_.list();
        if (loads) contacts_.bound();
        double best = 0, last = 0;
        bool isBest = true;
        for (int pass = 0;; ++pass) {
            const double worst = std::max(evaluate(), contacts_.error());
            const bool done = worst <= tuned::sweptTolerance;
            group_.error = pass == 0 ? worst : std::min(group_.error, worst);
            if (pass == 0 && done && !loads) return;
            isBest = pass == 0 || worst < best;
            if (isBest) {
                best = worst;
                for (SweptNetwork& m : members_) m.keepBest();
                contacts_.keepBest();
            }
            for (const SweptNetwork& m : members_) group_.work += tuned::productsOfNode * m.nodes();
            group_.work += tuned::productsOfNode * contacts_.rows();
            if (done || pass == tuned::networkPasses || !std::isfinite(worst)) break;
            factorise(pass > 0 && isSlow(worst, last, tuned::sweptTolerance), pass == 0);
            last = worst;
            solve();
            advance();
        }
        push(isBest);
    }

    /// Nodes that overlaps push apart take their links along, and what presses on these.
    void settlePushes() {
        bool any = contacts_.overlap();
        for (SweptNetwork& m : members_) any = m.loadPushes() || any;
        if (!any) return;
        factorise(false, true);
        correct();
        contacts_.solvePushes();
        contacts_.takeChanges();
        correct();
        for (SweptNetwork& m : members_) m.place();
        contacts_.placeBodies();
    }

    /// Where passes have not led to a solution, which networks that are crumpled or pressed beyond
    /// what they can bear may not have: all of them lose what speed they have against what they
    /// touch.
    void brakeUnsolved() {
        if (group_.error <= tuned::brakingTolerable) return;
        ++state_.statistics.chainFallbacks;
        contacts_.list();
        contacts_.brake();
        for (SweptNetwork& m : members_) m.forgetMultipliers();
    }

private:
    double evaluate() {
        double worst = 0;
        for (SweptNetwork& m : members_) worst = std::max(worst, m.evaluateLinks());
        contacts_.addPressed();
        for (SweptNetwork& m : members_) worst = std::max(worst, m.findResiduals());
        return worst;
    }
    void factorise(bool all, bool stale) {
        for (SweptNetwork& m : members_) {
            if (!all && !(stale && m.isStale())) continue;
            m.factorise();
            group_.work += m.price();
            group_.answers.clear();
        }
        if (!contacts_.areKnown()) contacts_.findAnswers();
    }
    void correct() {
        for (SweptNetwork& m : members_) m.correct();
    }
    /// First without what contacts change, which then find what they have to.
    void solve() {
        correct();
        contacts_.solve();
        contacts_.takeChanges();
        correct();
    }
    void advance() {
        double way = 1;
        for (const SweptNetwork& m : members_) way = std::max(way, m.farthest());
        for (SweptNetwork& m : members_) m.advance(1 / way);
        contacts_.advance(1 / way);
    }
    void push(bool isBest) {
        for (SweptNetwork& m : members_) {
            if (!isBest) m.takeBest();
            m.push();
        }
        contacts_.push();
        for (SweptNetwork& m : members_) m.move();
    }

    State& state_;
    NetworkGroup& group_;
    NetworkContacts contacts_;
    std::pmr::vector<SweptNetwork> members_;
};

NetworkMember& firstMember(State& state) {
    auto& members = state.trees.networkSweep.members;
    if (members.empty()) members.resize(1);
    return members.front();
}

}  // namespace

void NetworkSweeper::remember() {
    SweptNetwork(state_, tree_, firstMember(state_)).remember();
}

void NetworkSweeper::share(std::span<const Freedoms> given) {
    SweptNetwork(state_, tree_, firstMember(state_)).share(given);
}

double NetworkSweeper::strain() {
    return SweptNetwork(state_, tree_, firstMember(state_)).strain();
}

void answerLoads(State& state, std::uint32_t group) {
    SweptGroup(state, group).sweep(true);
}

void sweepNetworks(State& state, std::uint32_t number, bool first) {
    SweptGroup group(state, number);
    NetworkGroup& g = state.trees.networkGroups[number];
    g.waits = group.isSpent();
    if (g.waits) return;
    group.sweep(false);
    if (first) group.settlePushes();
}

void finishNetworks(State& state, std::uint32_t number) {
    SweptGroup group(state, number);
    if (std::exchange(state.trees.networkGroups[number].waits, false)) group.sweep(false);
    group.brakeUnsolved();
}

void recordNetworkForces(State& state, const Tree& tree) {
    for (auto l = tree.firstLink; l < tree.lastLink; ++l) {
        NetworkLink& n = state.trees.links[l];
        const auto& lambda = state.trees.linkLambda[l];
        for (std::size_t r = 0; r < 2; ++r)
            n.swept[r] = static_cast<double>(newtonsPerMultiplier(state)) * lambda[r];
        if (n.kind == LinkKind::joint) {
            state.joints.lambda[n.link] += static_cast<Real>(lambda[0]);
            continue;
        }
        forceOf(state, n) += newtonsPerMultiplier(state) *
                             Vec2(static_cast<Real>(lambda[0]), static_cast<Real>(lambda[1]));
    }
}

}  // namespace sulfur::detail
