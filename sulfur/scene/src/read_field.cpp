// Force fields from JSON.
#include "reader.hpp"

namespace sulfur::scene {

namespace {

template <std::size_t index>
bool tryKind(Reader& reader, std::size_t kind, Field& field) {
    if (kind != index) return false;
    describe(reader, field.emplace<index>());
    return true;
}

template <std::size_t... indices>
void readKind(Reader& reader, std::size_t kind, Field& field, std::index_sequence<indices...>) {
    (tryKind<indices>(reader, kind, field) || ...);
}

}  // namespace

/// A rectangle has a "low" and a "high" corner, a disc a "centre" and a "radius"; without a zone
/// the field is everywhere.
void Reader::zone(const char* key, Zone& value) {
    const auto member = find(key);
    if (!member) return;
    member->requireObject();
    const bool circle = member->find("centre").has_value();
    if (!circle && !member->find("low"))
        member->fail("has neither \"low\" and \"high\" nor \"centre\"; needed is one of them");
    Reader reader(*member, circle ? "circleZone" : "boxZone", below(key), *extra_);
    if (circle) {
        describe(reader, value.emplace<CircleZone>());
        reader.at("radius");
    } else {
        const auto& box = value.emplace<BoxZone>();
        describe(reader, std::get<BoxZone>(value));
        if ((box.low.array() >= box.high.array()).any())
            member->fail(
                "has a low corner that is not below its high corner; allowed is an extent "
                "on both axes");
    }
    reader.finish();
}

SceneField readField(const Node& node) {
    SceneField result;
    const auto kind = node.at("type").choice({fieldNames[0], fieldNames[1], fieldNames[2]});
    Reader reader(node, fieldParts[kind], "", result.extra);
    readKind(reader, kind, result.field, std::make_index_sequence<std::variant_size_v<Field>>());
    if (const auto* radial = std::get_if<RadialField>(&result.field); radial && radial->reach == 0)
        reader.at("reach").fail("is 0; allowed is more than 0, or \"unlimited\"");
    reader.finish();
    return result;
}

}  // namespace sulfur::scene
