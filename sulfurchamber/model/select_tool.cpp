// Selects and drags: bodies are put elsewhere while time stands still, and pulled by a spring
// while it runs.
#include <algorithm>
#include <cmath>

#include "fitting_marks.hpp"
#include "geometry.hpp"
#include "level_hand.hpp"
#include "meter_grip.hpp"
#include "tool.hpp"
#include "transform.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

constexpr double degrees = 180 / 3.14159265358979;
constexpr double turnStep = 15 / degrees;  // with the grid

class SelectTool final : public Tool {
public:
    explicit SelectTool(Workbench& bench) : Tool(bench), level_(bench) {}

    void press(const Pointer& pointer) override {
        cancel();
        from_ = to_ = pointer.position;
        if (level_.press(pointer)) return;
        if (pressHandle(pointer)) return;
        // While time runs what moves is caught, not the meters on it.
        if (!document().playing() && (meter_ = MeterGrip::take(bench(), pointer))) return;
        const BodyId body = bodyAt(world(), pointer.position, pointer.reach);
        // Marks lie on bodies. While time runs these are what one wants to pull.
        if (!body || !document().playing()) {
            if (const auto ref = fittingAt(document(), pointer.position, pointer.reach)) {
                bench().chooseFitting(ref);
                if (!document().playing()) doing_ = Doing::fitting;
                return;
            }
        }
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
        level_.move(pointer);
        if (meter_) meter_->moveTo(bench(), pointer);
        if (doing_ == Doing::pull) grip_->moveTo(pointer.position);
        if (doing_ == Doing::move) moveSelection(pointer.position - to_);
        if (doing_ == Doing::turn) turnTo(pointer.position);
        if (doing_ == Doing::scale) scaleTo(pointer.position);
        to_ = pointer.position;
    }

    void release(const Pointer& pointer) override {
        level_.release();
        if (meter_) {
            meter_->moveTo(bench(), pointer);
            meter_->release(bench());
            meter_.reset();
        }
        if (doing_ == Doing::idle) return;
        move(pointer);
        if (doing_ == Doing::band) selectBand();
        if (doing_ == Doing::fitting) moveChosen(pointer);
        if (doing_ == Doing::scale && factor_ != 1) {
            doing_ = Doing::idle;
            document().edit("Scale", [&] { scaleSelection(bench(), about_, factor_); });
        }
        // A click without a drag means this one of several.
        const bool clicked = doing_ == Doing::move && !moved_;
        if (moved_) document().commit();
        if (clicked && world().contains(pressed_)) bench().select({pressed_});
        toIdle();
    }

    void cancel() override {
        level_.cancel();
        if (meter_) meter_->cancel(bench());
        meter_.reset();
        if (moved_) document().rollback();
        toIdle();
    }

    void tick() override {
        if (doing_ != Doing::pull) return;
        for (const Push& push : grip_->pushes(world())) document().push(push);
        if (!grip_->holds(world())) toIdle();
    }

    Preview preview() const override {
        if (doing_ == Doing::band) return {Preview::Kind::band, from_, to_, 0};
        if (doing_ == Doing::fitting && (to_ - from_).norm() > 0)
            return {Preview::Kind::arrow, from_, to_, 0};
        if (doing_ == Doing::pull && grip_->holds(world()))
            return {Preview::Kind::spring, grip_->anchor(world()), grip_->target(), 0};
        if (doing_ == Doing::scale && bounds_)
            return {Preview::Kind::rectangle, about_ + factor_ * (bounds_->low - about_),
                    about_ + factor_ * (bounds_->high - about_), 0};
        return {};
    }

    std::string hint() const override {
        if (level_.holds()) return level_.hint();
        switch (doing_) {
            case Doing::pull:
                return "Pulling with a spring: let go to release";
            case Doing::move:
                return "Moving the selection: Escape puts it back";
            case Doing::fitting:
                return "Release where it is to be; Escape leaves it where it is";
            case Doing::band:
                return "Release to select what lies wholly in the frame";
            case Doing::turn:
                return "Turning by " + std::to_string(std::lround(turned_ * degrees)) +
                       " degrees, with the grid in steps of 15; Escape takes it back";
            case Doing::scale:
                return "Scaling to " + std::to_string(std::lround(factor_ * 100)) +
                       " %, mass with the area; Escape takes it back";
            case Doing::idle:
                break;
        }
        return document().playing()
                   ? "Drag a body to pull it with a spring, or drag a frame to select"
                   : "Click to select, drag to move, drag the handles to turn and scale; Delete "
                     "removes";
    }

private:
    enum class Doing { idle, band, move, pull, turn, scale, fitting };

    // The handles of what is selected, while time stands still.
    bool pressHandle(const Pointer& pointer) {
        bounds_ = selectionBounds(bench());
        if (document().playing() || !bounds_) return false;
        const Handles handles = handlesOf(*bounds_, pointer.reach);
        const auto hit = [&](const Point& place) {
            return (place - pointer.position).norm() <= pointer.reach;
        };
        about_ = handles.middle;
        factor_ = 1;
        turned_ = 0;
        if (hit(handles.turn))
            doing_ = Doing::turn;
        else if (std::any_of(handles.corners.begin(), handles.corners.end(), hit))
            doing_ = Doing::scale;
        return doing_ != Doing::idle;
    }

    // Less than the reach is a click.
    void moveChosen(const Pointer& pointer) {
        const auto ref = bench().fitting();
        const Point by = to_ - from_;
        doing_ = Doing::idle;
        if (!ref || by.norm() <= pointer.reach) return;
        document().edit("Move", [&] { moveFitting(document(), *ref, from_, by); });
    }

    void turnTo(const Point& place) {
        const Point before = from_ - about_;
        const Point now = place - about_;
        double angle = std::atan2(sulfur::cross(before, now), before.dot(now));
        if (bench().snap() > 0) angle = std::round(angle / turnStep) * turnStep;
        if (angle == turned_) return;
        if (!moved_) {
            document().begin("Turn");
            moved_ = true;
        }
        turnSelection(bench(), about_, angle - turned_);
        turned_ = angle;
    }

    void scaleTo(const Point& place) {
        const double before = (from_ - about_).norm();
        factor_ = std::clamp((place - about_).norm() / std::max(before, 1e-6), 0.05, 20.0);
        if (bench().snap() > 0) factor_ = std::max(0.1, std::round(factor_ * 10) / 10);
    }

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

    LevelHand level_;
    Doing doing_ = Doing::idle;
    bool additive_ = false;
    bool moved_ = false;
    BodyId pressed_;
    Point about_{0, 0};
    std::optional<Bounds> bounds_;
    double turned_ = 0;  // radians so far
    double factor_ = 1;
    Point from_{0, 0};
    Point to_{0, 0};
    std::optional<Grip> grip_;
    std::optional<MeterGrip> meter_;
};

}  // namespace

std::unique_ptr<Tool> makeSelectTool(Workbench& bench) {
    return std::make_unique<SelectTool>(bench);
}

}  // namespace sulfurchamber
