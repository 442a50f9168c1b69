// What joins and parts the bodies of a document, particle by particle.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

#include "document_steps.hpp"
#include "follow.hpp"

namespace sulfurchamber {

using sulfur::BodyId;
using sulfur::JointId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::Pose;
using sulfur::Real;
using sulfur::scene::ParticleRef;
using sulfur::scene::Prefab;

JointId Document::connect(ParticleId a, ParticleId b, sulfur::ConnectOptions options) {
    requireRoom(0, 1);
    const auto refA = refOf(a);
    const auto refB = refOf(b);
    if (!options.restLength)
        options.restLength = static_cast<Real>((world_->position(a) - world_->position(b)).norm());
    sulfur::ConnectOptions live = options;
    live.stiffness = scaled(live.stiffness, constants_);
    const JointId joint = world_->connect(a, b, live);
    touched();
    if (!refA || !refB) return joint;
    sulfur::scene::Connection connection;
    connection.a = *refA;
    connection.b = *refB;
    connection.options = options;
    plan_.connect(std::move(connection));
    const BodyId body = world_->info(a).body;
    if (moved_) bringPlanHere({&body, 1});
    return joint;
}

void Document::attach(ParticleId particle, BodyId body) {
    const auto ref = refOf(particle);
    const std::string id = idOf(body);
    const Pose pose = world_->pose(body);
    const Point local =
        Eigen::Rotation2Dd(-pose.angle) * (world_->position(particle) - pose.position);
    world_->attach(particle, body, local.cast<Real>());
    touched();
    if (!ref || id.empty()) return;
    plan_.scene().attachments.push_back({*ref, id, local.cast<Real>(), {}});
    if (moved_) bringPlanHere({&body, 1});
}

void Document::letPass(BodyId a, BodyId b) {
    const std::string idA = idOf(a);
    const std::string idB = idOf(b);
    world_->setCollision(a, b, false);
    touched();
    if (!idA.empty() && !idB.empty()) plan_.scene().vetoes.push_back({idA, idB});
}

void Document::join(ParticleId a, ParticleId b, const sulfur::JointSpec& joint) {
    const auto refA = refOf(a);
    const auto refB = refOf(b);
    if (a == b) throw std::runtime_error("a joint needs two particles");
    if (!refA || !refB) throw std::runtime_error("pieces cannot be joined; reset the scene first");
    requireRoom(0, 1);
    if (refA->body == refB->body) {
        sulfur::JointSpec made = joint;
        made.a = refA->particle;
        made.b = refB->particle;
        const BodyId body = world_->info(a).body;
        change({&body, 1}, [&](Prefab& prefab) {
            prefab.generator = {};
            prefab.blueprint.joints.push_back(made);
        });
        return;
    }
    const auto single = [&](const ParticleRef& ref) {
        return plan_.blueprint(ref.body).particles.size() == 1;
    };
    if (single(*refB)) {
        merge(refA->body, refB->body, refA->particle, joint);
    } else if (single(*refA)) {
        merge(refB->body, refA->body, refB->particle, joint);
    } else {
        sulfur::ConnectOptions options;
        options.stiffness = joint.stiffness;
        options.damping = joint.damping;
        options.strength = joint.strength;
        options.radius = joint.radius;
        connect(a, b, options);
    }
}

// The single particle becomes the last one of the other body. Whatever held it holds that.
void Document::merge(const std::string& into, const std::string& single, std::uint32_t other,
                     const sulfur::JointSpec& joint) {
    const std::array<BodyId, 2> both{bodyOf(into), bodyOf(single)};
    if (moved_) bringPlanHere(both);
    auto particle = plan_.blueprint(single).particles[0];
    const Point place = world_->position(world_->particles(both[1])[0]);
    const Pose pose = plan_.body(into).pose;
    particle.position = (Eigen::Rotation2Dd(-pose.angle) * (place - pose.position)).cast<Real>();
    const auto last = static_cast<std::uint32_t>(plan_.blueprint(into).particles.size());
    auto& state = plan_.body(into).state;
    if (state) {
        state->positions.push_back(place);
        state->velocities.emplace_back(0, 0);
        state->angle.reset();  // it is no single disc any more
        state->spin = 0;
    }
    sulfur::JointSpec made = joint;
    made.a = other;
    made.b = last;
    const sulfur::Blueprint before = scaled(plan_.blueprint(into), constants_);
    plan_.change({into}, [&](Prefab& prefab) {
        prefab.generator = {};
        prefab.blueprint.particles.push_back(particle);
        prefab.blueprint.joints.push_back(made);
    });
    for (auto& connection : plan_.scene().connections)
        for (ParticleRef* end : {&connection.a, &connection.b})
            if (end->body == single) *end = {into, last};
    for (auto& attachment : plan_.scene().attachments)
        if (attachment.particle.body == single) attachment.particle = {into, last};
    for (auto& mechanism : plan_.scene().mechanisms) {
        const auto names = bodiesOf(mechanism);
        if (std::any_of(names.begin(), names.end(), [&](auto* name) { return *name == into; }))
            continue;  // what joins both goes with the single one
        for (std::string* name : names)
            if (*name == single) *name = into;
    }
    takeOver([&] {
        follow(*world_, both[0], before, scaled(plan_.blueprint(into), constants_));
        world_->remove(both[1]);
        plan_.remove({single});
    });
}

void Document::remove(JointId joint) {
    const auto info = world_->info(joint);
    const auto a = refOf(info.a);
    const auto b = refOf(info.b);
    const auto there = made();
    world_->remove(joint);
    touched();
    if (!a || !b) return;
    const auto joins = [](std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) {
        return (p == r && q == s) || (p == s && q == r);
    };
    if (info.body) {
        plan_.change({a->body}, [&](Prefab& prefab) {
            auto& joints = prefab.blueprint.joints;
            const auto found = std::find_if(joints.begin(), joints.end(), [&](const auto& spec) {
                return joins(spec.a, spec.b, a->particle, b->particle);
            });
            if (found == joints.end()) return;
            prefab.generator = {};
            joints.erase(found);
            std::erase_if(prefab.blueprint.angles, [&](const auto& angle) {
                return joins(angle.a, angle.b, a->particle, b->particle) ||
                       joins(angle.b, angle.c, a->particle, b->particle);
            });
        });
        followRails(a->body, there);
        return;
    }
    const auto same = [](const ParticleRef& x, const ParticleRef& y) {
        return x.body == y.body && x.particle == y.particle;
    };
    const auto& connections = plan_.scene().connections;
    for (std::size_t i = 0; i < connections.size(); ++i)
        if ((same(connections[i].a, *a) && same(connections[i].b, *b)) ||
            (same(connections[i].a, *b) && same(connections[i].b, *a))) {
            plan_.remove(i);
            return;
        }
}

// A recipe has made another number of joints. A rail that was all of them is so again; of another
// one nobody knows where it was.
void Document::renewRails(const std::string& body, std::size_t jointsBefore) {
    const Prefab& prefab = plan_.prefab(plan_.body(body).blueprint);
    const std::size_t count = prefab.blueprint.joints.size();
    // Without a recipe the old joints come first, as they were.
    if (count == jointsBefore || prefab.generator.index() == 0) return;
    for (std::size_t i = scene().mechanisms.size(); i-- > 0;) {
        auto* slider = std::get_if<sulfur::scene::Slider>(&plan_.scene().mechanisms[i].spec);
        if (slider == nullptr || slider->a != body || slider->rail.empty()) continue;
        if (slider->rail.size() == jointsBefore) {
            slider->rail.resize(count);
            std::iota(slider->rail.begin(), slider->rail.end(), 0u);
        } else {
            unfit({FittingRef::Kind::mechanism, i});
        }
    }
}

// Rails name joints by their places. When one has gone, a slider keeps what is left of its rail in
// the world, or goes with its own link. `there`: mechanisms of the plan before that.
void Document::followRails(const std::string& body,
                           const std::vector<sulfur::scene::MadeMechanism>& there) {
    for (std::size_t i = there.size(); i-- > 0;) {
        const auto* old = std::get_if<sulfur::scene::Slider>(&scene().mechanisms.at(i).spec);
        if (old == nullptr || old->a != body || old->rail.empty()) continue;
        if (!there[i].id || !world_->contains(there[i].id)) {
            unfit({FittingRef::Kind::mechanism, i});
            continue;
        }
        const sulfur::MechanismInfo left = world_->info(there[i].id);
        auto& slider = std::get<sulfur::scene::Slider>(plan_.scene().mechanisms[i].spec);
        slider.options.value = left.railBegin;
        slider.rail.clear();
        const auto& joints = plan_.blueprint(body).joints;
        for (const JointId link : left.rail) {
            const auto info = world_->info(link);
            const auto a = refOf(info.a), b = refOf(info.b);
            const auto found = std::find_if(joints.begin(), joints.end(), [&](const auto& joint) {
                return a && b && joint.a == a->particle && joint.b == b->particle;
            });
            if (found != joints.end())
                slider.rail.push_back(static_cast<std::uint32_t>(found - joints.begin()));
        }
    }
}

}  // namespace sulfurchamber
