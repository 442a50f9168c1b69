// From JSON text to a Document. nlohmann-json's parser reports one token after the other; an
// iterator that counts what it has consumed gives every one its place in the text.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "text.hpp"

namespace sulfur::scene {

namespace {

/// An input iterator over the text that tells how far the parser has come.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*consumed_;
        return *this;
    }
    CountingIterator operator++(int) {
        const auto before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ == b.at_;
    }

private:
    const char* at_;
    std::size_t* consumed_;
};

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// What the parser complains about, without its own way of telling the place, and without the
/// bytes that it saw, which may be any.
std::string plainMessage(const std::string& message) {
    const auto dash = message.find(" - ");
    if (message.find("out_of_range") != std::string::npos)
        return "a number is beyond 1.8e308; allowed are finite numbers";
    if (dash == std::string::npos) return "is not JSON";
    std::string text = message.substr(dash + 3);
    const auto expected = text.rfind("; expected ");
    const std::string tail = expected == std::string::npos ? "" : text.substr(expected);
    text.resize(std::min(text.find("; last read: "), expected));
    if (text.find("unexpected end of input") == 0 ||
        text.find("missing closing quote") != std::string::npos)
        return "the text ends in the middle; it is cut off, so take a complete copy of the file";
    return "is not JSON: " + text + tail;
}

}  // namespace

/// Receives the parser's events and builds the list of values.
class TextBuilder {
public:
    using Json = nlohmann::json;
    using Text = Node::Text;
    // names that the parser asks for
    using number_integer_t = Json::number_integer_t;
    using number_unsigned_t = Json::number_unsigned_t;
    using number_float_t = Json::number_float_t;
    using string_t = Json::string_t;
    using binary_t = Json::binary_t;

    TextBuilder(Text& text, const DocumentLimits& limits) : text_(text), limits_(limits) {}

    void run() {
        refuseZeroBytes();
        const char* begin = text_.source.data();
        const char* end = begin + text_.source.size();
        if (text_.source.starts_with("\xEF\xBB\xBF")) last_ = 3;
        Json::sax_parse(CountingIterator(begin, &consumed_), CountingIterator(end, &consumed_),
                        this);
    }

    bool null() { return scalar(ValueType::null); }
    bool boolean(bool truth) {
        scalar(ValueType::boolean);
        text_.values.back().truth = truth;
        return true;
    }
    bool number_integer(number_integer_t) { return number(); }
    bool number_unsigned(number_unsigned_t) { return number(); }
    bool number_float(number_float_t, const string_t&) { return number(); }
    bool string(string_t& content) {
        scalar(ValueType::string);
        text_.values.back().string = store(content);
        return true;
    }
    bool binary(binary_t&) { return false; }
    bool start_object(std::size_t) { return open(ValueType::object); }
    bool end_object() {
        refuseDuplicates();
        return close();
    }
    bool start_array(std::size_t) { return open(ValueType::array); }
    bool end_array() { return close(); }
    bool key(string_t& content) {
        skipTo(consumed_);
        key_ = store(content);
        return true;
    }
    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& e) {
        auto at = std::min(position == 0 ? 0 : position - 1, text_.source.size());
        while (at > 0 && at == text_.source.size() && isSpace(text_.source[at - 1])) at = trimmed();
        const auto breaks =
            std::count(text_.source.begin(), text_.source.begin() + std::ptrdiff_t(at), '\n');
        refuse(static_cast<std::uint32_t>(breaks), plainMessage(e.what()));
    }

private:
    struct Open {
        std::uint32_t value;
        std::uint32_t lastChild = Text::none;
    };

    [[noreturn]] void refuse(std::uint32_t line, const std::string& message) const {
        throw ReadError(text_.origin.file, text_.origin.firstLine + static_cast<int>(line),
                        text_.origin.object, message);
    }

    /// The parser takes a zero byte for the end of the text and would not look behind it.
    void refuseZeroBytes() const {
        const auto zero = text_.source.find('\0');
        if (zero == std::string::npos) return;
        const auto breaks =
            std::count(text_.source.begin(), text_.source.begin() + std::ptrdiff_t(zero), '\n');
        refuse(static_cast<std::uint32_t>(breaks),
               "contains a zero byte; allowed is JSON text in UTF-8");
    }

    std::size_t trimmed() const {
        auto at = text_.source.size();
        while (at > 0 && isSpace(text_.source[at - 1])) --at;
        return at;
    }

    std::uint32_t store(const std::string& content) {
        if (content.empty()) return 0;
        text_.strings.push_back(content);
        return static_cast<std::uint32_t>(text_.strings.size() - 1);
    }

    /// Moves the place that lines are counted from.
    void skipTo(std::size_t place) {
        for (; last_ < place; ++last_) line_ += text_.source[last_] == '\n';
    }

    /// A value begins behind the last token and the separators that follow it.
    void begin(ValueType type) {
        while (isSpace(text_.source[last_]) || text_.source[last_] == ',' ||
               text_.source[last_] == ':')
            skipTo(last_ + 1);
        if (text_.values.size() >= limits_.values)
            refuse(line_, "has more than " + std::to_string(limits_.values) +
                              " values; split the file or make it simpler");
        Text::Value value;
        value.type = type;
        value.begin = static_cast<std::uint32_t>(last_);
        value.line = line_;
        const auto index = static_cast<std::uint32_t>(text_.values.size());
        if (!open_.empty()) link(value, index);
        text_.values.push_back(value);
    }

    void link(Text::Value& value, std::uint32_t index) {
        auto& top = open_.back();
        auto& parent = text_.values[top.value];
        value.parent = top.value;
        value.place = parent.count++;
        value.key = parent.type == ValueType::object ? key_ : 0;
        (top.lastChild == Text::none ? parent.first : text_.values[top.lastChild].next) = index;
        top.lastChild = index;
    }

    bool scalar(ValueType type) {
        begin(type);
        text_.values.back().end = static_cast<std::uint32_t>(consumed_);
        skipTo(consumed_);
        return true;
    }

    /// The parser knows that a number is over when it has seen one character more.
    bool number() {
        begin(ValueType::number);
        auto end = last_;
        const auto isPart = [](char c) {
            return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' ||
                   c == 'E';
        };
        while (end < text_.source.size() && isPart(text_.source[end])) ++end;
        text_.values.back().end = static_cast<std::uint32_t>(end);
        skipTo(end);
        return true;
    }

    bool open(ValueType type) {
        begin(type);
        if (open_.size() >= static_cast<std::size_t>(limits_.depth))
            refuse(line_, "arrays and objects are more than " + std::to_string(limits_.depth) +
                              " deep inside each other; make it flatter");
        open_.push_back({static_cast<std::uint32_t>(text_.values.size() - 1)});
        skipTo(consumed_);
        return true;
    }

    bool close() {
        text_.values[open_.back().value].end = static_cast<std::uint32_t>(consumed_);
        open_.pop_back();
        skipTo(consumed_);
        return true;
    }

    void refuseDuplicates() {
        const auto& object = text_.values[open_.back().value];
        std::vector<std::uint32_t> children;
        children.reserve(object.count);
        for (auto i = object.first; i != Text::none; i = text_.values[i].next)
            children.push_back(i);
        const auto keyOf = [this](std::uint32_t i) -> const std::string& {
            return text_.strings[text_.values[i].key];
        };
        std::sort(children.begin(), children.end(), [&](auto a, auto b) {
            const int order = keyOf(a).compare(keyOf(b));
            return order != 0 ? order < 0 : a < b;
        });
        const auto twin = std::adjacent_find(children.begin(), children.end(),
                                             [&](auto a, auto b) { return keyOf(a) == keyOf(b); });
        if (twin == children.end()) return;
        refuse(text_.values[twin[1]].line,
               "the key \"" + keyOf(*twin) + "\" is there twice in one object, first on line " +
                   std::to_string(text_.origin.firstLine +
                                  static_cast<int>(text_.values[*twin].line)) +
                   "; remove one");
    }

    Text& text_;
    const DocumentLimits& limits_;
    std::size_t consumed_ = 0;  ///< by the parser
    std::size_t last_ = 0;      ///< end of the last token
    std::uint32_t line_ = 0;    ///< of last_
    std::uint32_t key_ = 0;     ///< of the member that comes next
    std::vector<Open> open_;
};

Document Document::parse(std::string text, Origin origin, const DocumentLimits& limits) {
    if (text.size() > limits.bytes)
        throw ReadError(origin.file, origin.firstLine, origin.object,
                        "has " + std::to_string(text.size()) + " bytes; allowed are at most " +
                            std::to_string(limits.bytes));
    auto result = std::make_shared<Node::Text>();
    result->source = std::move(text);
    result->origin = std::move(origin);
    TextBuilder(*result, limits).run();
    return Document(std::move(result));
}

Document Document::read(const std::filesystem::path& file, const DocumentLimits& limits) {
    const std::string name = file.string();
    std::error_code problem;
    const auto status = std::filesystem::status(file, problem);
    if (!std::filesystem::exists(status))
        throw ReadError(name, 0, "", "is not there; check the name of the file");
    if (std::filesystem::is_directory(status))
        throw ReadError(name, 0, "", "is a folder; needed is a file");
    if (std::filesystem::is_fifo(status))  // it would wait for a writer for ever
        throw ReadError(name, 0, "", "is a pipe; needed is a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw ReadError(name, 0, "", "cannot be opened; check its permissions");
    // As soon as there is more than allowed it is enough, also of an endless device.
    std::string text;
    std::vector<char> part(std::size_t{64} << 10);
    while (stream && text.size() <= limits.bytes) {
        stream.read(part.data(), static_cast<std::streamsize>(part.size()));
        text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) throw ReadError(name, 0, "", "cannot be read to its end; check the disk");
    if (text.size() > limits.bytes)
        throw ReadError(name, 1, "",
                        "has more than " + std::to_string(limits.bytes) +
                            " bytes; allowed are at most " + std::to_string(limits.bytes));
    return parse(std::move(text), {.file = name, .firstLine = 1, .object = {}}, limits);
}

Node Document::root() const {
    return Node(text_.get(), 0);
}

const Origin& Document::origin() const {
    return text_->origin;
}

}  // namespace sulfur::scene
