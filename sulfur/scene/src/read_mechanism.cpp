// Mechanisms from JSON.
#include "reader.hpp"

namespace sulfur::scene {

namespace {

using Spec = decltype(SceneMechanism::spec);

template <std::size_t index>
bool trySpec(Reader& reader, std::size_t kind, Spec& spec) {
    if (kind != index) return false;
    describe(reader, spec.emplace<index>());
    return true;
}

template <std::size_t... indices>
void readSpec(Reader& reader, std::size_t kind, Spec& spec, std::index_sequence<indices...>) {
    (trySpec<indices>(reader, kind, spec) || ...);
}

/// What the ranges of single numbers do not say.
void requirePossible(const Reader& reader, const Spec& spec) {
    const auto requireAxis = [&](const Vec2& axis) {
        if (axis.isZero(0)) reader.at("axis").fail("is [0, 0]; allowed is any other vector");
    };
    if (const auto* slider = std::get_if<Slider>(&spec)) requireAxis(slider->axis);
    if (const auto* wheel = std::get_if<Wheel>(&spec)) requireAxis(wheel->axis);
    if (const auto* distance = std::get_if<Distance>(&spec);
        distance != nullptr && !(distance->options.drive.upper > 0))
        reader.at("drive").fail(
            "has an upper limit of 0 or less; allowed is more than 0, and a hinge for points "
            "that meet");
    if (const auto* gear = std::get_if<Gear>(&spec);
        gear != nullptr && std::abs(static_cast<double>(gear->ratio)) < Limits::leastRatio)
        reader.at("ratio").fail("is too near 0; allowed is 1e-6 to 1e6, or the same below 0");
}

}  // namespace

void Reader::name(const char* key, std::string& value) {
    value = readName(at(key));
}

void Reader::strength(const char* key, Real& value) {
    infinite(key, value, sulfur::infinite, Limits::strength, "unbreakable");
    if (value == 0) at(key).fail("is 0; allowed is more than 0, or \"unbreakable\"");
}

void Reader::drive(const char* key, Drive& value) {
    const auto member = find(key);
    if (!member) return;
    Reader reader(*member, "drive", below(key), *extra_);
    describe(reader, value);
    reader.finish();
    if (value.lower > value.upper)
        member->fail("lower is above upper; allowed is the same or less");
}

SceneMechanism readMechanism(const Node& node) {
    SceneMechanism result;
    const auto& n = mechanismNames;
    const auto kind = node.at("type").choice({n[0], n[1], n[2], n[3], n[4], n[5], n[6]});
    Reader reader(node, mechanismParts[kind], "", result.extra);
    if (const auto id = reader.find("id")) result.id = readName(*id);
    readSpec(reader, kind, result.spec, std::make_index_sequence<std::variant_size_v<Spec>>());
    requirePossible(reader, result.spec);
    reader.finish();
    return result;
}

}  // namespace sulfur::scene
