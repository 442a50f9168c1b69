// For every processor.
#include "kernels/contact_sweep.hpp"

#define SWEEP_BYTES 16
#include "kernels/contact_sweep.ipp"

namespace sulfur::detail {

const ContactKernels baselineContacts = {
    solve<false>, solve<true>, warm<false>,     warm<true>,     recover<false>, recover<true>,
    drift<false>, drift<true>, anyError<false>, anyError<true>, anyDeep<false>, anyDeep<true>};

}  // namespace sulfur::detail
