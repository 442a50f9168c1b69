// Every tool has a film, and the film does what the tool is for.
#include "model/tool_demo.hpp"

#include <gtest/gtest.h>

#include <string>

#include "model/meter.hpp"

namespace sulfurchamber {
namespace {

/// How much there is of what tools make.
struct Stock {
    std::size_t bodies = 0;
    std::size_t joints = 0;
    std::size_t others = 0;  // mechanisms and fields
    std::size_t pinned = 0;
};

Stock stockOf(const ToolDemo& demo) {
    const sulfur::World& world = demo.bench().document().world();
    Stock stock;
    const Totals sums = totals(world);
    stock.bodies = sums.bodies;
    stock.joints = sums.rigidJoints + sums.elasticJoints;
    const auto& scene = demo.bench().document().scene();
    stock.others = scene.mechanisms.size() + scene.fields.size() + thrustersOf(scene).size() +
                   metersOf(scene).size();
    for (const auto body : world.bodies())
        for (const auto particle : world.particles(body))
            stock.pinned += world.info(particle).pinned ? 1 : 0;
    return stock;
}

// Of what hangs in the film of the cut tool, metres.
double boxHeight(const ToolDemo& demo) {
    const Document& document = demo.bench().document();
    return document.world().centreOfMass(document.bodyOf("box")).y();
}

class ToolDemoTest : public testing::TestWithParam<ToolKind> {};

TEST_P(ToolDemoTest, DoesWhatTheToolIsFor) {
    const ToolKind tool = GetParam();
    ToolDemo demo(tool);
    EXPECT_EQ(demo.bench().tool(), tool);
    EXPECT_FALSE(demo.bench().hint().empty());
    EXPECT_LT(demo.hand().length(), ToolDemo::seconds) << "there is time to see what comes of it";
    const Stock before = stockOf(demo);
    const std::size_t stepsBefore = demo.bench().document().historyPlace();
    sulfur::Point start{0, 0};
    if (!demo.bench().document().world().bodies().empty())
        start = demo.bench().document().world().centreOfMass(
            demo.bench().document().world().bodies().back());
    const Bounds frame = toolDemoFrame();
    while (demo.time() < ToolDemo::seconds - 0.05) {
        demo.advance(1.0 / 60);
        const sulfur::Point hand = demo.hand().place();
        EXPECT_TRUE((hand.array() >= frame.low.array()).all() &&
                    (hand.array() <= frame.high.array()).all())
            << "the hand leaves the picture";
    }
    EXPECT_TRUE(demo.hand().done());
    EXPECT_EQ(demo.bench().document().world().validate(), "");
    const Stock after = stockOf(demo);
    const std::size_t steps = demo.bench().document().historyPlace() - stepsBefore;
    switch (tool) {
        case ToolKind::select: {
            const auto& world = demo.bench().document().world();
            EXPECT_GT((world.centreOfMass(world.bodies().back()) - start).norm(), 1);
            break;
        }
        case ToolKind::hinge:
        case ToolKind::motor:
        case ToolKind::weld:
        case ToolKind::spring:
        case ToolKind::cable:
        case ToolKind::winch:
        case ToolKind::slider:
        case ToolKind::pulley:
        case ToolKind::gear:
        case ToolKind::thruster:
        case ToolKind::wind:
        case ToolKind::gravity:
            EXPECT_EQ(after.others, before.others + 1);
            break;
        case ToolKind::axle:
            EXPECT_EQ(after.others, before.others + 2);
            break;
        case ToolKind::joint:
            EXPECT_EQ(after.joints, before.joints + 1);
            break;
        case ToolKind::pin:
            EXPECT_EQ(after.pinned, before.pinned + 1);
            break;
        case ToolKind::cut:
            EXPECT_LT(after.joints, before.joints);
            EXPECT_LT(boxHeight(demo), 0.5) << "the box falls by itself";
            break;
        case ToolKind::erase:
            EXPECT_EQ(after.bodies, before.bodies - 2);
            break;
        case ToolKind::measure:
        case ToolKind::protractor:
        case ToolKind::tracer:
        case ToolKind::gauge:
        case ToolKind::gun:
            EXPECT_EQ(after.others, before.others + 1);
            break;
        default:
            EXPECT_GT(after.bodies + after.others, before.bodies + before.others);
    }
    EXPECT_GE(steps, 1u);
}

TEST_P(ToolDemoTest, BeginsAgain) {
    ToolDemo demo(GetParam());
    const Stock first = stockOf(demo);
    for (int i = 0; i < 4; ++i) demo.advance(1);
    EXPECT_LT(demo.time(), ToolDemo::seconds);
    ToolDemo again(GetParam());
    while (again.time() + 1.0 / 60 < ToolDemo::seconds) again.advance(1.0 / 60);
    again.advance(1.0 / 60);
    EXPECT_EQ(again.time(), 0);
    EXPECT_EQ(stockOf(again).bodies, first.bodies);
}

INSTANTIATE_TEST_SUITE_P(Each, ToolDemoTest,
                         testing::ValuesIn(allTools().begin(), allTools().end()),
                         [](const auto& tool) { return std::string(toolName(tool.param)); });

}  // namespace
}  // namespace sulfurchamber
