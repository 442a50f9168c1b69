// For every processor.
#include "kernels/rows.hpp"

#include "kernels/rows.ipp"

namespace sulfur::detail {

const RowKernels baselineRows = rowKernelsHere;

}  // namespace sulfur::detail
