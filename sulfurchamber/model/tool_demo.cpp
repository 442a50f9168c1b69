#include "tool_demo.hpp"

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::Point;
using namespace hand;

/// What is there at first, and what the hand then does with the tool.
struct Film {
    ToolKind tool;
    HandMoves (*before)();  // at once, before the film begins
    HandMoves (*shown)();
};

HandMoves nothing() {
    return {};
}

// Made at once: a click or a drag with another tool.
HandMoves dragWith(ToolKind tool, const Point& from, const Point& to) {
    return take(tool) + drag(from, to);
}
HandMoves clickWith(ToolKind tool, const Point& at, bool shift = false) {
    return take(tool) + click(at, shift);
}

HandMoves thenPlay(HandMoves moves) {
    return std::move(moves) + hand::act("play");
}

// A round outline, a little wild.
std::vector<Point> blobOutline() {
    std::vector<Point> points;
    for (int i = 0; i <= 24; ++i) {
        const double angle = 2 * 3.14159265358979 * i / 24;
        const double radius = 0.5 + 0.09 * std::sin(3 * angle);
        points.emplace_back(radius * std::cos(angle), 1.2 + radius * std::sin(angle));
    }
    return points;
}

// --- what is there ---------------------------------------------------------------------------

HandMoves boxAtLeft() {
    return dragWith(ToolKind::box, {-1.5, 0.05}, {-0.9, 0.65});
}
HandMoves boxInTheAir() {
    return dragWith(ToolKind::box, {-0.9, 0.9}, {0.9, 1.2});
}
HandMoves ballAbove() {
    return dragWith(ToolKind::ball, {0, 2.1}, {0.2, 2.1});
}
HandMoves ballAtLeft() {
    return dragWith(ToolKind::ball, {-1.3, 2.2}, {-1.1, 2.2});
}
HandMoves twoParticles() {
    return clickWith(ToolKind::particle, {0, 2}, true) + clickWith(ToolKind::particle, {1, 1.6});
}
HandMoves jellyInTheAir() {
    return dragWith(ToolKind::jelly, {-0.5, 0.9}, {0.5, 1.7});
}
HandMoves boxOnARope() {
    return dragWith(ToolKind::box, {-0.3, 0.6}, {0.3, 1.1}) +
           dragWith(ToolKind::rope, {0, 2.3}, {-0.28, 1.08}) + take(ToolKind::select) +
           hand::act("play");
}
HandMoves threeBoxes() {
    return dragWith(ToolKind::box, {-1.4, 0.05}, {-0.8, 0.65}) +
           dragWith(ToolKind::box, {-0.3, 0.05}, {0.3, 0.65}) +
           dragWith(ToolKind::box, {0.8, 0.05}, {1.4, 0.65});
}

// Two boxes, of which the right one lies over the end of the left one.
HandMoves twoPlanks() {
    return dragWith(ToolKind::box, {-1.2, 1.5}, {0.1, 1.7}) +
           dragWith(ToolKind::box, {-0.1, 1.45}, {1.2, 1.75}) +
           clickWith(ToolKind::pin, {-1.18, 1.68});
}
HandMoves boxUnderPlank() {
    return dragWith(ToolKind::box, {-0.4, 0.8}, {0.4, 1.4});
}
HandMoves boxOnFloor() {
    return dragWith(ToolKind::box, {-0.3, 0.06}, {0.3, 0.56});
}
HandMoves cartOnAWheel() {
    return dragWith(ToolKind::wheel, {-0.6, 0.35}, {-0.6, 0.07}) +
           dragWith(ToolKind::wheel, {0.6, 0.35}, {0.6, 0.07}) +
           dragWith(ToolKind::box, {-1, 0.5}, {1, 0.75});
}
HandMoves twoWeights() {
    return dragWith(ToolKind::box, {-0.9, 0.9}, {-0.5, 1.3}) +
           dragWith(ToolKind::box, {0.45, 0.9}, {1.05, 1.5});
}
HandMoves twoDrivenWheels() {
    return dragWith(ToolKind::wheel, {-0.7, 1.2}, {-0.3, 1.2}) +
           dragWith(ToolKind::wheel, {0.4, 1.2}, {1.08, 1.2}) +
           clickWith(ToolKind::motor, {-0.7, 1.2}) + clickWith(ToolKind::hinge, {0.4, 1.2});
}

// --- what is shown ---------------------------------------------------------------------------

HandMoves showSelect() {
    return thenPlay(drag({-1.2, 0.35}, {0.4, 1.5}));
}
HandMoves showBox() {
    return thenPlay(drag({-0.6, 1}, {0.5, 1.7}));
}
HandMoves showBall() {
    return thenPlay(drag({0, 1.4}, {0.45, 1.4}));
}
HandMoves showWheel() {
    return drag({-0.6, 1}, {-0.25, 0.7}) + thenPlay(drag({0.6, 1}, {0.95, 0.7}));
}
HandMoves showPolygon() {
    return click({-0.7, 0.8}) + click({0.8, 0.9}) + click({0.2, 1.3}) + click({-0.4, 1.9}) +
           thenPlay(hand::act("finish"));
}
HandMoves showDraw() {
    return thenPlay(stroke(blobOutline()));
}
HandMoves showLine() {
    return thenPlay(drag({-0.9, 2}, {0.9, 2}));
}
HandMoves showBridge() {
    return thenPlay(drag({-1.4, 1.2}, {1.4, 1.2}));
}
HandMoves showCloth() {
    return thenPlay(drag({-0.7, 2.1}, {0.7, 0.9}));
}
HandMoves showWall() {
    return thenPlay(drag({-0.8, 0.06}, {0.8, 1.26}));
}
HandMoves showGround() {
    return thenPlay(drag({-1.6, 1.6}, {1, 0.5}));
}
HandMoves showParticle() {
    return click({-0.6, 1.2}) + click({0.6, 1.2}, true) + thenPlay(rest(0.1));
}
HandMoves showJoint() {
    return thenPlay(drag({0, 2}, {1, 1.6}));
}
HandMoves showPin() {
    return thenPlay(click({-0.47, 1.67}));
}
HandMoves showCut() {
    return rest(0.5) + drag({-0.8, 1.7}, {0.6, 1.6});
}
HandMoves showErase() {
    return click({0, 0.35}) + rest(0.3) + click({1.1, 0.35});
}
HandMoves showMeasure() {
    return drag({-1.2, 0.65}, {1.1, 1.5});
}

HandMoves showHinge() {
    return thenPlay(click({0, 1.6}));
}
HandMoves showMotor() {
    return thenPlay(click({0, 1.1}));
}
HandMoves showSpring() {
    return thenPlay(drag({0, 1.3}, {0.3, 2.2}));
}
HandMoves showWinch() {
    return thenPlay(drag({0, 2.3}, {0, 1.3}));
}
HandMoves showSlider() {
    return thenPlay(drag({0, 1.1}, {1.1, 0.6}));
}
HandMoves showAxle() {
    return drag({-0.6, 0.35}, {-0.6, 0.6}) + thenPlay(drag({0.6, 0.35}, {0.6, 0.6}));
}
HandMoves showPulley() {
    return click({-0.7, 1.28}) + click({-0.7, 2.2}) + click({0.75, 2.2}) +
           thenPlay(click({0.75, 1.45}));
}
HandMoves showGear() {
    return thenPlay(drag({-0.7, 1.2}, {0.4, 1.2}));
}
HandMoves showThruster() {
    return thenPlay(drag({0, 0.3}, {0.1, 1}));
}
HandMoves showZone() {
    return thenPlay(drag({-1.6, 0.1}, {1.6, 1.9}));
}
HandMoves showConveyor() {
    return thenPlay(drag({-1.6, 0.6}, {1.3, 0.6}));
}
HandMoves showLiquid() {
    return thenPlay(drag({-0.6, 0.9}, {0.4, 1.6}));
}

HandMoves showProtractor() {
    return drag({-0.9, 0.4}, {0.9, 0.5}) + click({0.5, 1.6});
}
HandMoves showTracer() {
    return thenPlay(click({-1.2, 0.35}) + rest(0.1));
}
HandMoves showGauge() {
    return thenPlay(click({0, 0.3}));
}
HandMoves showGun() {
    return thenPlay(drag({-0.9, 1}, {0.9, 1}));
}

constexpr Film films[] = {
    {ToolKind::select, boxAtLeft, showSelect},
    {ToolKind::box, nothing, showBox},
    {ToolKind::ball, nothing, showBall},
    {ToolKind::jelly, nothing, showBox},
    {ToolKind::wheel, boxInTheAir, showWheel},
    {ToolKind::polygon, nothing, showPolygon},
    {ToolKind::draw, nothing, showDraw},
    {ToolKind::rope, nothing, showLine},
    {ToolKind::chain, nothing, showLine},
    {ToolKind::bridge, ballAbove, showBridge},
    {ToolKind::cloth, nothing, showCloth},
    {ToolKind::wall, ballAbove, showWall},
    {ToolKind::ground, ballAtLeft, showGround},
    {ToolKind::particle, nothing, showParticle},
    {ToolKind::joint, twoParticles, showJoint},
    {ToolKind::hinge, twoPlanks, showHinge},
    {ToolKind::motor, boxUnderPlank, showMotor},
    {ToolKind::weld, twoPlanks, showHinge},
    {ToolKind::spring, boxUnderPlank, showSpring},
    {ToolKind::cable, boxUnderPlank, showSpring},
    {ToolKind::winch, boxUnderPlank, showWinch},
    {ToolKind::slider, boxUnderPlank, showSlider},
    {ToolKind::axle, cartOnAWheel, showAxle},
    {ToolKind::pulley, twoWeights, showPulley},
    {ToolKind::gear, twoDrivenWheels, showGear},
    {ToolKind::thruster, boxOnFloor, showThruster},
    {ToolKind::wind, ballAtLeft, showZone},
    {ToolKind::gravity, ballAtLeft, showZone},
    {ToolKind::conveyor, ballAtLeft, showConveyor},
    {ToolKind::liquid, nothing, showLiquid},
    {ToolKind::pin, jellyInTheAir, showPin},
    {ToolKind::cut, boxOnARope, showCut},
    {ToolKind::erase, threeBoxes, showErase},
    {ToolKind::measure, boxAtLeft, showMeasure},
    {ToolKind::protractor, nothing, showProtractor},
    {ToolKind::tracer, boxAtLeft, showTracer},
    {ToolKind::gauge, boxOnFloor, showGauge},
    {ToolKind::gun, ballAbove, showGun},
};

const Film& filmOf(ToolKind tool) {
    const auto* found = std::find_if(std::begin(films), std::end(films),
                                     [&](const Film& film) { return film.tool == tool; });
    return found == std::end(films) ? films[0] : *found;
}

}  // namespace

Bounds toolDemoFrame() {
    return {{-2, -0.25}, {2, 2.45}};
}

ToolDemo::ToolDemo(ToolKind tool) : tool_(tool) {
    restart();
}

void ToolDemo::restart() {
    const Film& film = filmOf(tool_);
    hand_.reset();
    bench_ = std::make_unique<Workbench>();
    Hand before(*bench_, film.before());
    before.advance(before.length() + 1);
    bench_->setTool(tool_);
    hand_ = std::make_unique<Hand>(*bench_, film.shown());
    time_ = ticksDue_ = 0;
}

void ToolDemo::advance(double by) {
    by = std::clamp(by, 0.0, seconds / 2);
    if (time_ + by >= seconds) {
        restart();
        return;
    }
    time_ += by;
    hand_->advance(by);
    if (!bench_->document().playing()) return;
    ticksDue_ += by / static_cast<double>(bench_->document().world().tickDuration());
    for (; ticksDue_ >= 1; ticksDue_ -= 1) bench_->tick();
}

}  // namespace sulfurchamber
