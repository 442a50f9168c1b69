// S8: the scenes with which Box2D 3 measures itself, rebuilt for every engine. Sizes, speeds and
// densities are its own; gravity and friction are this comparison's, except where its scene sets
// them.
#pragma once

#include <string>
#include <vector>

#include "bench/bodies.hpp"
#include "bench/scenes.hpp"
#include "bench/variants.hpp"

namespace sulfur::lab::bench {

/// What the scenes of S8 have in common: many bodies of any kind, whose overlaps are looked at four
/// times a second in the second half of the run.
class Crowd : public Play {
public:
    explicit Crowd(double seconds) : seconds_(seconds) {}

    void look(const EngineWorld& world, double time) override;
    Figures figures(const EngineWorld& world) override;

protected:
    /// Makes a body and returns its number.
    std::size_t add(EngineWorld& world, BodyPlan plan);
    /// A fixed upright rectangle with the friction of a body.
    void addWall(EngineWorld& world, const Point& centre, const Point& half);
    void remove(EngineWorld& world, std::size_t body);

    /// Whether a body that physics moves has left the scene.
    virtual bool lost(const BodyPlan&, const Motion&, double /*time*/) const { return false; }
    /// At each look.
    virtual void note(const EngineWorld&, double /*time*/) {}
    /// What this scene has to tell beside overlaps.
    virtual Figures more(const EngineWorld&) { return {}; }

    std::size_t count() const { return plans_.size(); }
    const BodyPlan& plan(std::size_t body) const { return plans_[body]; }
    /// Whether physics moves it and it was not removed.
    bool moves(std::size_t body) const;
    /// Of all that physics moves, J, with the spins of the solids.
    double kineticEnergy(const EngineWorld& world) const;

private:
    void sample(const EngineWorld& world, double time);

    double seconds_, lastTime_ = 0, nextSample_ = 0, fastest_ = 0;
    int samples_ = 0;
    std::vector<BodyPlan> plans_;
    std::vector<bool> removed_;
    std::vector<double> depths_;
};

/// Names of the scenes of S8: "tumbler", "spinner" and so on.
const std::vector<std::string>& crowdNames();
/// `name` must be one of them. With Extent::quick it is small and short.
Scene crowd(const std::string& name, Extent extent);

VariantScene tumbler(Extent extent);
VariantScene spinner(Extent extent);
VariantScene smash(Extent extent);
VariantScene rain(Extent extent);
VariantScene barrels(Extent extent);
VariantScene compounds(Extent extent);
VariantScene largePyramid(Extent extent);
VariantScene manyPyramids(Extent extent);
VariantScene jointGrid(Extent extent);

}  // namespace sulfur::lab::bench
