#include "writer.hpp"

#include <charconv>
#include <cmath>

#include "describe.hpp"

namespace sulfur::scene {

namespace {

template <class Number>
std::string shortest(Number value) {
    if (!std::isfinite(value)) return "null";
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string escaped(unsigned char c) {
    constexpr char hex[] = "0123456789abcdef";
    switch (c) {
        case '"':
            return "\\\"";
        case '\\':
            return "\\\\";
        case '\n':
            return "\\n";
        case '\t':
            return "\\t";
        default:
            return std::string("\\u00") + hex[c >> 4] + hex[c & 15];
    }
}

}  // namespace

std::string json(float value) {
    return shortest(value);
}

std::string json(double value) {
    return shortest(value);
}

std::string json(long long value) {
    return std::to_string(value);
}

std::string json(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || c == '"' || c == '\\') {
            result += escaped(byte);
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string json(const Vec2& value) {
    return '[' + json(value.x()) + ", " + json(value.y()) + ']';
}

std::string pointJson(const Point& value) {
    return '[' + json(value.x()) + ", " + json(value.y()) + ']';
}

std::string inLine(const std::vector<std::string>& items) {
    std::string result = "[";
    for (const auto& item : items) result += (result.size() > 1 ? ", " : "") + item;
    return result + ']';
}

std::string inLines(const std::vector<std::string>& items, std::size_t indent) {
    if (items.empty()) return "[]";
    std::string result = "[";
    for (std::size_t i = 0; i < items.size(); ++i)
        result += (i == 0 ? "\n" : ",\n") + std::string(indent + 2, ' ') + items[i];
    return result + '\n' + std::string(indent, ' ') + ']';
}

std::string wrapped(const std::vector<std::string>& items, std::size_t indent) {
    const std::string simple = inLine(items);
    if (simple.size() + indent <= 80) return simple;
    std::vector<std::string> lines(1);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
        if (!lines.back().empty() && indent + 3 + lines.back().size() + item.size() > 100)
            lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + item;
    }
    std::string result = "[";
    for (const auto& line : lines) result += '\n' + std::string(indent + 2, ' ') + line;
    return result + '\n' + std::string(indent, ' ') + ']';
}

void ObjectText::finish() {
    if (extra_ == nullptr) return;
    if (const auto found = extra_->find(path_); found != extra_->end()) add(found->second);
}

std::string ObjectText::inLine() const {
    std::string result = "{";
    for (const auto& [key, value] : members_)
        result += (result.size() > 1 ? ", " : "") + json(key) + ": " + value;
    return result + '}';
}

std::string ObjectText::inLines(std::size_t indent) const {
    if (members_.empty()) return "{}";
    std::string result = "{";
    for (const auto& [key, value] : members_)
        result += (result.size() > 1 ? ",\n" : "\n") + std::string(indent + 2, ' ') + json(key) +
                  ": " + value;
    return result + '\n' + std::string(indent, ' ') + '}';
}

void ObjectText::infinite(const char* key, Real value, Real usual, double, const char* word) {
    if (value == usual) return;
    add(key, value == sulfur::infinite ? json(std::string_view(word)) : json(value));
}

void ObjectText::points(const char* key, const std::vector<Vec2>& value, std::size_t, std::size_t,
                        double) {
    std::vector<std::string> items;
    for (const auto& point : value) items.push_back(json(point));
    add(key, wrapped(items, 6));
}

void ObjectText::indices(const char* key, const std::vector<std::uint32_t>& value, std::size_t) {
    if (value.empty()) return;
    std::string text = "[";
    for (const auto index : value)
        text += (text.size() > 1 ? ", " : "") + json(static_cast<long long>(index));
    add(key, text + "]");
}

void ObjectText::numbers(const char* key, const std::vector<Real>& value, std::size_t, double,
                         double) {
    if (value.empty()) return;
    std::vector<std::string> items;
    for (const Real number : value) items.push_back(json(number));
    add(key, wrapped(items, 6));
}

template <class Object>
void ObjectText::part(const char* key, const Object& value, bool always) {
    static const ExtraTree none;
    ObjectText text(extra_ != nullptr ? *extra_ : none, below(key));
    describe(text, value);
    text.finish();
    if (always || !text.empty()) add(key, text.inLine());
}

void ObjectText::zone(const char* key, const Zone& value) {
    if (const auto* box = std::get_if<BoxZone>(&value)) part(key, *box, true);
    if (const auto* circle = std::get_if<CircleZone>(&value)) {
        static const ExtraTree none;
        ObjectText text(extra_ != nullptr ? *extra_ : none, below(key));
        text.point("centre", circle->centre);
        text.add("radius", json(circle->radius));  // also where it is the usual one
        text.finish();
        add(key, text.inLine());
    }
}

template void ObjectText::part(const char*, const Material&, bool);
template void ObjectText::part(const char*, const Filter&, bool);
template void ObjectText::part(const char*, const BoxZone&, bool);
template void ObjectText::part(const char*, const Drive&, bool);

}  // namespace sulfur::scene
