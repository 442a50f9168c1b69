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
        : setting_(setting), world_(b2Vec2(0, static_cast<float>(-gravity))) {
        world_.SetAllowSleeping(false);
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

    std::vector<b2Body*> squares_;
    std::vector<std::vector<b2Body*>> ropes_;
};
