// What the game says, in the language of its player.
#pragma once

#include <atlax/translation.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace quaoar {

/// Looks sentences up in the game's gettext catalogs: the variable QUAOAR_CATALOGS,
/// "../share/locale" beside the program (installed), or the build folder. The English of the source
/// is the key, and what is shown where a catalog lacks it. Owns the catalogs' state, of which there
/// is one per process; main thread. Nothing fails.
class Texts {
public:
    /// In English, until setLanguage().
    Texts();

    std::string operator()(const std::string& english) const;
    /// The same, with what follows in place of each "{}" in turn.
    std::string operator()(const std::string& english,
                           std::initializer_list<std::string_view> values) const;

    /// "en", "de" and so on; empty for the user's environment. Throws atlax::Error for what is no
    /// name of a language.
    void setLanguage(std::string_view language);
    /// The one that setLanguage() was told; "en" at first.
    const std::string& language() const { return translation_.language(); }
    /// The one that comes after it, or with -1 before it, of those that there are.
    std::string nextLanguage(int way = 1) const;
    /// All that there are, English first.
    std::vector<std::string> languages() const;

private:
    atlax::Translation translation_;
};

}  // namespace quaoar
