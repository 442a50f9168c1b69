// Ours.
#include <array>
#include <cmath>
#include <numbers>
#include <sulfur/sulfur.hpp>

#include "battery/scenes.hpp"
#include "bench/engine.hpp"
#include "bench/engines/sulfur_blueprints.hpp"
#include "bench/threads.hpp"

namespace sulfur::lab::bench {

namespace {

constexpr Material surface{.staticFriction = Real(friction), .kineticFriction = Real(friction)};

class SulfurWorld final : public EngineWorld {
public:
    explicit SulfurWorld(const Setting& setting)
        : world_({.gravity = vec2(0, setting.weightless ? 0 : -gravity),
                  .tickRate = setting.rate,
                  .sleeping = setting.sleeping,
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
        static const Blueprint plan =
            shapes::box({.radius = real(cornerRadius()), .material = surface});
        squares_.push_back(world_.add(plan, {.position = centre, .angle = angle}));
        if (!velocity.isZero()) world_.setVelocity(squares_.back(), velocity.cast<Real>());
    }

    void addRope(const RopePlan& plan) override {
        // The library's rope has links and masses of one size each; then the masses are set.
        Blueprint rope = shapes::rope({.from = plan.points.front().cast<Real>(),
                                       .to = plan.points.back().cast<Real>(),
                                       .links = static_cast<int>(plan.points.size()) - 1,
                                       .radius = 0,
                                       .bending = 0,
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

    /// Whatever begins asleep falls asleep by itself soon.
    void addBody(const BodyPlan& plan) override {
        const Blueprint blueprint = blueprintOf(plan);
        const Body body = world_.add(blueprint, {plan.place, plan.angle});
        if (!plan.velocity.isZero()) world_.setVelocity(body, plan.velocity.cast<Real>());
        if (plan.mover == Mover::motor)
            motors_.push_back({body, {plan.place, plan.angle}, plan.spin});
        Kept kept{body, blueprint.particles[0].position.cast<double>(), {}};
        if (blueprint.particles.size() > 1)
            kept.second = blueprint.particles[1].position.cast<double>();
        for (const Point& socket : plan.sockets) kept.sockets.push_back(socket.cast<Real>());
        bodies_.push_back(std::move(kept));
    }
    void removeBody(std::size_t i) override { world_.remove(bodies_[i].body); }

    /// A particle of what can move is held at the place of the other socket.
    void addPin(const PinPlan& plan) override {
        const Body &a = bodies_[plan.a].body, &b = bodies_[plan.b].body;
        const ParticleId socketA = a[1 + plan.socketA], socketB = b[1 + plan.socketB];
        pins_.emplace_back(socketA, socketB);
        if (world_.kind(a) == BodyKind::dynamic)
            world_.attach(socketA, b, bodies_[plan.b].sockets[plan.socketB]);
        else
            world_.attach(socketB, a, bodies_[plan.a].sockets[plan.socketA]);
    }

    void addJoint(const JointPlan& plan, const BodyPlan& a, const BodyPlan& b) override {
        const BodyId first = bodies_[plan.a].body, second = bodies_[plan.b].body;
        const bool angular = plan.kind == JointPlan::Kind::hinge;
        const auto inertiaOf = [&](const BodyPlan& body) {
            if (body.mover != Mover::physics) return 0.0;
            return angular ? body.inertia() : body.mass();
        };
        const double omega = 2 * std::numbers::pi * plan.hertz;
        const double inertia = reduced(inertiaOf(a), inertiaOf(b));
        Drive way, motor;
        way.lower = plan.lower ? real(*plan.lower) : -infinite;
        way.upper = plan.upper ? real(*plan.upper) : infinite;
        way.stiffness = real(inertia * omega * omega);
        way.damping = real(2 * plan.dampingRatio * inertia * omega);
        way.rest = real(plan.rest);
        motor.motorSpeed = real(plan.motorSpeed);
        motor.motorMax = real(plan.motorMax);
        if (plan.kind == JointPlan::Kind::wheel) {
            joints_.push_back(world_
                                  .wheel(first, second, plan.at, plan.axis.cast<Real>(),
                                         {.spring = way, .motor = motor})
                                  .motor);
            return;
        }
        way.motorSpeed = motor.motorSpeed;
        way.motorMax = motor.motorMax;
        if (plan.kind == JointPlan::Kind::distance)
            joints_.push_back(world_.distance(first, plan.at, second, plan.atB, {.drive = way}));
        else if (angular)
            joints_.push_back(world_.hinge(first, second, plan.at, {.drive = way}));
        else
            joints_.push_back(world_.slider(first, second, plan.at, plan.axis.cast<Real>(),
                                            {.drive = way, .turns = false}));
    }
    void applyTorque(std::size_t body, double torque) override {
        world_.applyTorque(bodies_[body].body, real(torque));
    }
    void applyImpulse(std::size_t body, const Point& impulse, const Point& at) override {
        world_.applyImpulse(bodies_[body].body, impulse.cast<Real>(), at);
    }
    double inertia(std::size_t i, const BodyPlan&) const override {
        return static_cast<double>(world_.inertia(bodies_[i].body));
    }
    double motorForce(std::size_t joint) const override {
        return static_cast<double>(world_.info(joints_[joint]).force);
    }

    void step() override {
        for (Motor& motor : motors_) {
            motor.pose.angle += motor.spin * static_cast<double>(world_.tickDuration());
            world_.moveTo(motor.body, motor.pose);
        }
        world_.step();
        if (!profiling_) return;
        const auto& seconds = world_.statistics().seconds;
        for (std::size_t i = 0; i < seconds.size(); ++i) seconds_[i] += seconds[i];
    }

    double cornerRadius() const override { return 0.01; }

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

    Motion body(std::size_t i) const override {
        const Kept& kept = bodies_[i];
        Motion motion{.place = world_.position(kept.body[0]),
                      .velocity = world_.meanVelocity(kept.body).cast<double>()};
        if (kept.body.size() == 1) {
            motion.angle = world_.angle(kept.body);
            motion.spin = world_.angularVelocity(kept.body);
            return motion;
        }
        const ParticleId first = kept.body[0], second = kept.body[1];
        const Point side = kept.second - kept.first;
        const Point now = world_.position(second) - world_.position(first);
        motion.angle = std::atan2(cross(side, now), side.dot(now));
        motion.place = Motion{.place = motion.place, .angle = motion.angle}.at(-kept.first);
        const Vec2 apart = world_.velocity(second) - world_.velocity(first);
        motion.spin = cross(now, apart.cast<double>()) / now.squaredNorm();
        return motion;
    }
    std::pair<Point, Point> pin(std::size_t i) const override {
        return {world_.position(pins_[i].first), world_.position(pins_[i].second)};
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
    /// A body with the places of its first two particles in its plan.
    struct Kept {
        Body body;
        Point first{0, 0}, second{0, 0};
        std::vector<Vec2> sockets = {};
    };
    struct Motor {
        Body body;
        Pose pose;
        double spin = 0;  // rad/s
    };

    std::vector<Point> places(const Body& body) const {
        std::vector<Point> all;
        for (const ParticleId id : body.particles()) all.push_back(world_.position(id));
        return all;
    }

    World world_;
    std::vector<Body> squares_, ropes_, blobs_;
    std::vector<Kept> bodies_;
    std::vector<Motor> motors_;
    std::vector<std::pair<ParticleId, ParticleId>> pins_;
    std::vector<MechanismId> joints_;
    bool profiling_ = false;
    std::array<double, static_cast<std::size_t>(Stage::count)> seconds_{};
};

}  // namespace

std::unique_ptr<EngineWorld> makeSulfur(const Setting& setting) {
    return std::make_unique<SulfurWorld>(setting);
}

}  // namespace sulfur::lab::bench
