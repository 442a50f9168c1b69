// One tool of the palette. Tools live as long as they are chosen.
#pragma once

#include <memory>
#include <string>

#include "level_pieces.hpp"
#include "workbench.hpp"

namespace sulfurchamber {

class Tool {
public:
    explicit Tool(Workbench& bench) : bench_(bench) {}
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    virtual void press(const Pointer& pointer) = 0;
    virtual void move(const Pointer&) {}
    virtual void release(const Pointer&) {}
    /// Back to idle, undoing what is half done.
    virtual void cancel() {}
    /// Before each tick.
    virtual void tick() {}
    /// Enter: ends what takes several clicks.
    virtual void finish() {}
    /// Whether it has done what it was taken for: then one selects again.
    virtual bool done() const { return false; }
    virtual Preview preview() const { return {}; }
    /// Whether it shows the selection's frame itself.
    virtual bool showsFrame() const { return false; }
    virtual std::string hint() const = 0;

protected:
    Workbench& bench() const { return bench_; }
    Document& document() const { return bench_.document(); }
    sulfur::World& world() const { return bench_.document().world(); }

private:
    Workbench& bench_;
};

std::unique_ptr<Tool> makeSelectTool(Workbench& bench);
/// Polygons corner by corner, and soft bodies drawn freehand.
std::unique_ptr<Tool> makeOutlineTool(Workbench& bench, ToolKind kind);
/// Particles and joints, one by one.
std::unique_ptr<Tool> makeParticleTool(Workbench& bench, ToolKind kind);
/// Ready-made shapes between two points, and the ground.
std::unique_ptr<Tool> makeCreateTool(Workbench& bench, ToolKind kind);
/// What is fitted between bodies.
std::unique_ptr<Tool> makeMechanismTool(Workbench& bench, ToolKind kind);
/// Thrusters, zones, conveyors and liquid.
std::unique_ptr<Tool> makeZoneTool(Workbench& bench, ToolKind kind);
/// Pieces of a level.
std::unique_ptr<Tool> makePlaceTool(Workbench& bench, LevelPiece piece);
/// Rulers, protractors, tracers, force gauges and speed guns.
std::unique_ptr<Tool> makeMeterTool(Workbench& bench, ToolKind kind);
/// Pin, cut and erase.
std::unique_ptr<Tool> makeChangeTool(Workbench& bench, ToolKind kind);

}  // namespace sulfurchamber
