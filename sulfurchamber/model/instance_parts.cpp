#include "instance_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "fitting.hpp"
#include "properties.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Pose;
using sulfur::scene::Placement;
using sulfur::scene::Prefab;
using sulfur::scene::Scene;
using sulfur::scene::SceneMechanism;

constexpr double sameNumber = 1e-4;  // relative: edits by sliders round
constexpr double samePlace = 1e-4;   // metres, and radians

bool near(double a, double b) {
    return a == b || std::abs(a - b) <= sameNumber * std::max(std::abs(a), std::abs(b));
}

bool near(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() < samePlace &&
           std::abs(std::remainder(a.angle - b.angle, 2 * std::numbers::pi)) < samePlace;
}

// Density is mass by area: it is told as the mass.
bool isTrait(const NumberProperty& property) {
    return property.key != "density";
}

bool sameValue(const NumberProperty& property, const Part& a, const Part& b) {
    const auto x = property.get(a.prefab);
    const auto y = property.get(b.prefab);
    if (!x || !y || std::isnan(*x) || std::isnan(*y)) return true;  // told by the shape
    return near(*x, *y);
}

// Particle by particle and joint by joint, whatever the numbers of the whole are.
bool sameStructure(const sulfur::Blueprint& a, const sulfur::Blueprint& b) {
    if (a.particles.size() != b.particles.size() || a.joints.size() != b.joints.size() ||
        a.angles.size() != b.angles.size())
        return false;
    for (std::size_t i = 0; i < a.particles.size(); ++i) {
        const auto& p = a.particles[i];
        const auto& q = b.particles[i];
        if (static_cast<double>((p.position - q.position).norm()) > samePlace ||
            p.pinned != q.pinned || !near(p.radius, q.radius) || !near(p.mass, q.mass))
            return false;
    }
    return std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(),
                      [](const auto& p, const auto& q) {
                          return p.a == q.a && p.b == q.b && near(p.radius, q.radius) &&
                                 near(p.stiffness, q.stiffness) && near(p.damping, q.damping) &&
                                 near(p.strength, q.strength);
                      });
}

// Whether `a` would be as `b` is, if it had the numbers of `b`.
bool sameForm(const Part& a, const Part& b) {
    Part like = a;
    for (const NumberProperty& property : numberProperties())
        if (isTrait(property) && !sameValue(property, like, b))
            property.set(like.prefab, *property.get(b.prefab));
    return sameStructure(like.prefab.blueprint, b.prefab.blueprint);
}

bool sameSkin(const Part& a, const Part& b) {
    const auto& x = a.prefab.blueprint.skin;
    const auto& y = b.prefab.blueprint.skin;
    if (!x || !y) return !x && !y;
    if (x->texture != y->texture) return false;
    if (a.prefab.skinFitted || b.prefab.skinFitted)
        return a.prefab.skinFitted == b.prefab.skinFitted;
    return x->uv.size() == y->uv.size() &&
           std::equal(x->uv.begin(), x->uv.end(), y->uv.begin(), [](const auto& p, const auto& q) {
               return static_cast<double>((p - q).norm()) < samePlace;
           });
}

void takeSkin(Part& part, const Part& from) {
    part.prefab.skinFitted = from.prefab.skinFitted;
    part.prefab.blueprint.skin = from.prefab.blueprint.skin;
    if (!part.prefab.blueprint.skin) return;
    if (part.prefab.skinFitted)
        part.prefab.blueprint.skin = sulfur::scene::fitSkin(
            part.prefab.generator, part.prefab.blueprint, from.prefab.blueprint.skin->texture);
    else if (part.prefab.blueprint.skin->uv.size() != part.prefab.blueprint.particles.size())
        part.prefab.blueprint.skin.reset();
}

std::string partMember(const Placement& body, const std::string& key) {
    const auto own = body.extra.find("");
    if (own == body.extra.end()) return "";
    const auto* member = sulfur::scene::findExtra(own->second, key);
    return member == nullptr ? "" : member->json;
}

void setPartMember(Placement& body, const std::string& key, const std::string& json) {
    auto& extra = body.extra[""];
    if (json.empty())
        sulfur::scene::eraseExtra(extra, key);
    else
        sulfur::scene::setExtra(extra, key, json);
}

bool samePlacement(const Part& a, const Part& b) {
    if (a.placement.state.has_value() != b.placement.state.has_value()) return false;
    if (!a.placement.state) return near(a.placement.pose, b.placement.pose);
    const auto& p = a.placement.state->positions;
    const auto& q = b.placement.state->positions;
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [](const Point& x, const Point& y) { return (x - y).norm() < samePlace; });
}

void takePlacement(Part& part, const Part& from) {
    part.placement.pose = from.placement.pose;
    part.placement.velocity = from.placement.velocity;
    part.placement.state = from.placement.state;
    if (part.placement.state &&
        part.placement.state->positions.size() != part.prefab.blueprint.particles.size())
        part.placement.state.reset();
}

/// A trait that is no number.
struct OtherTrait {
    Trait trait;
    bool (*agree)(const Part&, const Part&);
    void (*take)(Part&, const Part&);
};

// The shape comes first: what is taken after it is taken for the shape that is there.
constexpr OtherTrait otherTraits[] = {
    {{"held", "Held in place"},
     [](const Part& a, const Part& b) {
         return a.prefab.blueprint.kind == b.prefab.blueprint.kind;
     },
     [](Part& part, const Part& from) { part.prefab.blueprint.kind = from.prefab.blueprint.kind; }},
    {{"layers", "Layers"},
     [](const Part& a, const Part& b) {
         const auto &x = a.prefab.blueprint.filter, &y = b.prefab.blueprint.filter;
         return x.category == y.category && x.mask == y.mask && x.group == y.group;
     },
     [](Part& part, const Part& from) {
         part.prefab.blueprint.filter = from.prefab.blueprint.filter;
     }},
    {{"sensor", "Sensor"},
     [](const Part& a, const Part& b) {
         return a.prefab.blueprint.sensor == b.prefab.blueprint.sensor;
     },
     [](Part& part, const Part& from) {
         part.prefab.blueprint.sensor = from.prefab.blueprint.sensor;
     }},
    {{"skin", "Skin"}, sameSkin, takeSkin},
    {{"colour", "Colour"},
     [](const Part& a, const Part& b) { return colourOf(a.placement) == colourOf(b.placement); },
     [](Part& part, const Part& from) {
         setPartMember(part.placement, "color", partMember(from.placement, "color"));
     }},
    {{"place", "Position"}, samePlacement, takePlacement},
};

// Members that the sandbox does not know, or that other parts of it know.
void mergePartMembers(const Placement& base, const Placement& mine, const Placement& next,
                      Placement& into) {
    std::set<std::string> keys;
    for (const Placement* one : {&mine, &next})
        if (const auto own = one->extra.find(""); own != one->extra.end())
            for (const auto& member : own->second) keys.insert(member.key);
    keys.erase("template");
    for (const std::string& key : keys) {
        const std::string own = partMember(mine, key);
        setPartMember(into, key, own == partMember(base, key) ? partMember(next, key) : own);
    }
}

}  // namespace

const std::vector<Trait>& traits() {
    static const std::vector<Trait> all = [] {
        std::vector<Trait> list{{"shape", "Shape"}};
        for (const NumberProperty& property : numberProperties())
            if (isTrait(property)) list.push_back({property.key, property.name});
        for (const OtherTrait& other : otherTraits) list.push_back(other.trait);
        return list;
    }();
    return all;
}

bool agree(std::string_view trait, const Part& a, const Part& b) {
    if (trait == "shape") return sameForm(a, b);
    if (const NumberProperty* property = numberProperty(trait)) return sameValue(*property, a, b);
    for (const OtherTrait& other : otherTraits)
        if (other.trait.key == trait) return other.agree(a, b);
    return true;
}

void take(std::string_view trait, Part& part, const Part& from) {
    if (trait == "shape") {
        const Part before = part;
        part.prefab = from.prefab;
        for (const Trait& one : traits())
            if (one.key != "shape" && one.key != "place" && !agree(one.key, part, before))
                take(one.key, part, before);
    } else if (const NumberProperty* property = numberProperty(trait)) {
        if (!sameValue(*property, part, from))
            property->set(part.prefab, *property->get(from.prefab));
    } else {
        for (const OtherTrait& other : otherTraits)
            if (other.trait.key == trait) other.take(part, from);
    }
}

Part merged(const Part& base, const Part& mine, const Part& next) {
    const bool ownShape = !sameForm(base, mine);
    Part made{ownShape ? mine.prefab : next.prefab, mine.placement};
    for (const Trait& trait : traits()) {
        if (trait.key == "shape") continue;
        const Part& from = agree(trait.key, base, mine) ? next : mine;
        // What nobody has changed keeps its very bits.
        if (&from == &next && agree(trait.key, base, next) && (ownShape || trait.key == "place"))
            continue;
        if (!agree(trait.key, made, from)) take(trait.key, made, from);
    }
    mergePartMembers(base.placement, mine.placement, next.placement, made.placement);
    made.prefab.blueprint.name = mine.prefab.blueprint.name;
    return made;
}

// --- looking ---------------------------------------------------------------------------------

std::map<std::string, Part> partsOf(const Template& made) {
    const Plan plan(made.scene);
    std::map<std::string, Part> parts;
    for (const Placement& body : made.scene.bodies)
        parts.emplace(body.id, Part{plan.dressed(body.id), body});
    return parts;
}

namespace {

Pose frameOf(const Plan& plan, const Instance& instance, const std::map<std::string, Part>& base) {
    constexpr std::size_t mostAsked = 12;
    Pose best;
    std::size_t most = 0, asked = 0;
    const auto frameBy = [&](const std::string& part, const std::string& id) {
        return composed(plan.body(id).pose, inverse(base.at(part).placement.pose));
    };
    // Parts in the order of the plan, so that the first one decides where none agree.
    for (const Placement& body : plan.scene().bodies) {
        const auto membership = membershipOf(body);
        if (!membership || membership->instance != instance.instance ||
            !base.contains(membership->part))
            continue;
        const Pose frame = frameBy(membership->part, body.id);
        std::size_t count = 0;
        for (const auto& [part, id] : instance.ids)
            if (base.contains(part) && near(frameBy(part, id), frame)) ++count;
        if (count > most) {
            most = count;
            best = frame;
        }
        if (++asked == mostAsked || most == instance.ids.size()) break;
    }
    return best;
}

}  // namespace

Looked look(const Plan& plan, const Instance& instance, const std::map<std::string, Part>& base) {
    Looked looked;
    looked.frame = frameOf(plan, instance, base);
    const Pose back = inverse(looked.frame);
    std::map<std::string, std::string> partOfBody;
    for (const auto& [part, id] : instance.ids) {
        partOfBody.emplace(id, part);
        Part one{plan.dressed(id), plan.body(id)};
        one.placement.kind.reset();
        one.placement.material.reset();
        one.placement.filter.reset();
        one.placement.sensor.reset();
        one.placement.id = part;
        carry(one.placement, back);
        looked.parts.emplace(part, std::move(one));
    }
    const auto isMine = [&](const std::string& id) { return partOfBody.contains(id); };
    for (auto connection : plan.scene().connections) {
        if (!isMine(connection.a.body) || !isMine(connection.b.body)) continue;
        connection.a.body = partOfBody.at(connection.a.body);
        connection.b.body = partOfBody.at(connection.b.body);
        looked.scene.connections.push_back(std::move(connection));
    }
    for (auto attachment : plan.scene().attachments) {
        if (!isMine(attachment.particle.body) || !isMine(attachment.body)) continue;
        attachment.particle.body = partOfBody.at(attachment.particle.body);
        attachment.body = partOfBody.at(attachment.body);
        looked.scene.attachments.push_back(std::move(attachment));
    }
    for (auto veto : plan.scene().vetoes)
        if (isMine(veto.a) && isMine(veto.b))
            looked.scene.vetoes.push_back({partOfBody.at(veto.a), partOfBody.at(veto.b)});
    std::vector<Thruster> thrusters;
    for (auto thruster : thrustersOf(plan.scene())) {
        if (!isMine(thruster.body)) continue;
        thruster.body = partOfBody.at(thruster.body);
        thrusters.push_back(std::move(thruster));
    }
    setThrusters(looked.scene, thrusters);
    // Whom thrusters may name.
    for (const auto& [part, id] : instance.ids) looked.scene.bodies.emplace_back().id = part;
    std::map<std::string, std::string> named;
    for (auto mechanism : plan.scene().mechanisms) {
        const auto names = bodiesOf(mechanism);
        if (!std::all_of(names.begin(), names.end(), [&](auto* name) { return isMine(*name); }))
            continue;
        if (auto* gear = std::get_if<sulfur::scene::Gear>(&mechanism.spec)) {
            if (!named.contains(gear->first) || !named.contains(gear->second)) continue;
            gear->first = named.at(gear->first);
            gear->second = named.at(gear->second);
        }
        carry(mechanism, back);
        for (std::string* name : names) *name = partOfBody.at(*name);
        const std::string part = partOf(mechanism);
        named.emplace(mechanism.id, part);
        mechanism.id = part;
        setPart(mechanism, "");
        looked.scene.mechanisms.push_back(std::move(mechanism));
    }
    return looked;
}

// --- ties ------------------------------------------------------------------------------------

namespace {

// What an element is, as the text of a scene that has nothing else.
template <class Element>
std::string tieText(std::vector<Element> Scene::*list, Element element) {
    Scene scene;
    (scene.*list).push_back(std::move(element));
    return sulfur::scene::format(scene);
}

// The template's new ones, with what was added and without what was taken away in this instance.
template <class Element>
void mergeList(std::vector<Element> Scene::*list, const Scene& base, const Scene& mine,
               const Scene& next, Scene& into) {
    std::set<std::string> before, own, following;
    for (const Element& one : base.*list) before.insert(tieText(list, one));
    for (const Element& one : mine.*list) own.insert(tieText(list, one));
    for (const Element& one : next.*list) {
        const std::string text = tieText(list, one);
        if (before.contains(text) && !own.contains(text)) continue;
        following.insert(text);
        (into.*list).push_back(one);
    }
    for (const Element& one : mine.*list) {
        const std::string text = tieText(list, one);
        if (!before.contains(text) && !following.contains(text)) (into.*list).push_back(one);
    }
}

std::string tieText(const Thruster& thruster) {
    Scene scene;
    setThrusters(scene, {thruster});
    return sulfur::scene::format(scene);
}

// As mergeList() has it.
void mergeThrusters(const Scene& base, const Scene& mine, const Scene& next, Scene& into) {
    std::set<std::string> before, own, following;
    std::vector<Thruster> made;
    for (const Thruster& one : thrustersOf(base)) before.insert(tieText(one));
    for (const Thruster& one : thrustersOf(mine)) own.insert(tieText(one));
    for (const Thruster& one : thrustersOf(next)) {
        const std::string text = tieText(one);
        if (before.contains(text) && !own.contains(text)) continue;
        following.insert(text);
        made.push_back(one);
    }
    for (const Thruster& one : thrustersOf(mine)) {
        const std::string text = tieText(one);
        if (!before.contains(text) && !following.contains(text)) made.push_back(one);
    }
    setThrusters(into, made);
}

bool sameMechanism(SceneMechanism a, SceneMechanism b) {
    const auto flatten = [](SceneMechanism& mechanism) {
        std::vector<Point> places;
        std::set<std::string> bodies;
        for (const std::string* name : bodiesOf(mechanism)) bodies.insert(*name);
        for (const std::string& body : bodies)
            for (Point* point : pointsOf(mechanism, body)) {
                places.push_back(*point);
                *point = Point(0, 0);
            }
        std::visit(
            [&](auto& spec) {
                if constexpr (requires { spec.axis; }) {
                    places.push_back(spec.axis.template cast<double>());
                    spec.axis = sulfur::Vec2(1, 0);
                }
            },
            mechanism.spec);
        mechanism.id.clear();
        setPart(mechanism, "");
        return places;
    };
    const auto p = flatten(a), q = flatten(b);
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [](const Point& x, const Point& y) { return (x - y).norm() < samePlace; }) &&
           tieText(&Scene::mechanisms, a) == tieText(&Scene::mechanisms, b);
}

const SceneMechanism* mechanismOf(const Scene& scene, const std::string& id) {
    for (const auto& mechanism : scene.mechanisms)
        if (!id.empty() && mechanism.id == id) return &mechanism;
    return nullptr;
}

}  // namespace

Scene mergedTies(const Scene& base, const Scene& mine, const Scene& next) {
    Scene made;
    for (const Scene* one : {&mine, &next})
        for (const Placement& body : one->bodies)
            if (made.body(body.id) == nullptr) made.bodies.emplace_back().id = body.id;
    mergeList(&Scene::connections, base, mine, next, made);
    mergeList(&Scene::attachments, base, mine, next, made);
    mergeList(&Scene::vetoes, base, mine, next, made);
    mergeThrusters(base, mine, next, made);
    for (const auto& mechanism : next.mechanisms) {
        const auto* before = mechanismOf(base, mechanism.id);
        const auto* own = mechanismOf(mine, mechanism.id);
        if (before != nullptr && own == nullptr) continue;
        const bool changed = before != nullptr && own != nullptr && !sameMechanism(*before, *own);
        made.mechanisms.push_back(changed ? *own : mechanism);
    }
    for (const auto& mechanism : mine.mechanisms)
        if (mechanismOf(base, mechanism.id) == nullptr &&
            mechanismOf(next, mechanism.id) == nullptr)
            made.mechanisms.push_back(mechanism);
    return made;
}

std::size_t tieDifferences(const Scene& base, const Scene& mine) {
    std::size_t count = 0;
    const auto compare = [&](auto list) {
        std::set<std::string> before, own;
        for (const auto& one : base.*list) before.insert(tieText(list, one));
        for (const auto& one : mine.*list) own.insert(tieText(list, one));
        for (const auto& text : before) count += own.contains(text) ? 0 : 1;
        for (const auto& text : own) count += before.contains(text) ? 0 : 1;
    };
    compare(&Scene::connections);
    compare(&Scene::attachments);
    compare(&Scene::vetoes);
    std::set<std::string> before, own;
    for (const Thruster& one : thrustersOf(base)) before.insert(tieText(one));
    for (const Thruster& one : thrustersOf(mine)) own.insert(tieText(one));
    for (const auto& text : before) count += own.contains(text) ? 0 : 1;
    for (const auto& text : own) count += before.contains(text) ? 0 : 1;
    for (const auto& mechanism : base.mechanisms) {
        const auto* now = mechanismOf(mine, mechanism.id);
        if (now == nullptr || !sameMechanism(mechanism, *now)) ++count;
    }
    for (const auto& mechanism : mine.mechanisms)
        if (mechanismOf(base, mechanism.id) == nullptr) ++count;
    return count;
}

}  // namespace sulfurchamber
