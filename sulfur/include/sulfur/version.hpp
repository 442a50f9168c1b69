/// \file
/// The version of the library.
#pragma once

namespace sulfur {

/// "major.minor.patch" of the library that is linked.
const char* version();

}  // namespace sulfur
