#include <quaoar/view/texts.hpp>

#include <algorithm>

namespace quaoar {

Texts::Texts()
    : translation_("quaoar",
                   atlax::catalogFolder("quaoar", "QUAOAR_CATALOGS", QUAOAR_BUILD_CATALOGS)) {
    translation_.setLanguage("en");
}

std::string Texts::operator()(const std::string& english) const {
    return translation_.translate(english.c_str());
}

std::string Texts::operator()(const std::string& english,
                              std::initializer_list<std::string_view> values) const {
    return atlax::fill((*this)(english), values);
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
