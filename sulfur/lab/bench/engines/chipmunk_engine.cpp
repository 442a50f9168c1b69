// Chipmunk.
#include <chipmunk/chipmunk.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

namespace {

cpVect vec(const Point& p) {
    return cpv(p.x(), p.y());
}

/// Debian's Chipmunk greets on standard output when its first space is made. That is where the
/// results go, so it speaks to nobody.
cpSpace* quietFirstSpace() {
    std::fflush(stdout);
    const int kept = ::dup(STDOUT_FILENO);
    const int nobody = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept >= 0 && nobody >= 0) ::dup2(nobody, STDOUT_FILENO);
    cpSpace* space = cpSpaceNew();
    std::fflush(stdout);
    if (kept >= 0 && nobody >= 0) ::dup2(kept, STDOUT_FILENO);
    if (kept >= 0) ::close(kept);
    if (nobody >= 0) ::close(nobody);
    return space;
}

cpSpace* newSpace() {
    static bool greeted = false;
    if (greeted) return cpSpaceNew();
    greeted = true;
    return quietFirstSpace();
}

class ChipmunkWorld final : public EngineWorld {
public:
    explicit ChipmunkWorld(const Setting& setting) : setting_(setting), space_(newSpace()) {
        cpSpaceSetGravity(space_, cpv(0, setting.weightless ? 0 : -gravity));
        // Half a second, as Box2D has it; infinite, as at first: never.
        if (setting.sleeping) cpSpaceSetSleepTimeThreshold(space_, 0.5);
        cpSpaceSetIterations(space_, setting.iterations);
        // The default of 0.1 is meant for pixels.
        cpSpaceSetCollisionSlop(space_, 0.005);
    }
    ~ChipmunkWorld() override {
        for (cpConstraint* constraint : constraints_) {
            cpSpaceRemoveConstraint(space_, constraint);
            cpConstraintFree(constraint);
        }
        for (const Kept& kept : kept_)
            if (kept.body != nullptr) free(kept);
        for (cpShape* shape : shapes_) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        for (cpBody* body : bodies_) {
            cpSpaceRemoveBody(space_, body);
            cpBodyFree(body);
        }
        cpSpaceFree(space_);
    }
    ChipmunkWorld(ChipmunkWorld&&) = delete;
    ChipmunkWorld& operator=(ChipmunkWorld&&) = delete;

    void addFixed(const Point& centre, const Point& half) override {
        cpBody* ground = cpSpaceGetStaticBody(space_);
        const Point low = centre - half, high = centre + half;
        add(cpBoxShapeNew2(ground, cpBBNew(low.x(), low.y(), high.x(), high.y()), 0));
    }

    void addSquare(const Point& centre, double angle, const Point& velocity) override {
        cpBody* body = addBody(centre, 1, cpMomentForBox(1, 1, 1));
        cpBodySetAngle(body, angle);
        cpBodySetVelocity(body, vec(velocity));
        add(cpBoxShapeNew(body, 1, 1, 0));
        squares_.push_back(body);
    }

    void addRope(const RopePlan& plan) override {
        std::vector<cpBody*> bodies;
        for (std::size_t i = 0; i < plan.points.size(); ++i) {
            constexpr double radius = 0.05;
            if (i == 0) {
                bodies.push_back(cpSpaceGetStaticBody(space_));
                anchors_.push_back(plan.points[0]);
                continue;
            }
            const double mass = plan.masses[i];
            bodies.push_back(
                addBody(plan.points[i], mass, cpMomentForCircle(mass, 0, radius, cpvzero)));
            const cpVect from = i == 1 ? vec(plan.points[0]) : cpvzero;
            add(cpPinJointNew(bodies[i - 1], bodies[i], from, cpvzero));
        }
        ropes_.push_back(std::move(bodies));
    }

    void addNet(const NetPlan& plan) override {
        constexpr double radius = 0.01;
        std::vector<cpBody*> bodies;
        for (std::size_t i = 0; i < plan.points.size(); ++i) {
            const double mass = plan.masses[i];
            if (mass > 0) {
                bodies.push_back(
                    addBody(plan.points[i], mass, cpMomentForCircle(mass, 0, radius, cpvzero)));
            } else {
                bodies.push_back(cpSpaceAddBody(space_, cpBodyNewStatic()));
                cpBodySetPosition(bodies.back(), vec(plan.points[i]));
                bodies_.push_back(bodies.back());
            }
        }
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (plan.masses[i] > 0) cpBodySetVelocity(bodies[i], vec(plan.velocities[i]));
        for (const NetPlan::Spring& spring : plan.springs) {
            if (spring.isRigid()) {
                cpConstraint* link =
                    cpPinJointNew(bodies[spring.a], bodies[spring.b], cpvzero, cpvzero);
                cpPinJointSetDist(link, spring.length);
                add(link);
                continue;
            }
            add(cpDampedSpringNew(bodies[spring.a], bodies[spring.b], cpvzero, cpvzero,
                                  spring.length, spring.stiffness, spring.damping));
        }
        anchors_.push_back(plan.points.front());
        ropes_.push_back(std::move(bodies));
    }

    void addBlob(const Point& centre) override {
        const std::vector<Point> places = BlobPlan::places();
        const double mass = BlobPlan::mass / static_cast<double>(places.size());
        std::vector<cpBody*> bodies;
        for (const Point& place : places) {
            bodies.push_back(addBody(centre + place, mass,
                                     cpMomentForCircle(mass, 0, BlobPlan::radius, cpvzero)));
            cpShape* shape = add(cpCircleShapeNew(bodies.back(), BlobPlan::radius, cpvzero));
            cpShapeSetFilter(
                shape, cpShapeFilterNew(blobs_.size() + 1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
        }
        for (const auto& [a, b] : BlobPlan::springs())
            add(cpDampedSpringNew(bodies[a], bodies[b], cpvzero, cpvzero,
                                  (places[b] - places[a]).norm(), BlobPlan::stiffness,
                                  BlobPlan::damping));
        blobs_.push_back(std::move(bodies));
    }

    void addBody(const BodyPlan& plan) override {
        const bool moves = plan.mover == Mover::physics;
        cpBody* body = moves                        ? cpBodyNew(plan.mass(), plan.inertia())
                       : plan.mover == Mover::motor ? cpBodyNewKinematic()
                                                    : cpBodyNewStatic();
        cpSpaceAddBody(space_, body);
        cpBodySetPosition(body, vec(plan.place));
        cpBodySetAngle(body, plan.angle);
        cpBodySetVelocity(body, vec(plan.velocity));
        if (plan.mover == Mover::motor) cpBodySetAngularVelocity(body, plan.spin);
        Kept kept{body, {}, plan.sockets};
        for (const Outline& part : plan.parts) {
            cpShape* shape = cpSpaceAddShape(space_, shapeOf(body, part));
            cpShapeSetFriction(shape, std::sqrt(plan.friction));
            // It multiplies these too.
            cpShapeSetElasticity(shape, std::sqrt(plan.restitution));
            if (plan.group != 0)
                cpShapeSetFilter(shape, cpShapeFilterNew(static_cast<cpGroup>(plan.group),
                                                         CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
            kept.shapes.push_back(shape);
        }
        cpSpaceReindexShapesForBody(space_, body);
        kept_.push_back(std::move(kept));
    }
    void removeBody(std::size_t i) override {
        free(kept_[i]);
        kept_[i].body = nullptr;
    }

    void addPin(const PinPlan& plan) override {
        const Kept &a = kept_[plan.a], &b = kept_[plan.b];
        add(cpPivotJointNew2(a.body, b.body, vec(a.sockets[plan.socketA]),
                             vec(b.sockets[plan.socketB])));
        pins_.push_back(plan);
    }

    void step() override { cpSpaceStep(space_, 1.0 / setting_.rate); }

    std::pair<Point, double> square(std::size_t i) const override {
        return {positionOf(squares_[i]), cpBodyGetAngle(squares_[i])};
    }
    std::vector<Point> rope(std::size_t i) const override {
        std::vector<Point> all = places(ropes_[i]);
        // The world's own static body stands at the origin, wherever a rope is held.
        if (ropes_[i].front() == cpSpaceGetStaticBody(space_)) all.front() = anchors_[i];
        return all;
    }
    std::vector<Point> blob(std::size_t i) const override { return places(blobs_[i]); }
    Motion body(std::size_t i) const override {
        const cpBody* body = kept_[i].body;
        const cpVect velocity = cpBodyGetVelocity(body);
        return {positionOf(body), cpBodyGetAngle(body), Point(velocity.x, velocity.y),
                cpBodyGetAngularVelocity(body)};
    }
    std::pair<Point, Point> pin(std::size_t i) const override {
        const PinPlan& plan = pins_[i];
        return {body(plan.a).at(kept_[plan.a].sockets[plan.socketA]),
                body(plan.b).at(kept_[plan.b].sockets[plan.socketB])};
    }

private:
    struct Kept {
        cpBody* body;
        std::vector<cpShape*> shapes;
        std::vector<Point> sockets;
    };

    void free(const Kept& kept) {
        for (cpShape* shape : kept.shapes) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        cpSpaceRemoveBody(space_, kept.body);
        cpBodyFree(kept.body);
    }

    static cpShape* shapeOf(cpBody* body, const Outline& part) {
        if (part.points.size() == 1)
            return cpCircleShapeNew(body, part.radius, vec(part.points[0]));
        if (part.points.size() == 2)
            return cpSegmentShapeNew(body, vec(part.points[0]), vec(part.points[1]), part.radius);
        std::vector<cpVect> points;
        for (const Point& p : part.points) points.push_back(vec(p));
        return cpPolyShapeNew(body, static_cast<int>(points.size()), points.data(),
                              cpTransformIdentity, part.radius);
    }

    /// Takes the shape. Chipmunk multiplies the friction of two surfaces.
    cpShape* add(cpShape* shape) {
        cpShapeSetFriction(shape, std::sqrt(friction));
        shapes_.push_back(cpSpaceAddShape(space_, shape));
        return shape;
    }
    void add(cpConstraint* constraint) {
        constraints_.push_back(cpSpaceAddConstraint(space_, constraint));
    }
    cpBody* addBody(const Point& centre, double mass, double inertia) {
        cpBody* body = cpSpaceAddBody(space_, cpBodyNew(mass, inertia));
        cpBodySetPosition(body, vec(centre));
        bodies_.push_back(body);
        return body;
    }
    static Point positionOf(const cpBody* body) {
        const cpVect p = cpBodyGetPosition(body);
        return {p.x, p.y};
    }
    static std::vector<Point> places(const std::vector<cpBody*>& bodies) {
        std::vector<Point> all;
        for (const cpBody* body : bodies) all.push_back(positionOf(body));
        return all;
    }

    Setting setting_;
    cpSpace* space_;
    std::vector<cpBody*> bodies_, squares_;
    std::vector<cpShape*> shapes_;
    std::vector<Kept> kept_;
    std::vector<PinPlan> pins_;
    std::vector<cpConstraint*> constraints_;
    std::vector<std::vector<cpBody*>> ropes_, blobs_;
    std::vector<Point> anchors_;
};

}  // namespace

std::unique_ptr<EngineWorld> makeChipmunk(const Setting& setting) {
    return std::make_unique<ChipmunkWorld>(setting);
}

std::string chipmunkVersion() {
    return cpVersionString;
}

}  // namespace sulfur::lab::bench
