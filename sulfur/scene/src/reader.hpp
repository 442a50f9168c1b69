// Reading the members of one JSON object, and keeping those that nobody asks for.
#pragma once

#include <sulfur/scene/scene.hpp>

#include "describe.hpp"
#include "keys.hpp"

namespace sulfur::scene {

/// A visitor for describe(): fills an object from JSON. Whoever makes one calls finish() at the
/// end.
class Reader {
public:
    /// `part` is a name for keysOf; `path` is where unknown members go in `extra`.
    Reader(const Node& object, std::string_view part, std::string path, ExtraTree& extra);

    const Node& node() const { return node_; }
    std::optional<Node> find(std::string_view key) const;
    Node at(std::string_view key) const;
    /// Keeps the members that are not in the list of the part's keys.
    void finish();

    void vec(const char* key, Vec2& value, const Vec2&, double limit) {
        readOptional(key, value, &Node::vec2, limit);
    }
    void size(const char* key, Vec2& value, const Vec2&, double limit);
    void number(const char* key, Real& value, Real, double low, double high) {
        readOptional(key, value, &Node::real, low, high);
    }
    void positive(const char* key, Real& value, Real, double high) {
        readOptional(key, value, &Node::positive, high);
    }
    template <class Integer>
    void integer(const char* key, Integer& value, Integer, std::int64_t low, std::int64_t high) {
        if (const auto member = find(key)) value = static_cast<Integer>(member->integer(low, high));
    }
    void infinite(const char* key, Real& value, Real, double high, const char* word);
    void optionalNumber(const char* key, std::optional<Real>& value, double low, double high);
    void flag(const char* key, bool& value, bool) { readOptional(key, value, &Node::boolean); }
    void index(const char* key, std::uint32_t& value);
    void points(const char* key, std::vector<Vec2>& value, std::size_t least, std::size_t most,
                double limit);
    /// May be missing.
    void indices(const char* key, std::vector<std::uint32_t>& value, std::size_t most);
    void numbers(const char* key, std::vector<Real>& value, std::size_t most, double low,
                 double high);
    void material(const char* key, Material& value);
    void optionalMaterial(const char* key, std::optional<Material>& value) {
        if (find(key)) material(key, value.emplace());
    }
    template <class Choice>
    void choice(const char* key, Choice& value, Choice, const std::array<const char*, 2>& names) {
        if (const auto member = find(key))
            value = static_cast<Choice>(member->choice({names[0], names[1]}));
    }
    /// A place that must be there.
    void point(const char* key, Point& value) { value = at(key).point(Limits::coordinate); }
    void zone(const char* key, Zone& value);
    /// An id that must be there.
    void name(const char* key, std::string& value);
    /// Above 0, or "unbreakable".
    void strength(const char* key, Real& value);
    void precise(const char* key, double& value, double, double low, double high) {
        readOptional(key, value, &Node::number, low, high);
    }
    void drive(const char* key, Drive& value);
    void optionalDrive(const char* key, std::optional<Drive>& value) {
        if (find(key)) drive(key, value.emplace());
    }

    void filter(const char* key, Filter& value);
    void kind(const char* key, BodyKind& value);
    void position(const char* key, Point& value) {
        readOptional(key, value, &Node::point, Limits::coordinate);
    }

    /// The path of a part inside this object.
    std::string below(const std::string& part) const;
    ExtraTree& extra() { return *extra_; }

private:
    template <class Value, class Result, class... Parameters, class... Arguments>
    void readOptional(const char* key, Value& value, Result (Node::*read)(Parameters...) const,
                      Arguments... arguments) {
        if (const auto member = find(key)) value = ((*member).*read)(arguments...);
    }

    Node node_;
    const KeyList* keys_;
    std::string path_;
    ExtraTree* extra_;
};

/// Reads the members of a "blueprints" object or of a blueprint file. `name` becomes the
/// blueprint's.
Prefab readPrefab(const Node& node, const std::string& name);

/// Reads an item of "fields". Its numbers are in range, but for what depends on the tick rate.
SceneField readField(const Node& node);

/// Reads an item of "mechanisms". Its numbers are in range; bodies and parts may be anything.
SceneMechanism readMechanism(const Node& node);

/// An id or a name: 1 to Limits::nameBytes bytes on one line.
std::string readName(const Node& node);
/// Throws unless "format" and "version" are what this library reads.
void requireFormat(const Reader& reader, std::string_view format);

}  // namespace sulfur::scene
