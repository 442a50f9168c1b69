// Why a scene is slow.
#include <gtest/gtest.h>

#include "model/load_watch.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

std::string causeAfter(Workbench& bench, int ticks) {
    LoadWatch watch;
    for (int i = 0; i < ticks; ++i) {
        watch.beforeTick(bench.document().world());
        bench.tick();
        watch.afterTick(bench.document().world());
    }
    return watch.cause();
}

TEST(LoadWatch, SaysWhatCostsMost) {
    Workbench boxes;
    boxes.dropBoxes(120);
    EXPECT_EQ(causeAfter(boxes, 100), "") << "too early to know";
    const std::string cause = causeAfter(boxes, 1000);
    const bool known = cause.find("contact") != std::string::npos ||
                       cause.find("pair") != std::string::npos ||
                       cause.find("particle") != std::string::npos;
    EXPECT_TRUE(known) << cause;
}

TEST(LoadWatch, ChangesNothingOfTheWorld) {
    Workbench watched;
    Workbench alone;
    for (Workbench* bench : {&watched, &alone}) bench->dropBoxes(20);
    causeAfter(watched, 300);
    for (int i = 0; i < 300; ++i) alone.tick();
    EXPECT_EQ(watched.document().world().hash(), alone.document().world().hash());
}

}  // namespace
}  // namespace sulfurchamber
