#include "core/bucket_sort.hpp"

#include <gtest/gtest.h>

#include "helpers.hpp"

namespace sulfur {
namespace {

struct Item {
    std::uint32_t key = 0, rest = 0;
    friend auto operator<=>(const Item&, const Item&) = default;
};

TEST(BucketSort, SortsAsTheStandardDoes) {
    test::Random random(7);
    std::vector<Item> scratch;
    std::vector<std::uint32_t> start;
    for (const std::uint32_t keys : {1u, 2u, 50u, 4000u}) {
        std::vector<Item> items;
        for (int i = 0; i < 1000; ++i)
            items.push_back({static_cast<std::uint32_t>(random.below(static_cast<int>(keys))),
                             static_cast<std::uint32_t>(random.below(100))});
        auto expected = items;
        std::sort(expected.begin(), expected.end());
        detail::bucketSort(items, scratch, start, keys, [](const Item& item) { return item.key; });
        EXPECT_EQ(items, expected) << keys;
    }
}

TEST(BucketSort, SortsNothing) {
    std::vector<Item> items, scratch;
    std::vector<std::uint32_t> start;
    detail::bucketSort(items, scratch, start, 0, [](const Item& item) { return item.key; });
    EXPECT_TRUE(items.empty());
}

}  // namespace
}  // namespace sulfur
