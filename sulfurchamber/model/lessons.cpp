#include "lessons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "geometry.hpp"
#include "level_pieces.hpp"
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

// What is there of a level: where it begins and ends, and what is between.
void lookAtLevel(const Document& document, LessonState& state) {
    state.level = isLevel(document);
    if (!state.level) return;
    state.spawn = shapeOf(document, {LevelKind::spawn, 0, {}}).at;
    state.exit = shapeOf(document, {LevelKind::exit, 0, {}}).at;
    const auto [left, right] = std::minmax(state.spawn.x(), state.exit.x());
    const auto count = [&, left = left, right = right](double x) {
        if (x > left && x < right) ++state.between;
    };
    for (const BodyId body : document.world().bodies())
        count(document.world().centreOfMass(body).x());
    for (const LevelThing& thing : levelThings(document)) {
        if (infoOf(thing.kind).ofBody || thing.kind == LevelKind::bounds) continue;
        const LevelShape shape = shapeOf(document, thing);
        if (shape.form == LevelShape::Form::point) count(shape.at.x());
        if (shape.form == LevelShape::Form::rectangle) count(shape.box.centre().x());
    }
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
    lookAtLevel(document, state);
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

// --- level -----------------------------------------------------------------------------------

constexpr double leastWay = 4;    // metres from the spawn to the exit
constexpr double leastPlay = 2;   // seconds
constexpr double eyeLevel = 0.5;  // metres: where a hand puts spawn and exit above the floor

double floorOf(const Workbench& bench) {
    return floorHeight(bench.document().world());
}

constexpr LessonStep levelSteps[] = {
    {"A level is a scene with a beginning and an end. Choose \"Make a level of this scene\" in the "
     "menu Level.",
     [](const LessonView& view) { return view.now.level; },
     [](const Workbench&) { return act("level-make", 0.5); }},
    {"Choose Spawn in the menu Level > Place and click at the left, a little above the floor: the "
     "hero begins there.",
     [](const LessonView& view) { return view.now.spawn != view.start.spawn; },
     [](const Workbench& bench) {
         return act("place-spawn", 0.4) + click({-4, floorOf(bench) + eyeLevel});
     }},
    {"Choose Exit there and click at the right, four metres from the spawn or more: who comes "
     "there "
     "has finished the level.",
     [](const LessonView& view) {
         return view.now.exit != view.start.exit &&
                (view.now.exit - view.now.spawn).norm() >= leastWay;
     },
     [](const Workbench& bench) {
         const Point spawn = shapeOf(bench.document(), {LevelKind::spawn, 0, {}}).at;
         return act("place-exit", 0.4) + click({spawn.x() + 8, floorOf(bench) + eyeLevel});
     }},
    {"Put something between them: drag a box with the box tool (B), or take a piece of the menu "
     "Level > Place.",
     [](const LessonView& view) { return view.now.between > view.start.between; },
     [](const Workbench& bench) {
         const LessonState state = stateOf(bench);
         const Point middle((state.spawn.x() + state.exit.x()) / 2, floorOf(bench) + 0.05);
         return take(ToolKind::box) + drag(middle - Point(0.4, 0), middle + Point(0.4, 0.8));
     }},
    {"Press F5 and play the level for some seconds, in this window: A and D move the hero, the "
     "mouse shoots the rope.",
     [](const LessonView& view) { return view.now.played > leastPlay; },
     [](const Workbench&) { return act("level-play", leastPlay); }},
    {"Press Esc: you are back where you edited. Playing has changed nothing of it.",
     [](const LessonView& view) { return view.seen.played && view.now.played == 0; },
     [](const Workbench&) { return act("level-edit"); }},
};

constexpr Lesson all[] = {
    {"build", "Build", "A box on a rope", buildSteps},
    {"break", "Break", "A wall that crumbles", breakSteps},
    {"soften", "Soften", "From jelly to rigid with one number", softenSteps},
    {"measure", "Measure", "A ruler and a diagram", measureSteps},
    {"rewind", "Rewind", "Back in time, and another future", rewindSteps},
    {"level", "Level", "A level of your own, played at once", levelSteps},
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

LessonRun::LessonRun(Workbench& bench, const Lesson& lesson, std::function<double()> played)
    : bench_(bench), lesson_(lesson), played_(std::move(played)) {
    begin();
}

LessonState LessonRun::state() const {
    LessonState state = stateOf(bench_);
    if (played_) state.played = played_();
    return state;
}

void LessonRun::begin() {
    start_ = state();
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
    const LessonState now = state();
    if (now.played > 0) seen_.played = true;
    if (!lesson_.steps[step_].done({bench_, start_, now, seen_})) return false;
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
