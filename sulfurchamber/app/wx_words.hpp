// Texts in the language of the user, as wxWidgets takes them.
#pragma once

#include <wx/string.h>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

#include "../model/words.hpp"

namespace sulfurchamber {

/// tr(), for windows.
inline wxString wxTr(const wxString& english) {
    return wxString::FromUTF8(tr(english.utf8_string()));
}
inline wxString wxTr(std::string_view english) {
    return wxString::FromUTF8(tr(std::string(english)));
}
inline wxString wxTr(const std::string& english) {
    return wxString::FromUTF8(tr(english));
}
inline wxString wxTr(const char* english) {
    return wxTr(std::string_view(english));
}
inline wxString wxTr(const char* english, std::initializer_list<std::string_view> values) {
    return wxString::FromUTF8(tr(english, values));
}
/// trCount(), for windows.
inline wxString wxTrCount(const char* one, const char* many, std::size_t count) {
    return wxString::FromUTF8(trCount(one, many, count));
}

}  // namespace sulfurchamber
