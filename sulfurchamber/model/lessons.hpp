// Lessons that look at what the learner does, and go on only when it is done.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "hand.hpp"

namespace sulfurchamber {

/// What there is, in numbers that tell whether something was done.
struct LessonState {
    std::size_t bodies = 0;
    std::size_t joints = 0;  ///< of bodies and between them
    std::size_t ties = 0;    ///< joints between bodies
    std::size_t steps = 0;   ///< of the history
    std::size_t measured = 0;
    std::size_t branches = 0;
    std::uint32_t branch = 0;  ///< of the present moment
    double time = 0;           ///< simulated, seconds
    double stiffness = 0;      ///< N/m, of what was selected last and is elastic
    bool level = false;        ///< the scene is one; what follows is about it
    sulfur::Point spawn{0, 0};
    sulfur::Point exit{0, 0};
    std::size_t between = 0;  ///< bodies and things of the level on the way from one to the other
    double played = 0;        ///< seconds of the play-test that goes on; 0: none does
};

/// What was seen since a step began, also for a moment only.
struct LessonSeen {
    bool pulled = false;
    double ruled = 0;  ///< metres on the ruler
    bool played = false;
};

/// What a step looks at.
struct LessonView {
    const Workbench& bench;
    LessonState start;  ///< when the step began
    LessonState now;
    LessonSeen seen;
};

struct LessonStep {
    const char* text;  ///< what to do, one or two sentences in English
    bool (*done)(const LessonView& view);
    /// What a hand does instead of the learner.
    HandMoves (*show)(const Workbench& bench);
};

struct Lesson {
    const char* name;   ///< "build", for scripts
    const char* title;  ///< in English, as the next
    const char* about;
    std::span<const LessonStep> steps;
};

/// All lessons in the order in which they are best taken.
std::span<const Lesson> lessons();
/// Null when there is none of this name.
const Lesson* lessonOf(std::string_view name);

/// One lesson on its way. Begins with what is open; an empty floor is best.
class LessonRun {
public:
    /// Both must outlive the run. `played` tells LessonState::played; empty where no level can be
    /// played.
    LessonRun(Workbench& bench, const Lesson& lesson, std::function<double()> played = {});

    const Lesson& lesson() const { return lesson_; }
    /// Of the present step, 0 at first; the number of steps at the end.
    std::size_t step() const { return step_; }
    bool finished() const { return step_ == lesson_.steps.size(); }
    /// What to do now, in English; praise at the end.
    std::string text() const;

    /// Looks at the scene and goes on when the step is done. Returns whether it went on. Often.
    bool look();
    /// Goes on although nothing was done.
    void skip();
    /// A hand that does the present step. `act` as Hand has it.
    Hand show(std::function<void(const std::string&)> act);

private:
    LessonState state() const;
    void begin();

    Workbench& bench_;
    const Lesson& lesson_;
    std::function<double()> played_;
    std::size_t step_ = 0;
    LessonState start_;
    LessonSeen seen_;
};

}  // namespace sulfurchamber
