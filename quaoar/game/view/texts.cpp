#include <quaoar/view/texts.hpp>

#include <algorithm>
#include <atlax/files.hpp>

namespace quaoar {
namespace {

constexpr const char* domain = "quaoar";

/// The first folder with a catalog of the game in it.
std::filesystem::path catalogFolder() {
    const atlax::Assets assets({.application = "locale",
                                .environmentVariable = "QUAOAR_CATALOGS",
                                .sourceFolder = QUAOAR_BUILD_CATALOGS});
    const std::string anyCatalog = std::string("de/LC_MESSAGES/") + domain + ".mo";
    for (const auto& folder : assets.folders()) {
        std::error_code ignored;
        if (std::filesystem::exists(folder / anyCatalog, ignored)) return folder;
    }
    return assets.folders().back();
}

}  // namespace

Texts::Texts() : translation_(domain, catalogFolder()) {
    translation_.setLanguage("en");
}

std::string Texts::operator()(const std::string& english) const {
    // A catalog's entry for the empty text is its header.
    return english.empty() ? english : translation_.translate(english.c_str());
}

std::string Texts::operator()(const std::string& english,
                              std::initializer_list<std::string_view> values) const {
    std::string text = (*this)(english);
    std::size_t from = 0;
    for (const std::string_view value : values) {
        const std::size_t at = text.find("{}", from);
        if (at == std::string::npos) break;
        text.replace(at, 2, value);
        from = at + value.size();
    }
    return text;
}

void Texts::setLanguage(std::string_view language) {
    translation_.setLanguage(language);
}

std::vector<std::string> Texts::languages() const {
    std::vector<std::string> all{"en"};
    for (const std::string& language : translation_.languages()) all.push_back(language);
    return all;
}

std::string Texts::nextLanguage(int way) const {
    const std::vector<std::string> all = languages();
    const auto here = std::find(all.begin(), all.end(), language());
    if (here == all.end()) return all.front();
    const std::size_t step = way > 0 ? 1 : all.size() - 1;
    return all[(static_cast<std::size_t>(here - all.begin()) + step) % all.size()];
}

}  // namespace quaoar
