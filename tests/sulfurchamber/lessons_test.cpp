// The lessons go on when the learner has done what they ask, and only then.
#include "model/lessons.hpp"

#include <gtest/gtest.h>

#include <string>

#include "model/measurement.hpp"

namespace sulfurchamber {
namespace {

/// Does what the window does for a lesson's hand.
class Learner {
public:
    explicit Learner(const Lesson& lesson) : run(bench, lesson) {}

    void act(const std::string& name) {
        Document& document = bench.document();
        if (name == "drop") bench.dropBoxes(10);
        if (name == "plot") bench.measure({quantity("height"), quantity("energy")});
        if (name == "plot-speed")
            bench.measure({quantity("height"), quantity("energy"), quantity("speed")});
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
            if (bench.document().playing())
                for (int i = 0; i < rate / 60; ++i) bench.tick();
            run.look();
            if (run.step() != before) return true;
        }
        return false;
    }

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
                         testing::Values("build", "break", "soften", "measure", "rewind"),
                         [](const auto& lesson) { return std::string(lesson.param); });

TEST(LessonList, HasThemInOrder) {
    EXPECT_EQ(lessons().size(), 5u);
    EXPECT_STREQ(lessons().front().name, "build");
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

}  // namespace
}  // namespace sulfurchamber
