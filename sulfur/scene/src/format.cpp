// Scenes and blueprints to JSON text. The order of members is fixed; unknown ones come last.
#include <sulfur/scene/file.hpp>

#include "describe.hpp"
#include "writer.hpp"

namespace sulfur::scene {

namespace {

std::vector<std::string> formatParticles(const Prefab& prefab) {
    std::vector<std::string> items;
    for (const auto& particle : prefab.blueprint.particles) {
        ObjectText text(prefab.extra, "particles[" + std::to_string(items.size()) + ']');
        // The position must be there; describe() would leave out the origin.
        if (particle.position == Vec2(0, 0)) text.add("position", json(particle.position));
        describe(text, particle);
        text.finish();
        items.push_back(text.inLine());
    }
    return items;
}

std::vector<std::string> formatJoints(const Prefab& prefab) {
    std::vector<std::string> items;
    for (const auto& joint : prefab.blueprint.joints) {
        ObjectText text(prefab.extra, "joints[" + std::to_string(items.size()) + ']');
        describe(text, joint);
        text.finish();
        items.push_back(text.inLine());
    }
    return items;
}

std::vector<std::string> formatAngles(const Prefab& prefab) {
    std::vector<std::string> items;
    for (const auto& angle : prefab.blueprint.angles) {
        ObjectText text(prefab.extra, "angles[" + std::to_string(items.size()) + ']');
        describe(text, angle);
        text.finish();
        items.push_back(text.inLine());
    }
    return items;
}

std::string formatSkin(const Prefab& prefab, std::size_t indent) {
    ObjectText text(prefab.extra, "skin");
    const Skin& skin = *prefab.blueprint.skin;
    text.add("texture", json(std::string_view(skin.texture)));
    if (prefab.skinFitted && prefab.generator.index() != 0) {
        text.finish();
        return text.inLine();
    }
    std::vector<std::string> uv;
    for (const auto& point : skin.uv) uv.push_back(json(point));
    text.add("uv", wrapped(uv, indent + 2));
    std::vector<std::string> triangles;
    for (const auto& t : skin.triangles)
        triangles.push_back('[' + std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " +
                            std::to_string(t[2]) + ']');
    text.add("triangles", wrapped(triangles, indent + 2));
    text.finish();
    return text.inLines(indent);
}

/// One line for a recipe, several for an explicit blueprint.
std::string formatPrefab(const Prefab& prefab, std::size_t indent) {
    ObjectText text(prefab.extra, "");
    const auto& plan = prefab.blueprint;
    const bool generated = prefab.generator.index() != 0;
    BodyKind usual = BodyKind::dynamic;
    if (generated) {
        text.add("shape", json(std::string_view(generatorNames[prefab.generator.index()])));
        std::visit([&](const auto& options) { describe(text, options); }, prefab.generator);
        usual = build(prefab.generator).kind;
    }
    if (plan.kind != usual)
        text.add("kind", json(std::string_view(kindNames[static_cast<std::size_t>(plan.kind)])));
    if (!generated) {
        text.add("particles", inLines(formatParticles(prefab), indent + 2));
        if (!plan.joints.empty()) text.add("joints", inLines(formatJoints(prefab), indent + 2));
        if (!plan.angles.empty()) text.add("angles", inLines(formatAngles(prefab), indent + 2));
        text.material("material", plan.material);
    }
    text.part("filter", plan.filter, false);
    text.flag("sensor", plan.sensor, false);
    text.flag("selfCollision", plan.selfCollision, false);
    if (plan.skin) text.add("skin", formatSkin(prefab, indent + 2));
    text.finish();
    return generated ? text.inLine() : text.inLines(indent);
}

std::string formatState(const Placement& body, std::size_t indent) {
    ObjectText text(body.extra, "state");
    std::vector<std::string> positions, velocities;
    for (const auto& position : body.state->positions) positions.push_back(pointJson(position));
    for (const auto& velocity : body.state->velocities) velocities.push_back(json(velocity));
    text.add("positions", wrapped(positions, indent + 2));
    text.add("velocities", wrapped(velocities, indent + 2));
    if (body.state->angle) text.add("angle", json(*body.state->angle));
    text.precise("spin", body.state->spin, 0, 0, 0);
    text.finish();
    return text.inLines(indent);
}

std::string formatBody(const Placement& body) {
    ObjectText text(body.extra, "");
    text.add("id", json(std::string_view(body.id)));
    text.add("blueprint", json(std::string_view(body.blueprint)));
    if (body.pose.position != Point(0, 0)) text.add("position", pointJson(body.pose.position));
    if (body.pose.angle != 0) text.add("angle", json(body.pose.angle));
    text.vec("velocity", body.velocity, {0, 0}, 0);
    if (body.kind)
        text.add("kind", json(std::string_view(kindNames[static_cast<std::size_t>(*body.kind)])));
    if (body.material) text.part("material", *body.material, true);
    if (body.filter) text.part("filter", *body.filter, true);
    if (body.sensor) text.add("sensor", *body.sensor ? "true" : "false");
    if (body.state) text.add("state", formatState(body, 6));
    text.finish();
    return text.inLine();
}

std::string formatRef(const ParticleRef& ref) {
    return '[' + json(std::string_view(ref.body)) + ", " + std::to_string(ref.particle) + ']';
}

std::string formatConnection(const Connection& connection) {
    ObjectText text(connection.extra, "");
    text.add("a", formatRef(connection.a));
    text.add("b", formatRef(connection.b));
    describeJoint(text, connection.options);
    text.finish();
    return text.inLine();
}

std::string formatAttachment(const Attachment& attachment) {
    ObjectText text;
    text.add("particle", formatRef(attachment.particle));
    text.add("body", json(std::string_view(attachment.body)));
    text.add("point", json(attachment.point));
    text.add(attachment.extra);
    return text.inLine();
}

std::string formatVeto(const Veto& veto) {
    return '[' + json(std::string_view(veto.a)) + ", " + json(std::string_view(veto.b)) + ']';
}

std::string formatField(const SceneField& field) {
    ObjectText text(field.extra, "");
    text.add("type", json(std::string_view(fieldNames[field.field.index()])));
    std::visit([&](const auto& one) { describe(text, one); }, field.field);
    text.finish();
    return text.inLine();
}

std::string formatMechanism(const SceneMechanism& mechanism) {
    ObjectText text(mechanism.extra, "");
    text.add("type", json(std::string_view(mechanismNames[mechanism.spec.index()])));
    if (!mechanism.id.empty()) text.name("id", mechanism.id);
    std::visit([&](const auto& one) { describe(text, one); }, mechanism.spec);
    text.finish();
    return text.inLine();
}

template <class Item, class Format>
void addList(ObjectText& text, const char* key, const std::vector<Item>& list, Format format) {
    if (list.empty()) return;
    std::vector<std::string> items;
    for (const auto& item : list) items.push_back(format(item));
    text.add(key, inLines(items, 2));
}

}  // namespace

std::string format(const Scene& scene) {
    ObjectText text;
    text.add("format", json(std::string_view("sulfur-scene")));
    text.add("version", "1");
    if (!scene.title.empty()) text.add("title", json(std::string_view(scene.title)));
    if (!scene.description.empty())
        text.add("description", json(std::string_view(scene.description)));
    ObjectText world;
    describe(world, scene.settings);
    world.add(scene.settingsExtra);
    if (!world.empty()) text.add("world", world.inLine());
    if (!scene.blueprints.empty()) {
        ObjectText blueprints;
        for (const auto& prefab : scene.blueprints)
            blueprints.add(prefab.blueprint.name, formatPrefab(prefab, 4));
        text.add("blueprints", blueprints.inLines(2));
    }
    addList(text, "bodies", scene.bodies, formatBody);
    addList(text, "connections", scene.connections, formatConnection);
    addList(text, "attachments", scene.attachments, formatAttachment);
    addList(text, "vetoes", scene.vetoes, formatVeto);
    addList(text, "fields", scene.fields, formatField);
    addList(text, "mechanisms", scene.mechanisms, formatMechanism);
    text.add(scene.extra);
    return text.inLines(0) + '\n';
}

std::string format(const Prefab& prefab) {
    ObjectText text;
    text.add("format", json(std::string_view("sulfur-blueprint")));
    text.add("version", "1");
    text.add("name", json(std::string_view(prefab.blueprint.name)));
    text.add("blueprint", formatPrefab(prefab, 2));
    if (const auto found = prefab.extra.find("file"); found != prefab.extra.end())
        text.add(found->second);
    return text.inLines(0) + '\n';
}

}  // namespace sulfur::scene
