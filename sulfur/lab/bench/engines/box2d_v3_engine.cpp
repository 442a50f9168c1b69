// Box2D 3, through its C interface. Its headers have the names of Box2D 2's: this file sees only
// these.
#include <box2d/box2d.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

namespace {

b2Vec2 vec(const Point& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

class Box2dV3World final : public EngineWorld {
public:
    explicit Box2dV3World(const Setting& setting) : setting_(setting) {
        b2WorldDef def = b2DefaultWorldDef();
        def.gravity = {0, setting.weightless ? 0 : static_cast<float>(-gravity)};
        def.enableSleep = setting.sleeping;
        def.workerCount = setting.threads;
        if (setting.contactHertz > 0) def.contactHertz = static_cast<float>(setting.contactHertz);
        world_ = b2CreateWorld(&def);
    }
    ~Box2dV3World() override { b2DestroyWorld(world_); }
    Box2dV3World(Box2dV3World&&) = delete;
    Box2dV3World& operator=(Box2dV3World&&) = delete;

    void addFixed(const Point& centre, const Point& half) override {
        b2BodyDef def = b2DefaultBodyDef();
        placeAt(def, centre);
        addBox(b2CreateBody(world_, &def), half);
    }

    void addSquare(const Point& centre, double angle, const Point& velocity) override {
        b2BodyDef def = b2DefaultBodyDef();
        def.type = b2_dynamicBody;
        placeAt(def, centre);
        def.rotation = b2MakeRot(static_cast<float>(angle));
        def.linearVelocity = vec(velocity);
        squares_.push_back(b2CreateBody(world_, &def));
        addBox(squares_.back(), Point(0.5, 0.5));
    }

    void addRope(const RopePlan& plan) override {
        constexpr double radius = 0.05;
        std::vector<b2BodyId> bodies;
        for (std::size_t i = 0; i < plan.points.size(); ++i) {
            bodies.push_back(addDisc(plan.points[i], radius, i == 0 ? 0 : plan.masses[i],
                                     /*group=*/-1));
            if (i == 0) continue;
            const double length = (plan.points[i] - plan.points[i - 1]).norm();
            const b2DistanceJointDef def = jointOf(bodies[i - 1], bodies[i], length);
            b2CreateDistanceJoint(world_, &def);
        }
        ropes_.push_back(std::move(bodies));
    }

    /// Springs are given by their frequency and damping ratio.
    void addNet(const NetPlan& plan) override {
        constexpr double radius = 0.01;
        std::vector<b2BodyId> bodies;
        for (std::size_t i = 0; i < plan.points.size(); ++i)
            bodies.push_back(addDisc(plan.points[i], radius, plan.masses[i], -1));
        for (std::size_t i = 0; i < bodies.size(); ++i)
            b2Body_SetLinearVelocity(bodies[i], vec(plan.velocities[i]));
        for (const NetPlan::Spring& spring : plan.springs) {
            b2DistanceJointDef def = jointOf(bodies[spring.a], bodies[spring.b], spring.length);
            if (spring.isRigid()) {
                b2CreateDistanceJoint(world_, &def);
                continue;
            }
            const double omega = std::sqrt(spring.stiffness / plan.reducedMass(spring));
            def.enableSpring = true;
            def.hertz = static_cast<float>(omega / (2 * std::numbers::pi));
            def.dampingRatio = static_cast<float>(spring.damping * omega / (2 * spring.stiffness));
            b2CreateDistanceJoint(world_, &def);
        }
        ropes_.push_back(std::move(bodies));
    }

    void addBlob(const Point& centre) override {
        const std::vector<Point> places = BlobPlan::places();
        const int group = -2 - static_cast<int>(blobs_.size());
        std::vector<b2BodyId> bodies;
        for (const Point& place : places)
            bodies.push_back(addDisc(centre + place, BlobPlan::radius,
                                     BlobPlan::mass / static_cast<double>(places.size()), group));
        for (const auto& [a, b] : BlobPlan::springs()) {
            b2DistanceJointDef def = jointOf(bodies[a], bodies[b], (places[b] - places[a]).norm());
            def.enableSpring = true;
            def.hertz = static_cast<float>(BlobPlan::hertz);
            def.dampingRatio = static_cast<float>(BlobPlan::dampingRatio);
            b2CreateDistanceJoint(world_, &def);
        }
        blobs_.push_back(std::move(bodies));
    }

    void addBody(const BodyPlan& plan) override {
        b2BodyDef def = b2DefaultBodyDef();
        def.type = plan.mover == Mover::physics ? b2_dynamicBody
                   : plan.mover == Mover::motor ? b2_kinematicBody
                                                : b2_staticBody;
        placeAt(def, plan.place);
        def.rotation = b2MakeRot(static_cast<float>(plan.angle));
        def.linearVelocity = vec(plan.velocity);
        def.angularVelocity = plan.mover == Mover::motor ? static_cast<float>(plan.spin) : 0;
        def.isAwake = !plan.asleep;
        bodies_.push_back({b2CreateBody(world_, &def), plan.sockets});
        b2ShapeDef shape = b2DefaultShapeDef();
        shape.density = static_cast<float>(plan.density);
        shape.material.friction = static_cast<float>(plan.friction);
        shape.material.restitution = static_cast<float>(plan.restitution);
        shape.filter.groupIndex = -plan.group;
        for (const Outline& part : plan.parts) addPart(bodies_.back().id, shape, part);
    }
    void removeBody(std::size_t i) override { b2DestroyBody(bodies_[i].id); }

    void addPin(const PinPlan& plan) override {
        b2RevoluteJointDef def = b2DefaultRevoluteJointDef();
        def.base.bodyIdA = bodies_[plan.a].id;
        def.base.bodyIdB = bodies_[plan.b].id;
        def.base.localFrameA.p = vec(bodies_[plan.a].sockets[plan.socketA]);
        def.base.localFrameB.p = vec(bodies_[plan.b].sockets[plan.socketB]);
        stiffen(def.base);
        b2CreateRevoluteJoint(world_, &def);
        pins_.push_back(plan);
    }

    void addJoint(const JointPlan& plan, const BodyPlan&, const BodyPlan&) override {
        const auto f = [](double x) { return static_cast<float>(x); };
        const double low = plan.lower.value_or(-1e6), high = plan.upper.value_or(1e6);
        kinds_.push_back(plan.kind);
        if (plan.kind == JointPlan::Kind::hinge) {
            b2RevoluteJointDef def = describe(plan, b2DefaultRevoluteJointDef());
            def.targetAngle = f(plan.rest);
            def.lowerAngle = f(low);
            def.upperAngle = f(high);
            def.maxMotorTorque = f(plan.motorMax);
            joints_.push_back(b2CreateRevoluteJoint(world_, &def));
        } else if (plan.kind == JointPlan::Kind::slider) {
            b2PrismaticJointDef def = describe(plan, b2DefaultPrismaticJointDef());
            def.targetTranslation = f(plan.rest);
            def.lowerTranslation = f(low);
            def.upperTranslation = f(high);
            def.maxMotorForce = f(plan.motorMax);
            joints_.push_back(b2CreatePrismaticJoint(world_, &def));
        } else if (plan.kind == JointPlan::Kind::wheel) {
            b2WheelJointDef def = describe(plan, b2DefaultWheelJointDef());
            def.lowerTranslation = f(low);
            def.upperTranslation = f(high);
            def.maxMotorTorque = f(plan.motorMax);
            joints_.push_back(b2CreateWheelJoint(world_, &def));
        } else {
            b2DistanceJointDef def = describe(plan, b2DefaultDistanceJointDef());
            def.enableSpring = true;  // without one it is a rod; one of 0 Hz does nothing
            def.length = f((plan.atB - plan.at).norm());
            def.minLength = f(plan.lower.value_or(0));
            def.maxLength = f(high);
            def.maxMotorForce = f(plan.motorMax);
            joints_.push_back(b2CreateDistanceJoint(world_, &def));
        }
    }
    void applyTorque(std::size_t body, double torque) override {
        b2Body_ApplyTorque(bodies_[body].id, static_cast<float>(torque), true);
    }
    void applyImpulse(std::size_t body, const Point& impulse, const Point& at) override {
        const b2Vec2 local = vec(localOf(body, at));
        const b2BodyId id = bodies_[body].id;
        b2Body_ApplyLinearImpulse(id, vec(impulse), b2Body_GetWorldPoint(id, local), true);
    }
    double motorForce(std::size_t joint) const override {
        const b2JointId id = joints_[joint];
        switch (kinds_[joint]) {
            case JointPlan::Kind::hinge:
                return static_cast<double>(b2RevoluteJoint_GetMotorTorque(id));
            case JointPlan::Kind::slider:
                return static_cast<double>(b2PrismaticJoint_GetMotorForce(id));
            case JointPlan::Kind::wheel:
                return static_cast<double>(b2WheelJoint_GetMotorTorque(id));
            case JointPlan::Kind::distance:
                return static_cast<double>(b2DistanceJoint_GetMotorForce(id));
        }
        return 0;
    }

    void step() override {
        b2World_Step(world_, 1 / static_cast<float>(setting_.rate), setting_.iterations);
        if (profiling_) addProfile();
    }

    std::pair<Point, double> square(std::size_t i) const override {
        return {positionOf(squares_[i]),
                static_cast<double>(b2Rot_GetAngle(b2Body_GetRotation(squares_[i])))};
    }
    std::vector<Point> rope(std::size_t i) const override { return places(ropes_[i]); }
    std::vector<Point> blob(std::size_t i) const override { return places(blobs_[i]); }

    Motion body(std::size_t i) const override {
        const b2BodyId id = bodies_[i].id;
        const b2Vec2 velocity = b2Body_GetLinearVelocity(id);
        return {.place = positionOf(id),
                .angle = static_cast<double>(b2Rot_GetAngle(b2Body_GetRotation(id))),
                .velocity = {static_cast<double>(velocity.x), static_cast<double>(velocity.y)},
                .spin = static_cast<double>(b2Body_GetAngularVelocity(id))};
    }
    std::pair<Point, Point> pin(std::size_t i) const override {
        const PinPlan& plan = pins_[i];
        return {body(plan.a).at(bodies_[plan.a].sockets[plan.socketA]),
                body(plan.b).at(bodies_[plan.b].sockets[plan.socketB])};
    }

    void setProfiling(bool on) override { profiling_ = on; }
    StageTimes stages() const override { return stages_; }

private:
    struct Kept {
        b2BodyId id;
        std::vector<Point> sockets;
    };

    static void addPart(b2BodyId body, const b2ShapeDef& def, const Outline& part) {
        const auto radius = static_cast<float>(part.radius);
        if (part.points.size() == 1) {
            const b2Circle circle{vec(part.points[0]), radius};
            b2CreateCircleShape(body, &def, &circle);
            return;
        }
        if (part.points.size() == 2) {
            const b2Capsule capsule{vec(part.points[0]), vec(part.points[1]), radius};
            b2CreateCapsuleShape(body, &def, &capsule);
            return;
        }
        std::vector<b2Vec2> points;
        for (const Point& p : part.points) points.push_back(vec(p));
        const b2Hull hull = b2ComputeHull(points.data(), static_cast<int>(points.size()));
        const b2Polygon polygon = b2MakePolygon(&hull, radius);
        b2CreatePolygonShape(body, &def, &polygon);
    }

    /// What all kinds have by the same names.
    template <class Def>
    Def describe(const JointPlan& plan, Def def) const {
        const bool distance = plan.kind == JointPlan::Kind::distance;
        def.base.bodyIdA = bodies_[plan.a].id;
        def.base.bodyIdB = bodies_[plan.b].id;
        def.base.localFrameA = frameOf(plan.a, plan.at, plan.axis);
        def.base.localFrameB = frameOf(plan.b, distance ? plan.atB : plan.at, plan.axis);
        stiffen(def.base);
        if (plan.heldHertz > 0) {
            def.base.constraintHertz = static_cast<float>(plan.heldHertz);
            def.base.constraintDampingRatio = static_cast<float>(plan.heldDampingRatio);
        }
        def.enableSpring = plan.hertz > 0;
        def.hertz = static_cast<float>(plan.hertz);
        def.dampingRatio = static_cast<float>(plan.dampingRatio);
        def.enableLimit = plan.lower || plan.upper;
        def.enableMotor = plan.motorMax > 0;
        def.motorSpeed = static_cast<float>(plan.motorSpeed);
        return def;
    }

    Point localOf(std::size_t which, const Point& at) const {
        const Motion now = body(which);
        return Motion{.place = {0, 0}, .angle = -now.angle}.at(at - now.place);
    }

    /// A place in the frame of a body, with the axis as its x.
    b2Transform frameOf(std::size_t which, const Point& at, const Point& axis) const {
        const double along = std::atan2(axis.y(), axis.x()) - body(which).angle;
        return {vec(localOf(which, at)), b2MakeRot(static_cast<float>(along))};
    }

    static void placeAt(b2BodyDef& def, const Point& p) {
        // Of another type where it was built for large worlds.
        def.position.x = static_cast<decltype(def.position.x)>(p.x());
        def.position.y = static_cast<decltype(def.position.y)>(p.y());
    }

    static b2ShapeDef shapeDef() {
        b2ShapeDef def = b2DefaultShapeDef();
        def.density = 1;
        def.material.friction = static_cast<float>(friction);
        return def;
    }

    static void addBox(b2BodyId body, const Point& half) {
        const b2ShapeDef def = shapeDef();
        const b2Polygon box = b2MakeBox(static_cast<float>(half.x()), static_cast<float>(half.y()));
        b2CreatePolygonShape(body, &def, &box);
    }

    /// A mass of 0 is fixed. Discs of one negative group do not touch each other.
    b2BodyId addDisc(const Point& centre, double radius, double mass, int group) {
        b2BodyDef bodyDef = b2DefaultBodyDef();
        bodyDef.type = mass > 0 ? b2_dynamicBody : b2_staticBody;
        placeAt(bodyDef, centre);
        const b2BodyId body = b2CreateBody(world_, &bodyDef);
        b2ShapeDef def = shapeDef();
        def.density = static_cast<float>(mass / (std::numbers::pi * radius * radius));
        def.filter.groupIndex = group;
        const b2Circle circle{{0, 0}, static_cast<float>(radius)};
        b2CreateCircleShape(body, &def, &circle);
        return body;
    }

    void stiffen(b2JointDef& def) const {
        if (setting_.stiffJoints) def.constraintHertz = 1e5F;
    }

    b2DistanceJointDef jointOf(b2BodyId a, b2BodyId b, double length) const {
        b2DistanceJointDef def = b2DefaultDistanceJointDef();
        def.base.bodyIdA = a;
        def.base.bodyIdB = b;
        def.length = static_cast<float>(length);
        stiffen(def.base);
        return def;
    }

    /// Box2D tells milliseconds of the last step.
    void addProfile() {
        const b2Profile p = b2World_GetProfile(world_);
        const std::array<std::pair<const char*, float>, 5> now{{{"pairs", p.pairs},
                                                                {"collide", p.collide},
                                                                {"constraints", p.constraints},
                                                                {"refit", p.refit},
                                                                {"whole step", p.step}}};
        if (stages_.empty())
            for (const auto& stage : now) stages_.emplace_back(stage.first, 0);
        for (std::size_t i = 0; i < now.size(); ++i)
            stages_[i].second += 1e-3 * static_cast<double>(now[i].second);
    }

    static Point positionOf(b2BodyId body) {
        const auto p = b2Body_GetPosition(body);
        return {static_cast<double>(p.x), static_cast<double>(p.y)};
    }
    static std::vector<Point> places(const std::vector<b2BodyId>& bodies) {
        std::vector<Point> all;
        for (const b2BodyId body : bodies) all.push_back(positionOf(body));
        return all;
    }

    Setting setting_;
    b2WorldId world_{};
    std::vector<b2BodyId> squares_;
    std::vector<Kept> bodies_;
    std::vector<PinPlan> pins_;
    std::vector<b2JointId> joints_;
    std::vector<JointPlan::Kind> kinds_;
    std::vector<std::vector<b2BodyId>> ropes_, blobs_;
    bool profiling_ = false;
    StageTimes stages_;
};

}  // namespace

std::unique_ptr<EngineWorld> makeBox2dV3(const Setting& setting) {
    return std::make_unique<Box2dV3World>(setting);
}

std::string box2dV3Version() {
    const b2Version v = b2GetVersion();
    return std::to_string(v.major) + '.' + std::to_string(v.minor) + '.' +
           std::to_string(v.revision);
}

}  // namespace sulfur::lab::bench
