#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace atlax {

/// Texts of an application in the language of its user, from gettext catalogs (.mo files).
///
/// A catalog stands at "<folder>/<language>/LC_MESSAGES/<domain>.mo"; CMake's atlax_catalogs()
/// makes it from a .po file. The texts in the source are the keys and, where a catalog lacks them,
/// the texts shown. Catalogs belong to the program and are trusted as it is.
///
/// The C library does the work, with one state per process: changing the language and opening
/// catalogs is for one thread while no other translates; translating is for any thread. What
/// translate() returns is a copy. Nothing here fails: what cannot be found is shown as in the
/// source.
class Translation {
public:
    /// `domain` is the name of the catalog, best that of the application. Uses the process's locale
    /// for messages, which is set from the environment (LC_ALL, LC_MESSAGES, LANG), and never
    /// changes how numbers are read or written.
    Translation(std::string domain, const std::filesystem::path& folder);

    /// From now on texts are in this language ("de", "de_AT"), or in that of the user's environment
    /// when it is empty, or as in the source when it is "en" or has no catalog. May be called while
    /// the program runs. Throws Error for what is no name of a language: 2 to 16 letters, digits,
    /// '_', '@' and '.', none of them a path.
    void setLanguage(std::string_view language);
    const std::string& language() const { return language_; }

    /// Languages that have a catalog, sorted; without that of the source.
    std::vector<std::string> languages() const;

    /// The text in the current language, UTF-8.
    std::string translate(const char* text) const;
    /// The same for a text that means different things in different places: `context` says which.
    std::string translate(const char* context, const char* text) const;
    /// The form for `count` things; the catalog's language decides how many forms there are. The
    /// text is returned as it is, with its placeholder.
    std::string plural(const char* one, const char* many, unsigned long count) const;
    std::string plural(const char* context, const char* one, const char* many,
                       unsigned long count) const;

private:
    std::string domain_;
    std::filesystem::path folder_;
    std::string language_;
};

/// Where the catalogs of a domain are: the folder that `environmentVariable` names, the installed
/// "../share/locale" beside the program, or `buildFolder`; the first that has any, else the last.
std::filesystem::path catalogFolder(const std::string& domain,
                                    const std::string& environmentVariable,
                                    const std::filesystem::path& buildFolder);

/// The text with a value in place of each "{}" in turn. Values are put in as they are, "{}" in them
/// too; "{}" without a value stays, and a value without one is left out.
std::string fill(std::string text, std::initializer_list<std::string_view> values);

}  // namespace atlax
