// Looking at instances, making templates of them and following these; placing is in
// place_instances.cpp.
#include "instances.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "fitting.hpp"
#include "instance_parts.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Pose;
using sulfur::scene::Placement;
using sulfur::scene::Prefab;
using sulfur::scene::Scene;

// The names of parts become the ids of bodies, or the other way round. Ties to others go.
void renameAll(Scene& scene, const std::map<std::string, std::string>& names) {
    const auto change = [&](std::string& name) { name = names.at(name); };
    forEachTiedName(scene, change);
    auto thrusters = thrustersOf(scene);
    for (Thruster& thruster : thrusters) change(thruster.body);
    for (Placement& body : scene.bodies)
        if (names.contains(body.id)) change(body.id);
    setThrusters(scene, thrusters);
}

// Ties of bodies or particles that are not there.
void dropLostTies(Scene& ties, const std::map<std::string, Part>& parts) {
    const auto lost = [&](const std::string& part) { return !parts.contains(part); };
    const auto lostEnd = [&](const sulfur::scene::ParticleRef& end) {
        return lost(end.body) ||
               end.particle >= parts.at(end.body).prefab.blueprint.particles.size();
    };
    std::erase_if(ties.connections, [&](const auto& c) { return lostEnd(c.a) || lostEnd(c.b); });
    std::erase_if(ties.attachments,
                  [&](const auto& a) { return lostEnd(a.particle) || lost(a.body); });
    std::erase_if(ties.vetoes, [&](const auto& v) { return lost(v.a) || lost(v.b); });
    sulfur::scene::removeMechanisms(ties.mechanisms, lost);
    auto thrusters = thrustersOf(ties);
    std::erase_if(thrusters, [&](const Thruster& thruster) { return lost(thruster.body); });
    setThrusters(ties, thrusters);
}

/// What an instance becomes.
struct Following {
    Instance instance;
    Pose frame;
    std::map<std::string, Part> before;
    std::map<std::string, Part> parts;  ///< in the frame
    std::vector<std::string> gone;      ///< ids of bodies
    Scene ties;
};

Following follow(const Plan& plan, const Instance& instance, const Template& base,
                 const Template& next) {
    const auto baseParts = partsOf(base);
    const auto nextParts = partsOf(next);
    Looked mine = look(plan, instance, baseParts);
    Following made{instance, mine.frame, mine.parts, {}, {}, {}};
    for (const auto& [part, own] : mine.parts) {
        const auto before = baseParts.find(part);
        const auto now = nextParts.find(part);
        if (now == nextParts.end() && before != baseParts.end())
            made.gone.push_back(instance.ids.at(part));
        else if (now == nextParts.end() || before == baseParts.end())
            made.parts.emplace(part, own);
        else
            made.parts.emplace(part, merged(before->second, own, now->second));
    }
    for (const auto& [part, now] : nextParts)
        if (!baseParts.contains(part) && !mine.parts.contains(part)) made.parts.emplace(part, now);
    made.ties = mergedTies(base.scene, mine.scene, next.scene);
    dropLostTies(made.ties, made.parts);
    return made;
}

std::string textOfPrefab(Prefab prefab) {
    prefab.blueprint.name = "x";
    return sulfur::scene::format(prefab);
}

// Blueprints of all parts of all instances; those that are equal change together.
void writeBlueprints(Plan& plan, const std::vector<Following>& all) {
    std::map<std::string, std::pair<std::vector<std::string>, const Prefab*>> groups;
    for (const Following& one : all)
        for (const auto& [part, now] : one.parts) {
            const auto id = one.instance.ids.find(part);
            if (id == one.instance.ids.end()) continue;
            std::string text = textOfPrefab(now.prefab);
            if (text == textOfPrefab(one.before.at(part).prefab)) continue;
            auto& group = groups[std::move(text)];
            group.first.push_back(id->second);
            group.second = &now.prefab;
        }
    for (const auto& [text, group] : groups)
        plan.change(group.first, [&](Prefab& prefab) { prefab = *group.second; });
}

void writePlacement(Plan& plan, const std::string& id, const Part& before, const Part& now,
                    const Pose& frame) {
    Placement& body = plan.body(id);
    const auto membership = membershipOf(body);
    body.extra = now.placement.extra;
    if (membership) setMembership(body, *membership);
    if (agree("place", before, now)) return;
    Placement carried = now.placement;
    carry(carried, frame);
    body.pose = carried.pose;
    body.velocity = carried.velocity;
    body.state = std::move(carried.state);
}

// In the place of the old ones, so that gears find their parts before them.
void writeTies(Plan& plan, Following& one, const std::map<std::string, std::string>& ids) {
    Scene& scene = plan.scene();
    std::set<std::string> mine;
    for (const auto& [part, id] : ids) mine.insert(id);
    const auto own = [&](const std::string& id) { return mine.contains(id); };
    std::erase_if(scene.connections, [&](const auto& c) { return own(c.a.body) && own(c.b.body); });
    std::erase_if(scene.attachments,
                  [&](const auto& a) { return own(a.particle.body) && own(a.body); });
    std::erase_if(scene.vetoes, [&](const auto& v) { return own(v.a) && own(v.b); });
    std::map<std::string, std::string> known;  // mechanisms by part
    std::set<std::string> taken;
    std::vector<sulfur::scene::SceneMechanism> kept;
    std::optional<std::size_t> place;
    std::set<std::string> inner;
    for (auto& mechanism : scene.mechanisms) {
        const auto names = bodiesOf(mechanism);
        bool isInner =
            std::all_of(names.begin(), names.end(), [&](auto* name) { return own(*name); });
        if (const auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec))
            isInner = inner.contains(gear->first) && inner.contains(gear->second);
        if (isInner) {
            if (!place) place = kept.size();
            inner.insert(mechanism.id);
            known.emplace(partOf(mechanism), mechanism.id);
        } else {
            taken.insert(mechanism.id);
            kept.push_back(std::move(mechanism));
        }
    }
    renameAll(one.ties, ids);
    std::map<std::string, std::string> named;
    for (auto& mechanism : one.ties.mechanisms) {
        const std::string part = mechanism.id;
        if (auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec)) {
            gear->first = named.at(gear->first);
            gear->second = named.at(gear->second);
        }
        carry(mechanism, one.frame);
        if (part.empty()) continue;
        const auto before = known.find(part);
        std::string id = before == known.end() || before->second.empty() ? part : before->second;
        for (int n = 2; !taken.insert(id).second; ++n) id = part + std::to_string(n);
        mechanism.id = id;
        setPart(mechanism, part);
        named.emplace(part, id);
    }
    kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(place.value_or(kept.size())),
                one.ties.mechanisms.begin(), one.ties.mechanisms.end());
    scene.mechanisms = std::move(kept);
    for (auto& connection : one.ties.connections)
        scene.connections.push_back(std::move(connection));
    for (auto& attachment : one.ties.attachments)
        scene.attachments.push_back(std::move(attachment));
    for (auto& veto : one.ties.vetoes) scene.vetoes.push_back(std::move(veto));
    auto thrusters = thrustersOf(scene);
    std::erase_if(thrusters, [&](const Thruster& thruster) { return own(thruster.body); });
    const auto added = thrustersOf(one.ties);
    thrusters.insert(thrusters.end(), added.begin(), added.end());
    setThrusters(scene, thrusters);
}

void writeInstance(Plan& plan, Following& one) {
    plan.remove(one.gone);
    std::map<std::string, std::string> ids;
    for (const auto& [part, now] : one.parts) {
        const auto known = one.instance.ids.find(part);
        if (known != one.instance.ids.end()) {
            ids.emplace(part, known->second);
            writePlacement(plan, known->second, one.before.at(part), now, one.frame);
            continue;
        }
        Placement body = now.placement;
        carry(body, one.frame);
        setMembership(body, {one.instance.name, one.instance.instance, part});
        ids.emplace(part, plan.add(now.prefab, std::move(body)));
    }
    writeTies(plan, one, ids);
}

const Instance* find(const std::vector<Instance>& all, const std::string& instance) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto& one) { return one.instance == instance; });
    return found == all.end() ? nullptr : &*found;
}

// An instance of a document with its template; throws where there is none.
struct Known {
    Instance instance;
    Template made;
    std::map<std::string, Part> base;
    Looked looked;
};
Known known(const Document& document, const std::string& instance) {
    const auto all = instancesOf(document.scene());
    const Instance* one = find(all, instance);
    if (one == nullptr) throw std::runtime_error(tr("there is no instance \"{}\"", {instance}));
    auto made = definition(document.scene(), one->name);
    if (!made)
        throw std::runtime_error(tr(
            "the scene does not have the template \"{}\"; unlink its instances, or paste it again",
            {one->name}));
    auto base = partsOf(*made);
    Looked looked = look(document.plan(), *one, base);
    return {*one, std::move(*made), std::move(base), std::move(looked)};
}

Membership membershipIn(const Document& document, const std::string& id) {
    const auto membership = membershipOf(document.plan().body(id));
    if (!membership) throw std::runtime_error(tr("\"{}\" is no part of an instance", {id}));
    return *membership;
}

// A template whose parts are these.
Template remade(const Template& made, const std::map<std::string, Part>& parts, Scene ties) {
    Template next = made;
    setThrusters(next.scene, thrustersOf(ties));
    next.scene.blueprints.clear();
    next.scene.bodies.clear();
    next.scene.connections = std::move(ties.connections);
    next.scene.attachments = std::move(ties.attachments);
    next.scene.vetoes = std::move(ties.vetoes);
    next.scene.mechanisms = std::move(ties.mechanisms);
    Plan plan(next.scene);
    // In the order that they had, new ones last.
    std::vector<std::string> order;
    for (const Placement& body : made.scene.bodies)
        if (parts.contains(body.id)) order.push_back(body.id);
    for (const auto& [part, one] : parts)
        if (made.scene.body(part) == nullptr) order.push_back(part);
    std::vector<std::string> ids;
    for (const std::string& part : order) {
        Placement body = parts.at(part).placement;
        clearMembership(body);
        ids.push_back(plan.add(parts.at(part).prefab, std::move(body)));
    }
    for (std::size_t i = 0; i < order.size(); ++i) plan.scene().bodies[i].id = order[i];
    next.scene = plan.scene();
    nameMechanisms(next.scene);
    return next;
}

}  // namespace

// --- looking ---------------------------------------------------------------------------------

std::vector<Override> overridesOf(const Document& document, const std::string& id) {
    std::vector<Override> found;
    if (id.empty() || !document.plan().contains(id)) return found;
    const auto membership = membershipOf(document.plan().body(id));
    if (!membership || !definition(document.scene(), membership->name)) return found;
    const Known one = known(document, membership->instance);
    const auto base = one.base.find(membership->part);
    if (base == one.base.end()) return found;
    const Part& mine = one.looked.parts.at(membership->part);
    const bool ownShape = !agree("shape", base->second, mine);
    for (const Trait& trait : traits()) {
        if (agree(trait.key, base->second, mine)) continue;
        // The mass of another shape goes with the shape.
        if (ownShape && trait.key == "mass") continue;
        found.push_back({std::string(trait.key), std::string(trait.name)});
    }
    return found;
}

std::size_t overrideCount(const Document& document, const std::string& instance) {
    const auto all = instancesOf(document.scene());
    const Instance* one = find(all, instance);
    if (one == nullptr) return 0;
    const auto made = definition(document.scene(), one->name);
    if (!made) return 0;
    const auto base = partsOf(*made);
    const Looked mine = look(document.plan(), *one, base);
    std::size_t count = tieDifferences(made->scene, mine.scene);
    for (const auto& [part, before] : base) {
        const auto own = mine.parts.find(part);
        if (own == mine.parts.end()) {
            ++count;
            continue;
        }
        for (const Trait& trait : traits())
            if (!agree(trait.key, before, own->second)) ++count;
    }
    return count;
}

std::vector<std::string> instancesOf(const Document& document, const std::vector<BodyId>& bodies) {
    std::vector<std::string> names;
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        const auto membership = membershipOf(document.plan().body(id));
        if (membership &&
            std::find(names.begin(), names.end(), membership->instance) == names.end())
            names.push_back(membership->instance);
    }
    return names;
}

// --- making ----------------------------------------------------------------------------------

Template makeTemplate(Document& document, const std::vector<BodyId>& bodies,
                      const std::string& name, const std::string& category) {
    if (name.empty() || name.size() > sulfur::scene::Limits::nameBytes ||
        name.find_first_of("\n\t\"\\/") != std::string::npos)
        throw std::runtime_error(
            tr("\"{}\" is no name for a template; allowed is one line of 1 to {} bytes without "
               "quotes and slashes",
               {name, std::to_string(sulfur::scene::Limits::nameBytes)}));
    if (definition(document.scene(), name))
        throw std::runtime_error(
            tr("the scene has a template \"{}\" already; update that one, or choose another name",
               {name}));
    Instance instance{name, freeInstance(document.scene(), name), {}};
    for (const BodyId body : document.withPegs(bodies))
        if (const std::string id = document.idOf(body); !id.empty()) instance.ids.emplace(id, id);
    if (instance.ids.empty())
        throw std::runtime_error(
            "nothing of what is selected was built; a template needs bodies "
            "that were");
    const Looked looked = look(document.plan(), instance, {});
    Template made{category.empty() ? "Other" : category, {}};
    made.scene.title = name;
    made.scene.settings = document.scene().settings;
    made = remade(made, looked.parts, looked.scene);
    const Bounds bounds = boundsOf(made.scene);
    moveScene(made.scene, -Point(bounds.centre().x(), bounds.low.y()));
    Scene& scene = document.planForEditing();
    for (const auto& [part, id] : instance.ids)
        setMembership(document.placementForEditing(id), {name, instance.instance, part});
    // Its mechanisms are those of the first instance, in the same order.
    std::size_t next = 0;
    std::set<std::string> inner;
    for (auto& mechanism : scene.mechanisms) {
        const auto names = bodiesOf(mechanism);
        bool isInner = std::all_of(names.begin(), names.end(),
                                   [&](auto* body) { return instance.ids.contains(*body); });
        if (const auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec))
            isInner = inner.contains(gear->first) && inner.contains(gear->second);
        if (!isInner) continue;
        inner.insert(mechanism.id);
        setPart(mechanism, made.scene.mechanisms.at(next++).id);
    }
    define(scene, made);
    return made;
}

// --- following -------------------------------------------------------------------------------

Template templateFrom(const Document& document, const std::string& instance) {
    const Known one = known(document, instance);
    return remade(one.made, one.looked.parts, one.looked.scene);
}

void changeTemplate(Document& document, const Template& next) {
    const auto base = definition(document.scene(), next.name());
    if (!base)
        throw std::runtime_error(tr("the scene does not have the template \"{}\"", {next.name()}));
    boundsOf(next.scene);  // what cannot be made is refused here
    document.rebuild([&](Plan& plan) {
        std::vector<Following> all;
        for (const Instance& instance : instancesOf(plan.scene()))
            if (instance.name == next.name()) all.push_back(follow(plan, instance, *base, next));
        writeBlueprints(plan, all);
        for (Following& one : all) writeInstance(plan, one);
        define(plan.scene(), next);
    });
}

void resetOverride(Document& document, const std::string& id, const std::string& key) {
    const Membership membership = membershipIn(document, id);
    const Known one = known(document, membership.instance);
    const auto base = one.base.find(membership.part);
    if (base == one.base.end()) return;
    Part mine = one.looked.parts.at(membership.part);
    const Part before = mine;
    for (const Trait& trait : traits())
        if ((key.empty() || trait.key == key) && !agree(trait.key, mine, base->second))
            take(trait.key, mine, base->second);
    document.rebuild([&](Plan& plan) {
        if (textOfPrefab(mine.prefab) != textOfPrefab(before.prefab))
            plan.change({id}, [&](Prefab& prefab) { prefab = mine.prefab; });
        writePlacement(plan, id, before, mine, one.looked.frame);
    });
}

Template applyOverride(Document& document, const std::string& id, const std::string& key) {
    const Membership membership = membershipIn(document, id);
    const Known one = known(document, membership.instance);
    const Part& mine = one.looked.parts.at(membership.part);
    auto parts = one.base;
    const auto base = parts.find(membership.part);
    if (base == parts.end()) return one.made;
    for (const Trait& trait : traits())
        if ((key.empty() || trait.key == key) && !agree(trait.key, base->second, mine))
            take(trait.key, base->second, mine);
    Template next = remade(one.made, parts, one.made.scene);
    changeTemplate(document, next);
    return next;
}

void unlink(Document& document, const std::vector<std::string>& instances) {
    Scene& scene = document.planForEditing();
    std::set<std::string> free;
    for (const Instance& one : instancesOf(scene)) {
        if (std::find(instances.begin(), instances.end(), one.instance) == instances.end())
            continue;
        for (const auto& [part, id] : one.ids) {
            clearMembership(document.placementForEditing(id));
            free.insert(id);
        }
    }
    for (auto& mechanism : scene.mechanisms) {
        const auto names = bodiesOf(mechanism);
        if (!names.empty() && std::all_of(names.begin(), names.end(),
                                          [&](auto* name) { return free.contains(*name); }))
            setPart(mechanism, "");
    }
    forgetUnusedDefinitions(scene);
}

}  // namespace sulfurchamber
