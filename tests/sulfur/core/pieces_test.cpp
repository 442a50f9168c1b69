#include "core/pieces.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sulfur {
namespace {

class Serial final : public Tasks {
public:
    std::size_t threads() const override { return 5; }
    double overhead() const override { return 0.5; }
    void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
        for (std::size_t i = count; i-- > 0;) task(context, i);
    }
};

TEST(Pieces, CoverAllOnceAndAreNotTooSmall) {
    Serial tasks;
    for (const std::size_t count : {0u, 1u, 9u, 10u, 19u, 20u, 23u, 49u, 50u, 1003u}) {
        std::vector<int> seen(count, 0);
        std::size_t pieces = 0;
        detail::inPieces(&tasks, count, 10, [&](std::size_t first, std::size_t last) {
            ++pieces;
            for (auto i = first; i < last; ++i) ++seen[i];
        });
        EXPECT_EQ(seen, std::vector<int>(count, 1)) << count;
        EXPECT_LE(pieces, std::max<std::size_t>(1, std::min<std::size_t>(5, count / 10))) << count;
    }
}

TEST(Pieces, AreOneWithoutThreads) {
    EXPECT_EQ(detail::piecesOf(nullptr, 1000000, 1), 1u);
}

}  // namespace
}  // namespace sulfur
