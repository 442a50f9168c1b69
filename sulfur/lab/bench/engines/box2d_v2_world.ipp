// What the adaptors of Box2D 2.4 and of LiquidFun, which contains Box2D 2.3, have in common.
// Included by both after the headers of their own library; each has its own copy.

inline b2Vec2 vec(const Point& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

inline Point pointOf(const b2Vec2& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// All but blobs and the step.
class ClassicWorld : public EngineWorld {
public:
    explicit ClassicWorld(const Setting& setting)
        : setting_(setting),
          world_(b2Vec2(0, setting.weightless ? 0 : static_cast<float>(-gravity))) {
        world_.SetAllowSleeping(setting.sleeping);
    }

    void addFixed(const Point& centre, const Point& half) override {
        b2BodyDef def;
        def.position = vec(centre);
        addBox(world_.CreateBody(&def), half);
    }

    void addSquare(const Point& centre, double angle, const Point& velocity) override {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = vec(centre);
        def.angle = static_cast<float>(angle);
        def.linearVelocity = vec(velocity);
        squares_.push_back(world_.CreateBody(&def));
        addBox(squares_.back(), Point(0.5, 0.5));
    }

    void addRope(const RopePlan& plan) override {
        constexpr double radius = 0.05;
        std::vector<b2Body*> bodies;
        for (std::size_t i = 0; i < plan.points.size(); ++i) {
            bodies.push_back(addDisc(plan.points[i], radius, i == 0 ? 0 : plan.masses[i], -1));
            if (i == 0) continue;
            b2DistanceJointDef def;
            def.Initialize(bodies[i - 1], bodies[i], vec(plan.points[i - 1]), vec(plan.points[i]));
            world_.CreateJoint(&def);
        }
        ropes_.push_back(std::move(bodies));
    }

    /// It has no capsules: each is a rectangle and two discs, with the mass that the plan has.
    void addBody(const BodyPlan& plan) override {
        b2BodyDef def;
        def.type = plan.mover == Mover::physics ? b2_dynamicBody
                   : plan.mover == Mover::motor ? b2_kinematicBody
                                                : b2_staticBody;
        def.position = vec(plan.place);
        def.angle = static_cast<float>(plan.angle);
        def.linearVelocity = vec(plan.velocity);
        def.angularVelocity = plan.mover == Mover::motor ? static_cast<float>(plan.spin) : 0;
        def.awake = !plan.asleep;
        b2Body* body = world_.CreateBody(&def);
        for (const Outline& part : plan.parts) addPart(body, plan, part);
        if (plan.mover == Mover::physics) {
            b2MassData data;
            data.mass = static_cast<float>(plan.mass());
            data.center.SetZero();
            data.I = static_cast<float>(plan.inertia());
            body->SetMassData(&data);
        }
        bodies_.push_back({body, plan.sockets});
    }
    void removeBody(std::size_t i) override { world_.DestroyBody(bodies_[i].body); }

    void addPin(const PinPlan& plan) override {
        b2RevoluteJointDef def;
        def.bodyA = bodies_[plan.a].body;
        def.bodyB = bodies_[plan.b].body;
        def.localAnchorA = vec(bodies_[plan.a].sockets[plan.socketA]);
        def.localAnchorB = vec(bodies_[plan.b].sockets[plan.socketB]);
        world_.CreateJoint(&def);
        pins_.push_back(plan);
    }

    Motion body(std::size_t i) const override {
        const b2Body* body = bodies_[i].body;
        return {pointOf(body->GetPosition()), static_cast<double>(body->GetAngle()),
                pointOf(body->GetLinearVelocity()),
                static_cast<double>(body->GetAngularVelocity())};
    }
    std::pair<Point, Point> pin(std::size_t i) const override {
        const PinPlan& plan = pins_[i];
        return {body(plan.a).at(bodies_[plan.a].sockets[plan.socketA]),
                body(plan.b).at(bodies_[plan.b].sockets[plan.socketB])};
    }

    std::pair<Point, double> square(std::size_t i) const override {
        return {pointOf(squares_[i]->GetPosition()), static_cast<double>(squares_[i]->GetAngle())};
    }
    std::vector<Point> rope(std::size_t i) const override { return places(ropes_[i]); }

protected:
    static std::vector<Point> places(const std::vector<b2Body*>& bodies) {
        std::vector<Point> all;
        for (const b2Body* body : bodies) all.push_back(pointOf(body->GetPosition()));
        return all;
    }

    /// A mass of 0 is fixed. Discs of one negative group do not touch each other.
    b2Body* addDisc(const Point& centre, double radius, double mass, int group) {
        b2BodyDef bodyDef;
        bodyDef.type = mass > 0 ? b2_dynamicBody : b2_staticBody;
        bodyDef.position = vec(centre);
        b2Body* body = world_.CreateBody(&bodyDef);
        b2CircleShape circle;
        circle.m_radius = static_cast<float>(radius);
        b2FixtureDef def;
        def.shape = &circle;
        def.friction = static_cast<float>(friction);
        def.density = static_cast<float>(mass / (std::numbers::pi * radius * radius));
        def.filter.groupIndex = static_cast<std::int16_t>(group);
        body->CreateFixture(&def);
        return body;
    }

    /// Numbers bodies that were joined elsewhere with the ropes.
    void keepRope(std::vector<b2Body*> bodies) { ropes_.push_back(std::move(bodies)); }

    Setting setting_;
    b2World world_;

private:
    static void addBox(b2Body* body, const Point& half) {
        b2PolygonShape box;
        box.SetAsBox(static_cast<float>(half.x()), static_cast<float>(half.y()));
        b2FixtureDef def;
        def.shape = &box;
        def.density = 1;
        def.friction = static_cast<float>(friction);
        body->CreateFixture(&def);
    }

    struct Kept {
        b2Body* body;
        std::vector<Point> sockets;
    };

    static void addPart(b2Body* body, const BodyPlan& plan, const Outline& part) {
        b2FixtureDef def;
        def.density = static_cast<float>(plan.density);
        def.friction = static_cast<float>(plan.friction);
        def.restitution = static_cast<float>(plan.restitution);
        def.filter.groupIndex = static_cast<std::int16_t>(-plan.group);
        const auto radius = static_cast<float>(part.radius);
        for (const Point& p : part.points) {
            if (part.points.size() > 2) break;
            b2CircleShape circle;
            circle.m_p = vec(p);
            circle.m_radius = radius;
            def.shape = &circle;
            body->CreateFixture(&def);
        }
        if (part.points.size() == 1) return;
        b2PolygonShape polygon;
        if (part.points.size() == 2) {
            const Point along = part.points[1] - part.points[0];
            polygon.SetAsBox(static_cast<float>(along.norm() / 2), radius,
                             vec((part.points[0] + part.points[1]) / 2),
                             static_cast<float>(std::atan2(along.y(), along.x())));
        } else {
            std::vector<b2Vec2> points;
            for (const Point& p : part.points)
                points.push_back(
                    vec(p + part.radius * Point(p.x() < 0 ? -1 : 1, p.y() < 0 ? -1 : 1)));
            polygon.Set(points.data(), static_cast<int32>(points.size()));
        }
        def.shape = &polygon;
        body->CreateFixture(&def);
    }

    std::vector<b2Body*> squares_;
    std::vector<Kept> bodies_;
    std::vector<PinPlan> pins_;
    std::vector<std::vector<b2Body*>> ropes_;
};
