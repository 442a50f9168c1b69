#include "json_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <sulfur/scene.hpp>

namespace sulfurchamber {
namespace {

constexpr std::size_t longestLine = 100;  // columns of a line that grows

[[noreturn]] void malformed() {
    throw std::runtime_error("this text is no well-formed JSON");
}

bool isContainer(char c) {
    return c == '{' || c == '[';
}

}  // namespace

JsonPath pathOf(JsonPath path, std::string_view dotted) {
    while (!dotted.empty()) {
        const std::size_t dot = dotted.find('.');
        const std::string_view part = dotted.substr(0, dot);
        const bool digits = part.find_first_not_of("0123456789") == std::string_view::npos;
        if (digits)
            path.emplace_back(static_cast<std::size_t>(std::stoul(std::string(part))));
        else
            path.emplace_back(std::string(part));
        dotted = dot == std::string_view::npos ? "" : dotted.substr(dot + 1);
    }
    return path;
}

// --- reading ---------------------------------------------------------------------------------

std::size_t JsonText::skipSpace(std::size_t at) const {
    at = text_.find_first_not_of(" \t\r\n", at);
    if (at == std::string::npos) malformed();
    return at;
}

std::size_t JsonText::skipString(std::size_t at) const {
    for (++at; at < text_.size(); ++at) {
        if (text_[at] == '\\')
            ++at;
        else if (text_[at] == '"')
            return at + 1;
    }
    malformed();
}

// Brackets are counted: what is inside was checked when the file was read.
std::size_t JsonText::skipValue(std::size_t at) const {
    if (text_[at] == '"') return skipString(at);
    if (!isContainer(text_[at])) {
        const std::size_t end = text_.find_first_of(" \t\r\n,]}", at);
        if (end == at) malformed();
        return std::min(end, text_.size());
    }
    int depth = 0;
    while (at < text_.size()) {
        const char c = text_[at];
        if (c == '"') {
            at = skipString(at);
            continue;
        }
        if (isContainer(c)) ++depth;
        if ((c == '}' || c == ']') && --depth == 0) return at + 1;
        ++at;
    }
    malformed();
}

std::vector<JsonText::Part> JsonText::partsAt(std::size_t begin) const {
    std::vector<Part> parts;
    if (!isContainer(text_[begin])) return parts;
    const bool object = text_[begin] == '{';
    std::size_t at = skipSpace(begin + 1);
    while (text_[at] != '}' && text_[at] != ']') {
        Part part;
        part.whole.begin = at;
        if (object) {
            if (text_[at] != '"') malformed();
            const std::size_t end = skipString(at);
            part.key = JsonText(text_.substr(at, end - at)).string({}).value_or("");
            at = skipSpace(end);
            if (text_[at] != ':') malformed();
            at = skipSpace(at + 1);
        }
        part.value.begin = at;
        part.whole.end = part.value.end = skipValue(at);
        parts.push_back(part);
        at = skipSpace(part.value.end);
        if (text_[at] == ',') at = skipSpace(at + 1);
    }
    return parts;
}

std::optional<JsonText::Part> JsonText::find(const JsonPath& path) const {
    const std::size_t begin = skipSpace(0);
    const std::size_t end = skipValue(begin);
    Part found{{begin, end}, {begin, end}, {}};
    for (const JsonStep& step : path) {
        const auto parts = partsAt(found.value.begin);
        const bool array = text_[found.value.begin] == '[';
        if (step.isIndex) {
            if (!array || step.index >= parts.size()) return std::nullopt;
            found = parts[step.index];
            continue;
        }
        const auto member = std::find_if(parts.begin(), parts.end(),
                                         [&](const Part& part) { return part.key == step.key; });
        if (array || member == parts.end()) return std::nullopt;
        found = *member;
    }
    return found;
}

std::optional<std::string> JsonText::get(const JsonPath& path) const {
    const auto part = find(path);
    if (!part) return std::nullopt;
    return text_.substr(part->value.begin, part->value.end - part->value.begin);
}

std::optional<double> JsonText::number(const JsonPath& path) const {
    const auto text = get(path);
    double value = 0;
    if (!text) return std::nullopt;
    const auto end = text->data() + text->size();
    const auto read = std::from_chars(text->data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
}

std::optional<std::string> JsonText::string(const JsonPath& path) const {
    const auto text = get(path);
    if (!text || text->front() != '"') return std::nullopt;
    if (text->find('\\') == std::string::npos) return text->substr(1, text->size() - 2);
    // Escapes are rare: the library reads them.
    sulfur::scene::Extra one;
    sulfur::scene::setExtra(one, "value", *text);
    sulfur::scene::Scene scene;
    scene.extra = std::move(one);
    return scene.section("value")->root().string(0, text->size());
}

std::optional<bool> JsonText::boolean(const JsonPath& path) const {
    const auto text = get(path);
    if (text == "true") return true;
    if (text == "false") return false;
    return std::nullopt;
}

std::vector<std::string> JsonText::keys(const JsonPath& path) const {
    std::vector<std::string> names;
    const auto part = find(path);
    if (!part || text_[part->value.begin] != '{') return names;
    for (const Part& member : partsAt(part->value.begin)) names.push_back(member.key);
    return names;
}

std::size_t JsonText::size(const JsonPath& path) const {
    const auto part = find(path);
    return part ? partsAt(part->value.begin).size() : 0;
}

std::optional<std::pair<int, int>> JsonText::lines(const JsonPath& path) const {
    const auto part = find(path);
    if (!part) return std::nullopt;
    const auto at = [this](std::size_t place) {
        const auto end = text_.begin() + static_cast<std::ptrdiff_t>(place);
        return 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
    };
    return std::pair(at(part->whole.begin), at(part->whole.end));
}

// --- changing --------------------------------------------------------------------------------

// Spaces before the first word of the line.
std::size_t JsonText::indentAt(std::size_t at) const {
    const std::size_t line = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    const std::size_t begin = line == std::string::npos ? 0 : line + 1;
    return text_.find_first_not_of(' ', begin) - begin;
}

// A list that no longer fits on its line gets a line for each of its parts.
void JsonText::spread(std::size_t container, const std::vector<Part>& parts) {
    const std::size_t indent = indentAt(container);
    std::string made(1, text_[container]);
    for (const Part& part : parts) {
        made += (made.size() > 1 ? ",\n" : "\n") + std::string(indent + 2, ' ');
        made += text_.substr(part.whole.begin, part.whole.end - part.whole.begin);
    }
    made += '\n' + std::string(indent, ' ') + (text_[container] == '{' ? '}' : ']');
    text_.replace(container, skipValue(container) - container, made);
}

void JsonText::add(std::size_t container, const std::string& entry, bool object) {
    if (!isContainer(text_[container]) || (text_[container] == '{') != object)
        throw std::runtime_error("there is no list to which this could be added");
    const auto parts = partsAt(container);
    if (parts.empty()) {
        text_.replace(container, skipValue(container) - container,
                      object ? '{' + entry + '}' : '[' + entry + ']');
        return;
    }
    // The space before the last part, as it is.
    const Part& last = parts.back();
    const std::size_t before = text_.find_last_not_of(" \t\r\n", last.whole.begin - 1);
    std::string space = text_.substr(before + 1, last.whole.begin - before - 1);
    const bool lines = space.find('\n') != std::string::npos;
    if (!lines) space = " ";
    text_.insert(last.whole.end, "," + space + entry);
    if (lines) return;
    const std::size_t lineBegin = text_.rfind('\n', container);
    const std::size_t begin = lineBegin == std::string::npos ? 0 : lineBegin + 1;
    if (skipValue(container) - begin > longestLine) spread(container, partsAt(container));
}

void JsonText::set(const JsonPath& path, std::string_view json) {
    if (const auto part = find(path)) {
        text_.replace(part->value.begin, part->value.end - part->value.begin, json);
        return;
    }
    const auto parent = find(JsonPath(path.begin(), path.end() - 1));
    if (!parent || path.back().isIndex)
        throw std::runtime_error("there is no object to which this could be added");
    const std::string key = jsonOf(std::string_view(path.back().key));
    add(parent->value.begin, key + ": " + std::string(json), true);
}

void JsonText::append(const JsonPath& array, std::string_view json) {
    const auto part = find(array);
    if (!part) throw std::runtime_error("there is no list to which this could be added");
    add(part->value.begin, std::string(json), false);
}

void JsonText::erase(const JsonPath& path) {
    const auto part = find(path);
    if (!part || path.empty()) return;
    const std::size_t next = skipSpace(part->whole.end);
    if (text_[next] == ',') {
        const std::size_t end = skipSpace(next + 1);
        text_.erase(part->whole.begin, end - part->whole.begin);
        return;
    }
    // The last one goes with the comma before it, and an empty list with its lines.
    const std::size_t before = text_.find_last_not_of(" \t\r\n", part->whole.begin - 1);
    if (text_[before] == ',')
        text_.erase(before, part->whole.end - before);
    else
        text_.erase(before + 1, next - before - 1);
}

void JsonText::rename(const JsonPath& path, std::string_view key) {
    const auto part = find(path);
    if (!part || part->whole.begin == part->value.begin)
        throw std::runtime_error("there is no member of this name");
    const std::size_t end = skipString(part->whole.begin);
    text_.replace(part->whole.begin, end - part->whole.begin, jsonOf(key));
}

// --- making ----------------------------------------------------------------------------------

std::string jsonOf(double value) {
    char digits[32];
    const double rounded = std::round(value * 1e4) / 1e4;
    const auto end = std::to_chars(digits, digits + sizeof digits, rounded == 0 ? 0 : rounded,
                                   std::chars_format::fixed)
                         .ptr;
    return {digits, end};
}

std::string jsonOf(std::string_view text) {
    constexpr char hex[] = "0123456789abcdef";
    std::string made = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            made += {'\\', c};
        else if (c == '\n')
            made += "\\n";
        else if (byte < 0x20)
            made += {'\\', 'u', '0', '0', hex[byte >> 4], hex[byte & 15]};
        else
            made += c;
    }
    return made + '"';
}

std::string jsonOf(double x, double y) {
    return '[' + jsonOf(x) + ", " + jsonOf(y) + ']';
}

}  // namespace sulfurchamber
