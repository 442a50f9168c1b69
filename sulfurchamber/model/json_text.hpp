// JSON that is edited as text: what is not touched keeps its bytes.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sulfurchamber {

/// One step of the way into a JSON text: the key of a member, or the place of an item.
struct JsonStep {
    JsonStep(const char* name) : key(name) {}
    JsonStep(std::string name) : key(std::move(name)) {}
    JsonStep(std::size_t place) : index(place), isIndex(true) {}
    std::string key;
    std::size_t index = 0;
    bool isIndex = false;
};
using JsonPath = std::vector<JsonStep>;

/// "zones", 2 and "wind.velocity.0" as one way: parts with digits alone are places of items.
JsonPath pathOf(JsonPath start, std::string_view dotted);

/// A JSON text with functions that change one value of it. Members and items that are added follow
/// the layout of those beside them.
///
/// A plain value. The text must be well-formed: std::runtime_error is thrown where it is not, and
/// where a way that must exist does not; the text is then as it was.
class JsonText {
public:
    explicit JsonText(std::string text) : text_(std::move(text)) {}
    const std::string& text() const { return text_; }

    bool has(const JsonPath& path) const { return find(path).has_value(); }
    /// The value as it is written, or nothing.
    std::optional<std::string> get(const JsonPath& path) const;
    /// The same as what it means; nothing where it is something else.
    std::optional<double> number(const JsonPath& path) const;
    std::optional<std::string> string(const JsonPath& path) const;
    std::optional<bool> boolean(const JsonPath& path) const;
    /// The keys of an object in their order; none for all else.
    std::vector<std::string> keys(const JsonPath& path) const;
    /// Items of an array, or members of an object.
    std::size_t size(const JsonPath& path) const;
    /// The first and the last line of a member or an item, counted from 1; nothing where it is not.
    std::optional<std::pair<int, int>> lines(const JsonPath& path) const;

    /// Replaces a value; adds the member where only its object is there.
    void set(const JsonPath& path, std::string_view json);
    /// Adds an item at the end of an array.
    void append(const JsonPath& array, std::string_view json);
    /// Takes a member or an item out, if it is there.
    void erase(const JsonPath& path);
    /// Gives a member another key.
    void rename(const JsonPath& path, std::string_view key);

private:
    struct Span {
        std::size_t begin = 0, end = 0;
    };
    /// A member or an item; without a key the whole is the value.
    struct Part {
        Span whole, value;
        std::string key;
    };
    std::vector<Part> partsAt(std::size_t begin) const;
    std::optional<Part> find(const JsonPath& path) const;
    std::size_t skipSpace(std::size_t at) const;
    std::size_t skipString(std::size_t at) const;
    std::size_t skipValue(std::size_t at) const;
    std::size_t indentAt(std::size_t at) const;
    void add(std::size_t container, const std::string& entry, bool object);
    void spread(std::size_t container, const std::vector<Part>& parts);

    std::string text_;
};

/// Numbers to the tenth of a millimetre, strings with what must be escaped, points as "[x, y]".
std::string jsonOf(double value);
std::string jsonOf(std::string_view text);
std::string jsonOf(double x, double y);

}  // namespace sulfurchamber
