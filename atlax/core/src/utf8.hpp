#pragma once

#include <string>
#include <string_view>

namespace atlax {

/// Whether a text is well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates).
bool isUtf8(std::string_view text);

/// A text from outside, made fit for a one-line message: what is not printable ASCII becomes '?',
/// and what is longer than 100 characters is cut.
std::string printable(std::string_view text);

}  // namespace atlax
