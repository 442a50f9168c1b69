#include "spring_system.hpp"

namespace sulfur::lab {

SpringSystem::SpringSystem(SpringPlan plan) : plan_(std::move(plan)), springsOf_(size()) {
    for (std::size_t j = 0; j < plan_.springs.size(); ++j)
        for (const std::size_t i : {plan_.springs[j].a, plan_.springs[j].b})
            springsOf_[i].push_back(j);
}

namespace {

/// The force on the end at `x` from the end at `y`.
Vec pull(const Spring& spring, const Vec& x, const Vec& v, const Vec& y, const Vec& w) {
    const Vec apart = x - y;
    const double distance = apart.norm();
    // Two particles in one place have no direction; the spring then pushes nowhere.
    if (!(distance > 0)) return Vec::Zero();
    const Vec n = apart / distance;
    return -(spring.stiffness * (distance - spring.restLength) + spring.damping * n.dot(v - w)) * n;
}

}  // namespace

Vec SpringSystem::acceleration(std::size_t i, const Vec& x, const Vec& v,
                               const State& others) const {
    const double w = plan_.inverseMass[i];
    if (w == 0) return Vec::Zero();
    Vec force = Vec::Zero();
    for (const std::size_t j : springsOf_[i]) {
        const Spring& spring = plan_.springs[j];
        const std::size_t other = spring.a == i ? spring.b : spring.a;
        force += pull(spring, x, v, others.x[other], others.v[other]);
    }
    return w * force + Vec(0, -plan_.gravity);
}

void SpringSystem::accelerations(const State& state, Vecs& out) const {
    out.resize(size());
    for (std::size_t i = 0; i < size(); ++i)
        out[i] = plan_.inverseMass[i] == 0 ? Vec(0, 0) : Vec(0, -plan_.gravity);
    for (const Spring& spring : plan_.springs) {
        const auto [a, b] = std::pair(spring.a, spring.b);
        const Vec force = pull(spring, state.x[a], state.v[a], state.x[b], state.v[b]);
        out[a] += plan_.inverseMass[a] * force;
        out[b] -= plan_.inverseMass[b] * force;
    }
}

// As in Rope::jacobian, without the change of the damper's direction.
void SpringSystem::jacobian(const State& state, Jacobian& out) const {
    out.blocks.clear();
    for (const Spring& spring : plan_.springs) {
        const Vec apart = state.x[spring.a] - state.x[spring.b];
        const double distance = apart.norm();
        if (!(distance > 0)) continue;
        const Mat nn = apart * apart.transpose() / (distance * distance);
        const double slack = spring.restLength / distance;
        const Mat dx = spring.stiffness * ((1 - slack) * Mat::Identity() + slack * nn);
        const Mat dv = spring.damping * nn;
        for (const auto& [i, j] : {std::pair(spring.a, spring.b), {spring.b, spring.a}}) {
            const double w = plan_.inverseMass[i];
            if (w == 0) continue;
            out.add(i, i, -w * dx, -w * dv);
            out.add(i, j, w * dx, w * dv);
        }
    }
}

}  // namespace sulfur::lab
