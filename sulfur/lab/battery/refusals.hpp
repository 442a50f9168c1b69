// Nonsense that a caller can pass.
#pragma once

#include "battery/row.hpp"

namespace sulfur::lab {

/// Passes zero-length, duplicate, coincident and pinned-to-pinned joints, NaN, infinite and
/// negative numbers to a world. One row a case: 0 when it was refused with sulfur::Error or did
/// nothing, or was accepted as documented, and the world is unchanged or goes on soundly; else 1.
Rows refusals();

}  // namespace sulfur::lab
