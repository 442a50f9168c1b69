// For processors with AVX2; compiled for nothing less.
#include "kernels/contact_sweep.hpp"

#define SWEEP_BYTES 32
#include "kernels/contact_sweep.ipp"

namespace sulfur::detail {

const ContactKernels avx2Contacts = {
    solve<false>, solve<true>, warm<false>,     warm<true>,     recover<false>, recover<true>,
    drift<false>, drift<true>, anyError<false>, anyError<true>, anyDeep<false>, anyDeep<true>};

}  // namespace sulfur::detail
