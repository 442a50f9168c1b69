// Tools that change what is there: pin, cut, erase.
#include <algorithm>
#include <cmath>

#include "fitting_marks.hpp"
#include "geometry.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

class PinTool final : public Tool {
public:
    using Tool::Tool;
    void press(const Pointer& pointer) override {
        const auto pick = particleAt(world(), pointer.position, pointer.reach);
        if (!pick || world().kind(pick->body) == sulfur::BodyKind::fixed) return;
        const bool pinned = world().info(pick->particle).pinned;
        document().edit(pinned ? "Unpin" : "Pin",
                        [&] { document().setPinned(pick->particle, !pinned); });
    }
    std::string hint() const override {
        return "Click a particle to pin it where it is, or to let it go";
    }
};

class CutTool final : public Tool {
public:
    using Tool::Tool;
    void press(const Pointer& pointer) override {
        cutting_ = true;
        from_ = to_ = pointer.position;
    }
    void move(const Pointer& pointer) override { to_ = pointer.position; }
    void release(const Pointer& pointer) override {
        if (!cutting_) return;
        move(pointer);
        cutting_ = false;
        const auto joints = jointsCrossing(world(), from_, to_);
        const auto lines = fittingsCrossing(document(), from_, to_);
        if (joints.empty() && lines.empty()) return;
        document().edit("Cut", [&] {
            // The last first: those before it keep their places.
            for (auto one = lines.rbegin(); one != lines.rend(); ++one) document().unfit(*one);
            for (const sulfur::JointId joint : joints)
                if (world().contains(joint)) document().remove(joint);
        });
    }
    void cancel() override { cutting_ = false; }
    Preview preview() const override {
        if (!cutting_) return {};
        return {Preview::Kind::stroke, from_, to_, 0};
    }
    std::string hint() const override {
        return "Drag across joints, cables and springs to cut them";
    }

private:
    bool cutting_ = false;
    Point from_{0, 0};
    Point to_{0, 0};
};

class EraseTool final : public Tool {
public:
    using Tool::Tool;
    void press(const Pointer& pointer) override {
        erasing_ = true;
        last_ = pointer.position;
        erase(pointer);
    }
    void move(const Pointer& pointer) override {
        if (!erasing_) return;
        // A quick hand leaves no gaps: everything on the way is erased.
        const Point way = pointer.position - last_;
        if (way.norm() == 0) return;  // what lay below it stays
        const double step = std::max(pointer.reach, 1e-3);
        const int steps = std::clamp(static_cast<int>(std::ceil(way.norm() / step)), 1, 500);
        for (int i = 1; i <= steps; ++i) {
            Pointer between = pointer;
            between.position = last_ + way * (static_cast<double>(i) / steps);
            erase(between);
        }
        last_ = pointer.position;
    }
    void release(const Pointer& pointer) override {
        move(pointer);
        if (changed_) document().commit();
        erasing_ = changed_ = false;
    }
    void cancel() override {
        if (changed_) document().rollback();
        erasing_ = changed_ = false;
    }
    std::string hint() const override {
        return "Click a body or a mark to erase it, or drag over several";
    }

private:
    void erase(const Pointer& pointer) {
        const auto fitting = fittingAt(document(), pointer.position, pointer.reach);
        const sulfur::BodyId body = bench().bodyUnder(pointer);
        if (!body && !fitting) return;
        if (!changed_) document().begin("Erase");
        changed_ = true;
        if (fitting)
            document().unfit(*fitting);
        else
            document().remove({&body, 1});
        bench().documentChanged();
    }

    Point last_{0, 0};
    bool erasing_ = false;
    bool changed_ = false;
};

}  // namespace

std::unique_ptr<Tool> makeChangeTool(Workbench& bench, ToolKind kind) {
    switch (kind) {
        case ToolKind::cut:
            return std::make_unique<CutTool>(bench);
        case ToolKind::erase:
            return std::make_unique<EraseTool>(bench);
        default:
            return std::make_unique<PinTool>(bench);
    }
}

}  // namespace sulfurchamber
