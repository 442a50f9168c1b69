#include "visible_texts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace sulfurchamber::test {
namespace {

// What speaks to a terminal, a log or a script, and drawings of icons.
bool speaksToPeople(const std::filesystem::path& file) {
    static const std::set<std::string> others{"options.cpp", "main.cpp", "icons.cpp",
                                              "screen_picture.cpp", "chamber_app.cpp"};
    const std::string name = file.filename().string();
    // What writes C++ and tables for other programs.
    static const std::set<std::string> writers{"table4", "cpp_source", "cpp_values"};
    return !others.contains(name) && !writers.contains(file.stem().string()) &&
           !name.starts_with("script") && name != "level_script.cpp";
}

bool isHex(char c) {
    return std::isxdigit(static_cast<unsigned char>(c)) != 0;
}

// The value of an escape sequence; `at` is behind the backslash and goes to its last character.
char unescaped(const std::string& source, std::size_t& at) {
    switch (source[at]) {
        case 'n':
            return '\n';
        case 't':
            return '\t';
        case 'x': {
            std::string digits;
            while (isHex(source[at + 1])) digits += source[++at];
            return static_cast<char>(std::stoi(digits, nullptr, 16));
        }
        default:
            return source[at];
    }
}

// The first place behind a comment, a character or a raw string that begins at `at`, or `at`.
std::size_t behindOther(const std::string& source, std::size_t at) {
    const auto behind = [&](const std::string& end, std::size_t from) {
        const std::size_t found = source.find(end, from);
        return found == std::string::npos ? source.size() : found + end.size();
    };
    if (source.compare(at, 2, "//") == 0 || source.compare(at, 8, "#include") == 0)
        return behind("\n", at) - 1;
    if (source.compare(at, 2, "/*") == 0) return behind("*/", at + 2);
    if (source.compare(at, 3, "R\"(") == 0) return behind(")\"", at);
    const bool digits = at > 0 && isHex(source[at - 1]);  // 1'000
    if (source[at] == '\'' && !digits) return behind("'", at + (source[at + 1] == '\\' ? 3 : 2));
    return at;
}

// Whether a literal is what tr() or its like is called with.
bool calledWith(const Literal& literal) {
    static const std::regex call(R"((^|[^A-Za-z_])(tr|wxTr|trInside|trCount|wxTrCount)\(\s*$)");
    return std::regex_search(literal.before, call);
}

}  // namespace

std::vector<Literal> literalsOf(const std::string& source) {
    std::vector<Literal> found;
    int line = 1;
    bool adjacent = false;
    for (std::size_t at = 0; at < source.size(); ++at) {
        const std::size_t behind = behindOther(source, at);
        if (behind != at) {
            line += static_cast<int>(
                std::count(source.begin() + static_cast<std::ptrdiff_t>(at),
                           source.begin() + static_cast<std::ptrdiff_t>(behind), '\n'));
            at = behind - 1;
            continue;
        }
        if (source[at] == '\n') ++line;
        if (source[at] != '"') {
            adjacent = adjacent && std::isspace(static_cast<unsigned char>(source[at])) != 0;
            continue;
        }
        if (!adjacent) {
            const std::size_t from = at > 60 ? at - 60 : 0;
            found.push_back({"", source.substr(from, at - from), line});
        }
        for (++at; at < source.size() && source[at] != '"'; ++at)
            found.back().text += source[at] == '\\' ? unescaped(source, ++at) : source[at];
        adjacent = true;
    }
    return found;
}

bool looksVisible(const std::string& text) {
    static const std::regex begins("^&?[A-Z]&?[a-z]");
    static const std::regex words("[a-z,;:] [a-z]");
    return text.size() > 2 && (std::regex_search(text, begins) || std::regex_search(text, words));
}

std::vector<VisibleText> visibleTexts(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string kind = entry.path().extension().string();
        if ((kind == ".cpp" || kind == ".hpp") && speaksToPeople(entry.path()))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<VisibleText> all;
    for (const auto& file : files) {
        std::ostringstream source;
        source << std::ifstream(file).rdbuf();
        const auto literals = literalsOf(source.str());
        for (std::size_t i = 0; i < literals.size(); ++i) {
            const Literal& one = literals[i];
            const std::string text = one.text.substr(0, one.text.find('\t'));
            if (!calledWith(one) && !looksVisible(text)) continue;
            VisibleText visible{text, "",
                                file.filename().string() + ":" + std::to_string(one.line)};
            if (one.before.find("rCount(") != std::string::npos && calledWith(one) &&
                i + 1 < literals.size())
                visible.plural = literals[++i].text;
            all.push_back(std::move(visible));
        }
    }
    return all;
}

}  // namespace sulfurchamber::test
