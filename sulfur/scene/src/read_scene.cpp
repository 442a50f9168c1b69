// Scene and blueprint files from JSON. Everything is checked here, so that instantiate() cannot
// fail on what was read.
#include <algorithm>
#include <map>
#include <sulfur/scene/file.hpp>

#include "make_mechanisms.hpp"
#include "placing.hpp"
#include "reader.hpp"

namespace sulfur::scene {

namespace {

/// What the parts of a scene must know of each other.
class SceneReader {
public:
    explicit SceneReader(Scene& scene) : scene_(scene) {}

    void read(const Node& root) {
        ExtraTree extra;
        Reader reader(root, "scene", "", extra);
        requireFormat(reader, "sulfur-scene");
        if (const auto title = reader.find("title"))
            scene_.title = title->string(0, Limits::textBytes);
        if (const auto text = reader.find("description"))
            scene_.description = text->string(0, Limits::textBytes);
        if (const auto world = reader.find("world")) readWorld(*world);
        if (const auto blueprints = reader.find("blueprints")) readBlueprints(*blueprints);
        if (const auto bodies = reader.find("bodies")) {
            for (const auto& body : bodies->array(0, Limits::bodies)) readBody(body);
        }
        if (const auto list = reader.find("connections")) {
            for (const auto& node : list->array(0, Limits::joints)) readConnection(node);
        }
        if (const auto list = reader.find("attachments")) {
            for (const auto& node : list->array(0, Limits::particles)) readAttachment(node);
        }
        if (const auto list = reader.find("vetoes")) {
            for (const auto& node : list->array(0, Limits::vetoes)) readVeto(node);
        }
        if (const auto list = reader.find("fields")) {
            for (const auto& node : list->array(0, Limits::fields)) readField(node);
        }
        if (const auto list = reader.find("mechanisms")) {
            const auto nodes = list->array(0, Limits::mechanisms);
            for (const auto& node : nodes) readMechanism(node);
            tryMechanisms(nodes);
        }
        reader.finish();
        scene_.extra = std::move(extra[""]);
    }

private:
    struct Known {
        std::size_t place;  ///< among the scene's bodies
        const Prefab* prefab;
        int line;
    };
    struct Total {
        std::size_t particles = 0;
        std::size_t joints = 0;

        void add(const Node& node, const Blueprint& plan, const char* what) {
            particles += plan.particles.size();
            joints += plan.joints.size() + plan.angles.size();
            refuse(node, what);
        }
        void refuse(const Node& node, const char* what) const {
            if (particles > Limits::particles)
                node.fail(std::string("brings the ") + what + " to " + std::to_string(particles) +
                          " particles; allowed are at most " + std::to_string(Limits::particles));
            if (joints > Limits::joints)
                node.fail(std::string("brings the ") + what + " to " + std::to_string(joints) +
                          " joints; allowed are at most " + std::to_string(Limits::joints));
        }
    };

    void readWorld(const Node& node) {
        ExtraTree extra;
        Reader reader(node, "world", "", extra);
        describe(reader, scene_.settings);
        reader.finish();
        if (scene_.settings.airFriction > static_cast<Real>(scene_.settings.tickRate))
            node.fail("airFriction is more than tickRate; allowed is 0 to tickRate");
        scene_.settingsExtra = std::move(extra[""]);
    }

    void readBlueprints(const Node& node) {
        Total total;
        for (const auto& member : node.members()) {
            const std::string name(member.key());
            if (name.empty() || name.size() > Limits::nameBytes ||
                name.find_first_of("\n\t") != std::string::npos)
                member.fail("has an unusable name; allowed is one line of 1 to " +
                            std::to_string(Limits::nameBytes) + " bytes");
            scene_.blueprints.push_back(readPrefab(member, name));
            total.add(member, scene_.blueprints.back().blueprint, "blueprints");
        }
        for (const auto& prefab : scene_.blueprints)
            prefabs_.emplace(prefab.blueprint.name, &prefab);
    }

    void readBody(const Node& node) {
        Placement body;
        Reader reader(node, "body", "", body.extra);
        const Node id = reader.at("id");
        body.id = readName(id);
        if (const auto twin = bodies_.find(body.id); twin != bodies_.end())
            id.fail("is the id of the body on line " + std::to_string(twin->second.line) +
                    " too; allowed is each id once");
        const Node name = reader.at("blueprint");
        body.blueprint = readName(name);
        const auto prefab = prefabs_.find(body.blueprint);
        if (prefab == prefabs_.end())
            name.fail("is \"" + body.blueprint + "\"; allowed is a name from \"blueprints\"");
        const auto& plan = prefab->second->blueprint;
        total_.add(node, plan, "scene");
        reader.position("position", body.pose.position);
        if (const auto angle = reader.find("angle")) body.pose.angle = angle->number(-1e6, 1e6);
        reader.vec("velocity", body.velocity, {}, Limits::speed);
        readOverrides(reader, body);
        if (const auto state = reader.find("state")) readState(*state, reader, plan, body);
        reader.finish();
        if (!body.state) requireInside(node, plan, body.pose);
        if (kindOf(body, *prefab->second) == BodyKind::fixed && body.velocity != Vec2(0, 0))
            reader.at("velocity")
                .fail(
                    "is given to a fixed body; allowed are dynamic and "
                    "kinematic ones");
        bodies_.emplace(body.id, Known{scene_.bodies.size(), prefab->second, node.line()});
        scene_.bodies.push_back(std::move(body));
    }

    static BodyKind kindOf(const Placement& body, const Prefab& prefab) {
        return body.kind.value_or(prefab.blueprint.kind);
    }

    static void readOverrides(Reader& reader, Placement& body) {
        if (reader.find("kind")) reader.kind("kind", body.kind.emplace());
        if (reader.find("material")) reader.material("material", body.material.emplace());
        if (reader.find("filter")) reader.filter("filter", body.filter.emplace());
        if (reader.find("sensor")) reader.flag("sensor", body.sensor.emplace(), false);
    }

    static void readState(const Node& node, Reader& body, const Blueprint& plan,
                          Placement& placement) {
        Reader reader(node, "state", body.below("state"), body.extra());
        auto& state = placement.state.emplace();
        const auto count = plan.particles.size();
        for (const auto& position : reader.at("positions").array(count, count))
            state.positions.push_back(position.point(Limits::coordinate));
        for (const auto& velocity : reader.at("velocities").array(count, count))
            state.velocities.push_back(velocity.vec2(Limits::speed));
        for (const char* key : {"angle", "spin"}) {
            const auto member = reader.find(key);
            if (!member) continue;
            if (count != 1)
                member->fail("is given to a body of " + std::to_string(count) +
                             " particles; allowed are those of one");
            (key[0] == 'a' ? state.angle.emplace() : state.spin) =
                member->number(-Limits::spin, Limits::spin);
        }
        reader.finish();
    }

    static void requireInside(const Node& node, const Blueprint& plan, const Pose& pose) {
        for (const Point& point : placed(plan, pose)) {
            if (point.cwiseAbs().maxCoeff() <= Limits::coordinate) continue;
            node.fail("a particle is at [" + std::to_string(point.x()) + ", " +
                      std::to_string(point.y()) +
                      "]; allowed are world coordinates from -1000 to 1000");
        }
    }

    const Known& knownBody(const Node& node) const {
        const std::string id = readName(node);
        const auto found = bodies_.find(id);
        if (found == bodies_.end())
            node.fail("is \"" + id + "\"; allowed is the id of a body in \"bodies\"");
        return found->second;
    }

    ParticleRef readRef(const Node& node) const {
        const auto parts = node.array(2, 2);
        const Known& body = knownBody(parts[0]);
        const auto last = static_cast<std::int64_t>(body.prefab->blueprint.particles.size()) - 1;
        return {scene_.bodies[body.place].id,
                static_cast<std::uint32_t>(parts[1].integer(0, last))};
    }

    bool isDynamic(const ParticleRef& ref) const {
        const Known& known = bodies_.at(ref.body);
        return kindOf(scene_.bodies[known.place], *known.prefab) == BodyKind::dynamic;
    }

    Point positionOf(const ParticleRef& ref) const {
        const Known& known = bodies_.at(ref.body);
        const auto& body = scene_.bodies[known.place];
        if (body.state) return body.state->positions[ref.particle];
        return placed(known.prefab->blueprint, body.pose)[ref.particle];
    }

    void readConnection(const Node& node) {
        Connection connection;
        Reader reader(node, "connection", "", connection.extra);
        connection.a = readRef(reader.at("a"));
        connection.b = readRef(reader.at("b"));
        describeJoint(reader, connection.options);
        reader.finish();
        const auto& [a, b] = std::tie(connection.a, connection.b);
        if (a.body == b.body && a.particle == b.particle)
            node.fail("joins a particle to itself; allowed are two different particles");
        if (!isDynamic(a) && !isDynamic(b))
            node.fail(
                "joins two particles that cannot move; allowed is at least one of a dynamic "
                "body");
        const auto& options = connection.options;
        const double length = options.restLength ? static_cast<double>(*options.restLength)
                                                 : (positionOf(a) - positionOf(b)).norm();
        if (length < 1e-9 && (options.stiffness == infinite || options.radius > 0))
            node.fail(
                "has length 0; a rigid joint or one with a radius needs two particles that "
                "are apart, or a restLength above 0; to hold them together use "
                "\"attachments\"");
        ++total_.joints;
        total_.refuse(node, "scene");
        scene_.connections.push_back(std::move(connection));
    }

    void readAttachment(const Node& node) {
        Attachment attachment;
        ExtraTree extra;
        Reader reader(node, "attachment", "", extra);
        attachment.particle = readRef(reader.at("particle"));
        attachment.body = scene_.bodies[knownBody(reader.at("body")).place].id;
        reader.at("point");
        reader.vec("point", attachment.point, {}, Limits::coordinate);
        reader.finish();
        attachment.extra = std::move(extra[""]);
        if (attachment.body == attachment.particle.body)
            node.fail("holds a particle at its own body; allowed is another body");
        scene_.attachments.push_back(std::move(attachment));
    }

    void readVeto(const Node& node) {
        const auto names = node.array(2, 2);
        const Veto veto{scene_.bodies[knownBody(names[0]).place].id,
                        scene_.bodies[knownBody(names[1]).place].id};
        if (veto.a == veto.b)
            node.fail("names \"" + veto.a + "\" twice; allowed are two different bodies");
        scene_.vetoes.push_back(veto);
    }

    void readField(const Node& node) {
        scene_.fields.push_back(scene::readField(node));
        const auto* wind = std::get_if<WindField>(&scene_.fields.back().field);
        if (wind && wind->drag > static_cast<Real>(scene_.settings.tickRate))
            node.fail("drag is more than the world's tickRate; allowed is 0 to tickRate");
    }

    void readMechanism(const Node& node) {
        SceneMechanism mechanism = scene::readMechanism(node);
        if (const auto* gear = std::get_if<Gear>(&mechanism.spec)) {
            requirePart(node.at("first"), gear->first);
            requirePart(node.at("second"), gear->second);
            if (gear->first == gear->second)
                node.fail("couples \"" + gear->first +
                          "\" with itself; allowed are two mechanisms");
        } else {
            requireEnds(node);
        }
        if (std::holds_alternative<Pulley>(mechanism.spec)) knownBody(node.at("frame"));
        if (const std::string& id = mechanism.id; !id.empty()) {
            const Part part{mechanism.spec.index(), node.line()};
            if (const auto [twin, isNew] = mechanisms_.emplace(id, part); !isNew)
                node.at("id").fail("is the id of the mechanism on line " +
                                   std::to_string(twin->second.line) +
                                   " too; allowed is each id once");
        }
        scene_.mechanisms.push_back(std::move(mechanism));
    }

    void requireEnds(const Node& node) const {
        const Known &a = knownBody(node.at("a")), &b = knownBody(node.at("b"));
        if (a.place == b.place)
            node.fail("joins \"" + scene_.bodies[a.place].id +
                      "\" to itself; allowed are two bodies");
        const auto moves = [&](const Known& known) {
            return kindOf(scene_.bodies[known.place], *known.prefab) == BodyKind::dynamic;
        };
        if (!moves(a) && !moves(b))
            node.fail("joins two bodies that cannot move; allowed is at least one that is dynamic");
    }

    void requirePart(const Node& node, const std::string& id) const {
        const auto part = mechanisms_.find(id);
        if (part == mechanisms_.end())
            node.fail("is \"" + id + "\"; allowed is the id of a mechanism before this one");
        if (std::string_view(mechanismNames[part->second.kind]) == "gear")
            node.fail("is \"" + id + "\", a gear; allowed are all other mechanisms");
    }

    /// Whether bodies can hold the points is for a world to say.
    void tryMechanisms(const std::vector<Node>& nodes) {
        const auto refused = refusals(scene_);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!refused[i].empty()) nodes[i].fail("cannot be made: " + refused[i]);
    }

    struct Part {
        std::size_t kind;  ///< its place in mechanismNames
        int line;
    };

    Scene& scene_;
    std::map<std::string, Part, std::less<>> mechanisms_;
    std::map<std::string, const Prefab*, std::less<>> prefabs_;
    std::map<std::string, Known, std::less<>> bodies_;
    Total total_;
};

Scene fromDocument(const Document& document) {
    Scene scene;
    scene.file = document.origin().file;
    SceneReader(scene).read(document.root());
    return scene;
}

Prefab prefabFrom(const Document& document) {
    ExtraTree extra;
    Reader reader(document.root(), "blueprintFile", "", extra);
    requireFormat(reader, "sulfur-blueprint");
    const std::string name = readName(reader.at("name"));
    Prefab prefab = readPrefab(reader.at("blueprint"), name);
    const auto& plan = prefab.blueprint;
    if (plan.particles.size() > Limits::particles ||
        plan.joints.size() + plan.angles.size() > Limits::joints)
        reader.at("blueprint")
            .fail(
                "is too large; allowed are at most 24000 particles and 72000 "
                "joints");
    reader.finish();
    if (!extra[""].empty()) prefab.extra["file"] = std::move(extra[""]);
    return prefab;
}

}  // namespace

Scene read(const std::filesystem::path& file) {
    return fromDocument(Document::read(file));
}

Scene parse(std::string_view text, std::string fileName) {
    return fromDocument(Document::parse(
        std::string(text), {.file = std::move(fileName), .firstLine = 1, .object = {}}));
}

Prefab readBlueprint(const std::filesystem::path& file) {
    return prefabFrom(Document::read(file));
}

Prefab parseBlueprint(std::string_view text, std::string fileName) {
    return prefabFrom(Document::parse(std::string(text),
                                      {.file = std::move(fileName), .firstLine = 1, .object = {}}));
}

}  // namespace sulfur::scene
