#include "words.hpp"

#include <array>
#include <atlax/translation.hpp>
#include <cctype>
#include <charconv>
#include <utility>

namespace sulfurchamber {
namespace {

constexpr const char* domain = "sulfurchamber";

// The C library keeps one state for the process, so there is one of these.
atlax::Translation& catalogs() {
    static atlax::Translation translation = [] {
        atlax::Translation made(domain, atlax::catalogFolder(domain, "SULFURCHAMBER_CATALOGS",
                                                             SULFURCHAMBER_BUILD_CATALOGS));
        made.setLanguage("en");
        return made;
    }();
    return translation;
}

}  // namespace

std::string tr(const std::string& english) {
    return catalogs().translate(english.c_str());
}

std::string tr(const std::string& english, std::initializer_list<std::string_view> values) {
    return atlax::fill(tr(english), values);
}

std::string trCount(const char* one, const char* many, std::size_t count) {
    return atlax::fill(catalogs().plural(one, many, count), {std::to_string(count)});
}

std::string trInside(const std::string& english) {
    std::string text = tr(english);
    // German writes nouns, which names are, with a capital letter everywhere: a catalog says so.
    const bool small = catalogs().translate("names inside of a sentence", "small") == "small";
    if (small && !text.empty())
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

std::string fixed(double value, int decimals) {
    std::array<char, 400> text{};  // the largest double has 309 digits before the point
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

std::string alphabetKey(std::string_view text) {
    // U+00C0 to U+00FF; '.' is two letters or none.
    static constexpr std::string_view plain =
        "aaaaaa.ceeeeiiiidnooooo.ouuuuyt.aaaaaa.ceeeeiiiidnooooo.ouuuuyty";
    std::string key;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        if (byte != 0xC3 || next < 0x80 || next > 0xBF) {
            key += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
            continue;
        }
        ++i;
        const char letter = plain[next - 0x80];
        if (letter != '.')
            key += letter;
        else if (next == 0x9F)
            key += "ss";
        else if (next == 0x86 || next == 0xA6)
            key += "ae";
        else
            key += text.substr(i - 1, 2);
    }
    return key;
}

bool standsBefore(const std::string& a, const std::string& b) {
    const std::string first = alphabetKey(a), second = alphabetKey(b);
    return first != second ? first < second : a < b;
}

void setLanguage(std::string_view language) {
    catalogs().setLanguage(language);
}

std::vector<std::string> languages() {
    std::vector<std::string> all{"en"};
    for (std::string& language : catalogs().languages()) all.push_back(std::move(language));
    return all;
}

std::string nameOfLanguage(const std::string& code) {
    static constexpr std::array<std::pair<const char*, const char*>, 3> names{
        {{"en", "English"}, {"de", "Deutsch"}, {"it", "Italiano"}}};
    for (const auto& [known, name] : names)
        if (code == known) return name;
    return code;
}

}  // namespace sulfurchamber
