// Selects and drags: bodies are put elsewhere while time stands still, and pulled by a spring
// while it runs.
#include <algorithm>

#include "geometry.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

class SelectTool final : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        cancel();
        from_ = to_ = pointer.position;
        const BodyId body = bodyAt(world(), pointer.position, pointer.reach);
        if (!body) {
            additive_ = pointer.shift || pointer.control;
            doing_ = Doing::band;
            return;
        }
        if (pointer.shift || pointer.control) {
            bench().toggle(body);
            return;
        }
        if (!bench().selected(body)) bench().select({body});
        pressed_ = body;
        if (document().playing()) {
            grip_ = Grip::take(world(), pointer.position, pointer.reach);
            if (grip_) doing_ = Doing::pull;
        } else {
            doing_ = Doing::move;
        }
    }

    void move(const Pointer& pointer) override {
        if (doing_ == Doing::pull) grip_->moveTo(pointer.position);
        if (doing_ == Doing::move) moveSelection(pointer.position - to_);
        to_ = pointer.position;
    }

    void release(const Pointer& pointer) override {
        if (doing_ == Doing::idle) return;
        move(pointer);
        if (doing_ == Doing::band) selectBand();
        // A click without a drag means this one of several.
        const bool clicked = doing_ == Doing::move && !moved_;
        if (moved_) document().commit();
        if (clicked && world().contains(pressed_)) bench().select({pressed_});
        toIdle();
    }

    void cancel() override {
        if (moved_) document().rollback();
        toIdle();
    }

    void tick() override {
        if (doing_ != Doing::pull) return;
        if (grip_->holds(world()))
            grip_->apply(world());
        else
            toIdle();
    }

    Preview preview() const override {
        if (doing_ == Doing::band) return {Preview::Kind::band, from_, to_, 0};
        if (doing_ == Doing::pull && grip_->holds(world()))
            return {Preview::Kind::spring, grip_->anchor(world()), grip_->target(), 0};
        return {};
    }

    std::string hint() const override {
        switch (doing_) {
            case Doing::pull:
                return "Pulling with a spring: let go to release";
            case Doing::move:
                return "Moving the selection: Escape puts it back";
            case Doing::band:
                return "Release to select what lies wholly in the frame";
            case Doing::idle:
                break;
        }
        return document().playing()
                   ? "Drag a body to pull it with a spring, or drag a frame to select"
                   : "Click to select, drag to move, Shift-click for several, Delete removes";
    }

private:
    enum class Doing { idle, band, move, pull };

    void moveSelection(const Point& by) {
        if (by.x() == 0 && by.y() == 0) return;
        if (!moved_) {
            document().begin("Move");
            moved_ = true;
        }
        document().translate(bench().selection(), by);
    }

    void selectBand() {
        auto found = bodiesIn(world(), from_, to_);
        if (additive_)
            found.insert(found.end(), bench().selection().begin(), bench().selection().end());
        bench().select(std::move(found));
    }

    void toIdle() {
        doing_ = Doing::idle;
        moved_ = false;
        grip_.reset();
    }

    Doing doing_ = Doing::idle;
    bool additive_ = false;
    bool moved_ = false;
    BodyId pressed_;
    Point from_{0, 0};
    Point to_{0, 0};
    std::optional<Grip> grip_;
};

}  // namespace

std::unique_ptr<Tool> makeSelectTool(Workbench& bench) {
    return std::make_unique<SelectTool>(bench);
}

}  // namespace sulfurchamber
