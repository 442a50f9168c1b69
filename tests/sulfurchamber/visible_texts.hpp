// Texts of the sandbox that somebody sees, found in its source.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sulfurchamber::test {

struct VisibleText {
    std::string text;    ///< in English, without the key behind a tab
    std::string plural;  ///< not empty where a number decides
    std::string where;   ///< "actions.cpp:27"
};

/// A string literal of C++ with the code just before it, adjacent ones as one.
struct Literal {
    std::string text;
    std::string before;
    int line = 1;
};
std::vector<Literal> literalsOf(const std::string& source);

/// Whether somebody reads it: it begins as a sentence or a name does, or has several words.
bool looksVisible(const std::string& text);

/// Everything that is visible in the C++ files of a folder and its folders: literals that look so,
/// and what tr() and its like are called with. Without files that speak to terminals and scripts.
std::vector<VisibleText> visibleTexts(const std::filesystem::path& folder);

}  // namespace sulfurchamber::test
