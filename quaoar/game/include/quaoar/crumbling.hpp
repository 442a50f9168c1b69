// Bodies that come loose some time after the hero or the rope has touched them.
#pragma once

#include <cstdint>
#include <memory>
#include <quaoar/attempt.hpp>
#include <vector>

namespace quaoar {

class Crumbling {
public:
    Crumbling() = default;
    explicit Crumbling(const Attempt& attempt);

    /// One tick. Whether something came loose.
    bool wear(const Attempt& attempt);

    /// 0: whole, 1: loose; 0 for what does not crumble.
    double worn(sulfur::BodyId body) const;
    std::uint64_t hash() const;

private:
    struct Plan {
        sulfur::BodyId body;
        int ticks = 0;  ///< of being touched, after which it comes loose
    };
    static void loosen(sulfur::World& world, sulfur::BodyId body);

    std::shared_ptr<const std::vector<Plan>> plans_;
    std::vector<int> touched_;  ///< ticks; beyond those of the plan: it is loose
};

}  // namespace quaoar
