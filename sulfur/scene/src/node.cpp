// Reading values with bounds, and naming the place when they are not what was asked for.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "text.hpp"

namespace sulfur::scene {

namespace {

std::string whole(const std::string& file, int line, const std::string& object,
                  const std::string& message) {
    std::string text = file;
    if (line > 0) text += ':' + std::to_string(line);
    text += ": ";
    if (!object.empty()) text += "object \"" + object + "\": ";
    return text + message;
}

const char* nameOf(ValueType type) {
    switch (type) {
        case ValueType::null:
            return "null";
        case ValueType::boolean:
            return "a boolean";
        case ValueType::number:
            return "a number";
        case ValueType::string:
            return "a string";
        case ValueType::array:
            return "an array";
        case ValueType::object:
            return "an object";
    }
    return "";
}

std::string shortest(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return std::string(digits, end);
}

/// The beginning of a text from the file, without what would break a message's line.
std::string excerpt(std::string_view text) {
    constexpr std::size_t most = 100;
    std::string shown;
    for (const char c : text.substr(0, most)) {
        const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        shown += control ? '?' : c;
    }
    if (text.size() <= most) return shown;
    // Cut no character in two.
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80)) shown.pop_back();
    return shown + "...";
}

std::string inQuotes(std::string_view text) {
    return '"' + excerpt(text) + '"';
}

/// The number nearest to the decimal text, which is known to be well-formed.
template <class Number>
Number nearest(std::string_view text) {
    Number value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc::result_out_of_range) return value;
    if constexpr (sizeof(Number) < sizeof(double)) {
        const double wide = nearest<double>(text);
        if (std::abs(wide) > 1) return std::numeric_limits<Number>::infinity();
    }
    // Beyond the range of double is refused when the text is parsed: it is too small.
    return 0;
}

std::string range(double low, double high) {
    return shortest(low) + " to " + shortest(high);
}

}  // namespace

ReadError::ReadError(std::string file, int line, std::string object, std::string message)
    : std::runtime_error(whole(file, line, object, message)),
      file_(std::move(file)),
      line_(line),
      object_(std::move(object)),
      message_(std::move(message)) {}

ValueType Node::type() const {
    return text_->values[index_].type;
}

int Node::line() const {
    return text_->origin.firstLine + static_cast<int>(text_->values[index_].line);
}

std::string_view Node::text() const {
    const auto& value = text_->values[index_];
    return std::string_view(text_->source).substr(value.begin, value.end - value.begin);
}

std::string_view Node::key() const {
    return text_->strings[text_->values[index_].key];
}

std::string Node::path(std::uint32_t from) const {
    std::vector<std::uint32_t> chain;
    for (auto i = index_; i != from && i != Text::none; i = text_->values[i].parent)
        chain.push_back(i);
    std::string result;
    for (auto i = chain.rbegin(); i != chain.rend(); ++i) {
        const auto& value = text_->values[*i];
        if (value.parent == Text::none) continue;
        if (text_->values[value.parent].type == ValueType::array) {
            result += '[' + std::to_string(value.place) + ']';
        } else {
            result += (result.empty() ? "" : ".") + text_->strings[value.key];
        }
    }
    return result;
}

// The object that a message names is the innermost one around the value that has an id. Where none
// has, it is the member of a top-level member ("blueprints": {"crate": ...} gives "crate"), or else
// the top-level member itself.
void Node::fail(const std::string& problem) const {
    std::vector<std::uint32_t> chain;  // from this value outwards
    for (auto i = index_; i != Text::none; i = text_->values[i].parent) chain.push_back(i);
    std::uint32_t from = 0;
    std::string object = text_->origin.object;
    // With a name of its own, the document's outermost value counts as a top-level member.
    const std::size_t named = object.empty() ? 3 : 2;
    for (std::size_t depth = std::min(named, chain.size()); depth > 1; --depth) {
        const Node around(text_, chain[chain.size() - depth]);
        if (around.type() != ValueType::object) continue;
        from = around.index_;
        object = around.key().empty() ? around.path(0) : std::string(around.key());
        break;
    }
    for (const auto i : chain) {
        if (text_->values[i].type != ValueType::object) continue;
        const auto id = Node(text_, i).find("id");
        if (!id || id->type() != ValueType::string) continue;
        from = i;
        object = excerpt(text_->strings[text_->values[id->index_].string]);
        break;
    }
    const std::string rest = path(from);
    throw ReadError(text_->origin.file, line(), excerpt(object),
                    rest.empty() ? problem : excerpt(rest) + ": " + problem);
}

bool Node::boolean() const {
    if (type() != ValueType::boolean)
        fail(std::string("is ") + nameOf(type()) + "; allowed is true or false");
    return text_->values[index_].truth;
}

double Node::number(double low, double high) const {
    if (type() != ValueType::number)
        fail(std::string("is ") + nameOf(type()) + "; allowed is a number from " +
             range(low, high));
    const double value = nearest<double>(text());
    if (!(value >= low && value <= high))
        fail("is " + shortest(value) + "; allowed is " + range(low, high));
    return value;
}

Real Node::real(double low, double high) const {
    number(low, high);
    return nearest<Real>(text());
}

Real Node::positive(double high) const {
    const std::string allowed = "more than 0, at most " + shortest(high);
    if (type() != ValueType::number)
        fail(std::string("is ") + nameOf(type()) + "; allowed is a number: " + allowed);
    const Real value = nearest<Real>(text());
    if (!(value > 0) || static_cast<double>(value) > high)
        fail("is " + shortest(nearest<double>(text())) + "; allowed is " + allowed);
    return value;
}

std::int64_t Node::integer(std::int64_t low, std::int64_t high) const {
    const std::string allowed = std::to_string(low) + " to " + std::to_string(high);
    if (type() != ValueType::number)
        fail(std::string("is ") + nameOf(type()) + "; allowed is a whole number from " + allowed);
    const auto digits = text();
    std::int64_t value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() || value < low ||
        value > high)
        fail("is " + std::string(digits.substr(0, 40)) + "; allowed is a whole number from " +
             allowed);
    return value;
}

std::string Node::string(std::size_t least, std::size_t most) const {
    const std::string allowed =
        "a string of " + std::to_string(least) + " to " + std::to_string(most) + " bytes";
    if (type() != ValueType::string)
        fail(std::string("is ") + nameOf(type()) + "; allowed is " + allowed);
    const auto& content = text_->strings[text_->values[index_].string];
    if (content.size() < least || content.size() > most)
        fail("has " + std::to_string(content.size()) + " bytes; allowed is " + allowed);
    const auto isControl = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
    };
    if (std::any_of(content.begin(), content.end(), isControl))
        fail("contains a control character; allowed are letters, line breaks and tabs");
    return content;
}

std::size_t Node::choice(std::initializer_list<std::string_view> words) const {
    if (type() == ValueType::string) {
        const auto& content = text_->strings[text_->values[index_].string];
        const auto found = std::find(words.begin(), words.end(), content);
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    }
    std::string allowed;
    for (const auto word : words)
        allowed += (allowed.empty() ? "\"" : ", \"") + std::string(word) + '"';
    const bool isString = type() == ValueType::string;
    fail("is " +
         (isString ? inQuotes(text_->strings[text_->values[index_].string])
                   : std::string(nameOf(type()))) +
         "; allowed is " + (words.size() > 1 ? "one of " : "") + allowed);
}

Vec2 Node::vec2(double limit) const {
    const auto parts = array(2, 2);
    return {parts[0].real(-limit, limit), parts[1].real(-limit, limit)};
}

Point Node::point(double limit) const {
    const auto parts = array(2, 2);
    return {parts[0].number(-limit, limit), parts[1].number(-limit, limit)};
}

std::vector<Node> Node::array(std::size_t least, std::size_t most) const {
    std::string allowed = "an array of ";
    if (least == most) {
        allowed += std::to_string(least);
    } else {
        allowed += std::to_string(least) + " to " + std::to_string(most);
    }
    if (type() != ValueType::array)
        fail(std::string("is ") + nameOf(type()) + "; allowed is " + allowed);
    const auto& value = text_->values[index_];
    if (value.count < least || value.count > most)
        fail("has " + std::to_string(value.count) + " members; allowed is " + allowed);
    std::vector<Node> result;
    result.reserve(value.count);
    for (auto i = value.first; i != Text::none; i = text_->values[i].next)
        result.push_back(Node(text_, i));
    return result;
}

std::vector<Node> Node::members() const {
    requireObject();
    std::vector<Node> result;
    result.reserve(text_->values[index_].count);
    for (auto i = text_->values[index_].first; i != Text::none; i = text_->values[i].next)
        result.push_back(Node(text_, i));
    return result;
}

void Node::requireObject() const {
    if (type() != ValueType::object)
        fail(std::string("is ") + nameOf(type()) + "; allowed is an object, {...}");
}

Node Node::at(std::string_view key) const {
    if (const auto member = find(key)) return *member;
    fail("has no \"" + std::string(key) + "\"; needed is one");
}

std::optional<Node> Node::find(std::string_view key) const {
    requireObject();
    for (auto i = text_->values[index_].first; i != Text::none; i = text_->values[i].next)
        if (text_->strings[text_->values[i].key] == key) return Node(text_, i);
    return std::nullopt;
}

bool safeAssetName(std::string_view name) {
    if (name.empty() || name.size() > 200) return false;
    const auto isBad = [](char c) {
        return c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    };
    if (std::any_of(name.begin(), name.end(), isBad)) return false;
    while (true) {
        const auto slash = name.find('/');
        const auto part = name.substr(0, slash);
        if (part.empty() || part == "." || part == "..") return false;
        if (slash == std::string_view::npos) return true;
        name.remove_prefix(slash + 1);
    }
}

std::string readAssetName(const Node& node) {
    std::string name = node.string(1, 200);
    if (!safeAssetName(name))
        node.fail(
            "is " + inQuotes(name) +
            "; allowed is a relative path such as \"crate.png\" without \"..\", \"\\\" and \":\"");
    return name;
}

}  // namespace sulfur::scene
