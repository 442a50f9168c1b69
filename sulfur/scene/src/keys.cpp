#include "keys.hpp"

#include <map>
#include <stdexcept>

#include "describe.hpp"

namespace sulfur::scene {

namespace {

/// The visitor that only notes the keys.
struct KeyVisitor {
    KeyList keys;

    template <class... Rest>
    void vec(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void size(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void number(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void positive(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void integer(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void infinite(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void optionalNumber(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class Value>
    void flag(const char* key, Value&&, bool) {
        keys.push_back(key);
    }
    template <class Value>
    void index(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class... Rest>
    void indices(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void numbers(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class... Rest>
    void points(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class Value>
    void point(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class Value>
    void zone(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class Value>
    void material(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class Value>
    void optionalMaterial(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class Value>
    void name(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class Value>
    void strength(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class... Rest>
    void precise(const char* key, Rest&&...) {
        keys.push_back(key);
    }
    template <class Value>
    void drive(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class Value>
    void optionalDrive(const char* key, Value&&) {
        keys.push_back(key);
    }
    template <class... Rest>
    void choice(const char* key, Rest&&...) {
        keys.push_back(key);
    }
};

template <class Object>
KeyList described(KeyList first = {}) {
    KeyVisitor visitor{std::move(first)};
    const Object object{};
    describe(visitor, object);
    return visitor.keys;
}

using Table = std::map<std::string_view, KeyList>;

Table makeTable() {
    KeyVisitor connection{{"a", "b"}};
    const ConnectOptions options;
    describeJoint(connection, options);
    Table table{
        {"scene",
         {"format", "version", "title", "description", "world", "blueprints", "bodies",
          "connections", "attachments", "vetoes", "fields", "mechanisms"}},
        {"blueprintFile", {"format", "version", "name", "blueprint"}},
        {"explicit",
         {"kind", "particles", "joints", "angles", "material", "filter", "sensor", "selfCollision",
          "skin"}},
        {"skin", {"texture", "uv", "triangles"}},
        {"body",
         {"id", "blueprint", "position", "angle", "velocity", "kind", "material", "filter",
          "sensor", "state"}},
        {"state", {"positions", "velocities", "angle", "spin"}},
        {"connection", connection.keys},
        {"attachment", {"particle", "body", "point"}},
        {"world", described<WorldSettings>()},
        {"particle", described<ParticleSpec>()},
        {"joint", described<JointSpec>()},
        {"angle", described<AngularJointSpec>()},
        {"material", described<Material>()},
        {"filter", described<Filter>()},
    };
    table["boxZone"] = described<BoxZone>();
    table["circleZone"] = described<CircleZone>();
    table["uniformField"] = described<UniformField>({"type"});
    table["radialField"] = described<RadialField>({"type"});
    table["windField"] = described<WindField>({"type"});
    table["drive"] = described<Drive>();
    table["hingeMechanism"] = described<Hinge>({"type", "id"});
    table["weldMechanism"] = described<Weld>({"type", "id"});
    table["sliderMechanism"] = described<Slider>({"type", "id"});
    table["wheelMechanism"] = described<Wheel>({"type", "id"});
    table["distanceMechanism"] = described<Distance>({"type", "id"});
    table["pulleyMechanism"] = described<Pulley>({"type", "id"});
    table["gearMechanism"] = described<Gear>({"type", "id"});
    const KeyList shape{"shape", "kind", "filter", "sensor", "selfCollision", "skin"};
    table["floor"] = described<FloorOptions>(shape);
    table["ground"] = described<shapes::GroundOptions>(shape);
    table["box"] = described<shapes::BoxOptions>(shape);
    table["ball"] = described<shapes::BallOptions>(shape);
    table["rope"] = described<shapes::RopeOptions>(shape);
    table["jelly"] = described<shapes::JellyOptions>(shape);
    table["blob"] = described<shapes::BlobOptions>(shape);
    table["polygon"] = described<shapes::PolygonOptions>(shape);
    table["wheel"] = described<shapes::WheelOptions>(shape);
    table["chain"] = described<shapes::ChainOptions>(shape);
    table["bridge"] = described<shapes::BridgeOptions>(shape);
    table["cloth"] = described<shapes::ClothOptions>(shape);
    table["wall"] = described<shapes::WallOptions>(shape);
    return table;
}

const Table& table() {
    static const Table result = makeTable();
    return result;
}

}  // namespace

const KeyList& keysOf(std::string_view part) {
    return table().at(part);
}

const std::vector<std::string_view>& parts() {
    static const std::vector<std::string_view> result = [] {
        std::vector<std::string_view> names;
        for (const auto& [name, keys] : table()) names.push_back(name);
        return names;
    }();
    return result;
}

}  // namespace sulfur::scene
