// What falls into the scene, and what has fallen out of it.
#include <algorithm>
#include <cmath>

#include "tool.hpp"
#include "workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::World;

constexpr double goldenFraction = 0.6180339887498949;
constexpr double rainWidth = 6;  // metres
constexpr double widest = 36;    // metres over which boxes drop at most
constexpr double boxSize = 0.5;

// How high the column around x is filled, or `otherwise` where it is empty.
double topAt(const World& world, double x, double otherwise) {
    double top = otherwise;
    bool any = false;
    for (const BodyId body : world.bodies())
        for (const sulfur::ParticleId particle : world.particles(body)) {
            const Point p = world.position(particle);
            if (std::abs(p.x() - x) > 1.5 * boxSize) continue;
            top = any ? std::max(top, p.y()) : p.y();
            any = true;
        }
    return top;
}

}  // namespace

void Workbench::setRain(double boxesPerSecond) {
    rain_ = std::clamp(boxesPerSecond, 0.0, 100.0);
    rainDue_ = 0;
}

void Workbench::addRainBox() {
    rainDue_ += rain_ * static_cast<double>(document_.world().tickDuration());
    if (rainDue_ < 1) return;
    // One step of the history for the whole shower: it begins with the first box.
    if (!document_.editing() || document_.undoLabel() != "Rain of boxes")
        document_.begin("Rain of boxes");
    for (; rainDue_ >= 1; rainDue_ -= 1) {
        try {
            dropBox(Drop::rain, rainWidth);
        } catch (...) {
            rain_ = 0;  // the scene is full
            document_.commit();
            throw;
        }
    }
}

// What falls while time runs is of this moment: the plan would have all of it in one place.
void Workbench::dropBox(Drop kind, double width) {
    const double share = std::fmod(static_cast<double>(dropped_) * goldenFraction, 1.0);
    const double x = (share - 0.5) * width;
    const double angle = 0.7 * std::fmod(static_cast<double>(dropped_) * 0.37, 1.0) - 0.35;
    const sulfur::shapes::BoxOptions box{.size = {Real(boxSize), Real(boxSize)}, .mass = 1};
    const double y = std::max(topAt(document_.world(), x, 0) + 1.0, 3.0);
    const sulfur::Pose pose{.position = {x, y}, .angle = angle};
    switch (kind) {
        case Drop::rain:
            document_.letFall(sulfur::scene::makePrefab("box", box), pose);
            break;
        case Drop::passing:
            document_.addPassing(sulfur::scene::makePrefab("box", box), pose);
            break;
        case Drop::planned:
            document_.add("box", box, pose);
            break;
    }
    ++dropped_;
}

void Workbench::dropBoxes(int count) {
    if (count <= 0) return;
    document_.edit("Drop boxes", [&] {
        const Drop kind = document_.canReset() ? Drop::passing : Drop::planned;
        // Many fall side by side: a tower would reach the sky.
        const double width = std::clamp(0.6 * std::sqrt(count), rainWidth, widest);
        for (int i = 0; i < count; ++i) dropBox(kind, width);
    });
}

// --- what has left ---------------------------------------------------------------------------

std::vector<BodyId> Workbench::strays() const {
    const World& world = document_.world();
    const Bounds inside = worldBounds(document_);
    std::vector<BodyId> found;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != sulfur::BodyKind::dynamic) continue;
        const auto bounds = world.bounds(body);
        if ((bounds.high.array() < inside.low.array()).any() ||
            (bounds.low.array() > inside.high.array()).any())
            found.push_back(body);
    }
    return found;
}

void Workbench::bringBackStrays() {
    const auto found = strays();
    if (found.empty()) return;
    tool_->cancel();
    document_.startTime();
    document_.edit("Bring back", [&] { document_.bringBack(found); });
}

void Workbench::deleteStrays() {
    const auto found = strays();
    if (found.empty()) return;
    tool_->cancel();
    document_.edit("Delete what has left", [&] { document_.remove(found); });
    forgetRemoved();
}

}  // namespace sulfurchamber
