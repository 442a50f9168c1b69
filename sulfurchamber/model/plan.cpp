#include "plan.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "fitting.hpp"
#include "meter.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::scene::Placement;
using sulfur::scene::Prefab;
using sulfur::scene::Scene;

// What two blueprints have in common when they are equal: all but the name.
std::string textOf(Prefab prefab) {
    prefab.blueprint.name = "x";
    return sulfur::scene::format(prefab);
}

bool hasOverrides(const Placement& body) {
    return body.kind || body.material || body.filter || body.sensor;
}

std::string baseOf(const std::string& name) {
    const auto end = name.find_last_not_of("0123456789");
    return end == std::string::npos ? name : name.substr(0, end + 1);
}

}  // namespace

void rebuild(Prefab& prefab) {
    if (prefab.generator.index() == 0) return;
    sulfur::Blueprint made = sulfur::scene::build(prefab.generator);
    const sulfur::Blueprint& old = prefab.blueprint;
    made.name = old.name;
    made.kind = old.kind;
    made.filter = old.filter;
    made.sensor = old.sensor;
    made.selfCollision = old.selfCollision;
    if (old.skin && prefab.skinFitted)
        made.skin = sulfur::scene::fitSkin(prefab.generator, made, old.skin->texture);
    else if (old.skin && old.particles.size() == made.particles.size())
        made.skin = old.skin;
    prefab.blueprint = std::move(made);
}

Plan::Plan(Scene scene) : scene_(std::move(scene)) {
    index();
}

void Plan::index() {
    bodies_.clear();
    prefabs_.clear();
    users_.clear();
    texts_.clear();
    numbers_.clear();
    particles_ = 0;
    joints_ = scene_.connections.size();
    for (std::size_t i = 0; i < scene_.blueprints.size(); ++i)
        prefabs_.emplace(scene_.blueprints[i].blueprint.name, i);
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        bodies_.emplace(scene_.bodies[i].id, i);
        ++users_[scene_.bodies[i].blueprint];
        count(prefab(scene_.bodies[i].blueprint).blueprint, 1);
    }
}

void Plan::count(const sulfur::Blueprint& blueprint, int sign) {
    const auto add = [sign](std::size_t& sum, std::size_t n) { sign > 0 ? sum += n : sum -= n; };
    add(particles_, blueprint.particles.size());
    add(joints_, blueprint.joints.size() + blueprint.angles.size());
}

bool Plan::contains(std::string_view id) const {
    return bodies_.contains(std::string(id));
}

const Placement& Plan::body(std::string_view id) const {
    return scene_.bodies[bodies_.at(std::string(id))];
}

Placement& Plan::body(std::string_view id) {
    return scene_.bodies[bodies_.at(std::string(id))];
}

const Prefab& Plan::prefab(std::string_view name) const {
    return scene_.blueprints[prefabs_.at(std::string(name))];
}

sulfur::Blueprint Plan::blueprint(std::string_view id) const {
    const Placement& placement = body(id);
    sulfur::Blueprint plan = prefab(placement.blueprint).blueprint;
    if (placement.kind) plan.kind = *placement.kind;
    if (placement.material) plan.material = *placement.material;
    if (placement.filter) plan.filter = *placement.filter;
    if (placement.sensor) plan.sensor = *placement.sensor;
    return plan;
}

Prefab Plan::dressed(std::string_view id) const {
    const Placement& placement = body(id);
    Prefab made = prefab(placement.blueprint);
    made.blueprint = blueprint(id);
    if (!placement.material) return made;
    std::visit(
        [&](auto& options) {
            if constexpr (requires { options.material; }) options.material = *placement.material;
        },
        made.generator);
    return made;
}

std::string Plan::freeId(const std::string& base) {
    const std::string stem = baseOf(base).empty() ? base : baseOf(base);
    const bool numbered = stem.ends_with('-') || stem.ends_with('_') || stem.ends_with(' ');
    int& number = numbers_.try_emplace(stem, 1).first->second;
    for (;; ++number) {
        std::string id = number == 1 && !numbered ? stem : stem + std::to_string(number);
        if (!bodies_.contains(id)) return id;
    }
}

// The name of an equal blueprint, or of this one, which is new then.
std::string Plan::share(Prefab prefab) {
    if (texts_.empty())
        for (const Prefab& known : scene_.blueprints)
            texts_.emplace(textOf(known), known.blueprint.name);
    std::string text = textOf(prefab);
    if (const auto known = texts_.find(text); known != texts_.end()) return known->second;
    const std::string base = prefab.blueprint.name.empty() ? "body" : baseOf(prefab.blueprint.name);
    std::string name = base.empty() ? "body" : base;
    for (int n = 2; prefabs_.contains(name); ++n) name = base + std::to_string(n);
    prefab.blueprint.name = name;
    prefabs_.emplace(name, scene_.blueprints.size());
    texts_.emplace(std::move(text), name);
    scene_.blueprints.push_back(std::move(prefab));
    return name;
}

std::string Plan::add(Prefab prefab, Placement placement) {
    placement.id = freeId(prefab.blueprint.name.empty() ? "body" : prefab.blueprint.name);
    placement.blueprint = share(std::move(prefab));
    ++users_[placement.blueprint];
    count(this->prefab(placement.blueprint).blueprint, 1);
    bodies_.emplace(placement.id, scene_.bodies.size());
    scene_.bodies.push_back(std::move(placement));
    return scene_.bodies.back().id;
}

void Plan::forgetUnused(const std::vector<std::string>& names) {
    const std::set<std::string> gone(names.begin(), names.end());
    std::erase_if(scene_.blueprints, [&](const Prefab& prefab) {
        const std::string& name = prefab.blueprint.name;
        if (!gone.contains(name)) return false;
        return std::none_of(scene_.bodies.begin(), scene_.bodies.end(),
                            [&](const Placement& body) { return body.blueprint == name; });
    });
    index();
}

void Plan::remove(const std::vector<std::string>& ids) {
    const std::set<std::string> gone(ids.begin(), ids.end());
    std::vector<std::string> names;
    for (const std::string& id : gone) names.push_back(body(id).blueprint);
    auto thrusters = thrustersOf(scene_);
    forgetMeters(scene_, [&](const std::string& id) { return gone.contains(id); });
    std::erase_if(scene_.bodies, [&](const Placement& body) { return gone.contains(body.id); });
    std::erase_if(scene_.connections, [&](const auto& connection) {
        return gone.contains(connection.a.body) || gone.contains(connection.b.body);
    });
    std::erase_if(scene_.attachments, [&](const auto& attachment) {
        return gone.contains(attachment.particle.body) || gone.contains(attachment.body);
    });
    std::erase_if(scene_.vetoes,
                  [&](const auto& veto) { return gone.contains(veto.a) || gone.contains(veto.b); });
    sulfur::scene::removeMechanisms(scene_.mechanisms,
                                    [&](const std::string& id) { return gone.contains(id); });
    std::erase_if(thrusters, [&](const auto& thruster) { return gone.contains(thruster.body); });
    setThrusters(scene_, thrusters);
    forgetUnused(names);
}

void Plan::change(const std::vector<std::string>& ids, const std::function<void(Prefab&)>& change) {
    // Bodies of one blueprint change together, those with words of their own each for itself.
    std::vector<std::vector<std::string>> groups;
    std::unordered_map<std::string, std::size_t> groupOf;
    for (const std::string& id : ids) {
        const Placement& placement = body(id);
        const std::string key =
            hasOverrides(placement) ? "body " + id : "blueprint " + placement.blueprint;
        const auto [found, isNew] = groupOf.emplace(key, groups.size());
        if (isNew) groups.emplace_back();
        groups[found->second].push_back(id);
    }
    std::vector<std::string> left;
    for (const auto& group : groups) {
        Prefab prefab = dressed(group.front());
        const std::string before = prefab.blueprint.name;
        change(prefab);
        prefab.blueprint.name = before;
        prefab.blueprint.validate();
        std::string name = before;
        if (users_.at(before) == group.size()) {
            scene_.blueprints[prefabs_.at(before)] = std::move(prefab);
            texts_.clear();
        } else {
            name = share(std::move(prefab));
            users_[before] -= group.size();
            users_[name] += group.size();
            left.push_back(before);
        }
        const std::size_t particles = this->prefab(name).blueprint.particles.size();
        for (const std::string& id : group) {
            Placement& placement = body(id);
            placement.blueprint = name;
            if (placement.state && placement.state->positions.size() != particles)
                placement.state.reset();
            placement.kind.reset();
            placement.material.reset();
            placement.filter.reset();
            placement.sensor.reset();
        }
    }
    forgetLostEnds();
    forgetUnused(left);
}

// Connections to particles that a blueprint no longer has.
void Plan::forgetLostEnds() {
    const auto lost = [&](const sulfur::scene::ParticleRef& end) {
        return end.particle >= prefab(body(end.body).blueprint).blueprint.particles.size();
    };
    std::erase_if(scene_.connections, [&](const auto& c) { return lost(c.a) || lost(c.b); });
    std::erase_if(scene_.attachments, [&](const auto& a) { return lost(a.particle); });
}

void forEachTiedName(sulfur::scene::Scene& scene, const std::function<void(std::string&)>& change) {
    for (auto& connection : scene.connections) {
        change(connection.a.body);
        change(connection.b.body);
    }
    for (auto& attachment : scene.attachments) {
        change(attachment.particle.body);
        change(attachment.body);
    }
    for (auto& veto : scene.vetoes) {
        change(veto.a);
        change(veto.b);
    }
    for (auto& mechanism : scene.mechanisms)
        for (std::string* name : bodiesOf(mechanism)) change(*name);
}

void Plan::rename(const std::string& id, const std::string& to) {
    if (id == to) return;
    if (to.empty() || to.size() > sulfur::scene::Limits::nameBytes ||
        to.find_first_of("\n\t\"\\") != std::string::npos)
        throw std::runtime_error(tr("“{}” is no name; allowed is one line of 1 to {} bytes",
                                    {to, std::to_string(sulfur::scene::Limits::nameBytes)}));
    if (contains(to))
        throw std::runtime_error(tr("“{}” is the name of another body; choose a free one", {to}));
    auto thrusters = thrustersOf(scene_);
    const bool thrusts = std::any_of(thrusters.begin(), thrusters.end(),
                                     [&](const auto& thruster) { return thruster.body == id; });
    for (const auto& member : scene_.extra)
        if (member.key != "meters" && !(thrusts && member.key == "devices") &&
            member.key != "templates" &&  // have names of their own
            member.json.find('"' + id + '"') != std::string::npos)
            throw std::runtime_error(
                tr("the {} of the scene names “{}”; change it there first", {member.key, id}));
    renameInMeters(scene_, id, to);
    body(id).id = to;
    const auto change = [&](std::string& name) {
        if (name == id) name = to;
    };
    forEachTiedName(scene_, change);
    for (auto& thruster : thrusters) change(thruster.body);
    if (thrusts) setThrusters(scene_, thrusters);
    index();
}

void Plan::connect(sulfur::scene::Connection connection) {
    scene_.connections.push_back(std::move(connection));
    ++joints_;
}

void Plan::remove(std::size_t connection) {
    scene_.connections.erase(scene_.connections.begin() + static_cast<std::ptrdiff_t>(connection));
    --joints_;
}

void Plan::carryMechanisms(const std::string& id, const sulfur::Pose& from,
                           const sulfur::Pose& to) {
    using sulfur::Point;
    const double turn = std::remainder(to.angle - from.angle, 2 * std::numbers::pi);
    const Eigen::Rotation2Dd turned(turn);
    const auto moved = [&](const Point& p) -> Point {
        return to.position + turned * (p - from.position);
    };
    const auto carryAngle = [&](auto& spec) {
        if (spec.b == id) spec.options.value += turn;
        if (spec.a == id) spec.options.value -= turn;
    };
    const auto carryAxis = [&](auto& spec) {
        const Point axis = spec.axis.template cast<double>().normalized();
        if (spec.a == id) spec.axis = Point(turned * axis).template cast<sulfur::Real>();
        if constexpr (requires { spec.options.value; }) {
            double& value = spec.options.value;
            if (spec.b == id) value += axis.dot(moved(spec.at) - spec.at);
            if (spec.a == id) value = (turned * axis).dot(spec.at - moved(spec.at - value * axis));
        }
    };
    const auto carry = [&](auto& spec) {
        if constexpr (requires { spec.axis; })
            carryAxis(spec);
        else if constexpr (requires { spec.options.value; })
            carryAngle(spec);
    };
    for (auto& mechanism : scene_.mechanisms) {
        std::visit(carry, mechanism.spec);
        for (Point* point : pointsOf(mechanism, id)) *point = moved(*point);
    }
}

std::vector<std::string> Plan::tiedTo(const std::vector<std::string>& ids) const {
    std::unordered_map<std::string, std::vector<std::string>> neighbours;
    const auto tie = [&](const std::string& a, const std::string& b) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    };
    for (const auto& connection : scene_.connections) tie(connection.a.body, connection.b.body);
    for (const auto& attachment : scene_.attachments)
        tie(attachment.particle.body, attachment.body);
    for (auto mechanism : scene_.mechanisms) {
        const auto names = bodiesOf(mechanism);
        for (std::size_t i = 1; i < names.size(); ++i) tie(*names[i - 1], *names[i]);
    }
    std::vector<std::string> found(ids);
    std::set<std::string> seen(ids.begin(), ids.end());
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const std::string& next : neighbours[found[i]])
            if (seen.insert(next).second) found.push_back(next);
    return found;
}

}  // namespace sulfurchamber
