// What the integrators integrate.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace sulfur::lab {

using Vec = Eigen::Vector2d;
using Mat = Eigen::Matrix2d;
using Vecs = std::vector<Vec>;

/// Positions (m) and velocities (m/s) of all particles.
struct State {
    Vecs x, v;
};

/// How accelerations change with positions and velocities, in 2 x 2 blocks: those of particle `row`
/// with particle `column`. What is not there is zero, and blocks at one place add up.
struct Jacobian {
    struct Block {
        std::size_t row, column;
        Mat position, velocity;
    };
    std::vector<Block> blocks;

    void add(std::size_t row, std::size_t column, const Mat& position, const Mat& velocity) {
        blocks.push_back({row, column, position, velocity});
    }
};

/// Particles whose accelerations depend on positions and velocities.
class System {
public:
    virtual ~System() = default;
    virtual std::size_t size() const = 0;
    /// The acceleration of particle `i`, in m/s^2, if it were at `x` with velocity `v` and all
    /// others as in `others`.
    virtual Vec acceleration(std::size_t i, const Vec& x, const Vec& v,
                             const State& others) const = 0;
    /// Replaces `out` by the derivatives of all accelerations at `state`.
    virtual void jacobian(const State& state, Jacobian& out) const = 0;

    /// All accelerations at `state`.
    virtual void accelerations(const State& state, Vecs& out) const {
        out.resize(size());
        for (std::size_t i = 0; i < size(); ++i)
            out[i] = acceleration(i, state.x[i], state.v[i], state);
    }
};

}  // namespace sulfur::lab
