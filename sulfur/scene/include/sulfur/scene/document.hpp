/// \file
/// A JSON text that knows its lines: what scenes, blueprints and every other file of strangers are
/// read through.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::scene {

/// A file that cannot be used. what() is one sentence of the form
/// `file:line: object "x": what is wrong; what is allowed`.
class ReadError : public std::runtime_error {
public:
    /// `line` 0: the file as a whole; `object` empty: no object in particular.
    ReadError(std::string file, int line, std::string object, std::string message);

    const std::string& file() const { return file_; }        ///< as it was given
    int line() const { return line_; }                       ///< counted from 1; 0: the whole file
    const std::string& object() const { return object_; }    ///< an id, a name or a path; may be ""
    const std::string& message() const { return message_; }  ///< what() without the above

private:
    std::string file_;
    int line_;
    std::string object_;
    std::string message_;
};

/// What a text may be at most. Everything beyond is refused before it costs memory or time.
struct DocumentLimits {
    /// Of the text: enough for every scene within sulfur::scene::Limits.
    std::size_t bytes = std::size_t{32} << 20;
    std::size_t values = 3'000'000;  ///< numbers, strings, arrays, ... in all
    int depth = 32;                  ///< arrays and objects inside each other
};

/// Where a text comes from, for messages.
struct Origin {
    std::string file;    ///< shown as it is
    int firstLine = 1;   ///< line of the file on which the text begins
    std::string object;  ///< name of the text's outermost value, when it is a part of a file
};

/// What kind of JSON value it is.
enum class ValueType : std::uint8_t { null, boolean, number, string, array, object };

/// One value of a Document. A small handle: copy it freely; valid while its document is alive.
/// Every function that cannot do what it promises throws ReadError with the value's line.
class Node {
public:
    /// What kind of value it is.
    ValueType type() const;
    /// Where it begins in its file, counted from 1.
    int line() const;
    /// The value exactly as it is written in the file.
    std::string_view text() const;
    /// "" for the outermost value and for members of an array.
    std::string_view key() const;

    /// Throws ReadError at this value. `problem` goes on from the value's path, as in
    /// "is 7; allowed is 0 to 3".
    [[noreturn]] void fail(const std::string& problem) const;

    /// True or false.
    bool boolean() const;
    /// A finite number from `low` to `high`.
    double number(double low, double high) const;
    /// The same, rounded once to Real.
    Real real(double low, double high) const;
    /// A finite number above 0, at most `high`.
    Real positive(double high) const;
    /// A number without a fraction from `low` to `high`.
    std::int64_t integer(std::int64_t low, std::int64_t high) const;
    /// A text of `least` to `most` bytes without control characters other than line breaks.
    std::string string(std::size_t least, std::size_t most) const;
    /// The place in `words` of the text that this value must be.
    std::size_t choice(std::initializer_list<std::string_view> words) const;
    /// `[x, y]`, both within -limit to limit.
    Vec2 vec2(double limit) const;
    /// The same in double precision.
    Point point(double limit) const;

    /// The members of an array that has `least` to `most` of them.
    std::vector<Node> array(std::size_t least, std::size_t most) const;
    /// The members of an object in the order of the file.
    std::vector<Node> members() const;
    /// Throws unless this is an object.
    void requireObject() const;
    /// A member of an object that must be there.
    Node at(std::string_view key) const;
    /// A member of an object, if it is there.
    std::optional<Node> find(std::string_view key) const;

private:
    friend class Document;
    friend class TextBuilder;
    struct Text;
    Node(const Text* text, std::uint32_t index) : text_(text), index_(index) {}
    std::string path(std::uint32_t from) const;

    const Text* text_;
    std::uint32_t index_;
};

/// Reads the member `key` of `object` if it is there and leaves `value` alone if not:
/// `readOptional(node, "mass", mass, &Node::positive, 1e9)`.
template <class Value, class Result, class... Parameters, class... Arguments>
void readOptional(const Node& object, std::string_view key, Value& value,
                  Result (Node::*read)(Parameters...) const, Arguments... arguments) {
    if (const auto member = object.find(key)) value = ((*member).*read)(arguments...);
}

/// A parsed JSON text: RFC 8259, without duplicate keys, within DocumentLimits.
class Document {
public:
    /// Throws ReadError. Complexity: linear in the text.
    static Document parse(std::string text, Origin origin, const DocumentLimits& limits = {});
    /// Reads and parses a file; throws ReadError also when it cannot be read.
    static Document read(const std::filesystem::path& file, const DocumentLimits& limits = {});

    /// The outermost value.
    Node root() const;
    /// Where the text came from.
    const Origin& origin() const;

private:
    explicit Document(std::shared_ptr<const Node::Text> text) : text_(std::move(text)) {}
    std::shared_ptr<const Node::Text> text_;
};

/// Whether `name` is a harmless asset name: a relative path of at most 200 bytes, its parts
/// separated by '/', none empty, "." or "..", without backslash, colon or control characters.
bool safeAssetName(std::string_view name);
/// safeAssetName or ReadError.
std::string readAssetName(const Node& node);

}  // namespace sulfur::scene
