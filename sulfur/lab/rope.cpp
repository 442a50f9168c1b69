#include "rope.hpp"

#include <cmath>

namespace sulfur::lab {

State Rope::start() const {
    State state;
    for (std::size_t i = 0; i < size(); ++i) {
        state.x.emplace_back(c_.length * static_cast<double>(i + 1), 0);
        state.v.emplace_back(0, 0);
    }
    return state;
}

Vec Rope::pull(const Vec& x, const Vec& v, const Vec& y, const Vec& w) const {
    const Vec apart = x - y;
    const double distance = apart.norm();
    // Two particles in one place have no direction; the spring then pushes nowhere.
    const Vec n = distance > 0 ? Vec(apart / distance) : Vec::Zero();
    const Vec speed = v - w;
    const Vec damper = c_.damper == Damper::full ? speed : Vec(n * n.dot(speed));
    return -c_.stiffness * (distance - c_.length) * n - c_.damping * damper;
}

Vec Rope::acceleration(std::size_t i, const Vec& x, const Vec& v, const State& others) const {
    const Vec zero = Vec::Zero();
    Vec force = -c_.airFriction * v;
    force += i == 0 ? pull(x, v, zero, zero) : pull(x, v, others.x[i - 1], others.v[i - 1]);
    if (i + 1 < size()) force += pull(x, v, others.x[i + 1], others.v[i + 1]);
    return force / c_.mass + Vec(0, -c_.gravity);
}

void Rope::accelerations(const State& state, Vecs& out) const {
    out.assign(size(), Vec(0, -c_.gravity));
    for (std::size_t i = 0; i < size(); ++i) {
        const Vec zero = Vec::Zero();
        const Vec force = i == 0 ? pull(state.x[0], state.v[0], zero, zero)
                                 : pull(state.x[i], state.v[i], state.x[i - 1], state.v[i - 1]);
        out[i] += (force - c_.airFriction * state.v[i]) / c_.mass;
        if (i > 0) out[i - 1] -= force / c_.mass;
    }
}

// With n = d / |d|, the derivative of k (|d| - l) n by d is k (1 - l / |d|) I + k l / |d| n n'.
// That of the axial damper's direction is left out: Newton then converges a little more slowly.
void Rope::jacobian(const State& state, Jacobian& out) const {
    out.blocks.clear();
    const Mat air = -c_.airFriction / c_.mass * Mat::Identity();
    for (std::size_t i = 0; i < size(); ++i) {
        out.add(i, i, Mat::Zero(), air);
        const Vec apart = i == 0 ? state.x[0] : Vec(state.x[i] - state.x[i - 1]);
        const double distance = apart.norm();
        if (!(distance > 0)) continue;
        const Mat nn = apart * apart.transpose() / (distance * distance);
        const double slack = c_.length / distance;
        const Mat dx = c_.stiffness / c_.mass * ((1 - slack) * Mat::Identity() + slack * nn);
        const Mat dv =
            c_.damping / c_.mass * (c_.damper == Damper::full ? Mat(Mat::Identity()) : nn);
        out.add(i, i, -dx, -dv);
        if (i == 0) continue;
        out.add(i, i - 1, dx, dv);
        out.add(i - 1, i, dx, dv);
        out.add(i - 1, i - 1, -dx, -dv);
    }
}

// Hanging at rest, spring j carries the weight T below it and is longer by T / k: it has let down
// that weight by l + T / k and stored T^2 / 2k.
double Rope::budget() const {
    double sum = 0;
    for (std::size_t j = 0; j < size(); ++j) {
        const double weight = c_.mass * c_.gravity * static_cast<double>(size() - j);
        sum += weight * c_.length + weight * weight / (2 * c_.stiffness);
    }
    return sum;
}

double Rope::kineticEnergy(const State& state) const {
    double sum = 0;
    for (const Vec& v : state.v) sum += c_.mass / 2 * v.squaredNorm();
    return sum;
}

}  // namespace sulfur::lab
