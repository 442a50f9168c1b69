#include "properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "geometry.hpp"
#include "loop_region.hpp"
#include "recipe_access.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Blueprint;
using sulfur::BodyId;
using sulfur::Real;
using sulfur::scene::Prefab;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double differs = std::numeric_limits<double>::quiet_NaN();
constexpr double softDamping = 0.15;  // of critical, for what has become elastic

Real toReal(double value) {
    return static_cast<Real>(value);
}

// A number of all joints that `counts` chooses: the same one, or that they differ.
template <class Get, class Counts>
std::optional<double> ofJoints(const Blueprint& blueprint, const Get& get, const Counts& counts) {
    std::optional<double> value;
    for (const auto& joint : blueprint.joints) {
        if (!counts(joint)) continue;
        const auto own = static_cast<double>(get(joint));
        if (value && *value != own) return differs;
        value = own;
    }
    return value;
}

bool any(const sulfur::JointSpec&) {
    return true;
}
bool isElasticJoint(const sulfur::JointSpec& joint) {
    return std::isfinite(joint.stiffness);
}

// --- mass ------------------------------------------------------------------------------------

std::optional<double> mass(const Prefab& prefab) {
    if (prefab.blueprint.kind == sulfur::BodyKind::fixed) return std::nullopt;
    return static_cast<double>(prefab.blueprint.mass());
}

void setMass(Prefab& prefab, double value) {
    if (inRecipe(
            prefab, [](auto& o) -> decltype((o.mass)) { return o.mass; },
            [&](Real& recipe) { recipe = toReal(value); }))
        return;
    const double factor = value / static_cast<double>(prefab.blueprint.mass());
    for (auto& particle : prefab.blueprint.particles)
        particle.mass = toReal(static_cast<double>(particle.mass) * factor);
    prefab.generator = {};
}

std::optional<double> density(const Prefab& prefab) {
    const double area = areaOf(prefab.blueprint);
    const auto whole = mass(prefab);
    if (!whole || !(area > 0)) return std::nullopt;
    return *whole / area;
}

void setDensity(Prefab& prefab, double value) {
    setMass(prefab, value * areaOf(prefab.blueprint));
}

// --- joints ----------------------------------------------------------------------------------

std::optional<double> stiffness(const Prefab& prefab) {
    const auto spokes = ofRecipe<double>(
        prefab, [](const auto& o) -> decltype((o.spokeStiffness)) { return o.spokeStiffness; });
    if (spokes) return spokes;
    if (prefab.blueprint.kind == sulfur::BodyKind::fixed) return std::nullopt;
    return ofJoints(
        prefab.blueprint, [](const auto& joint) { return joint.stiffness; }, any);
}

// What becomes elastic needs a damper, or it trembles for long.
double dampingFor(const Prefab& prefab, double stiffness) {
    const auto count = static_cast<double>(prefab.blueprint.particles.size());
    const double mass = static_cast<double>(prefab.blueprint.mass()) / count;
    return 2 * softDamping * std::sqrt(stiffness * mass);
}

void setStiffness(Prefab& prefab, double value) {
    const double damping = std::isfinite(value) ? dampingFor(prefab, value) : 0;
    const bool spokes = inRecipe(
        prefab, [](auto& o) -> decltype((o.spokeStiffness)) { return o.spokeStiffness; },
        [&](Real& recipe) { recipe = toReal(value); });
    if (spokes) {
        inRecipe(
            prefab, [](auto& o) -> decltype((o.spokeDamping)) { return o.spokeDamping; },
            [&](Real& recipe) { recipe = recipe > 0 ? recipe : toReal(damping); });
        return;
    }
    const bool recipe = inRecipe(
        prefab, [](auto& o) -> decltype((o.stiffness)) { return o.stiffness; },
        [&](Real& own) { own = toReal(value); });
    if (recipe) {
        inRecipe(
            prefab, [](auto& o) -> decltype((o.damping)) { return o.damping; },
            [&](Real& own) { own = own > 0 ? own : toReal(damping); });
        return;
    }
    for (auto& joint : prefab.blueprint.joints) {
        joint.stiffness = toReal(value);
        if (!(joint.damping > 0)) joint.damping = toReal(damping);
    }
    prefab.generator = {};
}

std::optional<double> damping(const Prefab& prefab) {
    if (prefab.blueprint.kind == sulfur::BodyKind::fixed) return std::nullopt;
    return ofJoints(
        prefab.blueprint, [](const auto& joint) { return joint.damping; }, isElasticJoint);
}

void setDamping(Prefab& prefab, double value) {
    const auto set = [&](Real& own) { own = toReal(value); };
    if (inRecipe(
            prefab, [](auto& o) -> decltype((o.spokeDamping)) { return o.spokeDamping; }, set))
        return;
    if (inRecipe(
            prefab, [](auto& o) -> decltype((o.damping)) { return o.damping; }, set))
        return;
    for (auto& joint : prefab.blueprint.joints) joint.damping = toReal(value);
    prefab.generator = {};
}

std::optional<double> strength(const Prefab& prefab) {
    if (prefab.blueprint.kind == sulfur::BodyKind::fixed) return std::nullopt;
    return ofJoints(
        prefab.blueprint, [](const auto& joint) { return joint.strength; }, any);
}

void setStrength(Prefab& prefab, double value) {
    if (inRecipe(
            prefab, [](auto& o) -> decltype((o.strength)) { return o.strength; },
            [&](Real& own) { own = toReal(value); }))
        return;
    for (auto& joint : prefab.blueprint.joints) joint.strength = toReal(value);
    prefab.generator = {};
}

// --- surface ---------------------------------------------------------------------------------

void setMaterial(Prefab& prefab, const sulfur::Material& material) {
    const bool recipe = inRecipe(
        prefab, [](auto& o) -> decltype((o.material)) { return o.material; },
        [&](sulfur::Material& own) { own = material; });
    prefab.blueprint.material = material;
    if (!recipe) prefab.generator = {};
}

template <class Change>
void changeMaterial(Prefab& prefab, Change&& change) {
    auto material = prefab.blueprint.material;
    change(material);
    setMaterial(prefab, material);
}
std::optional<double> sliding(const Prefab& prefab) {
    return static_cast<double>(prefab.blueprint.material.kineticFriction);
}
void setSliding(Prefab& prefab, double value) {
    changeMaterial(prefab, [&](sulfur::Material& m) {
        m.kineticFriction = toReal(value);
        m.staticFriction = std::max(m.staticFriction, m.kineticFriction);
    });
}
std::optional<double> sticking(const Prefab& prefab) {
    return static_cast<double>(prefab.blueprint.material.staticFriction);
}
void setSticking(Prefab& prefab, double value) {
    changeMaterial(prefab, [&](sulfur::Material& m) {
        m.staticFriction = toReal(value);
        m.kineticFriction = std::min(m.staticFriction, m.kineticFriction);
    });
}
std::optional<double> restitution(const Prefab& prefab) {
    return static_cast<double>(prefab.blueprint.material.restitution);
}
void setRestitution(Prefab& prefab, double value) {
    changeMaterial(prefab, [&](sulfur::Material& m) { m.restitution = toReal(value); });
}
std::optional<double> surfaceSpeed(const Prefab& prefab) {
    return static_cast<double>(prefab.blueprint.material.surfaceSpeed);
}
void setSurfaceSpeed(Prefab& prefab, double value) {
    changeMaterial(prefab, [&](sulfur::Material& m) { m.surfaceSpeed = toReal(value); });
}

// --- the recipe's own numbers ----------------------------------------------------------------

#define SULFURCHAMBER_RECIPE(NAME, MEMBER)                                                       \
    std::optional<double> get##NAME(const Prefab& prefab) {                                      \
        return ofRecipe<double>(prefab,                                                          \
                                [](const auto& o) -> decltype((o.MEMBER)) { return o.MEMBER; }); \
    }                                                                                            \
    void set##NAME(Prefab& prefab, double value) {                                               \
        inRecipe(                                                                                \
            prefab, [](auto& o) -> decltype((o.MEMBER)) { return o.MEMBER; },                    \
            [&](auto& own) { own = static_cast<std::decay_t<decltype(own)>>(value); });          \
    }

SULFURCHAMBER_RECIPE(Width, size[0])
SULFURCHAMBER_RECIPE(Height, size[1])
SULFURCHAMBER_RECIPE(Radius, radius)
SULFURCHAMBER_RECIPE(Columns, columns)
SULFURCHAMBER_RECIPE(Rows, rows)
SULFURCHAMBER_RECIPE(Segments, segments)
SULFURCHAMBER_RECIPE(Planks, planks)
SULFURCHAMBER_RECIPE(Links, links)
SULFURCHAMBER_RECIPE(Bending, bending)
SULFURCHAMBER_RECIPE(BendingDamping, bendingDamping)
SULFURCHAMBER_RECIPE(Sag, sag)
SULFURCHAMBER_RECIPE(Rim, rimRadius)
SULFURCHAMBER_RECIPE(SkinRadius, skinRadius)

#undef SULFURCHAMBER_RECIPE

std::optional<double> slack(const Prefab& prefab) {
    const auto* rope = std::get_if<sulfur::shapes::RopeOptions>(&prefab.generator);
    if (rope == nullptr) return std::nullopt;
    // What the recipe leaves open is what it makes of it.
    const double usual = rope->pinFirst && rope->pinLast ? 0.02 : 0;
    return rope->slack ? static_cast<double>(*rope->slack) : usual;
}
void setSlack(Prefab& prefab, double value) {
    if (auto* rope = std::get_if<sulfur::shapes::RopeOptions>(&prefab.generator)) {
        rope->slack = toReal(value);
        rebuild(prefab);
    }
}

constexpr std::array properties{
    NumberProperty{"mass", "Mass", "kg", "Of the whole body", 1e-3, 1e6, Scale::logarithmic, "",
                   false, mass, setMass},
    NumberProperty{"density", "Density", "kg/m\xC2\xB2", "Mass of a square metre; a box of 1 m",
                   1e-2, 1e5, Scale::logarithmic, "", false, density, setDensity},
    NumberProperty{"stiffness", "Stiffness", "N/m", "Of each joint: from jelly to rigid", 1, 1e8,
                   Scale::logarithmic, "rigid", false, stiffness, setStiffness},
    NumberProperty{"damping", "Damping", "N s/m", "How soon elastic joints come to rest", 0, 1e4,
                   Scale::cubic, "", false, damping, setDamping},
    NumberProperty{"strength", "Strength", "N", "The force at which a joint breaks", 1, 1e7,
                   Scale::logarithmic, "never", false, strength, setStrength},
    NumberProperty{"sliding", "Sliding", "", "Coefficient of sliding friction", 0, 3, Scale::linear,
                   "", false, sliding, setSliding},
    NumberProperty{"static", "Sticking", "", "Coefficient of static friction", 0, 3, Scale::linear,
                   "", false, sticking, setSticking},
    NumberProperty{"restitution", "Bounce", "", "Restitution: 1 rebounds as fast as it came", 0, 1,
                   Scale::linear, "", false, restitution, setRestitution},
    NumberProperty{"surface-speed", "Conveyor", "m/s", "How fast its surface runs, as a belt does",
                   -10, 10, Scale::linear, "", false, surfaceSpeed, setSurfaceSpeed},
    NumberProperty{"width", "Width", "m", "Outer width", 0.05, 100, Scale::logarithmic, "", false,
                   getWidth, setWidth},
    NumberProperty{"height", "Height", "m", "Outer height", 0.05, 100, Scale::logarithmic, "",
                   false, getHeight, setHeight},
    NumberProperty{"radius", "Radius", "m", "Of a round body; half the thickness of others", 1e-3,
                   50, Scale::logarithmic, "", false, getRadius, setRadius},
    NumberProperty{"columns", "Columns", "", "Particles or cells across", 2, 100, Scale::linear, "",
                   true, getColumns, setColumns},
    NumberProperty{"rows", "Rows", "", "Particles or cells up", 2, 100, Scale::linear, "", true,
                   getRows, setRows},
    NumberProperty{"segments", "Segments", "", "Particles around", 3, 100, Scale::linear, "", true,
                   getSegments, setSegments},
    NumberProperty{"planks", "Planks", "", "Of a bridge", 1, 100, Scale::linear, "", true,
                   getPlanks, setPlanks},
    NumberProperty{"links", "Links", "", "Of a rope or chain", 1, 1000, Scale::cubic, "", true,
                   getLinks, setLinks},
    NumberProperty{"bending", "Bending", "", "How stiff a rope is against bending", 0, 100,
                   Scale::cubic, "", false, getBending, setBending},
    NumberProperty{"bending-damping", "Bend damping", "", "How strongly bending of a rope is damped",
                   0, 100, Scale::cubic, "", false, getBendingDamping, setBendingDamping},
    NumberProperty{"slack", "Slack", "", "The share by which a rope is longer than its way", 0, 10,
                   Scale::cubic, "", false, slack, setSlack},
    NumberProperty{"sag", "Sag", "m", "How far the middle of a bridge hangs", 0, 50, Scale::cubic,
                   "", false, getSag, setSag},
    NumberProperty{"rim", "Rim", "m", "Half the thickness of a wheel's rim", 1e-3, 10,
                   Scale::logarithmic, "", false, getRim, setRim},
    NumberProperty{"skin-radius", "Outline", "m", "Half the thickness of a soft disc's outline",
                   1e-3, 10, Scale::logarithmic, "", false, getSkinRadius, setSkinRadius},
};

constexpr std::array presets{
    MaterialPreset{"Ice", 9, 0.02, 0.05, 0.05, infinite},
    MaterialPreset{"Rubber", 12, 0.9, 1.1, 0.7, 2000},
    MaterialPreset{"Wood", 6, 0.35, 0.45, 0.2, infinite},
    MaterialPreset{"Stone", 24, 0.6, 0.7, 0.1, infinite},
    MaterialPreset{"Steel", 78, 0.4, 0.5, 0.3, infinite},
    MaterialPreset{"Jelly", 4, 0.5, 0.6, 0, 260},
    MaterialPreset{"Cloth", 0.5, 0.6, 0.7, 0, 2000},
};

// Each distinct blueprint of some bodies once.
template <class Visit>
void forEachPrefab(const Document& document, std::span<const BodyId> bodies, const Visit& visit) {
    std::set<std::string> seen;
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        const auto& placement = document.plan().body(id);
        const bool own = placement.kind || placement.material || placement.filter;
        if (!own && !seen.insert(placement.blueprint).second) continue;
        visit(document.plan().dressed(id));
    }
}

template <class Value, class Get>
std::optional<Value> sameOf(const Document& document, std::span<const BodyId> bodies,
                            const Get& get) {
    std::optional<Value> value;
    bool same = true;
    forEachPrefab(document, bodies, [&](const Prefab& prefab) {
        const Value own = get(prefab);
        if (value && *value != own) same = false;
        value = own;
    });
    return same ? value : std::nullopt;
}

}  // namespace

std::span<const NumberProperty> numberProperties() {
    return properties;
}

const NumberProperty* numberProperty(std::string_view key) {
    const auto* found = std::find_if(properties.begin(), properties.end(),
                                     [&](const auto& property) { return property.key == key; });
    return found == properties.end() ? nullptr : found;
}

std::span<const MaterialPreset> materialPresets() {
    return presets;
}

Common common(const Document& document, std::span<const BodyId> bodies,
              const NumberProperty& property) {
    Common all;
    bool same = true;
    forEachPrefab(document, bodies, [&](const Prefab& prefab) {
        const auto own = property.get(prefab);
        if (!own) return;
        if (std::isnan(*own) || (all.applies && all.value != own)) same = false;
        all.applies = true;
        all.value = own;
    });
    if (!same) all.value.reset();
    return all;
}

void setProperty(Document& document, std::span<const BodyId> bodies, const NumberProperty& property,
                 double value) {
    const bool endless = std::isinf(value) && value > 0 && !property.endless.empty();
    if (!endless && !(value >= property.low && value <= property.high))
        throw std::runtime_error(tr("{} is out of range", {tr(std::string(property.name))}));
    if (property.whole) value = std::round(value);
    document.change(bodies, [&](Prefab& prefab) {
        if (property.get(prefab)) property.set(prefab, value);
    });
}

void applyPreset(Document& document, std::span<const BodyId> bodies, const MaterialPreset& preset) {
    document.change(bodies, [&](Prefab& prefab) {
        if (density(prefab)) setDensity(prefab, preset.density);
        auto material = prefab.blueprint.material;
        material.kineticFriction = toReal(preset.kineticFriction);
        material.staticFriction = toReal(preset.staticFriction);
        material.restitution = toReal(preset.restitution);
        setMaterial(prefab, material);
        if (!stiffness(prefab)) return;
        // A body of the same stuff sags by the same share, whatever it weighs.
        const double weight = std::max(static_cast<double>(prefab.blueprint.mass()), 1e-3);
        setStiffness(prefab, preset.stiffness * (std::isfinite(preset.stiffness) ? weight : 1));
        if (std::isfinite(preset.stiffness))
            setDamping(prefab, dampingFor(prefab, preset.stiffness * weight));
    });
}

std::optional<bool> heldInPlace(const Document& document, std::span<const BodyId> bodies) {
    return sameOf<bool>(document, bodies, [](const Prefab& prefab) {
        return prefab.blueprint.kind == sulfur::BodyKind::fixed;
    });
}

void holdInPlace(Document& document, std::span<const BodyId> bodies, bool on) {
    document.change(bodies, [&](Prefab& prefab) {
        prefab.blueprint.kind = on ? sulfur::BodyKind::fixed : sulfur::BodyKind::dynamic;
    });
}

std::string colourOf(const sulfur::scene::Placement& body) {
    const auto own = body.extra.find("");
    if (own == body.extra.end()) return "";
    const auto* member = sulfur::scene::findExtra(own->second, "color");
    if (member == nullptr || member->json.size() != 9 || member->json[1] != '#' ||
        member->json.find_first_not_of("0123456789abcdefABCDEF", 2) != 8)
        return "";
    return member->json.substr(1, 7);
}

std::optional<std::string> colour(const Document& document, std::span<const BodyId> bodies) {
    std::optional<std::string> same;
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        std::string own = colourOf(document.plan().body(id));
        if (same && *same != own) return std::nullopt;
        same = std::move(own);
    }
    return same;
}

std::vector<std::string> shownColours(const Document& document, std::span<const BodyId> bodies) {
    std::vector<std::string> colours;
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        std::string own = id.empty() ? "" : colourOf(document.plan().body(id));
        if (own.empty()) {
            const auto stiffness =
                common(document, std::span(&body, 1), *numberProperty("stiffness")).value;
            own = stiffness && std::isfinite(*stiffness) ? "#ffb347" : "#6fa8dc";
        }
        if (std::find(colours.begin(), colours.end(), own) == colours.end())
            colours.push_back(std::move(own));
    }
    return colours;
}

void setColour(Document& document, std::span<const BodyId> bodies, const std::string& colour) {
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        auto& extra = document.placementForEditing(id).extra[""];
        if (colour.empty())
            sulfur::scene::eraseExtra(extra, "color");
        else
            sulfur::scene::setExtra(extra, "color", '"' + colour + '"');
    }
}

double areaOf(const Blueprint& blueprint) {
    constexpr double pi = 3.14159265358979;
    double area = 0;
    for (const auto& particle : blueprint.particles) {
        const auto r = static_cast<double>(particle.radius);
        area += pi * r * r;
    }
    std::vector<sulfur::Point> points;
    for (const auto& particle : blueprint.particles)
        points.emplace_back(particle.position.cast<double>());
    double radius = 0;
    for (const auto& joint : blueprint.joints)
        radius = std::max(radius, static_cast<double>(joint.radius));
    const auto around = [&](const std::vector<std::uint32_t>& loop) {
        double length = 0;
        for (std::size_t i = 0; i < loop.size(); ++i)
            length += (points[loop[(i + 1) % loop.size()]] - points[loop[i]]).norm();
        return length * radius + 4 * radius * radius;
    };
    for (const LoopRegion& region : regionsOfLoops(outlines(blueprint), points)) {
        area += areaOf(region, points) + around(region.outer);
        for (const auto& hole : region.holes) area += around(hole) - 8 * radius * radius;
    }
    return area;
}

}  // namespace sulfurchamber
