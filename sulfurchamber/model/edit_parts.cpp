// Single particles and joints of a document: which are there, and what they become.
#include <Eigen/Geometry>
#include <algorithm>

#include "document_steps.hpp"
#include "meter.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Blueprint;
using sulfur::BodyId;
using sulfur::JointId;
using sulfur::JointSpec;
using sulfur::scene::ParticleRef;
using sulfur::scene::Prefab;

// What was measured with a particle in another place is measured anew.
void forgetLengths(Blueprint& plan, std::uint32_t particle) {
    for (JointSpec& joint : plan.joints)
        if (joint.a == particle || joint.b == particle) joint.restLength.reset();
    for (auto& angle : plan.angles)
        if (angle.a == particle || angle.b == particle || angle.c == particle)
            angle.restAngle.reset();
}

// With its joints and angles; those after it move up by one.
void takeOut(Blueprint& plan, std::uint32_t particle) {
    const auto holds = [&](const auto&... ends) { return ((ends == particle) || ...); };
    const auto moveUp = [&](auto&... ends) { (void(ends -= ends > particle ? 1 : 0), ...); };
    std::erase_if(plan.joints, [&](const JointSpec& j) { return holds(j.a, j.b); });
    for (JointSpec& joint : plan.joints) moveUp(joint.a, joint.b);
    std::erase_if(plan.angles, [&](const auto& angle) { return holds(angle.a, angle.b, angle.c); });
    for (auto& angle : plan.angles) moveUp(angle.a, angle.b, angle.c);
    plan.particles.erase(plan.particles.begin() + particle);
    if (!plan.skin) return;
    auto& skin = *plan.skin;
    std::erase_if(skin.triangles, [&](const auto& t) { return holds(t[0], t[1], t[2]); });
    for (auto& t : skin.triangles) moveUp(t[0], t[1], t[2]);
    if (skin.uv.size() > particle) skin.uv.erase(skin.uv.begin() + particle);
    if (skin.triangles.empty()) plan.skin.reset();
}

JointSpec specOf(const sulfur::ConnectOptions& options) {
    JointSpec spec;
    spec.stiffness = options.stiffness;
    spec.damping = options.damping;
    spec.restLength = options.restLength;
    spec.radius = options.radius;
    spec.strength = options.strength;
    return spec;
}

}  // namespace

std::optional<FittingRef> Document::partOf(sulfur::ParticleId particle) const {
    const auto ref = refOf(particle);
    if (!ref) return std::nullopt;
    return FittingRef{FittingRef::Kind::particle, ref->particle, ref->body};
}

std::optional<FittingRef> Document::partOf(JointId joint) const {
    const auto info = world_->info(joint);
    const auto a = refOf(info.a), b = refOf(info.b);
    if (!a || !b) return std::nullopt;
    const auto same = [](const ParticleRef& x, const ParticleRef& y) {
        return x.body == y.body && x.particle == y.particle;
    };
    if (!info.body) {
        const auto& all = scene().connections;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (same(all[i].a, *a) && same(all[i].b, *b))
                return FittingRef{FittingRef::Kind::connection, i, {}};
        return std::nullopt;
    }
    const Blueprint& plan = sharedBlueprint(a->body);
    for (std::size_t i = 0; i < plan.joints.size(); ++i)
        if (plan.joints[i].a == a->particle && plan.joints[i].b == b->particle)
            return FittingRef{FittingRef::Kind::joint, i, a->body};
    return std::nullopt;
}

// Without what the placement says otherwise, which are no places and no ends.
const Blueprint& Document::sharedBlueprint(const std::string& id) const {
    return plan_.prefab(plan_.body(id).blueprint).blueprint;
}

bool Document::hasPart(const FittingRef& ref) const {
    if (ref.kind == FittingRef::Kind::connection) return ref.index < scene().connections.size();
    if (!plan_.contains(ref.body)) return false;
    const Blueprint& plan = sharedBlueprint(ref.body);
    return ref.index < (ref.kind == FittingRef::Kind::particle ? plan.particles.size()
                                                               : plan.joints.size());
}

Fitting Document::part(const FittingRef& ref) const {
    if (ref.kind == FittingRef::Kind::connection)
        return JointPart{specOf(scene().connections.at(ref.index).options)};
    const Blueprint& plan = sharedBlueprint(ref.body);
    if (ref.kind == FittingRef::Kind::particle) return ParticlePart{plan.particles.at(ref.index)};
    return JointPart{plan.joints.at(ref.index)};
}

std::string Document::markOf(const FittingRef& ref) const {
    const auto text = [](std::size_t number) { return std::to_string(number); };
    const auto end = [&](const ParticleRef& e) { return e.body + ":" + text(e.particle); };
    if (ref.kind == FittingRef::Kind::connection) {
        const auto& connection = scene().connections.at(ref.index);
        return end(connection.a) + "-" + end(connection.b);
    }
    const Blueprint& plan = sharedBlueprint(ref.body);
    const std::string count = text(plan.particles.size());
    if (ref.kind == FittingRef::Kind::particle) return count;
    const JointSpec& joint = plan.joints.at(ref.index);
    return text(joint.a) + "-" + text(joint.b) + " of " + count;
}

std::vector<sulfur::Point> Document::placesOf(const FittingRef& ref) const {
    const auto place = [&](const std::string& id, std::size_t particle,
                           std::vector<sulfur::Point>& places) {
        const BodyId body = bodyOf(id);
        if (!body) return;
        const auto particles = world_->particles(body);
        if (particle < particles.size()) places.push_back(world_->position(particles[particle]));
    };
    std::vector<sulfur::Point> places;
    if (!hasPart(ref)) return places;
    if (ref.kind == FittingRef::Kind::particle) {
        place(ref.body, ref.index, places);
    } else if (ref.kind == FittingRef::Kind::joint) {
        const JointSpec& joint = sharedBlueprint(ref.body).joints[ref.index];
        place(ref.body, joint.a, places);
        place(ref.body, joint.b, places);
    } else {
        const auto& connection = scene().connections[ref.index];
        place(connection.a.body, connection.a.particle, places);
        place(connection.b.body, connection.b.particle, places);
    }
    return places;
}

// Of this moment; null where it has broken.
JointId Document::jointOf(const FittingRef& ref) const {
    const auto find = [](const auto& all, const auto& isIt) {
        const auto found = std::find_if(all.begin(), all.end(), isIt);
        return found == all.end() ? JointId{} : *found;
    };
    if (ref.kind == FittingRef::Kind::connection)
        return find(world_->connections(), [&](JointId one) { return partOf(one) == ref; });
    const BodyId body = bodyOf(ref.body);
    if (!body) return {};
    const JointSpec& spec = sharedBlueprint(ref.body).joints.at(ref.index);
    const auto particles = world_->particles(body);
    return find(world_->joints(body), [&](JointId one) {
        const auto info = world_->info(one);
        return info.a == particles[spec.a] && info.b == particles[spec.b];
    });
}

void Document::setPart(const FittingRef& ref, const Fitting& to) {
    if (ref.kind == FittingRef::Kind::connection) {
        const JointSpec& spec = std::get<JointPart>(to).spec;
        const JointId joint = jointOf(ref);
        auto& options = plan_.scene().connections.at(ref.index).options;
        options.stiffness = spec.stiffness;
        options.damping = spec.damping;
        options.restLength = spec.restLength;
        options.radius = spec.radius;
        options.strength = spec.strength;
        if (!joint) return;
        const auto info = world_->info(joint);
        sulfur::ConnectOptions live = options;
        live.stiffness = scaled(live.stiffness, constants_);
        if (moved_ && !live.restLength) live.restLength = info.restLength;
        world_->remove(joint);
        world_->connect(info.a, info.b, live);
        return;
    }
    const BodyId body = bodyOf(ref.body);
    if (!body) throw std::runtime_error("pieces cannot be changed so; reset the scene first");
    if (ref.kind == FittingRef::Kind::joint) {
        change({&body, 1}, [&](Prefab& prefab) {
            prefab.generator = {};
            prefab.blueprint.joints.at(ref.index) = std::get<JointPart>(to).spec;
        });
        return;
    }
    const sulfur::ParticleSpec& wanted = std::get<ParticlePart>(to).spec;
    const auto place = static_cast<std::uint32_t>(ref.index);
    const sulfur::Point by =
        (wanted.position - sharedBlueprint(ref.body).particles.at(place).position).cast<double>();
    const bool moves = by != sulfur::Point(0, 0);
    if (moves) requirePlan();
    change({&body, 1}, [&](Prefab& prefab) {
        prefab.generator = {};
        prefab.blueprint.particles.at(place) = wanted;
        if (moves) forgetLengths(prefab.blueprint, place);
    });
    if (!moves) return;
    auto& placement = plan_.body(ref.body);
    if (placement.state)
        placement.state->positions.at(place) += Eigen::Rotation2Dd(placement.pose.angle) * by;
    for (auto& connection : plan_.scene().connections)
        for (const ParticleRef& end : {connection.a, connection.b})
            if (end.body == ref.body && end.particle == place)
                connection.options.restLength.reset();
    stamp();
    touched();
}

void Document::removePart(const FittingRef& ref) {
    if (ref.kind != FittingRef::Kind::particle) {
        if (const JointId joint = jointOf(ref)) return remove(joint);
        throw std::runtime_error("it has broken; reset the scene first");
    }
    requirePlan();
    const BodyId body = bodyOf(ref.body);
    if (plan_.blueprint(ref.body).particles.size() == 1) return remove({&body, 1});
    const auto gone = static_cast<std::uint32_t>(ref.index);
    auto& plan = plan_.scene();
    // Rails name joints by their places, which change.
    for (std::size_t i = plan.mechanisms.size(); i-- > 0;)
        if (const auto* slider = std::get_if<sulfur::scene::Slider>(&plan.mechanisms[i].spec);
            slider != nullptr && slider->a == ref.body && !slider->rail.empty())
            unfit({FittingRef::Kind::mechanism, i, {}});
    const auto isGone = [&](const ParticleRef& end) {
        return end.body == ref.body && end.particle == gone;
    };
    const auto moveUp = [&](ParticleRef& end) {
        if (end.body == ref.body && end.particle > gone) --end.particle;
    };
    std::erase_if(plan.connections, [&](const auto& c) { return isGone(c.a) || isGone(c.b); });
    std::erase_if(plan.attachments, [&](const auto& held) { return isGone(held.particle); });
    for (auto& connection : plan.connections) {
        moveUp(connection.a);
        moveUp(connection.b);
    }
    for (auto& held : plan.attachments) moveUp(held.particle);
    forgetParticleInMeters(plan, ref.body, gone);
    auto state = plan_.body(ref.body).state;
    if (state) {
        state->positions.erase(state->positions.begin() + gone);
        state->velocities.erase(state->velocities.begin() + gone);
    }
    plan_.change({ref.body}, [&](Prefab& prefab) {
        prefab.generator = {};
        takeOut(prefab.blueprint, gone);
    });
    plan_.body(ref.body).state = std::move(state);
    stamp();
    touched();
}

// Who moves or removes particles changes what stands still: in a moment nobody knows where the
// others would be.
void Document::requirePlan() const {
    if (canReset())
        throw std::runtime_error(
            "particles are moved and removed before time runs; reset the scene first");
}

}  // namespace sulfurchamber
