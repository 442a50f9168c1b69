// Blueprints from JSON: explicit ones and recipes.
#include <algorithm>
#include <sulfur/error.hpp>

#include "reader.hpp"

namespace sulfur::scene {

namespace {

void readParticles(Reader& reader, Blueprint& plan) {
    const auto particles = reader.at("particles").array(1, Limits::particles);
    plan.particles.reserve(particles.size());
    for (const auto& node : particles) {
        const auto place = std::to_string(plan.particles.size());
        Reader particle(node, "particle", reader.below("particles[" + place + "]"), reader.extra());
        particle.at("position");
        ParticleSpec spec;
        describe(particle, spec);
        particle.finish();
        plan.particles.push_back(spec);
    }
}

Real lengthOf(const JointSpec& joint, const Blueprint& plan) {
    if (joint.restLength) return *joint.restLength;
    return (plan.particles[joint.b].position - plan.particles[joint.a].position).norm();
}

JointSpec readJoint(Reader& joint, const Blueprint& plan) {
    JointSpec spec;
    describe(joint, spec);
    const auto last = static_cast<std::int64_t>(plan.particles.size()) - 1;
    joint.at("a").integer(0, last);
    joint.at("b").integer(0, last);
    if (spec.a == spec.b)
        joint.node().fail("joins particle " + std::to_string(spec.a) +
                          " to itself; allowed are two different particles");
    if (lengthOf(spec, plan) == 0 && (spec.stiffness == infinite || spec.radius > 0))
        joint.node().fail(
            "has length 0; a rigid joint or one with a radius needs two particles that are apart, "
            "or a restLength above 0");
    if (spec.bend != 0 && !(spec.stiffness == infinite && spec.radius > 0))
        joint.at("bend").fail(
            "is of a joint that is not rigid or has no radius; allowed is one "
            "of a rigid joint with a radius");
    joint.finish();
    return spec;
}

void readJoints(Reader& reader, Blueprint& plan) {
    const auto list = reader.find("joints");
    if (!list) return;
    const auto joints = list->array(0, Limits::joints);
    plan.joints.reserve(joints.size());
    for (const auto& node : joints) {
        const auto place = std::to_string(plan.joints.size());
        Reader joint(node, "joint", reader.below("joints[" + place + "]"), reader.extra());
        plan.joints.push_back(readJoint(joint, plan));
    }
}

AngularJointSpec readAngle(Reader& angle, const Blueprint& plan) {
    AngularJointSpec spec;
    describe(angle, spec);
    const auto last = static_cast<std::int64_t>(plan.particles.size()) - 1;
    for (const char* end : {"a", "b", "c"}) angle.at(end).integer(0, last);
    if (spec.a == spec.b || spec.b == spec.c || spec.a == spec.c)
        angle.node().fail("names a particle twice; allowed are three different particles");
    const auto& place = plan.particles[spec.b].position;
    if (place == plan.particles[spec.a].position || place == plan.particles[spec.c].position)
        angle.node().fail("has its corner b where a or c stands; allowed are places that differ");
    if (spec.lower > spec.upper)
        angle.node().fail("lower is above upper; allowed is the same or less");
    angle.finish();
    return spec;
}

void readAngles(Reader& reader, Blueprint& plan) {
    const auto list = reader.find("angles");
    if (!list) return;
    for (const auto& node : list->array(0, Limits::joints)) {
        const auto place = std::to_string(plan.angles.size());
        Reader angle(node, "angle", reader.below("angles[" + place + "]"), reader.extra());
        plan.angles.push_back(readAngle(angle, plan));
    }
}

void readTriangles(const Node& list, Skin& skin, std::size_t particles) {
    const auto last = static_cast<std::int64_t>(particles) - 1;
    for (const auto& node : list.array(0, Limits::joints)) {
        const auto corners = node.array(3, 3);
        auto& triangle = skin.triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            triangle[i] = static_cast<std::uint32_t>(corners[i].integer(0, last));
    }
}

/// A skin with only a texture is fitted to the shape.
void readSkin(Reader& reader, Prefab& prefab) {
    const auto node = reader.find("skin");
    if (!node) return;
    Reader skin(*node, "skin", reader.below("skin"), reader.extra());
    const std::string texture = readAssetName(skin.at("texture"));
    const auto uv = skin.find("uv");
    const auto triangles = skin.find("triangles");
    auto& plan = prefab.blueprint;
    const bool generated = prefab.generator.index() != 0;
    if (generated && !uv && !triangles) {
        plan.skin = fitSkin(prefab.generator, plan, texture);
        prefab.skinFitted = true;
    } else {
        plan.skin.emplace();
        plan.skin->texture = texture;
        const auto count = plan.particles.size();
        for (const auto& point : skin.at("uv").array(count, count))
            plan.skin->uv.push_back(point.vec2(100));
        readTriangles(skin.at("triangles"), *plan.skin, count);
    }
    skin.finish();
}

/// Refuses what would take much memory before it is made.
void requireModest(const Node& node, const Generator& generator) {
    const auto require = [&](int columns, int rows) {
        const auto particles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
        if (particles > Limits::particles)
            node.fail("columns times rows are " + std::to_string(particles) +
                      " particles; allowed are at most " + std::to_string(Limits::particles));
    };
    if (const auto* jelly = std::get_if<shapes::JellyOptions>(&generator))
        require(jelly->columns, jelly->rows);
    if (const auto* cloth = std::get_if<shapes::ClothOptions>(&generator))
        require(cloth->columns, cloth->rows);
    if (const auto* wall = std::get_if<shapes::WallOptions>(&generator))
        require(wall->columns + 1, wall->rows + 1);
}

template <std::size_t index>
bool tryGenerator(Reader& reader, std::string_view shape, Prefab& prefab) {
    if (shape != generatorNames[index]) return false;
    describe(reader, prefab.generator.emplace<index>());
    return true;
}

template <std::size_t... indices>
void readGenerator(Reader& reader, std::string_view shape, Prefab& prefab,
                   std::index_sequence<indices...>) {
    (tryGenerator<indices + 1>(reader, shape, prefab) || ...);
}

void readGenerated(Reader& reader, std::string_view shape, Prefab& prefab) {
    readGenerator(reader, shape, prefab,
                  std::make_index_sequence<std::variant_size_v<Generator> - 1>());
    requireModest(reader.node(), prefab.generator);
    prefab.blueprint = build(prefab.generator);
}

template <std::size_t... indices>
std::size_t chooseShape(const Node& shape, std::index_sequence<indices...>) {
    return shape.choice({generatorNames[indices + 1]...});
}

/// The place of the named shape among those that files may name.
std::size_t chooseShape(const Node& shape) {
    return chooseShape(shape, std::make_index_sequence<std::size(generatorNames) - 1>());
}

/// Generators share a mass among particles, so that only the outcome can be judged.
void requireMasses(const Node& node, const Blueprint& plan) {
    for (std::size_t i = 0; i < plan.particles.size(); ++i) {
        if (static_cast<double>(plan.particles[i].mass) >= Limits::smallestMass) continue;
        node.fail("particle " + std::to_string(i) +
                  " has less than 1e-9 kg; allowed is 1e-9 to 1e9 for each particle");
    }
}

void readExplicit(Reader& reader, Blueprint& plan) {
    readParticles(reader, plan);
    readJoints(reader, plan);
    readAngles(reader, plan);
    reader.material("material", plan.material);
}

}  // namespace

Prefab readPrefab(const Node& node, const std::string& name) {
    Prefab prefab;
    auto& plan = prefab.blueprint;
    const auto shape = node.find("shape");
    std::string part = "explicit";
    if (shape) {
        part = generatorNames[1 + chooseShape(*shape)];
    } else if (!node.find("particles")) {
        node.fail("has neither \"shape\" nor \"particles\"; needed is one of them");
    }
    Reader reader(node, part, "", prefab.extra);
    try {
        if (shape) {
            readGenerated(reader, part, prefab);
        } else {
            readExplicit(reader, plan);
        }
        plan.name = name;
        reader.kind("kind", plan.kind);
        reader.filter("filter", plan.filter);
        reader.flag("sensor", plan.sensor, false);
        reader.flag("selfCollision", plan.selfCollision, false);
        readSkin(reader, prefab);
        reader.finish();
        plan.validate();
        requireMasses(node, plan);
    } catch (const Error& error) {
        node.fail(error.what());
    }
    return prefab;
}

}  // namespace sulfur::scene
