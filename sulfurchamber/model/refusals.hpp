// What the libraries below the sandbox refuse, in the language of its user.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sulfurchamber {

/// A refusal in the language of setLanguage(). Texts of the catalogs are found as tr() finds them.
/// A sentence of the libraries, which know one language, is found by its pattern, and what stands
/// in the pattern's gaps is translated in turn, but not what is quoted. "file:3: object: problem"
/// is translated part by part. What nobody knows stays as it is. Any thread; nothing fails.
std::string trRefusal(const std::string& english);

/// The sentences of the libraries, with "{}" where values stand.
std::span<const std::string_view> refusalPatterns();

}  // namespace sulfurchamber
