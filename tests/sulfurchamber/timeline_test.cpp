// Rewinding: every recorded tick comes back to the bit, branches are kept, memory is bounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

void drag(Workbench& bench, ToolKind tool, Point from, Point to) {
    bench.setTool(tool);
    bench.press({.position = from});
    bench.move({.position = (from + to) / 2});
    bench.release({.position = to});
}

void letRun(Workbench& bench, int ticks) {
    for (int i = 0; i < ticks; ++i) bench.tick();
}

TEST(Timeline, EveryTickComesBackToTheBit) {
    Workbench bench;
    Document& document = bench.document();
    drag(bench, ToolKind::box, {0, 2}, {0.6, 2.6});
    drag(bench, ToolKind::jelly, {-2, 1}, {-1, 2});
    drag(bench, ToolKind::rope, {1, 3}, {3, 3});
    std::vector<std::uint64_t> hashes;
    const auto one = [&] {
        hashes.push_back(document.world().hash());
        bench.tick();
    };
    for (int i = 0; i < 300; ++i) one();
    bench.setRain(30);
    for (int i = 0; i < 300; ++i) one();
    bench.setRain(0);
    // A pull with the mouse.
    document.play();
    bench.setTool(ToolKind::select);
    const Point jelly = document.world().centreOfMass(document.world().bodies()[2]);
    bench.press({.position = jelly});
    bench.move({.position = jelly + Point(1, 2)});
    for (int i = 0; i < 200; ++i) one();
    bench.release({.position = jelly + Point(1, 2)});
    for (int i = 0; i < 100; ++i) one();
    const std::uint64_t end = document.world().ticks();
    hashes.push_back(document.world().hash());
    const std::uint32_t line = document.timeline().line();
    EXPECT_EQ(document.timeline().first(line), 0u);
    EXPECT_EQ(document.timeline().last(line), end);
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) {
        const std::uint64_t tick = i == 0 ? 0 : i == 1 ? end : random() % (end + 1);
        ASSERT_TRUE(document.goTo({line, tick}));
        ASSERT_EQ(document.world().ticks(), tick);
        ASSERT_EQ(document.world().hash(), hashes[tick]) << "tick " << tick;
        EXPECT_FALSE(document.playing());
    }
    EXPECT_TRUE(document.timeline().others().empty());
}

TEST(Timeline, GoingOnFromTheEndIsTheSameAsNeverHavingLooked) {
    Workbench looked;
    Workbench not_;
    for (Workbench* bench : {&looked, &not_}) {
        drag(*bench, ToolKind::ball, {0, 2}, {0.6, 2.6});
        letRun(*bench, 200);
    }
    const std::uint32_t line = looked.document().timeline().line();
    looked.document().goTo({line, 77});
    looked.document().goTo({line, 200});
    for (Workbench* bench : {&looked, &not_}) letRun(*bench, 300);
    EXPECT_EQ(looked.document().world().hash(), not_.document().world().hash());
    EXPECT_EQ(looked.document().timeline().line(), line);
    EXPECT_TRUE(looked.document().timeline().others().empty());
}

TEST(Timeline, GoingOnFromAnEarlierMomentIsABranchAndTheOldFutureStays) {
    Workbench bench;
    Document& document = bench.document();
    drag(bench, ToolKind::box, {0, 3}, {0.6, 3.6});
    letRun(bench, 400);
    const std::uint64_t old = document.world().hash();
    const std::uint32_t first = document.timeline().line();
    document.goTo({first, 150});
    // Looking alone changes nothing.
    EXPECT_TRUE(document.timeline().others().empty());
    Constants constants = document.constants();
    constants.gravity = -5;
    document.setConstants(constants);
    letRun(bench, 100);
    const std::uint32_t second = document.timeline().line();
    EXPECT_NE(second, first);
    EXPECT_EQ(document.world().ticks(), 250u);
    EXPECT_GT(document.world().centreOfMass(document.world().bodies()[1]).y(), 2);
    const std::uint64_t risen = document.world().hash();
    ASSERT_EQ(document.timeline().others().size(), 1u);
    EXPECT_EQ(document.timeline().others()[0].branch, first);
    EXPECT_EQ(document.timeline().others()[0].from, 150u);
    EXPECT_EQ(document.timeline().others()[0].last, 400u);
    // The line of the branch has what came before it.
    EXPECT_EQ(document.timeline().first(second), 0u);
    document.goTo({second, 30});
    EXPECT_EQ(document.world().ticks(), 30u);
    document.goTo({second, 250});
    EXPECT_EQ(document.world().hash(), risen);
    // And the old future is where it was.
    document.goTo({first, 400});
    EXPECT_EQ(document.world().hash(), old);
    EXPECT_EQ(document.timeline().line(), first);
    ASSERT_EQ(document.timeline().others().size(), 1u);
    EXPECT_EQ(document.timeline().others()[0].branch, second);
    EXPECT_EQ(document.timeline().others()[0].from, 150u);
}

TEST(Timeline, EditsBreaksAndFirstContactsAreMarked) {
    Workbench bench;
    Document& document = bench.document();
    drag(bench, ToolKind::box, {0, 0.6}, {0.6, 1.2});
    letRun(bench, 400);
    const auto count = [&](Mark::Kind kind) {
        const auto marks = document.timeline().marks(document.timeline().line());
        EXPECT_TRUE(std::is_sorted(marks.begin(), marks.end(),
                                   [](const Mark& a, const Mark& b) { return a.tick < b.tick; }));
        return std::count_if(marks.begin(), marks.end(),
                             [&](const Mark& mark) { return mark.kind == kind; });
    };
    EXPECT_EQ(count(Mark::Kind::edit), 0);  // what was built before time passed is no moment
    EXPECT_EQ(count(Mark::Kind::contact), 1);
    EXPECT_EQ(count(Mark::Kind::breakage), 0);
    drag(bench, ToolKind::ball, {-3, 2}, {-2.6, 2});
    EXPECT_EQ(count(Mark::Kind::edit), 1);
    EXPECT_EQ(document.timeline().marks(document.timeline().line()).back().label, "Add ball");
    letRun(bench, 500);
    EXPECT_EQ(count(Mark::Kind::contact), 2);  // the ball lands; the box has touched before
    document.edit("Throw", [&] {
        for (const BodyId body : document.world().bodies())
            if (document.world().name(body) == "ball")
                document.place(body, {.position = {0.3, 6}, .angle = 0});
        Constants constants = document.constants();
        constants.gravity = 30;
        document.setConstants(constants);
    });
    letRun(bench, 900);
    EXPECT_EQ(count(Mark::Kind::edit), 2);
    EXPECT_GT(count(Mark::Kind::contact), 2);
    EXPECT_EQ(textOf({0, Mark::Kind::contact, "", 1}), "1 first contact");
    EXPECT_EQ(textOf({0, Mark::Kind::breakage, "", 3}), "3 joints break");
    EXPECT_EQ(textOf({0, Mark::Kind::edit, "Move", 1}), "Move");
}

TEST(Timeline, BreaksAreMarked) {
    Workbench bench;
    Document& document = bench.document();
    auto prefab = sulfur::scene::makePrefab(
        "stick", sulfur::shapes::RopeOptions{.from = {0, 0}, .to = {2, 0}});
    prefab.generator = {};
    prefab.blueprint.particles.front().pinned = true;
    for (auto& joint : prefab.blueprint.joints) joint.strength = 0.05f;
    document.edit("Add", [&] { document.add(prefab, {}); });
    const auto ids = document.world().bodies();
    document.edit("Lift", [&] { document.translate({&ids[1], 1}, {0, 4}); });
    letRun(bench, 600);
    const auto marks = document.timeline().marks(document.timeline().line());
    EXPECT_TRUE(std::any_of(marks.begin(), marks.end(),
                            [](const Mark& mark) { return mark.kind == Mark::Kind::breakage; }));
}

void run(Timeline& timeline, sulfur::World& world, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        timeline.prepare(world);
        world.step();
        timeline.ticked(world);
    }
}

void addHeap(sulfur::World& world) {
    Document source;
    for (const auto& body : source.plan().scene().bodies)
        world.add(source.plan().blueprint(body.id), body.pose);
    const auto box = sulfur::scene::makePrefab("box", sulfur::shapes::BoxOptions{});
    for (int i = 0; i < 60; ++i)
        world.add(box.blueprint,
                  {.position = {i % 6 * 1.3 - 4, 1 + i / 6 * 1.2}, .angle = 0.1 * i});
}

// Small limits show in a few seconds what 64 MiB show in many.
TEST(Timeline, MemoryIsBoundedAndTheLatestMomentsStay) {
    Timeline timeline({.bytes = 3u << 20, .assured = 4, .longest = 20, .interval = 0.1});
    sulfur::World world;
    addHeap(world);
    std::map<std::uint64_t, std::uint64_t> hashes;
    for (int i = 0; i < 6000; ++i) {
        timeline.prepare(world);
        hashes[world.ticks()] = world.hash();
        world.step();
        timeline.ticked(world);
        ASSERT_LE(timeline.bytes(), 3u << 20);
    }
    const std::uint32_t line = timeline.line();
    EXPECT_LT(timeline.first(line), 6000u - 2000u);  // four seconds at least
    for (const std::uint64_t tick :
         {timeline.first(line), std::uint64_t{4321}, std::uint64_t{5999}}) {
        timeline.go(world, {line, tick}, 1e9);
        ASSERT_EQ(world.ticks(), tick);
        ASSERT_EQ(world.hash(), hashes[tick]);
    }
    // What is too old leads to the oldest that is left.
    timeline.go(world, {line, 0}, 1e9);
    EXPECT_EQ(world.ticks(), timeline.first(line));
    timeline.clear();
    EXPECT_TRUE(timeline.empty());
    EXPECT_LT(timeline.bytes(), 1000u);
}

// The line is so short that it leaves room for those beside it.
TEST(Timeline, ManyBranchesTakeNoMoreAndTheLatestCanBeReached) {
    Timeline timeline({.bytes = 6u << 20, .assured = 1, .longest = 2, .interval = 0.1});
    sulfur::World world;
    addHeap(world);
    run(timeline, world, 500);
    for (int i = 0; i < 30; ++i) {
        timeline.go(world, {timeline.line(), timeline.last(timeline.line()) - 200}, 1e9);
        for (int tick = 0; tick < 400; ++tick) {
            timeline.prepare(world);
            world.step();
            timeline.ticked(world);
            ASSERT_LE(timeline.bytes(), 6u << 20);
        }
    }
    EXPECT_GT(timeline.others().size(), 1u);
    EXPECT_LT(timeline.others().size(), 30u);
    for (const auto& other : timeline.others()) {
        timeline.go(world, {other.branch, other.last}, 1e9);
        EXPECT_EQ(world.ticks(), other.last);
    }
}

TEST(Timeline, OlderThanTheLongestIsForgotten) {
    Timeline timeline({.bytes = 64u << 20, .assured = 1, .longest = 2, .interval = 0.1});
    sulfur::World world;
    for (int i = 0; i < 5000; ++i) {
        timeline.prepare(world);
        world.step();
        timeline.ticked(world);
    }
    EXPECT_GE(5000u - timeline.first(timeline.line()), 1000u - 450u);
    EXPECT_LE(5000u - timeline.first(timeline.line()), 1000u + 50u);
    EXPECT_LT(timeline.keys(), 30u);
}

// What a caller that asks until it is there relies on.
void expectEachTickIsReached(Timeline& timeline, sulfur::World& world, std::uint32_t line) {
    ASSERT_LE(timeline.first(line), timeline.last(line));
    for (std::uint64_t wish = 0; wish <= timeline.last(line) + 50; wish += 50) {
        const std::uint64_t tick = std::clamp(wish, timeline.first(line), timeline.last(line));
        ASSERT_EQ(timeline.go(world, {line, wish}, 1e9), (Moment{line, tick}));
        ASSERT_EQ(world.ticks(), tick);
    }
}

void addFalling(sulfur::World& world, int count) {
    const auto box = sulfur::scene::makePrefab("box", sulfur::shapes::BoxOptions{});
    for (int i = 0; i < count; ++i) world.add(box.blueprint, {.position = {2.0 * i, 0}});
}

TEST(Timeline, ABranchThatPartedFromWhatIsForgottenBeginsByItself) {
    Timeline timeline({.bytes = 64u << 20, .assured = 1, .longest = 2, .interval = 0.1});
    sulfur::World world;
    addFalling(world, 1);
    run(timeline, world, 500);
    const std::uint32_t old = timeline.line();
    timeline.go(world, {old, 100}, 1e9);
    const Timeline::Place early = timeline.place();
    run(timeline, world, 10);
    const std::uint32_t side = timeline.line();
    timeline.go(world, {old, 500}, 1e9);
    for (int i = 0; i < 3000 && timeline.first(old) <= 110; ++i) run(timeline, world, 1);
    const std::uint64_t first = timeline.first(old);
    const std::uint64_t last = timeline.last(old);
    const std::uint64_t hash = world.hash();
    ASSERT_GT(first, 110u);
    EXPECT_EQ(timeline.first(side), 100u);
    EXPECT_EQ(timeline.last(side), 110u);
    expectEachTickIsReached(timeline, world, side);
    ASSERT_EQ(timeline.others().size(), 1u);
    EXPECT_EQ(timeline.others()[0].from, first);
    EXPECT_EQ(timeline.others()[0].last, last);
    // It goes on, and takes nothing from the other, however long it gets.
    run(timeline, world, 1500);
    EXPECT_GT(timeline.first(side), 100u);
    EXPECT_EQ(timeline.first(old), first);
    timeline.go(world, {old, last}, 1e9);
    EXPECT_EQ(world.ticks(), last);
    EXPECT_EQ(world.hash(), hash);
    // A moment that is forgotten is none to come back to.
    timeline.comeBack(early);
    EXPECT_FALSE(timeline.now());
}

TEST(Timeline, ASideBranchThatLostItsBeginningCanBeReached) {
    Timeline timeline({.bytes = 600'000, .assured = 1, .longest = 1e4, .interval = 0.02});
    sulfur::World world;
    addFalling(world, 20);
    run(timeline, world, 200);
    const std::uint32_t old = timeline.line();
    timeline.go(world, {old, 100}, 1e9);
    run(timeline, world, 300);
    const std::uint32_t side = timeline.line();
    ASSERT_EQ(timeline.first(side), 0u);
    timeline.go(world, {old, 200}, 1e9);
    for (int i = 0; i < 20000 && timeline.first(side) <= 100; ++i) run(timeline, world, 1);
    ASSERT_GT(timeline.first(side), 100u);
    ASSERT_LT(timeline.first(side), 400u);
    EXPECT_EQ(timeline.first(old), 0u);
    expectEachTickIsReached(timeline, world, side);
    expectEachTickIsReached(timeline, world, old);
}

TEST(Timeline, APlaceInAFutureThatIsForgottenIsLeft) {
    Timeline timeline({.bytes = 600'000, .assured = 1, .longest = 1e4, .interval = 0.02});
    sulfur::World world;
    addFalling(world, 20);
    run(timeline, world, 200);
    const std::uint32_t old = timeline.line();
    const Timeline::Place end = timeline.place();
    const sulfur::Snapshot then = world.snapshot();
    timeline.go(world, {old, 100}, 1e9);
    run(timeline, world, 1);
    const std::uint32_t line = timeline.line();
    for (int i = 0; i < 20000 && timeline.last(old) > 100; ++i) run(timeline, world, 1);
    ASSERT_EQ(timeline.last(old), 100u);
    world.restore(then);
    timeline.comeBack(end);
    EXPECT_FALSE(timeline.now());
    run(timeline, world, 10);
    EXPECT_EQ(timeline.first(timeline.line()), 200u);
    EXPECT_EQ(timeline.last(timeline.line()), 210u);
    expectEachTickIsReached(timeline, world, old);
    expectEachTickIsReached(timeline, world, line);
}

TEST(Timeline, AStepInTimeStopsWhenItsTimeIsSpentAndGoesOnWhenAskedAgain) {
    Workbench bench;
    drag(bench, ToolKind::box, {0, 3}, {0.6, 3.6});
    letRun(bench, 100);
    Document& document = bench.document();
    const Moment wanted{document.timeline().line(), 45};
    const std::uint64_t hash = [&] {
        document.goTo(wanted);
        return document.world().hash();
    }();
    document.goTo({wanted.branch, 99});
    int calls = 1;
    while (!document.goTo(wanted, 0)) ++calls;
    EXPECT_GT(calls, 10);  // a tick a call
    EXPECT_EQ(document.world().hash(), hash);
}

// Steps of the history and moments of the record do not disturb each other.
TEST(Timeline, UndoOfAnEditInAnEarlierMomentLeavesPlanAndRecordWhole) {
    Workbench bench;
    Document& document = bench.document();
    drag(bench, ToolKind::box, {0, 3}, {0.6, 3.6});
    const std::string plan = document.text();
    letRun(bench, 300);
    const std::uint64_t end = document.world().hash();
    const std::uint32_t line = document.timeline().line();
    document.goTo({line, 120});
    const std::uint64_t then = document.world().hash();
    EXPECT_EQ(document.text(), plan);
    EXPECT_EQ(document.undoLabel(), "Add box");
    drag(bench, ToolKind::ball, {2, 2}, {2.5, 2});
    const std::string withBall = document.text();
    letRun(bench, 50);
    document.undo();
    EXPECT_EQ(document.text(), plan);
    EXPECT_EQ(document.world().hash(), then);
    document.redo();
    EXPECT_EQ(document.text(), withBall);
    EXPECT_EQ(document.world().bodies().size(), 3u);
    document.goTo({line, 300});
    EXPECT_EQ(document.world().hash(), end);
    EXPECT_EQ(document.text(), withBall);
    // Reset shows the plan, and the record is there still.
    document.reset();
    EXPECT_EQ(document.world().bodies().size(), 3u);
    EXPECT_FALSE(document.timeline().now());
    document.goTo({line, 120});
    EXPECT_EQ(document.world().hash(), then);
    document.undo();  // of the reset
    EXPECT_EQ(document.world().hash(), end);
    EXPECT_EQ(document.text(), withBall);
}

TEST(Timeline, AnotherSceneHasNoPast) {
    Workbench bench;
    letRun(bench, 50);
    EXPECT_FALSE(bench.document().timeline().empty());
    bench.document().clear();
    EXPECT_TRUE(bench.document().timeline().empty());
}

}  // namespace
}  // namespace sulfurchamber
