#include "bench/crowd.hpp"

#include <algorithm>
#include <utility>

#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

constexpr double sampleInterval = 0.25;  // s

constexpr Variant crowds[] = {{"tumbler", tumbler},
                              {"spinner", spinner},
                              {"smash", smash},
                              {"rain", rain},
                              {"large-pyramid", largePyramid},
                              {"many-pyramids", manyPyramids},
                              {"joint-grid", jointGrid},
                              {"barrels", barrels},
                              {"compounds", compounds}};

}  // namespace

std::size_t Crowd::add(EngineWorld& world, BodyPlan plan) {
    world.addBody(plan);
    plans_.push_back(std::move(plan));
    removed_.push_back(false);
    return plans_.size() - 1;
}

void Crowd::addWall(EngineWorld& world, const Point& centre, const Point& half) {
    BodyPlan wall{.parts = {rectangle(half)}};
    wall.mover = Mover::nobody;
    wall.place = centre;
    add(world, std::move(wall));
}

void Crowd::remove(EngineWorld& world, std::size_t body) {
    world.removeBody(body);
    removed_[body] = true;
}

bool Crowd::moves(std::size_t body) const {
    return plans_[body].mover == Mover::physics && !removed_[body];
}

void Crowd::look(const EngineWorld& world, double time) {
    note(world, time);
    lastTime_ = time;
    // Ticks of some rates end a rounding error before the moment that is meant.
    if (time + 1e-9 < std::max(nextSample_, seconds_ / 2)) return;
    nextSample_ = std::max(nextSample_, seconds_ / 2) + sampleInterval;
    sample(world, time);
}

void Crowd::sample(const EngineWorld& world, double time) {
    ++samples_;
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        if (removed_[i]) continue;
        const BodyPlan& plan = plans_[i];
        const Motion motion = world.body(i);
        if (!motion.finite()) continue;
        if (moves(i) && lost(plan, motion, time)) continue;
        if (moves(i)) fastest_ = std::max(fastest_, motion.velocity.norm());
        for (const Outline& part : plan.parts)
            pieces.push_back({placed(part, motion), i, plan.group, moves(i)});
    }
    const std::vector<double> found = overlaps(pieces);
    depths_.insert(depths_.end(), found.begin(), found.end());
}

Figures Crowd::figures(const EngineWorld& world) {
    // A run that was stopped may end before the first sample.
    if (samples_ == 0) sample(world, lastTime_);
    double gone = 0;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        if (!moves(i)) continue;
        const Motion motion = world.body(i);
        if (!motion.finite() || lost(plans_[i], motion, lastTime_)) ++gone;
    }
    Figures all{{"mean overlap", "mm", mean(depths_) * millimetres},
                {"p99 overlap", "mm", percentile(depths_, 0.99) * millimetres},
                {"max overlap", "mm", percentile(depths_, 1) * millimetres},
                {"lost", "", gone},
                {"fastest", "m/s", fastest_}};
    for (Figure& figure : more(world)) all.push_back(std::move(figure));
    return all;
}

double Crowd::kineticEnergy(const EngineWorld& world) const {
    double sum = 0;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        if (!moves(i)) continue;
        const Motion motion = world.body(i);
        sum += plans_[i].mass() * motion.velocity.squaredNorm() / 2 +
               plans_[i].inertia() * motion.spin * motion.spin / 2;
    }
    return sum;
}

const std::vector<std::string>& crowdNames() {
    static const std::vector<std::string> names = namesOf(crowds);
    return names;
}

Scene crowd(const std::string& name, Extent extent) {
    return variantOf("S8", Feature::bodies, "p99 overlap", crowds, name, extent);
}

}  // namespace sulfur::lab::bench
