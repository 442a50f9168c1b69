// What the sandbox says, in the language of its user.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace sulfurchamber {

/// The text in the language of setLanguage(): the English of the source is the key, and what is
/// shown where a catalog lacks it. Texts in tables (actions, tools, properties, steps of the
/// history) are plain literals and go through this where they are shown; a sentence that is put
/// together is one literal here, with "{}" where the values go. Any thread; nothing fails.
std::string tr(const std::string& english);
/// The same, with what follows in place of each "{}" in turn.
std::string tr(const std::string& english, std::initializer_list<std::string_view> values);
/// The form for `count` things, with the count in place of "{}": "{} joint", "{} joints".
std::string trCount(const char* one, const char* many, std::size_t count);

/// A name of a table inside of a sentence: "gravity" for "Gravity", and "Schwerkraft" in German.
std::string trInside(const std::string& english);
/// A number for a sentence, with a point and `decimals` digits behind it.
std::string fixed(double value, int decimals);

/// What a name is sorted and searched by, as dictionaries in German and Italian have it: small
/// letters without accents, "ä" as "a", "ß" as "ss". Letters of other scripts stay.
std::string alphabetKey(std::string_view text);
/// Whether a name stands before another one in a list.
bool standsBefore(const std::string& a, const std::string& b);

/// "en", "de" and so on; empty for the user's environment. One thread, while no other translates.
/// Throws std::exception for what is no name of a language.
void setLanguage(std::string_view language);
/// All that there are, English first.
std::vector<std::string> languages();
/// What a language calls itself: "Deutsch"; its code where that is not known.
std::string nameOfLanguage(const std::string& code);

}  // namespace sulfurchamber
