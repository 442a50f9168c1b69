// What changes a document: each function changes the plan and the world in the same moment.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "document_steps.hpp"
#include "follow.hpp"
#include "instances.hpp"
#include "level_things.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::JointId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::Pose;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::World;
using sulfur::scene::Limits;
using sulfur::scene::ParticleRef;
using sulfur::scene::Placement;
using sulfur::scene::Prefab;

constexpr double sameShape = 1e-3;  // metres by which a body may differ from its blueprint's shape

// Whether the particles are where the blueprint has them at this pose.
bool hasItsShape(const World& world, BodyId body, const sulfur::Blueprint& plan, const Pose& pose) {
    const auto particles = world.particles(body);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Point planned = pose.position + Eigen::Rotation2Dd(pose.angle) *
                                                  plan.particles[i].position.cast<double>();
        if ((world.position(particles[i]) - planned).norm() > sameShape) return false;
    }
    return true;
}

// Where the frame of a body is when the scene begins: a state may have left the pose.
Pose startOf(const Plan& plan, const std::string& id) {
    const Placement& placement = plan.body(id);
    if (!placement.state) return placement.pose;
    World trial(plan.scene().settings);
    const BodyId body = trial.add(plan.blueprint(id), placement.pose);
    sulfur::scene::applyState(plan.scene(), placement, trial, body);
    return trial.pose(body);
}

}  // namespace

std::vector<std::string> Document::idsOf(std::span<const BodyId> bodies) const {
    std::vector<std::string> ids;
    for (const BodyId body : bodies)
        if (std::string id = idOf(body); !id.empty()) ids.push_back(std::move(id));
    return ids;
}

std::optional<ParticleRef> Document::refOf(ParticleId particle) const {
    const BodyId body = world_->info(particle).body;
    std::string id = idOf(body);
    if (id.empty()) return std::nullopt;
    const auto particles = world_->particles(body);
    const auto found = std::find(particles.begin(), particles.end(), particle);
    return ParticleRef{std::move(id), static_cast<std::uint32_t>(found - particles.begin())};
}

void Document::requireRoom(std::size_t particles, std::size_t joints) const {
    std::size_t inWorld = 0;
    std::size_t jointsInWorld = world_->connections().size();
    for (const BodyId body : world_->bodies()) {
        inWorld += world_->particles(body).size();
        jointsInWorld += world_->joints(body).size();
    }
    const auto refuse = [](std::size_t wanted, std::size_t most, const char* sentence) {
        throw std::runtime_error(tr(sentence, {std::to_string(wanted), std::to_string(most)}));
    };
    const std::size_t all = std::max(inWorld, plan_.particles()) + particles;
    if (all > Limits::particles)
        refuse(all, Limits::particles, "there would be {} particles; a scene may have at most {}");
    const std::size_t allJoints = std::max(jointsInWorld, plan_.joints()) + joints;
    if (allJoints > Limits::joints)
        refuse(allJoints, Limits::joints, "there would be {} joints; a scene may have at most {}");
}

// --- adding and removing ---------------------------------------------------------------------

BodyId Document::add(const std::string& name, const sulfur::scene::Generator& recipe,
                     const Pose& pose) {
    Placement placement;
    placement.pose = pose;
    return add(sulfur::scene::makePrefab(name, recipe), placement);
}

BodyId Document::add(const Prefab& prefab, const Placement& placement) {
    const auto& blueprint = prefab.blueprint;
    requireRoom(blueprint.particles.size(), blueprint.joints.size() + blueprint.angles.size());
    blueprint.validate();
    const std::string id = plan_.add(prefab, placement);
    const sulfur::Body body =
        world_->add(scaled(plan_.blueprint(id), constants_), plan_.body(id).pose);
    world_->setUserData(body.id(), keyOf(id));
    if (placement.state) {
        sulfur::scene::applyState(plan_.scene(), plan_.body(id), *world_, body);
    } else if (placement.velocity != Vec2(0, 0)) {
        world_->setVelocity(body.id(), placement.velocity);
    }
    touched();
    return body.id();
}

std::size_t Document::placeOfPassing(const Prefab& prefab) {
    const std::string text = sulfur::scene::format(prefab);
    const auto known = std::find_if(passing_.begin(), passing_.end(), [&](const Prefab& other) {
        return sulfur::scene::format(other) == text;
    });
    const auto place = static_cast<std::size_t>(known - passing_.begin());
    if (known == passing_.end()) passing_.push_back(prefab);
    return place;
}

BodyId Document::addPassing(const Prefab& prefab, const Pose& pose) {
    requireRoom(prefab.blueprint.particles.size(), prefab.blueprint.joints.size());
    const std::size_t place = placeOfPassing(prefab);
    const sulfur::Body body = world_->add(scaled(prefab.blueprint, constants_), pose);
    world_->setUserData(body.id(), passingBit | place);
    touched();
    return body.id();
}

void Document::letFall(const Prefab& prefab, const Pose& pose) {
    requireRoom(prefab.blueprint.particles.size(), prefab.blueprint.joints.size());
    const std::size_t place = placeOfPassing(prefab);
    if (!falling_.blueprint || falling_.place != place || !(falling_.constants == constants_))
        falling_ = {
            place, constants_,
            std::make_shared<const sulfur::Blueprint>(scaled(prefab.blueprint, constants_))};
    beforeActing();
    const Arrival arrival{falling_.blueprint, pose, passingBit | place};
    world_->setUserData(world_->add(*arrival.blueprint, pose).id(), arrival.userData);
    timeline_.note(arrival);
    ++revision_;
}

std::vector<BodyId> Document::insert(const sulfur::scene::Scene& scene, const Point& by) {
    std::map<std::string, BodyId, std::less<>> made;
    std::vector<BodyId> bodies;
    for (Placement placement : scene.bodies) {
        Prefab prefab = *scene.prefab(placement.blueprint);
        placement.pose.position += by;
        if (placement.state)
            for (Point& place : placement.state->positions) place += by;
        bodies.push_back(add(prefab, placement));
        made.emplace(placement.id, bodies.back());
    }
    const auto particle = [&](const ParticleRef& ref) {
        return world_->particles(made.at(ref.body))[ref.particle];
    };
    for (const auto& connection : scene.connections)
        connect(particle(connection.a), particle(connection.b), connection.options);
    auto& plan = plan_.scene();
    for (auto attachment : scene.attachments) {
        world_->attach(particle(attachment.particle), made.at(attachment.body), attachment.point);
        attachment.particle.body = idOf(made.at(attachment.particle.body));
        attachment.body = idOf(made.at(attachment.body));
        plan.attachments.push_back(std::move(attachment));
    }
    for (const auto& veto : scene.vetoes) {
        world_->setCollision(made.at(veto.a), made.at(veto.b), false);
        plan.vetoes.push_back({idOf(made.at(veto.a)), idOf(made.at(veto.b))});
    }
    insertMechanisms(scene, by, made);
    auto own = thrustersOf(plan);
    for (Thruster thruster : thrustersOf(scene)) {
        thruster.body = idOf(made.at(thruster.body));
        own.push_back(std::move(thruster));
    }
    setThrusters(plan, own);
    // Instances that come along follow their templates here too.
    takeDefinitions(plan, scene);
    renameInstances(plan, idsOf(bodies));
    return bodies;
}

void Document::insertMechanisms(const sulfur::scene::Scene& scene, const Point& by,
                                const std::map<std::string, BodyId, std::less<>>& made) {
    auto mechanisms = scene.mechanisms;
    for (auto& mechanism : mechanisms)
        for (const auto& [id, body] : made)
            for (Point* point : pointsOf(mechanism, id)) *point += by;
    sulfur::scene::makeMechanisms(mechanisms, made, *world_);
    auto& plan = plan_.scene().mechanisms;
    const auto isTaken = [&](const std::string& id) {
        return std::any_of(plan.begin(), plan.end(), [&](const auto& m) { return m.id == id; });
    };
    std::map<std::string, std::string> renamed;
    for (auto& mechanism : mechanisms) {
        for (std::string* name : bodiesOf(mechanism)) *name = idOf(made.at(*name));
        if (auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec)) {
            gear->first = renamed.at(gear->first);
            gear->second = renamed.at(gear->second);
        }
        if (std::string& id = mechanism.id; !id.empty()) {
            const std::string before = id;
            for (int n = 2; isTaken(id); ++n) id = before + std::to_string(n);
            renamed.emplace(before, id);
        }
        plan.push_back(std::move(mechanism));
    }
}

void Document::remove(std::span<const BodyId> bodies) {
    const std::vector<BodyId> gone = withPegs(bodies);
    if (isLevel(*this)) forgetBodies(*this, idsOf(gone));
    plan_.remove(idsOf(gone));
    for (const BodyId body : gone)
        if (world_->contains(body)) world_->remove(body);
    touched();
}

// --- places ----------------------------------------------------------------------------------

// In a moment: the plan has these bodies, and all that is tied to them, where they are now.
void Document::bringPlanHere(std::span<const BodyId> bodies) {
    std::unordered_map<std::string, BodyId> here;
    for (const BodyId body : world_->bodies())
        if (std::string id = idOf(body); !id.empty()) here.emplace(std::move(id), body);
    for (const std::string& id : plan_.tiedTo(idsOf(bodies))) {
        const auto found = here.find(id);
        if (found == here.end()) continue;
        Placement& placement = plan_.body(id);
        const Pose before = startOf(plan_, id);
        placement.pose = world_->pose(found->second);
        plan_.carryMechanisms(id, before, placement.pose);
        placement.velocity = Vec2(0, 0);
        placement.state.reset();
        if (hasItsShape(*world_, found->second, plan_.blueprint(id), placement.pose)) continue;
        sulfur::scene::BodyState state;
        for (const ParticleId particle : world_->particles(found->second)) {
            state.positions.push_back(world_->position(particle));
            state.velocities.emplace_back(0, 0);
        }
        placement.state = std::move(state);
    }
}

void Document::translate(std::span<const BodyId> chosen, const Point& by) {
    const std::vector<BodyId> bodies = withPegs(chosen);
    for (const BodyId body : bodies) {
        for (const ParticleId particle : world_->particles(body))
            world_->setPosition(particle, world_->position(particle) + by);
        const std::string id = idOf(body);
        if (id.empty() || moved_) continue;
        Placement& placement = plan_.body(id);
        placement.pose.position += by;
        plan_.carryMechanisms(id, {}, {.position = by});
        if (placement.state)
            for (Point& place : placement.state->positions) place += by;
    }
    touched();
    if (moved_) bringPlanHere(bodies);
}

void Document::place(BodyId body, const Pose& pose) {
    const Pose before = world_->pose(body);
    world_->setPose(body, pose);
    touched();
    const std::string id = idOf(body);
    if (moved_) bringPlanHere({&body, 1});
    if (id.empty() || moved_) return;
    Placement& placement = plan_.body(id);
    placement.pose = pose;
    plan_.carryMechanisms(id, before, pose);
    if (!placement.state) return;
    const double turn = pose.angle - before.angle;
    if (auto& angle = placement.state->angle)
        angle = std::remainder(*angle + turn, 2 * std::numbers::pi);
    const Eigen::Rotation2Dd turned(turn);
    for (Point& place : placement.state->positions)
        place = pose.position + turned * (place - before.position);
    for (Vec2& velocity : placement.state->velocities)
        velocity = (turned * velocity.cast<double>()).cast<Real>();
}

void Document::placeWithPegs(BodyId body, const Pose& pose) {
    const Pose before = world_->pose(body);
    const auto all = withPegs({&body, 1});
    const Eigen::Rotation2Dd turned(pose.angle - before.angle);
    for (const BodyId one : all) {
        const Pose was = world_->pose(one);
        const double angle =
            std::remainder(was.angle + pose.angle - before.angle, 2 * std::numbers::pi);
        place(one, one == body
                       ? pose
                       : Pose{pose.position + turned * (was.position - before.position), angle});
    }
}

Bounds worldBounds(const Document& document) {
    constexpr double leastRoom = 50;  // metres
    std::optional<Bounds> all;
    const auto include = [&](const Point& place) {
        if (!all) all = Bounds{place, place};
        all->include(place);
    };
    const Plan& plan = document.plan();
    for (const Placement& body : plan.scene().bodies) {
        if (body.state) {
            for (const Point& place : body.state->positions) include(place);
            continue;
        }
        for (const auto& particle : plan.prefab(body.blueprint).blueprint.particles)
            include(body.pose.position +
                    Eigen::Rotation2Dd(body.pose.angle) * particle.position.cast<double>());
    }
    if (!all) all = Bounds{};
    const Point room = all->size().cwiseMax(leastRoom);
    return {all->low - room, all->high + room};
}

void Document::bringBack(std::span<const BodyId> bodies) {
    if (!moved_) return;
    constexpr double step = 1;  // metres between those that the plan does not have
    double top = 0;
    for (const Placement& body : plan_.scene().bodies) top = std::max(top, body.pose.position.y());
    double x = -step * static_cast<double>(bodies.size()) / 2;
    for (const BodyId body : bodies) {
        const std::string id = idOf(body);
        Pose pose{.position = {x += step, top + 3}, .angle = 0};
        if (!id.empty()) pose = plan_.body(id).pose;
        world_->setPose(body, pose);
        if (world_->kind(body) == sulfur::BodyKind::dynamic)
            world_->setVelocity(body, Vec2(0, 0), 0);
    }
    touched();
}

// --- blueprints ------------------------------------------------------------------------------

void Document::change(std::span<const BodyId> bodies, const std::function<void(Prefab&)>& change) {
    struct Changed {
        BodyId body;
        std::string id;
        sulfur::Blueprint before;
    };
    std::vector<Changed> changed;
    std::vector<BodyId> pieces;
    for (const BodyId body : bodies) {
        std::string id = idOf(body);
        if (id.empty()) {
            pieces.push_back(body);
            continue;
        }
        sulfur::Blueprint before = scaled(plan_.blueprint(id), constants_);
        changed.push_back({body, std::move(id), std::move(before)});
    }
    const auto ids = idsOf(bodies);
    takeOver([&] {
        plan_.change(ids, change);
        touched();
        for (const Changed& one : changed)
            follow(*world_, one.body, one.before, scaled(plan_.blueprint(one.id), constants_));
        for (const BodyId piece : pieces) changePiece(piece, change);
    });
    for (const Changed& one : changed) renewRails(one.id, one.before.joints.size());
}

void Document::changePiece(BodyId body, const std::function<void(Prefab&)>& change) {
    const Pose pose = world_->pose(body);
    Prefab prefab;
    prefab.blueprint = sulfur::scene::blueprintNow(*world_, body, pose.position);
    const sulfur::Blueprint before = prefab.blueprint;
    change(prefab);
    follow(*world_, body, before, prefab.blueprint);
}

void Document::rebuild(const std::function<void(Plan&)>& change) {
    change(plan_);
    plan_ = Plan(sulfur::scene::parse(sulfur::scene::format(plan_.scene()), "the scene"));
    playing_ = false;
    stamp();
}

void Document::rename(BodyId body, const std::string& to) {
    const std::string id = idOf(body);
    if (id.empty()) throw std::runtime_error("a piece has no name");
    renameInLevel(*this, id, to);
    plan_.rename(id, to);
    world_->setUserData(body, keyOf(to));
    touched();
}

void Document::setPinned(ParticleId particle, bool pinned) {
    const auto ref = refOf(particle);
    world_->setPinned(particle, pinned);
    touched();
    if (!ref) return;
    plan_.change({ref->body}, [&](Prefab& prefab) {
        prefab.generator = {};
        prefab.blueprint.particles[ref->particle].pinned = pinned;
    });
    const BodyId body = world_->info(particle).body;
    if (moved_) bringPlanHere({&body, 1});
}

// --- the level -------------------------------------------------------------------------------

const std::string& Document::levelText() const {
    static const std::string none;
    const auto* member = sulfur::scene::findExtra(plan_.scene().extra, "level");
    return member == nullptr ? none : member->json;
}

void Document::setLevelText(std::string json) {
    auto& extra = plan_.scene().extra;
    if (json.empty())
        sulfur::scene::eraseExtra(extra, "level");
    else
        sulfur::scene::setExtra(extra, "level", std::move(json));
    ++revision_;
}

// --- constants -------------------------------------------------------------------------------

void Document::setConstants(const Constants& wanted) {
    using L = ConstantLimits;
    const bool own = !open_;
    if (own) begin("Change constants");
    try {
        auto& settings = plan_.scene().settings;
        const double gravity = std::clamp(wanted.gravity, -L::gravity, L::gravity);
        if (gravity != constants_.gravity) {
            settings.gravity = {settings.gravity.x(), static_cast<Real>(-gravity)};
            world_->setGravity(settings.gravity);
            touched();
            constants_.gravity = gravity;
        }
        const double air =
            std::clamp(wanted.airFriction, 0.0,
                       std::min(L::airFriction, static_cast<double>(settings.tickRate)));
        if (air != constants_.airFriction) {
            settings.airFriction = static_cast<Real>(air);
            world_->setAirFriction(settings.airFriction);
            touched();
            constants_.airFriction = air;
        }
        setFactors(wanted);
    } catch (...) {
        rollback();
        throw;
    }
    if (own) commit();
}

void Document::setFactors(const Constants& wanted) {
    using L = ConstantLimits;
    Constants next = constants_;
    next.elasticity = std::clamp(wanted.elasticity, L::minElasticity, L::maxElasticity);
    next.friction = std::clamp(wanted.friction, 0.0, L::friction);
    if (next == constants_) return;
    // What is not of the plan is scaled by the quotient; from a friction of 0 it comes back to the
    // usual one.
    Constants quotient;
    quotient.elasticity = next.elasticity / constants_.elasticity;
    quotient.friction = constants_.friction > 0 ? next.friction / constants_.friction : 1;
    const auto bodies = world_->bodies();
    for (const BodyId body : std::vector<BodyId>(bodies.begin(), bodies.end())) {
        if (const std::string id = idOf(body); !id.empty()) {
            const auto plan = plan_.blueprint(id);
            follow(*world_, body, scaled(plan, constants_), scaled(plan, next));
            continue;
        }
        sulfur::Blueprint now =
            sulfur::scene::blueprintNow(*world_, body, world_->centreOfMass(body));
        sulfur::Blueprint after = scaled(now, quotient);
        if (!(constants_.friction > 0)) after.material = scaled(sulfur::Material{}, next);
        follow(*world_, body, now, after);
    }
    for (const JointId joint : world_->connections())
        world_->setStiffness(joint, scaled(world_->info(joint).stiffness, quotient));
    constants_ = next;
    touched();
}

}  // namespace sulfurchamber
