// The lessons go on when the learner has done what they ask, and only then.
#include "model/lessons.hpp"

#include <gtest/gtest.h>

#include <string>

#include "model/level_pieces.hpp"
#include "model/measurement.hpp"

namespace sulfurchamber {
namespace {

/// Does what the window does for a lesson's hand.
class Learner {
public:
    explicit Learner(const Lesson& lesson) : run(bench, lesson, [this] { return played; }) {}

    void act(const std::string& name) {
        Document& document = bench.document();
        if (name == "drop") bench.dropBoxes(10);
        if (name == "plot") bench.measure({quantity("height"), quantity("energy")});
        if (name == "plot-speed")
            bench.measure({quantity("height"), quantity("energy"), quantity("speed")});
        if (name == "level-make") document.edit("Make a level", [&] { makeLevel(document); });
        for (const LevelPieceInfo& piece : levelPieces())
            if (name == "place-" + std::string(piece.name)) bench.setPlacing(piece.piece);
        if (name == "level-play") played = 0.001;
        if (name == "level-edit") played = 0;
        if (name == "second-back") {
            const auto& timeline = document.timeline();
            const auto second = static_cast<std::uint64_t>(document.world().settings().tickRate);
            document.goTo({timeline.line(), timeline.now()->tick - second});
        }
        if (name == "other-future") {
            const auto other = document.timeline().others().front();
            document.goTo({other.branch, other.last});
        }
    }

    /// Lets time go by as a window does; false when the step was not done in `seconds`.
    bool wait(double seconds, Hand* hand = nullptr) {
        const std::size_t before = run.step();
        const int rate = bench.document().world().settings().tickRate;
        for (int frame = 0; frame < seconds * 60; ++frame) {
            if (hand != nullptr) hand->advance(1.0 / 60);
            if (played > 0) played += 1.0 / 60;
            if (bench.document().playing())
                for (int i = 0; i < rate / 60; ++i) bench.tick();
            run.look();
            if (run.step() != before) return true;
        }
        return false;
    }

    double played = 0;  // seconds of the play-test
    Workbench bench;
    LessonRun run;
};

class Lessons : public testing::TestWithParam<const char*> {};

TEST_P(Lessons, EachStepIsDoneByItsHandAndByNothingElse) {
    Learner learner(*lessonOf(GetParam()));
    while (!learner.run.finished()) {
        const std::size_t step = learner.run.step();
        const std::string text = learner.run.text();
        if (!learner.bench.document().playing()) {
            EXPECT_FALSE(learner.wait(0.3)) << "without anything done: " << text;
        }
        Hand hand = learner.run.show([&](const std::string& name) { learner.act(name); });
        ASSERT_TRUE(learner.wait(hand.length() + 6, &hand)) << text;
        EXPECT_EQ(learner.run.step(), step + 1) << text;
        while (!hand.done()) hand.advance(0.1);
    }
    EXPECT_EQ(learner.run.step(), learner.run.lesson().steps.size());
    EXPECT_FALSE(learner.run.look());
    EXPECT_EQ(learner.bench.document().world().validate(), "");
}

TEST_P(Lessons, StepsCanBeSkipped) {
    Learner learner(*lessonOf(GetParam()));
    for (std::size_t i = 0; i < learner.run.lesson().steps.size(); ++i) {
        EXPECT_EQ(learner.run.step(), i);
        EXPECT_FALSE(learner.run.text().empty());
        learner.run.skip();
    }
    EXPECT_TRUE(learner.run.finished());
    learner.run.skip();
    EXPECT_TRUE(learner.run.finished());
    EXPECT_FALSE(learner.run.text().empty());
    EXPECT_TRUE(learner.run.show({}).done());
}

INSTANTIATE_TEST_SUITE_P(Each, Lessons,
                         testing::Values("build", "break", "soften", "measure", "rewind", "level"),
                         [](const auto& lesson) { return std::string(lesson.param); });

TEST(LessonList, HasThemInOrder) {
    EXPECT_EQ(lessons().size(), 6u);
    EXPECT_STREQ(lessons().front().name, "build");
    EXPECT_STREQ(lessons().back().name, "level");
    EXPECT_EQ(lessonOf("no such lesson"), nullptr);
}

TEST(LessonSteps, AreNotDoneByAnotherThing) {
    Learner learner(*lessonOf("build"));
    Hand ball(learner.bench, hand::operator+(hand::take(ToolKind::ball), hand::click({0, 1})));
    EXPECT_FALSE(learner.wait(1, &ball)) << "a ball is no box";
    EXPECT_TRUE(ball.done());
    Hand box(learner.bench, hand::operator+(hand::take(ToolKind::box), hand::click({1, 1})));
    EXPECT_TRUE(learner.wait(1, &box));
}

TEST(LessonSteps, OfALevelWantAWayWithSomethingOnIt) {
    Learner learner(*lessonOf("level"));
    const auto place = [&](const char* piece, const sulfur::Point& at) {
        learner.act(piece);
        Hand hand(learner.bench, hand::click(at));
        return learner.wait(1, &hand);
    };
    learner.act("level-make");
    ASSERT_TRUE(learner.wait(0.1));
    ASSERT_TRUE(place("place-spawn", {-3, 0.5}));
    EXPECT_FALSE(place("place-exit", {0.5, 0.5})) << "3.5 m are too near";
    EXPECT_TRUE(place("place-exit", {3, 0.5}));
    EXPECT_FALSE(place("place-pickup", {4, 0.5})) << "behind the exit";
    EXPECT_TRUE(place("place-pickup", {0, 0.5})) << "things of the level are something too";
    learner.act("level-play");
    EXPECT_FALSE(learner.wait(1)) << "a glance is not enough";
    EXPECT_TRUE(learner.wait(2));
    EXPECT_FALSE(learner.wait(1)) << "it is played still";
    learner.act("level-edit");
    EXPECT_TRUE(learner.wait(0.1));
    EXPECT_TRUE(learner.run.finished());
}

}  // namespace
}  // namespace sulfurchamber
