// For processors with AVX2; compiled for nothing less.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels avx2Rows = rowKernelsHere;

}  // namespace sulfur::detail
