// A running world as a scene.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <sulfur/scene/instance.hpp>

#include "capture_mechanism.hpp"
#include "make_mechanisms.hpp"
#include "placing.hpp"

namespace sulfur::scene {

namespace {

/// The drive of an angular joint that is made again, with an angle between -pi and pi: its limits
/// and target go back by the whole turns that it has made. A spring forgets these.
Drive withoutTurns(Drive drive, double angle) {
    const double turn = 2 * std::numbers::pi;
    const auto turns = static_cast<Real>(turn * std::nearbyint(angle / turn));
    drive.lower -= turns;
    drive.upper -= turns;
    if (drive.motorTarget) *drive.motorTarget -= turns;
    return drive;
}

/// Of a joint, if it shows another surface than a body.
std::optional<Material> ownMaterial(const World& world, JointId joint, BodyId body) {
    const Material& own = world.material(joint);
    return own == world.material(body) ? std::nullopt : std::optional(own);
}

class Capture {
public:
    Capture(const World& world, const Scene& base, const Instance& instance)
        : world_(world), base_(base), instance_(instance) {
        for (const auto& [id, body] : instance.bodies) oldIds_.emplace(body, id);
        for (std::size_t i = 0; i < base.connections.size() && i < instance.connections.size(); ++i)
            oldConnections_.emplace(instance.connections[i], &base.connections[i]);
        for (std::size_t i = 0; i < base.attachments.size() && i < instance.attachments.size(); ++i)
            oldAttachments_.emplace(instance.attachments[i], &base.attachments[i]);
        for (const MechanismId id : world.mechanisms()) {
            const MechanismInfo info = world.info(id);
            ownBodies_.insert(info.own.begin(), info.own.end());
            ownPins_.insert(info.pins.begin(), info.pins.end());
            if (info.vetoes) ownVetoes_.insert(std::minmax(info.a, info.b));
        }
    }

    Scene run() {
        scene_ = base_;
        scene_.settings = world_.settings();
        scene_.settings.gravity = world_.gravity();
        scene_.settings.airFriction = world_.airFriction();
        scene_.bodies.clear();
        scene_.connections.clear();
        scene_.attachments.clear();
        scene_.vetoes.clear();
        scene_.fields.clear();
        scene_.mechanisms.clear();
        // Bodies of the scene first, so that newer ones cannot take their ids.
        for (const bool old : {true, false}) {
            for (const BodyId body : world_.bodies())
                if (oldIds_.contains(body) == old && !ownBodies_.contains(body)) addBody(body);
        }
        for (const JointId joint : world_.connections()) addConnection(joint);
        addAttachments();
        addVetoes();
        addFields();
        addMechanisms();
        return std::move(scene_);
    }

private:
    void addBody(BodyId body) {
        Placement placement;
        const auto old = oldIds_.find(body);
        const Placement* before = old == oldIds_.end() ? nullptr : base_.body(old->second);
        if (before != nullptr) placement = *before;
        if (before == nullptr || !describes(blueprintOf(base_, *before), body)) {
            const Blueprint* rest = nullptr;
            Blueprint known;
            if (before != nullptr) {
                known = blueprintOf(base_, *before);
                if (known.particles.size() == world_.particles(body).size()) rest = &known;
            }
            makePlacement(placement, body, rest);
        }
        addState(placement, body);
        remember(body, placement.id);
        newIds_.emplace(body, placement.id);
        scene_.bodies.push_back(std::move(placement));
    }

    void remember(BodyId body, const std::string& id) {
        const auto particles = world_.particles(body);
        for (std::uint32_t i = 0; i < particles.size(); ++i)
            refs_.emplace(particles[i], ParticleRef{id, i});
    }

    /// Gives the body an explicit blueprint of its own. Its frame is the old blueprint's where the
    /// particles are still the same, and otherwise the centre of mass of what is there now.
    void makePlacement(Placement& placement, BodyId body, const Blueprint* rest) {
        const std::string name = world_.name(body).empty() ? "body" : world_.name(body);
        if (placement.id.empty()) placement.id = freeIdInBoth(name);
        placement.kind.reset();
        placement.material.reset();
        placement.filter.reset();
        placement.sensor.reset();
        if (rest == nullptr) placement.pose = {world_.centreOfMass(body), 0};
        Prefab prefab;
        prefab.blueprint = blueprintNow(world_, body, placement.pose.position);
        for (std::size_t k = 0; rest != nullptr && k < rest->particles.size(); ++k)
            prefab.blueprint.particles[k].position = rest->particles[k].position;
        prefab.blueprint.name = scene_.freeName(placement.id);
        placement.blueprint = prefab.blueprint.name;
        scene_.blueprints.push_back(std::move(prefab));
    }

    std::string freeIdInBoth(const std::string& base) const {
        for (int n = 1;; ++n) {
            const std::string id = n == 1 ? base : base + std::to_string(n);
            if (scene_.body(id) == nullptr && !instance_.bodies.contains(id)) return id;
        }
    }

    /// Whether adding `plan` would make a body like this one, wherever its particles are.
    bool describes(const Blueprint& plan, BodyId body) const {
        const Blueprint now = plan.particles.size() == world_.particles(body).size()
                                  ? blueprintNow(world_, body, Point(0, 0))
                                  : Blueprint{};
        if (plan.kind != now.kind || !(plan.material == now.material) ||
            !(plan.filter == now.filter) || plan.sensor != now.sensor ||
            plan.selfCollision != now.selfCollision || plan.joints.size() != now.joints.size() ||
            plan.angles.size() != now.angles.size())
            return false;
        const auto sameParticle = [](const ParticleSpec& a, const ParticleSpec& b) {
            return a.mass == b.mass && a.radius == b.radius && a.pinned == b.pinned;
        };
        const auto sameJoint = [&](const JointSpec& a, const JointSpec& b) {
            const Vec2 apart = plan.particles[a.b].position - plan.particles[a.a].position;
            return a.a == b.a && a.b == b.b && a.stiffness == b.stiffness &&
                   a.damping == b.damping && a.radius == b.radius && a.strength == b.strength &&
                   a.bend == b.bend && a.restLength.value_or(apart.norm()) == b.restLength &&
                   a.material.value_or(plan.material) == b.material.value_or(plan.material);
        };
        const auto sameAngle = [&](const AngularJointSpec& a, const AngularJointSpec& b) {
            return a.a == b.a && a.b == b.b && a.c == b.c && same(plan.drive(a), now.drive(b));
        };
        return std::equal(plan.particles.begin(), plan.particles.end(), now.particles.begin(),
                          now.particles.end(), sameParticle) &&
               std::equal(plan.joints.begin(), plan.joints.end(), now.joints.begin(), sameJoint) &&
               std::equal(plan.angles.begin(), plan.angles.end(), now.angles.begin(), sameAngle);
    }

    /// Bodies that rest exactly where their pose puts them need no state.
    void addState(Placement& placement, BodyId body) {
        placement.state.reset();
        placement.velocity = Vec2(0, 0);
        const Blueprint& plan = scene_.prefab(placement.blueprint)->blueprint;
        const auto planned = placed(plan, placement.pose);
        BodyState state;
        bool moved = false;
        for (const ParticleId id : world_.particles(body)) {
            const ParticleInfo info = world_.info(id);
            const Point& before = planned[state.positions.size()];
            moved = moved || (info.position - before).norm() > 1e-9 || info.velocity != Vec2(0, 0);
            state.positions.push_back(info.position);
            state.velocities.push_back(info.velocity);
        }
        if (state.positions.size() == 1 && world_.info(world_.particles(body)[0]).radius > 0) {
            const double angle = world_.angle(body);
            state.angle = angle;
            // A tiny disc may spin faster than a file can say.
            state.spin =
                std::clamp<double>(world_.angularVelocity(body), -Limits::spin, Limits::spin);
            moved = moved || std::abs(angle - placement.pose.angle) > 1e-9 || state.spin != 0;
        }
        if (moved) placement.state = std::move(state);
    }

    void addConnection(JointId joint) {
        const JointInfo info = world_.info(joint);
        if (!refs_.contains(info.a) || !refs_.contains(info.b)) return;
        Connection connection;
        if (const auto old = oldConnections_.find(joint); old != oldConnections_.end())
            connection.extra = old->second->extra;
        connection.a = refs_.at(info.a);
        connection.b = refs_.at(info.b);
        connection.options = {
            info.stiffness, info.damping,  info.restLength,
            info.radius,    info.strength, ownMaterial(world_, joint, world_.info(info.a).body)};
        scene_.connections.push_back(std::move(connection));
    }

    /// An attachment to a joint between bodies, or of a particle to its own body, is nothing that
    /// a scene can say.
    void addAttachments() {
        for (const AttachmentId id : world_.attachments()) {
            const AttachmentInfo info = world_.info(id);
            const BodyId body = world_.info(info.supports[0]).body;
            if (ownPins_.contains(id) || !refs_.contains(info.particle)) continue;
            bool elsewhere = world_.info(info.particle).body == body || ownBodies_.contains(body);
            for (std::uint32_t k = 1; k < info.count; ++k)
                elsewhere = elsewhere || world_.info(info.supports[k]).body != body;
            if (elsewhere) continue;
            Attachment attachment;
            const auto old = oldAttachments_.find(id);
            if (old != oldAttachments_.end()) attachment = *old->second;
            attachment.particle = refs_.at(info.particle);
            attachment.body = refs_.at(info.supports[0]).body;
            if (old == oldAttachments_.end() || hasNewFrame(attachment.body))
                attachment.point = pointOf(info);
            scene_.attachments.push_back(std::move(attachment));
        }
    }

    void addVetoes() {
        for (const auto& [a, b] : world_.vetoes())
            if (newIds_.contains(a) && newIds_.contains(b) &&
                !ownVetoes_.contains(std::minmax(a, b)))
                scene_.vetoes.push_back({newIds_.at(a), newIds_.at(b)});
    }

    /// Who would refuse them is asked before anybody reads them: bodies that have bent or lost
    /// particles may no longer hold a point.
    void addMechanisms() {
        MechanismCapture capture(world_, newIds_);
        for (std::size_t i = 0; i < base_.mechanisms.size() && i < instance_.mechanisms.size(); ++i)
            capture.know(base_.mechanisms[i], instance_.mechanisms[i]);
        scene_.mechanisms = capture.run();
        const auto refused = refusals(scene_);
        std::size_t place = 0;
        std::erase_if(scene_.mechanisms, [&](const auto&) { return !refused[place++].empty(); });
    }

    void addFields() {
        for (const FieldId id : world_.fields()) {
            SceneField field;
            const auto old = std::find(instance_.fields.begin(), instance_.fields.end(), id);
            const auto place = static_cast<std::size_t>(old - instance_.fields.begin());
            if (old != instance_.fields.end() && place < base_.fields.size())
                field = base_.fields[place];
            field.field = world_.field(id);
            scene_.fields.push_back(std::move(field));
        }
    }

    /// Whether the body has another blueprint now, so that places in the old one mean nothing.
    bool hasNewFrame(const std::string& id) const {
        const Placement* before = base_.body(id);
        return before == nullptr || before->blueprint != scene_.body(id)->blueprint;
    }

    /// Where an attachment is in the frame of the blueprint of its supports.
    Vec2 pointOf(const AttachmentInfo& info) const {
        Vec2 point(0, 0);
        for (std::uint32_t k = 0; k < info.count; ++k) {
            const ParticleRef& ref = refs_.at(info.supports[k]);
            const auto* prefab = scene_.prefab(scene_.body(ref.body)->blueprint);
            point += info.weights[k] * prefab->blueprint.particles[ref.particle].position;
        }
        return point;
    }

    const World& world_;
    const Scene& base_;
    const Instance& instance_;
    Scene scene_;
    std::map<BodyId, std::string> oldIds_, newIds_;
    // What mechanisms have made for themselves, and make again.
    std::set<BodyId> ownBodies_;
    std::set<AttachmentId> ownPins_;
    std::set<std::pair<BodyId, BodyId>> ownVetoes_;
    std::map<JointId, const Connection*> oldConnections_;
    std::map<AttachmentId, const Attachment*> oldAttachments_;
    std::map<ParticleId, ParticleRef> refs_;
};

}  // namespace

Blueprint blueprintNow(const World& world, BodyId body, const Point& origin) {
    Blueprint plan;
    plan.name = world.name(body);
    plan.kind = world.kind(body);
    plan.material = world.material(body);
    plan.filter = world.filter(body);
    plan.sensor = world.sensor(body);
    plan.selfCollision = world.selfCollision(body);
    plan.skin = world.skin(body);
    std::map<ParticleId, std::uint32_t> places;
    for (const ParticleId id : world.particles(body)) {
        const ParticleInfo info = world.info(id);
        places.emplace(id, static_cast<std::uint32_t>(plan.particles.size()));
        const Point place = info.position - origin;
        plan.particles.push_back({place.cast<Real>(), info.mass, info.radius, info.pinned});
    }
    for (const JointId id : world.joints(body)) {
        const JointInfo info = world.info(id);
        plan.joints.push_back({places.at(info.a), places.at(info.b), info.stiffness, info.damping,
                               info.restLength, info.radius, info.strength,
                               ownMaterial(world, id, body), info.bend});
    }
    for (const AngleInfo& info : world.angles(body)) {
        const Drive d = withoutTurns(withinFile(info.drive), info.angle);
        plan.angles.push_back({places.at(info.a), places.at(info.b), places.at(info.c), d.stiffness,
                               d.damping, d.rest, d.lower, d.upper, d.motorSpeed, d.motorMax,
                               d.motorTarget, d.strength});
    }
    if (plan.skin && plan.skin->uv.size() != plan.particles.size()) plan.skin.reset();
    return plan;
}

Scene capture(const World& world, const Scene& base, const Instance& instance) {
    return Capture(world, base, instance).run();
}

}  // namespace sulfur::scene
