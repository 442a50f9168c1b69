// For processors with AVX-512, which has twice as many registers and masks of its own; compiled for
// nothing less.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels avx512Rows = rowKernelsHere;

}  // namespace sulfur::detail
