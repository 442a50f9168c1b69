// What a snapshot that somebody has forged may say of fields and grabs.
#include "model/influences.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace sulfur::detail {
namespace {

/// Reads nothing but lists of numbers: one handle in the first, none in the others.
struct OddLists {
    int lists = 0;
    void operator()(std::vector<std::uint32_t>& list) { list.assign(lists++ == 0 ? 1 : 0, 0u); }
};

TEST(Influences, HandlesThatFitNoListAreFound) {
    Influences influences;
    influences.fields.emplace_back().id = {1, 1};
    OddLists lists;
    influences.fieldSlots.archive(lists);
    EXPECT_EQ(influences.validate(), "handles of influences that fit no list");
}

}  // namespace
}  // namespace sulfur::detail
