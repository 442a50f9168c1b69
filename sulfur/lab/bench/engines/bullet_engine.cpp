// Bullet: three dimensions, of which two are used. Squares are cubes that may neither leave the
// plane nor tip out of it; ropes are its soft ropes.
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <string>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

namespace {

btVector3 vec(const Point& p) {
    return {static_cast<btScalar>(p.x()), static_cast<btScalar>(p.y()), 0};
}

class BulletWorld final : public EngineWorld {
public:
    explicit BulletWorld(const Setting& setting)
        : setting_(setting),
          dispatcher_(&configuration_),
          world_(&dispatcher_, &broadPhase_, &solver_, &configuration_) {
        world_.setGravity(btVector3(0, static_cast<btScalar>(-gravity), 0));
        world_.getSolverInfo().m_numIterations = setting.iterations;
        softInfo_.m_gravity = world_.getGravity();
        softInfo_.m_broadphase = &broadPhase_;
        softInfo_.m_dispatcher = &dispatcher_;
        softInfo_.m_sparsesdf.Initialize();
    }
    ~BulletWorld() override {
        for (const auto& rope : ropes_) world_.removeSoftBody(rope.get());
        for (const auto& body : fixed_) world_.removeRigidBody(body.get());
        for (const auto& body : squares_) world_.removeRigidBody(body.get());
    }
    BulletWorld(BulletWorld&&) = delete;
    BulletWorld& operator=(BulletWorld&&) = delete;

    void addFixed(const Point& centre, const Point& half) override {
        const btVector3 size(static_cast<btScalar>(half.x()), static_cast<btScalar>(half.y()), 1);
        shapes_.push_back(std::make_unique<btBoxShape>(size));
        fixed_.push_back(std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(0, nullptr, shapes_.back().get())));
        add(*fixed_.back(), centre, 0);
    }

    void addSquare(const Point& centre, double angle, const Point& velocity) override {
        if (!squareShape_) {
            constexpr btScalar half(0.5);
            squareShape_ = std::make_unique<btBoxShape>(btVector3(half, half, half));
        }
        btVector3 inertia;
        squareShape_->calculateLocalInertia(1, inertia);
        squares_.push_back(std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(1, nullptr, squareShape_.get(), inertia)));
        btRigidBody& body = *squares_.back();
        add(body, centre, angle);
        body.setLinearFactor(btVector3(1, 1, 0));
        body.setAngularFactor(btVector3(0, 0, 1));
        body.setLinearVelocity(vec(velocity));
        body.setActivationState(DISABLE_DEACTIVATION);
    }

    void addRope(const RopePlan& plan) override {
        std::vector<btVector3> places;
        std::vector<btScalar> masses;
        for (std::size_t i = 0; i < plan.points.size(); ++i) {
            places.push_back(vec(plan.points[i]));
            // A soft body's node of mass 0 is held.
            masses.push_back(i == 0 ? btScalar(0) : static_cast<btScalar>(plan.masses[i]));
        }
        ropes_.push_back(std::make_unique<btSoftBody>(&softInfo_, static_cast<int>(places.size()),
                                                      places.data(), masses.data()));
        btSoftBody& rope = *ropes_.back();
        for (int i = 1; i < static_cast<int>(places.size()); ++i) rope.appendLink(i - 1, i);
        rope.m_materials[0]->m_kLST = 1;
        rope.m_cfg.kDP = 0;
        rope.m_cfg.piterations = setting_.iterations;
        rope.m_cfg.collisions = 0;
        rope.setActivationState(DISABLE_DEACTIVATION);
        world_.addSoftBody(&rope);
    }

    /// Never asked: its soft bodies are of three dimensions.
    void addBlob(const Point&) override {}

    void step() override {
        const btScalar tick = btScalar(1) / static_cast<btScalar>(setting_.rate);
        world_.stepSimulation(tick, 0, tick);
    }

    std::pair<Point, double> square(std::size_t i) const override {
        const btTransform& frame = squares_[i]->getWorldTransform();
        const btVector3 right = frame.getBasis().getColumn(0);
        return {pointOf(frame.getOrigin()),
                std::atan2(static_cast<double>(right.y()), static_cast<double>(right.x()))};
    }
    std::vector<Point> rope(std::size_t i) const override {
        std::vector<Point> all;
        for (int k = 0; k < ropes_[i]->m_nodes.size(); ++k)
            all.push_back(pointOf(ropes_[i]->m_nodes[k].m_x));
        return all;
    }
    std::vector<Point> blob(std::size_t) const override { return {}; }

private:
    static Point pointOf(const btVector3& v) {
        return {static_cast<double>(v.x()), static_cast<double>(v.y())};
    }

    void add(btRigidBody& body, const Point& centre, double angle) {
        const btQuaternion turn(btVector3(0, 0, 1), static_cast<btScalar>(angle));
        body.setWorldTransform(btTransform(turn, vec(centre)));
        // Bullet multiplies the friction of two surfaces.
        body.setFriction(static_cast<btScalar>(std::sqrt(friction)));
        world_.addRigidBody(&body);
    }

    Setting setting_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadPhase_;
    btSequentialImpulseConstraintSolver solver_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::unique_ptr<btBoxShape> squareShape_;
    btSoftRigidDynamicsWorld world_;
    btSoftBodyWorldInfo softInfo_;
    std::vector<std::unique_ptr<btRigidBody>> fixed_, squares_;
    std::vector<std::unique_ptr<btSoftBody>> ropes_;
};

}  // namespace

std::unique_ptr<EngineWorld> makeBullet(const Setting& setting) {
    return std::make_unique<BulletWorld>(setting);
}

std::string bulletVersion() {
    const int v = btGetVersion();
    return std::to_string(v / 100) + '.' + std::to_string(v % 100);
}

}  // namespace sulfur::lab::bench
