#include "battery/random/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "battery/random/momenta.hpp"
#include "battery/random/staged.hpp"

namespace sulfur::lab {

namespace {

constexpr std::array<const char*, lawCount> names{
    "finite",           "valid",  "restore",  "walls", "speed", "momentum",
    "angular-momentum", "energy", "sleeping", "rest"};

constexpr int checkpoints = 8;
constexpr double conserved = 1e-5, gained = 0.01, squeezed = 1.25, restingWay = 0.02;

/// A scene on trial.
class Trial {
public:
    Trial(const Scene& scene, const std::vector<Law>& laws)
        : scene_(scene), laws_(laws), staged_(scene, scene.sleeping) {}

    std::vector<Breach> run() {
        staged_.launch();
        about_ = centreOf(staged_.world);
        start_ = momentaOf(staged_.world, about_);
        largest_ = start_.linear.scale;
        largestAngular_ = start_.angularScale;
        checkEvery_ = std::max(1, scene_.ticks / checkpoints);
        for (tick_ = 1; tick_ <= scene_.ticks; ++tick_)
            if (!tick()) break;
        if (asks(Law::sleeping) && scene_.closed() && scene_.sleeping && !lost_) compareSleeping();
        std::vector<Breach> all;
        for (const auto& [law, breach] : breaches_) all.push_back(breach);
        return all;
    }

private:
    bool asks(Law law) const { return std::find(laws_.begin(), laws_.end(), law) != laws_.end(); }
    /// Notes what was measured, if it is more than the bound; NaN is.
    void hold(Law law, double measured, double bound) {
        if (!asks(law) || measured <= bound) return;
        auto& breach =
            breaches_.try_emplace(law, Breach{law, measured, bound, tick_}).first->second;
        if (measured > breach.measured) {
            breach.measured = measured;
            breach.bound = bound;
        }
    }

    /// Returns whether it makes sense to go on.
    bool tick() {
        restoreInTheMiddle();
        staged_.step(twin_.get());
        if (twin_) hold(Law::restore, twin_->hash() == staged_.world.hash() ? 0 : 1, 0);
        if (!staged_.finite()) {
            hold(Law::finite, 1, 0);
            return false;
        }
        lost_ = lost_ || !staged_.world.events().particlesLost.empty();
        if (scene_.closed() && asks(Law::momentum) && !lost_) judgeMomentum();
        if (scene_.room > 0 && scene_.contacts && asks(Law::walls))
            hold(Law::walls, staged_.behindWalls(), 0);
        if (asks(Law::speed)) judgeSpeed();
        if (tick_ % checkEvery_ == 0 || tick_ == scene_.ticks) check();
        if (scene_.restsAfter > 0 && asks(Law::rest)) judgeRest();
        return true;
    }
    void restoreInTheMiddle() {
        if (!asks(Law::restore)) return;
        if (tick_ == scene_.ticks / 2) {
            twin_ = std::make_unique<World>();
            twin_->restore(staged_.world.snapshot());
        }
        if (tick_ == scene_.ticks / 2 + 20) twin_.reset();
    }
    void judgeMomentum() {
        const Momentum now = momentumOf(staged_.world);
        largest_ = std::max(largest_, now.scale);
        last_ = now.sum;
        hold(Law::momentum, share((now.sum - start_.linear.sum).norm(), largest_), conserved);
    }
    /// The part of the whole; of nothing at all, what rounding leaves is nothing too.
    static double share(double part, double whole) {
        return part == 0 || whole < 1e-12 ? 0 : part / whole;
    }

    void check() {
        if (asks(Law::valid)) hold(Law::valid, staged_.world.validate().empty() ? 0 : 1, 0);
        const bool angular = asks(Law::angularMomentum) && scene_.closed() && !lost_;
        const bool energy = asks(Law::energy) && scene_.undriven();
        if (!angular && !energy) return;
        const Momenta now = momentaOf(staged_.world, about_);
        if (angular) {
            largestAngular_ = std::max(largestAngular_, now.angularScale);
            hold(Law::angularMomentum,
                 share(std::abs(now.angular - start_.angular), largestAngular_), conserved);
        }
        if (energy) {
            given_ = std::max(given_, start_.gravitational - now.gravitational);
            const double before = start_.kinetic + start_.gravitational;
            const double halfTick = start_.linear.scale * scene_.gravity / scene_.rate;
            hold(Law::energy,
                 share(std::max(0.0, now.energy - before - halfTick), start_.kinetic + given_),
                 gained);
        }
    }
    void judgeSpeed() {
        const bool onlyDrivers =
            scene_.influences.empty() &&
            std::none_of(scene_.ties.begin(), scene_.ties.end(), [](const Tie&) { return true; });
        if (scene_.undriven() || !onlyDrivers) return;
        double first = 0, restitution = 0;
        for (const Thing& t : scene_.things) {
            const double rim = t.velocity.norm() + std::abs(t.spin) * reachOf(planOf(t));
            first = std::max(first, rim);
            restitution = std::max(restitution, t.restitution);
        }
        const double fall = 2 * scene_.gravity * 2 * scene_.room;
        const double bound =
            squeezed * std::pow(1 + restitution, 3) * std::sqrt(first * first + fall);
        const double fastest = staged_.fastest();
        hold(Law::speed, fastest == 0 ? 0 : fastest / bound, 1);
    }
    void judgeRest() {
        const auto second = static_cast<long>(scene_.ticks - scene_.rate);
        if (tick_ == second)
            for (const BodyId id : staged_.movers()) places_[id] = staged_.world.centreOfMass(id);
        if (tick_ < scene_.ticks) return;
        for (const auto& [id, place] : places_)
            if (staged_.world.contains(id))
                hold(Law::rest, (staged_.world.centreOfMass(id) - place).norm(), restingWay);
    }
    /// What sleeping changes of the whole.
    void compareSleeping() {
        Staged awake(scene_, false);
        awake.launch();
        for (int i = 0; i < scene_.ticks; ++i) {
            awake.step();
            if (!awake.world.events().particlesLost.empty()) return;
        }
        const Eigen::Vector2d with = momentumOf(staged_.world).sum;
        const Momentum without = momentumOf(awake.world);
        hold(Law::sleeping, share((with - without.sum).norm(), std::max(largest_, without.scale)),
             conserved);
    }

    const Scene& scene_;
    const std::vector<Law>& laws_;
    Staged staged_;
    std::unique_ptr<World> twin_;
    std::map<Law, Breach> breaches_;
    std::map<BodyId, Point> places_;
    Point about_{0, 0};
    Momenta start_;
    Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
    double largest_ = 0, largestAngular_ = 0, given_ = 0;
    int checkEvery_ = 1;
    long tick_ = 0;
    bool lost_ = false;  // particles without a surface are gone, and what they had with them
};

}  // namespace

const char* name(Law law) {
    return names[static_cast<std::size_t>(law)];
}

Law lawOf(const std::string& name) {
    for (const Law law : allLaws())
        if (name == lab::name(law)) return law;
    throw std::out_of_range("no law is named " + name);
}

std::vector<Law> allLaws() {
    std::vector<Law> all;
    for (std::size_t i = 0; i < lawCount; ++i) all.push_back(static_cast<Law>(i));
    return all;
}

std::vector<Breach> judge(const Scene& scene, const std::vector<Law>& laws) {
    return Trial(scene, laws).run();
}

}  // namespace sulfur::lab
