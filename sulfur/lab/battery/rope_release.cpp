#include "battery/rope_release.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"
#include "references/chain.hpp"

namespace sulfur::lab {

namespace {

constexpr double linkMass = 0.05;  // kg

ChainOptions planOf(const RopeRelease& o) {
    ChainOptions plan;
    for (int i = 0; i <= o.links; ++i) {
        plan.places.emplace_back(o.linkLength * i, 0);
        plan.masses.push_back(linkMass * (i == o.links ? o.load : 1));
    }
    plan.lengths.assign(static_cast<std::size_t>(o.links), o.linkLength);
    return plan;
}

/// Watches the energy in windows of 0.05 s, in shares of `budget`, from 0 at the release.
class EnergyRange {
public:
    EnergyRange(double budget, int tickRate)
        : budget_(budget), window_(std::max(1, tickRate / 20)) {}
    void add(const World& world) {
        sum_ += world.energy();
        if (++count_ < window_) return;
        const double mean = sum_ / count_ / budget_;
        lost = worst(lost, -mean);
        gained = worst(gained, mean);
        sum_ = count_ = 0;
    }
    double lost = 0, gained = 0;

private:
    double budget_, sum_ = 0;
    int window_, count_ = 0;
};

/// How many of `states` there are before the load turns back for the first time.
std::size_t swingLength(const std::vector<State>& states) {
    std::size_t n = 0;
    while (n < states.size() && !(states[n].v.back().x() > 0 && states[n].x.back().x() < 0)) ++n;
    return n;
}

/// The load's motion until it turns back for the first time.
ChainPath firstSwing(const ChainOptions& plan, double h) {
    const std::size_t links = plan.lengths.size();
    const ChainPlan reference{
        plan.lengths, {plan.masses.begin() + 1, plan.masses.end()}, standardGravity};
    const State start{{plan.places.begin() + 1, plan.places.end()}, Vecs(links, Vec::Zero())};
    // A pendulum with all its mass at the end needs 3.71 sqrt(l / g) from one side to the other.
    const double rope = plan.lengths.front() * static_cast<double>(links);
    const auto most = static_cast<std::size_t>(1.5 * 3.71 * std::sqrt(rope / standardGravity) / h);
    const auto ticks = swingLength(convergedPath(reference, start, h, most, rope, 32).states);
    return convergedPath(reference, start, h, ticks, 1e-5 * rope, 512);
}

}  // namespace

Rows releaseRope(const RopeRelease& options, const Setup& setup) {
    const ChainOptions plan = planOf(options);
    World world(still(setup, standardGravity));
    const Body body = world.add(chain(plan));
    double budget = 0;
    for (std::size_t i = 1; i < plan.places.size(); ++i)
        budget += plan.masses[i] * standardGravity * plan.places[i].x();
    const double rope = options.linkLength * options.links;
    const ChainPath way = options.accurate ? firstSwing(plan, 1.0 / setup.tickRate) : ChainPath();
    EnergyRange energy(budget, setup.tickRate);
    double stretch = 0, away = 0;
    const auto ticks = std::lround(options.seconds * setup.tickRate);
    for (long tick = 1; tick <= ticks; ++tick) {
        world.step();
        for (std::size_t j = 0; j < plan.lengths.size(); ++j) {
            const double now = (world.position(body[j + 1]) - world.position(body[j])).norm();
            stretch = worst(stretch, std::abs(now / options.linkLength - 1));
        }
        if (options.accurate) energy.add(world);
        const auto n = static_cast<std::size_t>(tick);
        if (n < way.states.size())
            away = worst(away, (world.position(body.back()) - way.states[n].x.back()).norm());
    }
    const std::string name =
        fmt::format("rope of {} links of {:g} m, load {:g}, {:g} s: ", options.links,
                    options.linkLength, options.load, options.seconds);
    Rows rows{atMost(name + "stretch of a link (share)", stretch, options.stretchBound),
              atMost(name + "not finite", allFinite(world, body.particles()) ? 0 : 1, 0)};
    if (!options.accurate) return rows;
    rows.push_back(atMost(name + "energy lost (share)", energy.lost, 0.05));
    rows.push_back(atMost(name + "energy gained (share)", energy.gained, 0.02));
    rows.push_back(
        atMost(name + fmt::format("load's path in the first swing, {:.2f} s (share of "
                                  "length; reference within {:.1e})",
                                  static_cast<double>(way.states.size()) / setup.tickRate,
                                  way.error / rope),
               away / rope, 0.02));
    return rows;
}

}  // namespace sulfur::lab
