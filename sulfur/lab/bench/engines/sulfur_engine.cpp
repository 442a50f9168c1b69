// Ours.
#include <array>
#include <cmath>
#include <sulfur/sulfur.hpp>

#include "battery/scenes.hpp"
#include "bench/engine.hpp"
#include "bench/threads.hpp"

namespace sulfur::lab::bench {

namespace {

constexpr Material surface{.staticFriction = Real(friction), .kineticFriction = Real(friction)};

class SulfurWorld final : public EngineWorld {
public:
    explicit SulfurWorld(const Setting& setting)
        : world_({.gravity = vec2(0, -gravity),
                  .tickRate = setting.rate,
                  .sleeping = false,
                  .sweeps = setting.iterations}) {
        world_.setTasks(tasksFor(static_cast<std::size_t>(setting.threads)));
    }

    void addFixed(const Point& centre, const Point& half) override {
        Blueprint body =
            shapes::box({.size = vec2(2 * half.x(), 2 * half.y()), .material = surface});
        body.kind = BodyKind::fixed;
        world_.add(body, {.position = centre});
    }

    void addSquare(const Point& centre, double angle, const Point& velocity) override {
        // Overlaps are measured between sharp squares, beyond which a round corner reaches by 0.41
        // radii when it touches a face.
        static const Blueprint plan = shapes::box({.radius = Real(0.01), .material = surface});
        squares_.push_back(world_.add(plan, {.position = centre, .angle = angle}));
        if (!velocity.isZero()) world_.setVelocity(squares_.back(), velocity.cast<Real>());
    }

    void addRope(const RopePlan& plan) override {
        // The library's rope has links and masses of one size each; then the masses are set.
        Blueprint rope = shapes::rope({.from = plan.points.front().cast<Real>(),
                                       .to = plan.points.back().cast<Real>(),
                                       .links = static_cast<int>(plan.points.size()) - 1,
                                       .radius = 0,
                                       .pinFirst = true});
        for (std::size_t i = 1; i < plan.points.size(); ++i)
            rope.particles[i].mass = real(plan.masses[i]);
        ropes_.push_back(world_.add(rope));
    }

    void addBlob(const Point& centre) override {
        // Its capsules are as thick as the discs of the plan, and their axes are where the discs
        // have their centres.
        static const Blueprint plan = [] {
            constexpr double size = (BlobPlan::side - 1) * BlobPlan::spacing + 2 * BlobPlan::radius;
            return shapes::jelly({.size = vec2(size, size),
                                  .columns = BlobPlan::side,
                                  .rows = BlobPlan::side,
                                  .mass = real(BlobPlan::mass),
                                  .radius = real(BlobPlan::radius),
                                  .stiffness = real(BlobPlan::stiffness),
                                  .damping = real(BlobPlan::damping),
                                  .material = surface});
        }();
        blobs_.push_back(world_.add(plan, {.position = centre}));
    }

    void step() override {
        world_.step();
        if (!profiling_) return;
        const auto& seconds = world_.statistics().seconds;
        for (std::size_t i = 0; i < seconds.size(); ++i) seconds_[i] += seconds[i];
    }

    std::pair<Point, double> square(std::size_t i) const override {
        const auto corners = squares_[i].particles();
        Point centre(0, 0);
        for (std::size_t k = 0; k < 4; ++k) centre += world_.position(corners[k]) / 4;
        const Point side = world_.position(corners[1]) - world_.position(corners[0]);
        return {centre, std::atan2(side.y(), side.x())};
    }
    std::vector<Point> rope(std::size_t i) const override { return places(ropes_[i]); }
    std::vector<Point> blob(std::size_t i) const override {
        std::vector<Point> all = places(blobs_[i]);
        all.resize(BlobPlan::side * BlobPlan::side);  // without a core in the middle
        return all;
    }

    void setProfiling(bool on) override {
        profiling_ = on;
        world_.setProfiling(on);
    }
    StageTimes stages() const override {
        StageTimes times;
        for (std::size_t i = 0; i < seconds_.size(); ++i)
            times.emplace_back(name(static_cast<Stage>(i)), seconds_[i]);
        return times;
    }

private:
    std::vector<Point> places(const Body& body) const {
        std::vector<Point> all;
        for (const ParticleId id : body.particles()) all.push_back(world_.position(id));
        return all;
    }

    World world_;
    std::vector<Body> squares_, ropes_, blobs_;
    bool profiling_ = false;
    std::array<double, static_cast<std::size_t>(Stage::count)> seconds_{};
};

}  // namespace

std::unique_ptr<EngineWorld> makeSulfur(const Setting& setting) {
    return std::make_unique<SulfurWorld>(setting);
}

}  // namespace sulfur::lab::bench
