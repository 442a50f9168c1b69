#include "workbench.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::World;

constexpr double goldenFraction = 0.6180339887498949;
constexpr double rainWidth = 6;  // metres
constexpr double boxSize = 0.5;

std::unique_ptr<Tool> makeTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::select:
            return makeSelectTool(bench);
        case ToolKind::pin:
        case ToolKind::cut:
        case ToolKind::erase:
            return makeChangeTool(bench, kind);
        default:
            return makeCreateTool(bench, kind);
    }
}

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

// Only the bodies that are wanted, with what connects them to each other.
sulfur::scene::Scene only(sulfur::scene::Scene scene, const std::set<std::string>& ids) {
    std::set<std::string> prefabs;
    std::erase_if(scene.bodies, [&](const auto& body) { return !ids.contains(body.id); });
    for (const auto& body : scene.bodies) prefabs.insert(body.blueprint);
    std::erase_if(scene.blueprints,
                  [&](const auto& p) { return !prefabs.contains(p.blueprint.name); });
    std::erase_if(scene.connections, [&](const auto& c) {
        return !ids.contains(c.a.body) || !ids.contains(c.b.body);
    });
    std::erase_if(scene.attachments, [&](const auto& a) {
        return !ids.contains(a.particle.body) || !ids.contains(a.body);
    });
    std::erase_if(scene.vetoes,
                  [&](const auto& v) { return !ids.contains(v.a) || !ids.contains(v.b); });
    scene.extra.clear();
    return scene;
}

}  // namespace

std::string_view toolName(ToolKind tool) {
    static constexpr std::array<std::string_view, allTools.size()> names{
        "select", "box", "ball", "jelly", "rope", "ground", "pin", "cut", "erase"};
    return names[static_cast<std::size_t>(tool)];
}

std::optional<ToolKind> toolFromName(std::string_view name) {
    for (const ToolKind tool : allTools)
        if (toolName(tool) == name) return tool;
    return std::nullopt;
}

Workbench::Workbench() : tool_(makeTool(*this, ToolKind::select)) {}
Workbench::~Workbench() = default;

void Workbench::setTool(ToolKind tool) {
    tool_->cancel();
    tool_ = makeTool(*this, tool);
    toolKind_ = tool;
}

void Workbench::press(const Pointer& pointer) {
    tool_->press(pointer);
}
void Workbench::move(const Pointer& pointer) {
    tool_->move(pointer);
}
void Workbench::release(const Pointer& pointer) {
    tool_->release(pointer);
    forgetRemoved();
}
void Workbench::cancel() {
    tool_->cancel();
}
Preview Workbench::preview() const {
    return tool_->preview();
}
std::string Workbench::hint() const {
    return tool_->hint();
}

Point Workbench::snapped(const Point& point) const {
    if (!(snap_ > 0)) return point;
    return {std::round(point.x() / snap_) * snap_, std::round(point.y() / snap_) * snap_};
}

void Workbench::documentChanged() {
    forgetRemoved();
}

void Workbench::forgetRemoved() {
    std::erase_if(selection_, [&](BodyId body) { return !document_.world().contains(body); });
}

// --- time ------------------------------------------------------------------------------------

void Workbench::tick() {
    tool_->tick();
    if (rain_ > 0) addRainBox();
    document_.tick();
}

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
        const double share = std::fmod(static_cast<double>(dropped_) * goldenFraction, 1.0);
        dropBox(document_.world(), (share - 0.5) * rainWidth);
    }
}

void Workbench::dropBox(World& world, double x) {
    const double angle = 0.7 * std::fmod(static_cast<double>(dropped_) * 0.37, 1.0) - 0.35;
    sulfur::Blueprint box =
        sulfur::shapes::box({.size = {Real(boxSize), Real(boxSize)}, .mass = 1});
    box.name = "box";
    const double y = std::max(topAt(world, x, 0) + 1.0, 3.0);
    ++dropped_;
    document_.addScaled(box, {.position = {x, y}, .angle = angle});
}

void Workbench::dropBoxes(int count) {
    if (count <= 0) return;
    document_.edit("Drop boxes", [&](World& world) {
        for (int i = 0; i < count; ++i) {
            const double share = std::fmod(static_cast<double>(dropped_) * goldenFraction, 1.0);
            dropBox(world, (share - 0.5) * rainWidth);
        }
    });
}

// --- selection -------------------------------------------------------------------------------

bool Workbench::selected(BodyId body) const {
    return std::binary_search(selection_.begin(), selection_.end(), body);
}

void Workbench::select(std::vector<BodyId> bodies) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    selection_ = std::move(bodies);
    forgetRemoved();
}

void Workbench::toggle(BodyId body) {
    auto bodies = selection_;
    if (selected(body))
        std::erase(bodies, body);
    else
        bodies.push_back(body);
    select(std::move(bodies));
}

void Workbench::selectAll() {
    const auto bodies = document_.world().bodies();
    select({bodies.begin(), bodies.end()});
}

void Workbench::deleteSelection() {
    if (selection_.empty()) return;
    tool_->cancel();
    document_.edit("Delete", [&](World& world) {
        for (const BodyId body : selection_) world.remove(body);
    });
    selection_.clear();
}

std::string Workbench::copy() const {
    if (selection_.empty()) return {};
    // capture() lists the bodies in the order of the world.
    auto scene = document_.capture();
    const auto bodies = document_.world().bodies();
    std::set<std::string> ids;
    for (std::size_t i = 0; i < bodies.size() && i < scene.bodies.size(); ++i)
        if (selected(bodies[i])) ids.insert(scene.bodies[i].id);
    return sulfur::scene::format(only(std::move(scene), ids));
}

void Workbench::paste(const std::string& text, const sulfur::Vec2& offset) {
    const auto scene = sulfur::scene::parse(text, "the clipboard");
    std::vector<BodyId> made;
    tool_->cancel();
    document_.edit("Paste", [&](World& world) {
        const auto instance = sulfur::scene::instantiate(scene, world);
        for (const auto& placement : scene.bodies) made.push_back(instance.body(placement.id));
        for (const BodyId body : made)
            for (const sulfur::ParticleId particle : world.particles(body))
                world.setPosition(particle, world.position(particle) + offset.cast<double>());
    });
    select(std::move(made));
}

void Workbench::duplicate() {
    if (const std::string text = copy(); !text.empty()) paste(text, {Real(0.5), Real(0.5)});
}

}  // namespace sulfurchamber
