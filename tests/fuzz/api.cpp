// Whatever the public interface of the library is called with, in whatever order, it obeys or
// throws sulfur::Error and changes nothing; the world stays sound; and it goes on to the same bits
// with and without threads, looked at or not, restored from a snapshot or not. The bytes are the
// decisions of a caller; tests/sulfur/calls has it and what it demands.
#include "calls/caller.hpp"
#include "decisions.hpp"

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    return mutateDecisions(data, size, most, seed, 1500);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int mostCalls = 1000;
    sulfur::test::callBesideATwin(
        std::make_unique<sulfur::test::ByteNumbers>(std::span(data, size)), mostCalls);
    return 0;
}
