#include <libintl.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <atlax/translation.hpp>
#include <clocale>
#include <cstdlib>

#include "utf8.hpp"

// The C library's counter of changes, documented in the manual of gettext ("Being a gettext grok"):
// without it a text that was looked up before a change of LANGUAGE keeps its old translation.
extern "C" int _nl_msg_cat_cntr;  // NOLINT

namespace atlax {

namespace fs = std::filesystem;

namespace {

constexpr char contextEnd = '\004';  // as msgfmt writes it

void requireLanguage(std::string_view language) {
    const bool good = std::all_of(language.begin(), language.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '@' || c == '.';
    });
    if (!good || language.size() < 2 || language.size() > 16 || language[0] == '.')
        throw Error("\"" + printable(language) +
                    "\" is no name of a language as \"de\" or \"de_AT\"");
}

/// In the locale "C" the C library never translates, whatever LANGUAGE says; in "C.UTF-8", which is
/// part of it, it does.
void leaveLocaleC() {
    const char* now = std::setlocale(LC_MESSAGES, "");
    const std::string_view name = now != nullptr ? now : "C";
    if (name != "C" && name != "POSIX") return;
    if (std::setlocale(LC_MESSAGES, "C.UTF-8") == nullptr)
        log(LogLevel::Warning, "no translations: this system has no locale \"C.UTF-8\"");
}

}  // namespace

Translation::Translation(std::string domain, const fs::path& folder)
    : domain_(std::move(domain)), folder_(fs::absolute(folder)) {
    leaveLocaleC();
    ::bindtextdomain(domain_.c_str(), folder_.c_str());
    ::bind_textdomain_codeset(domain_.c_str(), "UTF-8");
}

void Translation::setLanguage(std::string_view language) {
    if (!language.empty()) requireLanguage(language);
    leaveLocaleC();  // a toolkit may have set the locale since
    language_ = language;
    if (language.empty())
        ::unsetenv("LANGUAGE");
    else
        ::setenv("LANGUAGE", language_.c_str(), 1);
    ++_nl_msg_cat_cntr;
}

std::vector<std::string> Translation::languages() const {
    std::vector<std::string> out;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder_, failed)) {
        const fs::path catalog = entry.path() / "LC_MESSAGES" / (domain_ + ".mo");
        if (fs::is_regular_file(catalog, failed)) out.push_back(entry.path().filename().string());
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::string Translation::translate(const char* text) const {
    // The entry of the empty text is the catalog's header.
    return *text == '\0' ? "" : ::dgettext(domain_.c_str(), text);
}

std::string Translation::translate(const char* context, const char* text) const {
    const std::string key = std::string(context) + contextEnd + text;
    const char* found = ::dgettext(domain_.c_str(), key.c_str());
    return found == key.c_str() ? text : found;
}

std::string Translation::plural(const char* one, const char* many, unsigned long count) const {
    return ::dngettext(domain_.c_str(), one, many, count);
}

std::string Translation::plural(const char* context, const char* one, const char* many,
                                unsigned long count) const {
    const std::string key = std::string(context) + contextEnd + one;
    const char* found = ::dngettext(domain_.c_str(), key.c_str(), many, count);
    return found == key.c_str() ? one : found;
}

fs::path catalogFolder(const std::string& domain, const std::string& environmentVariable,
                       const fs::path& buildFolder) {
    const Assets assets({.application = "locale",
                         .environmentVariable = environmentVariable,
                         .sourceFolder = buildFolder});
    std::error_code ignored;
    for (const fs::path& folder : assets.folders())
        for (const auto& language : fs::directory_iterator(folder, ignored))
            if (fs::exists(language.path() / "LC_MESSAGES" / (domain + ".mo"), ignored))
                return folder;
    return assets.folders().back();
}

std::string fill(std::string text, std::initializer_list<std::string_view> values) {
    std::size_t from = 0;
    for (const std::string_view value : values) {
        const std::size_t at = text.find("{}", from);
        if (at == std::string::npos) break;
        text.replace(at, 2, value);
        from = at + value.size();
    }
    return text;
}

}  // namespace atlax
