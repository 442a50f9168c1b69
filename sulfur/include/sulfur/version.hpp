/// \file
/// The version of the library, and of the language that its headers need.
#pragma once

// GCC 10 calls its C++20 201709.
#if __cplusplus <= 201703L
#error "sulfur needs C++20: compile with -std=c++20"
#endif

namespace sulfur {

/// "major.minor.patch" of the library that is linked.
const char* version();

}  // namespace sulfur
