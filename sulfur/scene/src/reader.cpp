#include "reader.hpp"

#include <algorithm>
#include <stdexcept>

namespace sulfur::scene {

Reader::Reader(const Node& object, std::string_view part, std::string path, ExtraTree& extra)
    : node_(object), keys_(&keysOf(part)), path_(std::move(path)), extra_(&extra) {
    node_.requireObject();
}

std::optional<Node> Reader::find(std::string_view key) const {
    // A mistake in this library, not in a file: the list of keys would be wrong.
    if (std::find(keys_->begin(), keys_->end(), key) == keys_->end())
        throw std::logic_error("sulfur::scene reads the key \"" + std::string(key) +
                               "\" which its list of keys lacks");
    return node_.find(key);
}

Node Reader::at(std::string_view key) const {
    find(key);
    return node_.at(key);
}

void Reader::finish() {
    Extra unknown;
    for (const auto& member : node_.members()) {
        if (std::find(keys_->begin(), keys_->end(), member.key()) != keys_->end()) continue;
        unknown.push_back({std::string(member.key()), std::string(member.text()), member.line()});
    }
    if (!unknown.empty()) (*extra_)[path_] = std::move(unknown);
}

std::string Reader::below(const std::string& part) const {
    return path_.empty() ? part : path_ + '.' + part;
}

void Reader::size(const char* key, Vec2& value, const Vec2&, double limit) {
    const auto member = find(key);
    if (!member) return;
    const auto sides = member->array(2, 2);
    value = {sides[0].positive(limit), sides[1].positive(limit)};
}

void Reader::infinite(const char* key, Real& value, Real, double high, const char* word) {
    const auto member = find(key);
    if (!member) return;
    if (member->type() == ValueType::string) {
        member->choice({word});
        value = sulfur::infinite;
        return;
    }
    if (member->type() != ValueType::number)
        member->fail(std::string("is neither a number nor \"") + word +
                     "\"; allowed is a number of at least 0, or \"" + word + '"');
    value = member->real(0, high);
}

void Reader::optionalNumber(const char* key, std::optional<Real>& value, double low, double high) {
    if (const auto member = find(key)) value = member->real(low, high);
}

void Reader::index(const char* key, std::uint32_t& value) {
    value = static_cast<std::uint32_t>(at(key).integer(0, 0xffffffffLL));
}

void Reader::points(const char* key, std::vector<Vec2>& value, std::size_t least, std::size_t most,
                    double limit) {
    for (const auto& point : at(key).array(least, most)) value.push_back(point.vec2(limit));
}

void Reader::indices(const char* key, std::vector<std::uint32_t>& value, std::size_t most) {
    const auto member = find(key);
    if (!member) return;
    for (const auto& item : member->array(1, most))
        value.push_back(
            static_cast<std::uint32_t>(item.integer(0, static_cast<std::int64_t>(most) - 1)));
}

void Reader::numbers(const char* key, std::vector<Real>& value, std::size_t most, double low,
                     double high) {
    const auto member = find(key);
    if (!member) return;
    for (const auto& item : member->array(0, most))
        value.push_back(static_cast<Real>(item.number(low, high)));
}

void Reader::material(const char* key, Material& value) {
    const auto member = find(key);
    if (!member) return;
    Reader reader(*member, "material", below(key), *extra_);
    describe(reader, value);
    reader.finish();
    if (value.staticFriction < value.kineticFriction)
        member->fail("staticFriction is less than kineticFriction; allowed is the same or more");
}

void Reader::filter(const char* key, Filter& value) {
    const auto member = find(key);
    if (!member) return;
    Reader reader(*member, "filter", below(key), *extra_);
    describe(reader, value);
    reader.finish();
}

void Reader::kind(const char* key, BodyKind& value) {
    if (const auto member = find(key))
        value = static_cast<BodyKind>(member->choice({kindNames[0], kindNames[1], kindNames[2]}));
}

std::string readName(const Node& node) {
    std::string name = node.string(1, Limits::nameBytes);
    if (name.find_first_of("\n\t") != std::string::npos)
        node.fail("contains a line break or a tab; allowed is one line");
    return name;
}

void requireFormat(const Reader& reader, std::string_view format) {
    reader.at("format").choice({format});
    const Node version = reader.at("version");
    if (version.type() != ValueType::number || version.text() != "1")
        version.fail("is " + std::string(version.text().substr(0, 20)) +
                     "; allowed is 1, the only version that this program reads");
}

}  // namespace sulfur::scene
