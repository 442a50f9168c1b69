// Making JSON text: objects on one line or on several, numbers in their shortest exact form.
#pragma once

#include <string>
#include <string_view>
#include <sulfur/scene/scene.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace sulfur::scene {

/// The shortest decimal that reads back as the same number. What JSON cannot hold becomes null,
/// which the reader refuses with the right line.
std::string json(float value);
std::string json(double value);
std::string json(long long value);
std::string json(std::string_view text);
std::string json(const Vec2& value);
std::string pointJson(const Point& value);

/// `[a, b, c]` on one line.
std::string inLine(const std::vector<std::string>& items);
/// One item per line, `indent` spaces before the closing bracket.
std::string inLines(const std::vector<std::string>& items, std::size_t indent);
/// As many items on a line as fit into 100 columns.
std::string wrapped(const std::vector<std::string>& items, std::size_t indent);

/// Collects the members of one object. A visitor for describe(): members that have the value which
/// they would have anyway are left out.
class ObjectText {
public:
    ObjectText() = default;
    /// Unknown members of `extra` at `path` and below are written by finish().
    ObjectText(const ExtraTree& extra, std::string path) : extra_(&extra), path_(std::move(path)) {}

    void add(std::string_view key, std::string value) {
        members_.emplace_back(key, std::move(value));
    }
    void add(const Extra& extra) {
        for (const auto& member : extra) add(member.key, member.json);
    }
    /// Adds the unknown members of the object itself.
    void finish();
    bool empty() const { return members_.empty(); }
    std::string inLine() const;
    std::string inLines(std::size_t indent) const;
    std::string below(const std::string& part) const {
        return path_.empty() ? part : path_ + '.' + part;
    }

    void vec(const char* key, const Vec2& value, const Vec2& usual, double) {
        if (value != usual) add(key, json(value));
    }
    void size(const char* key, const Vec2& value, const Vec2& usual, double) {
        if (value != usual) add(key, json(value));
    }
    void number(const char* key, Real value, Real usual, double, double) {
        if (value != usual) add(key, json(value));
    }
    void positive(const char* key, Real value, Real usual, double) {
        if (value != usual) add(key, json(value));
    }
    template <class Integer>
    void integer(const char* key, Integer value, Integer usual, std::int64_t, std::int64_t) {
        if (value != usual) add(key, json(static_cast<long long>(value)));
    }
    void infinite(const char* key, Real value, Real usual, double, const char* word);
    void optionalNumber(const char* key, const std::optional<Real>& value, double, double) {
        if (value) add(key, json(*value));
    }
    void flag(const char* key, bool value, bool usual) {
        if (value != usual) add(key, value ? "true" : "false");
    }
    void index(const char* key, std::uint32_t value) {
        add(key, json(static_cast<long long>(value)));
    }
    void points(const char* key, const std::vector<Vec2>& value, std::size_t, std::size_t, double);
    /// Nothing where there are none.
    void indices(const char* key, const std::vector<std::uint32_t>& value, std::size_t);
    void numbers(const char* key, const std::vector<Real>& value, std::size_t, double, double);
    void point(const char* key, const Point& value) { add(key, pointJson(value)); }
    void zone(const char* key, const Zone& value);
    void name(const char* key, const std::string& value) {
        add(key, json(std::string_view(value)));
    }
    void strength(const char* key, Real value) {
        infinite(key, value, sulfur::infinite, 0, "unbreakable");
    }
    void precise(const char* key, double value, double usual, double, double) {
        if (value != usual) add(key, json(value));
    }
    void drive(const char* key, const Drive& value) { part(key, value, false); }
    void optionalDrive(const char* key, const std::optional<Drive>& value) {
        if (value) part(key, *value, true);
    }
    void material(const char* key, const Material& value) { part(key, value, false); }
    void optionalMaterial(const char* key, const std::optional<Material>& value) {
        if (value) part(key, *value, true);
    }
    template <class Choice, class Names>
    void choice(const char* key, Choice value, Choice usual, const Names& names) {
        if (value != usual)
            add(key, json(std::string_view(names[static_cast<std::size_t>(value)])));
    }

    /// A nested object that is left out when nothing in it is unusual, unless `always`.
    template <class Object>
    void part(const char* key, const Object& value, bool always);

private:
    std::vector<std::pair<std::string, std::string>> members_;
    const ExtraTree* extra_ = nullptr;
    std::string path_;
};

}  // namespace sulfur::scene
