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
