#include "lessons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "properties.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using namespace hand;

// --- looking ---------------------------------------------------------------------------------

template <class Options>
bool isMadeBy(const Document& document, BodyId body) {
    const std::string id = document.idOf(body);
    if (id.empty()) return false;
    const auto& prefab = document.plan().prefab(document.plan().body(id).blueprint);
    return std::holds_alternative<Options>(prefab.generator);
}

// The newest body of a shape; null when there is none.
template <class Options>
BodyId newest(const Workbench& bench) {
    const auto bodies = bench.document().world().bodies();
    for (auto body = bodies.rbegin(); body != bodies.rend(); ++body)
        if (isMadeBy<Options>(bench.document(), *body)) return *body;
    return {};
}

Point centreOf(const Workbench& bench, BodyId body) {
    return body ? bench.document().world().centreOfMass(body) : Point(0, 1);
}

template <class Options>
bool hasNew(const LessonView& view) {
    return view.now.bodies > view.start.bodies && newest<Options>(view.bench);
}

double stiffnessOf(const Workbench& bench) {
    std::vector<BodyId> bodies = bench.selection();
    if (bodies.empty())
        if (const BodyId jelly = newest<sulfur::shapes::JellyOptions>(bench)) bodies = {jelly};
    return common(bench.document(), bodies, *numberProperty("stiffness")).value.value_or(0);
}

LessonState stateOf(const Workbench& bench) {
    const Document& document = bench.document();
    const Totals sums = totals(document.world());
    const Timeline& timeline = document.timeline();
    LessonState state;
    state.bodies = sums.bodies;
    state.joints = sums.rigidJoints + sums.elasticJoints;
    state.ties = document.scene().connections.size();
    state.steps = document.historyPlace();
    state.measured = bench.measured().size();
    state.branches = timeline.empty() ? 0 : timeline.others().size() + 1;
    state.branch = timeline.now() ? timeline.now()->branch : 0;
    state.time = document.world().time();
    state.stiffness = stiffnessOf(bench);
    return state;
}

bool hasRun(const LessonView& view, double seconds) {
    return view.now.time > view.start.time + seconds;
}

bool ranASecond(const LessonView& view) {
    return hasRun(view, 1);
}

bool ranTwoSeconds(const LessonView& view) {
    return hasRun(view, 2);
}

HandMoves showPlay(const Workbench& bench) {
    return bench.document().playing() ? rest(0.1) : act("play");
}

// --- build -----------------------------------------------------------------------------------

constexpr LessonStep buildSteps[] = {
    {"Choose the box tool (B) and drag a box in the air, well above the floor.",
     hasNew<sulfur::shapes::BoxOptions>,
     [](const Workbench&) {
         return take(ToolKind::box) + drag({-0.4, 0.9}, {0.4, 1.5});
     }},
    {"Choose the rope tool (R). Drag from a place above the box to one of its corners: the rope "
     "ties itself to it.",
     [](const LessonView& view) { return view.now.ties > view.start.ties; },
     [](const Workbench& bench) {
         const BodyId box = newest<sulfur::shapes::BoxOptions>(bench);
         Point corner(0, 1.5);
         if (box) {
             const auto& world = bench.document().world();
             for (const auto particle : world.particles(box))
                 if (world.position(particle).y() > corner.y() - 0.03)
                     corner = world.position(particle);
         }
         return take(ToolKind::rope) + drag(corner + Point(0.2, 1.4), corner);
     }},
    {"Press Space: time runs, and the box swings. Watch it for a second.", ranASecond, showPlay},
    {"Choose the select tool (V) and pull the box with the mouse while time runs: a spring "
     "follows the pointer.",
     [](const LessonView& view) { return view.seen.pulled; },
     [](const Workbench& bench) {
         const Point box = centreOf(bench, newest<sulfur::shapes::BoxOptions>(bench));
         return showPlay(bench) + take(ToolKind::select) + drag(box, box + Point(0.9, 0.3));
     }},
    {"Press Ctrl+R: everything is back where it was built. Playing never damages what was built.",
     [](const LessonView& view) { return !view.bench.document().canReset(); },
     [](const Workbench&) { return act("reset"); }},
};

// --- break -----------------------------------------------------------------------------------

constexpr LessonStep breakSteps[] = {
    {"Choose the wall tool (N) and click about a metre above the floor: a wall of cells that "
     "crumbles.",
     hasNew<sulfur::shapes::WallOptions>,
     [](const Workbench&) {
         return take(ToolKind::wall) + click({0, 0.85});
     }},
    {"Choose the ball tool (O) and drag a large ball high above the wall, from its centre to its "
     "rim.",
     hasNew<sulfur::shapes::BallOptions>,
     [](const Workbench&) {
         return take(ToolKind::ball) + drag({0.2, 3.6}, {0.9, 3.6});
     }},
    {"Press Space: the ball falls, and joints break that bear more than their strength.",
     [](const LessonView& view) {
         return view.now.joints < view.start.joints && hasRun(view, 0.5);
     },
     showPlay},
    {"Choose the cut tool (X) and drag across what still holds together.",
     [](const LessonView& view) {
         return view.now.joints < view.start.joints && view.now.steps > view.start.steps;
     },
     [](const Workbench& bench) {
         // Through the largest piece that is left of the wall.
         const auto& world = bench.document().world();
         BodyId largest;
         std::size_t most = 0;
         for (const BodyId body : world.bodies())
             if (world.kind(body) == sulfur::BodyKind::dynamic &&
                 world.joints(body).size() > most) {
                 largest = body;
                 most = world.joints(body).size();
             }
         const Point middle = centreOf(bench, largest);
         return act("pause") + take(ToolKind::cut) +
                drag(middle + Point(-1.6, 0.03), middle + Point(1.6, 0.04));
     }},
};

// --- soften ----------------------------------------------------------------------------------

constexpr LessonStep softenSteps[] = {
    {"Choose the jelly tool (J) and drag a jelly that stands on the floor, about a metre wide.",
     hasNew<sulfur::shapes::JellyOptions>,
     [](const Workbench&) {
         return take(ToolKind::jelly) + drag({-0.6, 0.06}, {0.6, 0.86});
     }},
    {"Choose the box tool (B) and click above the jelly: it bears a box.",
     hasNew<sulfur::shapes::BoxOptions>,
     [](const Workbench& bench) {
         const Point jelly = centreOf(bench, newest<sulfur::shapes::JellyOptions>(bench));
         return take(ToolKind::box) + click(jelly + Point(0, 1));
     }},
    {"Press Space and see how far the jelly gives way.", ranASecond, showPlay},
    {"Choose the select tool (V) and click the jelly. On the page Object (Ctrl+2) move Stiffness "
     "to the left, to less than half.",
     [](const LessonView& view) {
         return view.now.stiffness > 0 && view.now.stiffness < view.start.stiffness / 2;
     },
     [](const Workbench& bench) {
         const Point jelly = centreOf(bench, newest<sulfur::shapes::JellyOptions>(bench));
         return act("pause") + take(ToolKind::select) + click(jelly) + act("softer", 0.5);
     }},
    {"Now move Stiffness to its right end: the same jelly is rigid. One number makes the "
     "difference.",
     [](const LessonView& view) { return std::isinf(view.now.stiffness); },
     [](const Workbench& bench) {
         const Point jelly = centreOf(bench, newest<sulfur::shapes::JellyOptions>(bench));
         return act("pause") + take(ToolKind::select) + click(jelly) + act("rigid", 0.5);
     }},
};

// --- measure ---------------------------------------------------------------------------------

constexpr LessonStep measureSteps[] = {
    {"Choose the ball tool (O) and click two metres above the floor.",
     [](const LessonView& view) {
         return hasNew<sulfur::shapes::BallOptions>(view) &&
                centreOf(view.bench, newest<sulfur::shapes::BallOptions>(view.bench)).y() > 1.5;
     },
     [](const Workbench&) {
         return take(ToolKind::ball) + click({0, 2.2});
     }},
    {"Choose the measure tool (3) and drag from the floor to the ball: the hint tells the length.",
     [](const LessonView& view) { return view.seen.ruled > 0.5; },
     [](const Workbench& bench) {
         const Point ball = centreOf(bench, newest<sulfur::shapes::BallOptions>(bench));
         return take(ToolKind::measure) + drag({ball.x(), 0.05}, ball);
     }},
    {"Choose the select tool (V), click the ball beside the ruler and press F8: a diagram of its "
     "height and energy.",
     [](const LessonView& view) {
         return !view.bench.selection().empty() && view.now.measured > 0;
     },
     [](const Workbench& bench) {
         const Point ball = centreOf(bench, newest<sulfur::shapes::BallOptions>(bench));
         // The ruler ends at its centre.
         return take(ToolKind::select) + click(ball + Point(0.19, 0.08)) + act("plot");
     }},
    {"Press Space and let the ball bounce: each tick is a sample.",
     [](const LessonView& view) {
         const auto& series = view.bench.measurements().series();
         return ranASecond(view) && !series.empty() && series[0].samples.size() > 100;
     },
     showPlay},
    {"Choose another quantity in the menu Measure, such as Speed.",
     [](const LessonView& view) { return view.now.measured > view.start.measured; },
     [](const Workbench&) { return act("plot-speed", 0.5); }},
};

// --- rewind ----------------------------------------------------------------------------------

// How far before the end of its line the present moment is, seconds.
double beforeEnd(const Workbench& bench) {
    const Timeline& timeline = bench.document().timeline();
    if (!timeline.now()) return 0;
    return static_cast<double>(timeline.last(timeline.line()) - timeline.now()->tick) *
           static_cast<double>(bench.document().world().tickDuration());
}

constexpr LessonStep rewindSteps[] = {
    {"Press D: ten boxes hang in the air.",
     [](const LessonView& view) { return view.now.bodies >= view.start.bodies + 10; },
     [](const Workbench&) { return act("drop"); }},
    {"Press Space and let them fall for two seconds.", ranTwoSeconds, showPlay},
    {"Drag the point on the bar of time to the left, a second or more, or press Page Up: time runs "
     "back.",
     [](const LessonView& view) { return beforeEnd(view.bench) > 0.9; },
     [](const Workbench&) { return act("pause") + act("second-back", 0.4); }},
    {"Change the past: choose the ball tool (O) and click somewhere.",
     [](const LessonView& view) {
         return view.now.steps > view.start.steps && hasNew<sulfur::shapes::BallOptions>(view);
     },
     [](const Workbench&) {
         return take(ToolKind::ball) + click({0.4, 3});
     }},
    {"Press Space: it goes on from here, and another future begins.",
     [](const LessonView& view) { return view.now.branches > 1 && hasRun(view, 0.5); }, showPlay},
    {"Press Z: the future that was left is still there. Both are kept.",
     [](const LessonView& view) { return view.now.branch != view.start.branch; },
     [](const Workbench&) { return act("pause") + act("other-future", 0.4); }},
};

constexpr Lesson all[] = {
    {"build", "Build", "A box on a rope", buildSteps},
    {"break", "Break", "A wall that crumbles", breakSteps},
    {"soften", "Soften", "From jelly to rigid with one number", softenSteps},
    {"measure", "Measure", "A ruler and a diagram", measureSteps},
    {"rewind", "Rewind", "Back in time, and another future", rewindSteps},
};

}  // namespace

std::span<const Lesson> lessons() {
    return all;
}

const Lesson* lessonOf(std::string_view name) {
    for (const Lesson& lesson : all)
        if (lesson.name == name) return &lesson;
    return nullptr;
}

LessonRun::LessonRun(Workbench& bench, const Lesson& lesson) : bench_(bench), lesson_(lesson) {
    begin();
}

void LessonRun::begin() {
    start_ = stateOf(bench_);
    seen_ = {};
}

std::string LessonRun::text() const {
    return finished() ? "That was all of this lesson. Well done!" : lesson_.steps[step_].text;
}

bool LessonRun::look() {
    if (finished()) return false;
    const Preview preview = bench_.preview();
    if (preview.kind == Preview::Kind::spring && bench_.document().playing()) seen_.pulled = true;
    if (preview.kind == Preview::Kind::ruler) seen_.ruled = std::max(seen_.ruled, preview.size);
    if (!lesson_.steps[step_].done({bench_, start_, stateOf(bench_), seen_})) return false;
    skip();
    return true;
}

void LessonRun::skip() {
    if (finished()) return;
    ++step_;
    begin();
}

Hand LessonRun::show(std::function<void(const std::string&)> act) {
    const auto stiffen = [this](double newtonsPerMetre) {
        bench_.document().edit("Change stiffness", [&] {
            setProperty(bench_.document(), bench_.selection(), *numberProperty("stiffness"),
                        newtonsPerMetre);
        });
    };
    const auto perform = [this, stiffen, act = std::move(act)](const std::string& name) {
        if (name == "softer")
            stiffen(std::max(1.0, 0.3 * stateOf(bench_).stiffness));
        else if (name == "rigid")
            stiffen(std::numeric_limits<double>::infinity());
        else if (act)
            act(name);
    };
    return Hand(bench_, finished() ? HandMoves{} : lesson_.steps[step_].show(bench_), perform);
}

}  // namespace sulfurchamber
