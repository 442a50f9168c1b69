// A spring that is changed while the world runs: what follows from that reaches the joints at its
// two ends, and mostly ends there. So a rope that is reeled in costs what the rope costs.
#pragma once

#include <vector>

#include "joints/classify.hpp"

namespace sulfur::detail {

/// What a spring with another stiffness or damping changes of the joints around it.
class Retuning {
public:
    /// May throw std::bad_alloc; nothing is changed yet.
    Retuning(const State& state, std::uint32_t joint, const Spring& spring);

    /// Whether nothing else follows: each joint stays what it is, a force, a constraint, or both.
    bool isLocal() const { return isLocal_; }
    /// Of a local one. Networks that the joints are links of renew their factors.
    void apply(State& state) const;

private:
    struct Changed {
        std::uint32_t joint = none;
        HowSolved how;
    };

    void collect(const State& state, std::uint32_t joint, const Spring& spring);

    std::vector<Changed> changed_;
    bool isLocal_ = true;
};

}  // namespace sulfur::detail
