// Why a scene is slower than real time.
#pragma once

#include <array>
#include <string>
#include <sulfur/world.hpp>

namespace sulfurchamber {

/// Sums up what the stages of ticks cost, once in a while, and says which costs most. The times
/// change nothing of what the world does.
class LoadWatch {
public:
    /// Before each tick.
    void beforeTick(sulfur::World& world);
    /// After each tick.
    void afterTick(const sulfur::World& world);
    /// "contacts of 2400 things", of the last seconds; empty before anything is known.
    std::string cause() const { return cause_; }
    void clear();

private:
    void conclude(const sulfur::World& world);

    std::array<double, static_cast<std::size_t>(sulfur::Stage::count)> seconds_{};
    std::uint64_t ticks_ = 0;
    std::uint64_t timed_ = 0;
    std::string cause_;
};

}  // namespace sulfurchamber
